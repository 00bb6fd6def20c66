//! The figures of a solution, and what the user should know about them.

use super::balance::film_balance_error;
use super::limits::thin_film_warning;
use super::profile::Profile;
use crate::contact::{ContactKind, Scales};
use crate::solution::{Estimate, FilmReduction, LevelStats, Located, Summary, solved};
use crate::solve::adapt::{error_bars, grading_errors};
use crate::solve::evaluate::{central_film, largest_pressure, minimum_film};
use crate::solve::newton::FilmModel;
use crate::solve::sequence::{Role, StageSolution};

/// Reads the figures off the finest stage.
pub fn summarise(
    solution: &StageSolution,
    levels: &[LevelStats],
    model: &FilmModel,
    scales: &Scales,
) -> Summary {
    let (d, state) = (&solution.discretisation, &solution.state);
    let located = |value: f64, [x, y]: [f64; 2]| Located {
        value,
        x: x * scales.length,
        y: y * scales.length,
    };
    let profile = Profile::new(d, state, 16);
    let (h_m, at) = minimum_film(d, state);
    let (h_line, x_line) = profile.film_minimum();
    let (p_max, p_at) = largest_pressure(d, state);
    let p_min = state.pressure.iter().fold(0.0_f64, |m, p| m.min(*p));
    let grading = grading_errors(d.contact.kind, d.contact.elasticity.model, &solution.stage.sizes);
    let bars = error_bars(levels, grading).map(|b| b.bars);
    let estimate = |value: f64, figure: usize| Estimate {
        value,
        error: bars.map(|b| b[figure] * value.abs()),
    };
    Summary {
        film_central: estimate(central_film(d, state) * scales.film, 0),
        film_minimum: estimate(h_m * scales.film, 1),
        film_minimum_at: located(h_m * scales.film, at),
        film_centreline_minimum: located(h_line * scales.film, [x_line, 0.0]),
        pressure_maximum: located(p_max * scales.pressure, p_at),
        spike: profile
            .spike()
            .map(|(p, x)| located(p * scales.pressure, [x, 0.0])),
        outlet_position: profile.outlet() * scales.length,
        pressure_minimum: p_min * scales.pressure,
        film_balance_error: film_balance_error(solution, model),
        load_balance_error: (d.integral(&state.pressure) / scales.load - 1.0).abs(),
        rigid_separation: state.rigid_separation * scales.film,
    }
}

/// Films with and without shear thinning, where both were found on the same mesh.
pub fn film_reduction(levels: &[LevelStats]) -> Option<FilmReduction> {
    let at = levels
        .iter()
        .rposition(|l| l.role == Role::Comparison && l.converged)?;
    let newtonian = &levels[at];
    let thinned = levels[at + 1..]
        .iter()
        .find(|l| l.converged && !l.role.leads() && l.is_beside(newtonian))?;
    Some(FilmReduction {
        central: 1.0 - thinned.film_central / newtonian.film_central,
        minimum: 1.0 - thinned.film_minimum / newtonian.film_minimum,
    })
}

/// Change of the largest pressure from mesh to mesh, relative, up to which it counts as resolved.
const PRESSURE_RESOLVED: f64 = 0.05;

/// Warnings about a solution: film too thin for a continuum, error bars too wide, contact area
/// too small.
pub fn warnings(
    kind: ContactKind,
    summary: &Summary,
    solution: &StageSolution,
    levels: &[LevelStats],
    target_error: Option<f64>,
) -> Vec<String> {
    let mut warnings = Vec::new();
    let minimum = summary.film_minimum;
    warnings.extend(thin_film_warning(
        "the minimum film thickness",
        minimum.value,
    ));
    if minimum.error.is_none() {
        warnings.push(
            "no error bar: no coarser mesh converged (or solver.error_estimate is off)".to_owned(),
        );
    }
    // On the mesh of the solution itself it was only the case's own pressures that failed.
    let own = solved(levels);
    let stuck = levels
        .last()
        .is_some_and(|l| !l.converged && own.is_none_or(|s| s.n_contact_elements != l.n_contact_elements));
    for (name, figure) in [("central", summary.film_central), ("minimum", minimum)] {
        let relative = figure.error.unwrap_or(0.0) / figure.value;
        match target_error {
            Some(target) if relative > target => warnings.push(format!(
                "the {name} film thickness is uncertain by {:.2} %, beyond [mesh] target_error: refinement \
                 ended at {}",
                100.0 * relative,
                if stuck {
                    "a mesh on which Newton's method does not converge"
                } else {
                    "the largest mesh allowed ([mesh] max_unknowns)"
                }
            )),
            None if relative > 0.05 => warnings.push(format!(
                "the {name} film thickness is uncertain by {:.0} %: use a finer mesh ([mesh] preset = \"fine\")",
                100.0 * relative
            )),
            _ => {}
        }
    }
    if solution.rough {
        warnings.push(format!(
            "Newton's method ended at a pressure update of {:.0e} p_h: it does not converge further on this mesh",
            solution.reached.update
        ));
    }
    let converged: Vec<&LevelStats> = levels.iter().filter(|l| l.converged).collect();
    if let [.., coarse, fine] = converged[..]
        && (coarse.pressure_maximum / fine.pressure_maximum - 1.0).abs() > PRESSURE_RESOLVED
    {
        warnings.push(format!(
            "the largest pressure is that of a spike which the mesh does not resolve: {:.3} GPa on the \
             mesh before, {:.3} GPa here; film thickness does not depend on it",
            coarse.pressure_maximum / 1e9,
            fine.pressure_maximum / 1e9
        ));
    }
    let orders = [
        solution.discretisation.pressure.element.order(),
        solution.discretisation.contact.deflection.element.order(),
    ];
    if orders.contains(&1) {
        // Measured on a roller: 3 and 4 of the differences that the bars are made of.
        warnings.push(
            "first-order elements err by more than their error bars: use [mesh] pressure_order 2 or \
             more and elastic_order 2"
                .to_owned(),
        );
    }
    let (d, e) = (
        &solution.discretisation,
        &solution.discretisation.contact.extents,
    );
    let profile = Profile::new(d, &solution.state, 2);
    if profile.outlet() > e.outlet - 0.02 {
        warnings.push(format!(
            "the film does not break before the outlet edge X = {}: move it outward ([mesh] outlet)",
            e.outlet
        ));
    }
    let inlet_film = profile.fields.first().map_or(f64::INFINITY, |f| f.film);
    let centre = central_film(d, &solution.state);
    if inlet_film < 20.0 * centre {
        warnings.push(format!(
            "the film at the inlet edge X = {} is only {:.0} times the central film: the contact is \
             starved by its own contact area; move the edge outward ([mesh] inlet{})",
            e.inlet,
            inlet_film / centre,
            if kind == ContactKind::Circular { ", side" } else { "" }
        ));
    }
    warnings
}
