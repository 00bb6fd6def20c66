//! The figures of a solved stage, and warnings about them.

use super::balance::film_balance_error;
use crate::contact::Scales;
use crate::engine::Profile;
use crate::post::limits::thin_film_warning;
use crate::post::summary::{EdgeFilms, edge_warnings, summary_of};
use crate::solution::{Figure, FilmReduction, LevelStats, Measured, Role, Summary, solved};
use crate::solve::adapt::{RefinementEnd, bar_of_edges};
use crate::solve::bars::reduction;
use crate::solve::evaluate::central_film;
use crate::solve::newton_level::FilmModel;
use crate::solve::sequence::StageSolution;
use crate::warning::{Warning, WarningKind};

/// The figures of the finest stage.
pub fn summarise(
    solution: &StageSolution,
    measured: &Measured,
    model: &FilmModel,
    scales: &Scales,
) -> Summary {
    let (d, state) = (&solution.discretisation, &solution.state);
    let p_min = state.pressure.iter().fold(0.0_f64, |m, p| m.min(*p));
    Summary {
        pressure_minimum: p_min * scales.pressure,
        film_balance_error: film_balance_error(solution, model),
        load_balance_error: (d.integral(&state.pressure) / scales.load - 1.0).abs(),
        rigid_separation: state.rigid_separation * scales.film,
        ..summary_of(measured)
    }
}

/// Films with and without shear thinning, where both were found on the same mesh.
pub fn film_reduction(levels: &[LevelStats], measured: &Measured) -> Option<FilmReduction> {
    let [thinned, newtonian] = comparison_pair(levels, Role::Comparison)?;
    let of = |figure| reduction(figure, thinned, newtonian, measured);
    Some(FilmReduction {
        central: of(Figure::FilmCentral)?,
        minimum: of(Figure::FilmMinimum)?,
    })
}

/// The stage of the full problem and, on the same mesh, the last comparison stage with `role`.
pub(super) fn comparison_pair(levels: &[LevelStats], role: Role) -> Option<[&LevelStats; 2]> {
    let at = levels.iter().rposition(|l| l.role == role && l.converged)?;
    let simpler = &levels[at];
    let full = levels[at + 1..]
        .iter()
        .find(|l| l.converged && !l.role.leads() && l.has_mesh_of(simpler))?;
    Some([full, simpler])
}

/// Change of the largest pressure from mesh to mesh, relative, up to which it counts as resolved.
const PRESSURE_RESOLVED: f64 = 0.05;

/// Why a mesh is not refined further, in words.
fn refinement_ended(end: Option<RefinementEnd>) -> String {
    match end {
        None => "refinement ended at a mesh on which Newton's method does not converge".to_owned(),
        Some(RefinementEnd::Unknowns(most)) => format!(
            "refinement ended at the largest mesh allowed, of about {most} pressure unknowns ([mesh] max_unknowns)"
        ),
        Some(RefinementEnd::BodyUnknowns(most)) => format!(
            "refinement ended at the largest body allowed, of about {most} displacement unknowns ([mesh] max_unknowns)"
        ),
        Some(RefinementEnd::Refinements(n)) => {
            format!("refinement ended after {n} refinements, as many as a mesh may have")
        }
        Some(RefinementEnd::Pressure) => "the cells resolve the film, but the pressure error widens the bar: a \
                                          smaller [mesh] pressure_error, without refine_for = \"films\", lowers it"
            .to_owned(),
        // Bars of another kind were wide before.
        Some(RefinementEnd::Reached | RefinementEnd::NothingToHalve) => {
            "the error estimate requires no smaller cells; a smaller [mesh] target_error lowers the error bar"
                .to_owned()
        }
        Some(RefinementEnd::NoEstimate) => {
            "the errors on the last mesh could not be estimated, so that it was not refined".to_owned()
        }
    }
}

/// Warnings about a solution: film too thin for a continuum, error bars too wide, contact area
/// too small.
pub fn warnings(
    summary: &Summary,
    solution: &StageSolution,
    levels: &[LevelStats],
    target_error: Option<f64>,
) -> Vec<Warning> {
    let mut warnings = Vec::new();
    let minimum = summary.film_minimum;
    warnings.extend(thin_film_warning(
        "the minimum film thickness",
        minimum.value,
    ));
    if minimum.error.is_none() {
        warnings.push(Warning::new(
            WarningKind::NoErrorBar,
            "no error bar: no coarser mesh converged (or solver.error_estimate is off)",
        ));
    }
    warnings.extend(film_errors(summary, solution, levels, target_error));
    if solution.rough {
        let update = solution.reached.update;
        let text = format!(
            "Newton's method ended at a pressure update of {update:.0e} p_h: it does not converge further on this mesh"
        );
        warnings.push(Warning::beyond(WarningKind::Convergence, update, text));
    }
    warnings.extend(spike(summary, levels));
    let orders = [
        solution.discretisation.pressure.element.order(),
        solution.discretisation.contact.deflection.element.order(),
    ];
    if orders.contains(&1) {
        // Measured on a roller: 3 and 4 of the differences that the bars are made of.
        warnings.push(Warning::new(
            WarningKind::FirstOrder,
            "the errors of first-order elements exceed their error bars: use [mesh] pressure_order 2 or \
             more and elastic_order 2",
        ));
    }
    let d = &solution.discretisation;
    let profile = Profile::new(d, &solution.state, 2);
    let films = EdgeFilms {
        outlet: profile.outlet(),
        inlet: profile.fields.first().map_or(f64::INFINITY, |f| f.film),
        centre: central_film(d, &solution.state),
    };
    warnings.extend(edge_warnings(&d.contact.extents, &d.contact.shape, films));
    warnings
}

/// Warnings about error bars of the films that are wider than requested.
fn film_errors(
    summary: &Summary,
    solution: &StageSolution,
    levels: &[LevelStats],
    target_error: Option<f64>,
) -> Vec<Warning> {
    let mut warnings = Vec::new();
    let side_key = match solution.discretisation.contact.shape.is_line() {
        true => "",
        false => ", side",
    };
    let own = solved(levels);
    let edges = own.and_then(|l| l.estimate).map_or([0.0; 2], |e| e.edges);
    let figures = [
        (
            WarningKind::CentralFilmError,
            "central",
            summary.film_central,
        ),
        (
            WarningKind::MinimumFilmError,
            "minimum",
            summary.film_minimum,
        ),
    ];
    for ((kind_of_error, name, figure), edges) in figures.into_iter().zip(edges) {
        let relative = figure.error.unwrap_or(0.0) / figure.value;
        let text = match target_error {
            Some(target) if relative > target && bar_of_edges(edges) > 0.5 * relative => format!(
                "the {name} film thickness is uncertain by {:.2} %, beyond [mesh] target_error, because the edges of the \
                 contact area are near (move them outward, [mesh] inlet{}), or pressures below zero far behind a thick film pull at it ([solver] method = \
                 \"finite-volumes\" has none)",
                100.0 * relative,
                side_key
            ),
            Some(target) if relative > target => format!(
                "the {name} film thickness is uncertain by {:.2} %, beyond [mesh] target_error: {}",
                100.0 * relative,
                refinement_ended(solution.refinement_end),
            ),
            None if relative > 0.05 => format!(
                "the {name} film thickness is uncertain by {:.0} %: use a finer mesh ([mesh] preset = \"fine\")",
                100.0 * relative
            ),
            _ => continue,
        };
        warnings.push(Warning::beyond(kind_of_error, relative, text));
    }
    warnings
}

/// Warning about a largest pressure that the mesh does not resolve; `None` where it has an error bar, which says as much.
fn spike(summary: &Summary, levels: &[LevelStats]) -> Option<Warning> {
    let pressures: Vec<f64> = (levels.iter().filter(|l| l.converged))
        .filter_map(|l| l.figures.value(Figure::PressureMaximum))
        .collect();
    let [.., coarse, fine] = pressures[..] else {
        return None;
    };
    let change = (coarse / fine - 1.0).abs();
    if summary.pressure_maximum.error.is_some() || change <= PRESSURE_RESOLVED || change.is_nan() {
        return None;
    }
    let text = format!(
        "the largest pressure is that of a spike which the mesh does not resolve: {:.3} GPa on the \
         mesh before, {:.3} GPa here; film thickness does not depend on it",
        coarse / 1e9,
        fine / 1e9
    );
    Some(Warning::beyond(WarningKind::Spike, change, text))
}
