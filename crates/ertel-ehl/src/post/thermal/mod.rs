//! Temperatures and heat of a solution.
//!
//! - `cross_film`: profiles across the film;
//! - `field`: temperature of the whole film and of both bodies.

pub mod at_rest;
pub mod cross_film;
mod field;

use ertel_rheology::provenance::TemperatureRange;

use crate::contact::{Scales, Symmetry};
use crate::engine::heat::walls;
use crate::film::{FilmNodes, Nodal};
use crate::params::ThermalParams;
use crate::post::summary::comparison_pair;
use crate::solution::Role;
use crate::solution::{
    Coupling, Estimate, Figure, FilmTemperatures, HeatBalance, LevelStats, Located, Measured,
    Thermal, ThermalReduction,
};
use crate::solve::bars;
use crate::solve::discretisation::Discretisation;
use crate::solve::heat::balance::heat_balance;
use crate::solve::heat::space::HeatSpace;
use crate::solve::points::fields_in;
use crate::solve::sequence::{Problem, StageSolution};
use crate::solve::system::State;
use crate::warning::{Warning, WarningKind};

/// Temperatures and heat; `None` for an isothermal solution.
pub fn thermal(
    solution: &StageSolution,
    problem: &Problem,
    levels: &[LevelStats],
    measured: &Measured,
    params: &ThermalParams,
) -> Option<Thermal> {
    let (d, state) = (&solution.discretisation, &solution.state);
    let (space, heat) = (d.heat.as_ref()?, problem.heat.as_ref()?);
    let stats = solution.coupling.unwrap_or_default();
    let scales = &problem.scales;
    let balance = heat_balance(d, state, &problem.fluid, heat, scales);
    Some(Thermal {
        inlet_temperature: heat.inlet_temperature,
        film_maximum: measured.located(Figure::FilmTemperatureMaximum),
        film_lowest: measured.located(Figure::FilmTemperatureLowest),
        film_mean: measured.estimate(Figure::FilmTemperatureMean),
        body_1_maximum: measured.located(Figure::TemperatureBody1Maximum),
        body_1_mean: measured.estimate(Figure::TemperatureBody1Mean),
        body_2_maximum: measured.located(Figure::TemperatureBody2Maximum),
        body_2_mean: measured.estimate(Figure::TemperatureBody2Mean),
        balance: HeatBalance {
            shear: measured.estimate(Figure::HeatShear),
            compression: measured.estimate(Figure::HeatCompression),
            to_body_1: measured.estimate(Figure::HeatToBody1),
            to_body_2: measured.estimate(Figure::HeatToBody2),
            by_film: measured.estimate(Figure::HeatByFilm),
            error: balance.error,
        },
        reduction: reduction(levels, measured, problem.fluid.slides()),
        coupling: Coupling {
            rounds: stats.rounds,
            contraction: stats.contraction,
            change: stats.change,
            tolerance: stats.tolerance,
            n_temperatures: space.n(),
            iterations: stats.heat.iterations,
            krylov_iterations: stats.heat.krylov_iterations,
        },
        centreline: centreline(d, state, space),
        surface: surface(d, state, space),
        profiles: (params.profiles.iter())
            .filter_map(|point| {
                let body_1 = &heat.bodies[0].velocity;
                cross_film::profile(d, state, &problem.fluid, scales, body_1, *point)
            })
            .collect(),
        field: params.field.then(|| field::field(d, state, space, scales)),
    })
}

/// Excess over the range of the data, K, that is not reported: it is within the accuracy of the laws.
const BEYOND: f64 = 1.0;

/// A place in half-widths; where a half was solved, its mirror image has the same.
fn place([x, y]: [f64; 2], symmetry: Symmetry) -> String {
    // No minus zero.
    let rounded = |v: f64| format!("{:.2}", (100.0 * v).round() / 100.0 + 0.0);
    let x = rounded(x);
    match symmetry {
        _ if y == 0.0 => format!("x/a {x}"),
        Symmetry::Half => format!("x/a {x}, y/a ±{}", rounded(y.abs())),
        Symmetry::Full => format!("x/a {x}, y/a {}", rounded(y)),
    }
}

/// Warnings: temperatures that the data of the lubricant do not cover, points without film.
pub fn warnings(
    thermal: &Thermal,
    ranges: &[TemperatureRange],
    params: &ThermalParams,
    scales: &Scales,
    symmetry: Symmetry,
    extents: [f64; 3],
) -> Vec<Warning> {
    let mut warnings = Vec::new();
    let a = scales.length;
    let place = |at: &Located| place([at.x / a, at.y / a], symmetry);
    for (kind, verb, extreme) in [
        (WarningKind::HottestFilm, "reaches", &thermal.film_maximum),
        (WarningKind::ColdestFilm, "falls to", &thermal.film_lowest),
    ] {
        let temperature = extreme.value;
        // An inlet outside the range is reported with the case.
        let known = TemperatureRange::left(ranges, thermal.inlet_temperature);
        let range = TemperatureRange::left(ranges, temperature).filter(|range| {
            known != Some(*range)
                && (temperature > range.highest + BEYOND || temperature < range.lowest - BEYOND)
        });
        let Some(range) = range else {
            continue;
        };
        let text = format!(
            "the temperature of the film {verb} {:.1} °C at {}; the data of the lubricant are valid {range} ({})",
            temperature - 273.15,
            place(extreme),
            range.basis
        );
        let excess = (temperature - range.highest).max(range.lowest - temperature);
        warnings.push(Warning::beyond(kind, excess, text));
    }
    let [inlet, outlet, side] = extents;
    for [x, y] in &params.profiles {
        if !((inlet..=outlet).contains(x) && y.abs() <= side) {
            let text = format!(
                "no profile across the film at [{x}, {y}] ([thermal] profiles): the contact area extends from {inlet} to \
                 {outlet} along the motion, and to ±{side} across it"
            );
            warnings.push(Warning::new(WarningKind::NoEffect, text));
        }
    }
    warnings
}

/// Films and tractions with and without heat, where both were found on the same mesh; traction only where the
/// surfaces slide.
fn reduction(levels: &[LevelStats], measured: &Measured, slides: bool) -> Option<ThermalReduction> {
    let [thermal, isothermal] = comparison_pair(levels, Role::Isothermal)?;
    let of = |figure| bars::reduction(figure, thermal, isothermal, measured);
    let isothermal_traction = isothermal.figures.value(Figure::TractionCoefficient)?;
    let relative = bars::relative_error_on(thermal, Figure::TractionCoefficient, measured);
    Some(ThermalReduction {
        film_central: of(Figure::FilmCentral)?,
        film_minimum: of(Figure::FilmMinimum)?,
        traction: of(Figure::TractionCoefficient).filter(|_| slides),
        // The mesh error is much the same as that of the thermal film.
        isothermal_traction: Estimate {
            value: isothermal_traction,
            error: relative.map(|relative| relative * isothermal_traction.abs()),
        },
    })
}

/// Temperatures at the points of the centreline.
fn centreline(d: &Discretisation, state: &State, space: &HeatSpace) -> FilmTemperatures {
    let profile = super::fields::sampled(d, state);
    let mut temperatures = FilmTemperatures::default();
    for fields in &profile.fields {
        if let Some(profile) = &fields.temperature {
            temperatures.push(&space.column.film, &profile.temperature);
        }
    }
    temperatures
}

/// Temperatures at the pressure nodes.
fn surface(d: &Discretisation, state: &State, space: &HeatSpace) -> FilmTemperatures {
    let element = &d.pressure.element;
    let order = element.order() as f64;
    let mut values = vec![Nodal::default(); d.pressure.n_nodes()];
    for c in 0..d.contact.n_elements() {
        for (alpha, node) in element.lattice().iter().zip(d.pressure.nodes_of(c)) {
            let xi = [
                f64::from(alpha[1]) / order,
                f64::from(alpha[2]) / order,
                0.0,
            ];
            if let Some(profile) = fields_in(d, state, c, xi).temperature {
                values[*node as usize] = profile.temperature;
            }
        }
    }
    let mut temperatures = FilmTemperatures::default();
    for values in &values {
        temperatures.push(&space.column.film, values);
    }
    temperatures
}

impl FilmTemperatures {
    /// Adds a point from the temperatures at the film's nodes.
    pub(crate) fn push(&mut self, film: &FilmNodes, values: &Nodal) {
        let [body_1, body_2] = walls(film, values);
        self.mid.push(film.through(values).at(0.0));
        self.mean.push(film.mean(values));
        self.body_1.push(body_1);
        self.body_2.push(body_2);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of a contact that was solved as a whole, the mirror image of a place is another place.
    #[test]
    fn places_have_an_image_only_in_symmetric_contacts() {
        let at = |y, symmetry| place([-0.001, y], symmetry);
        assert_eq!(at(-0.306, Symmetry::Half), "x/a 0.00, y/a ±0.31");
        assert_eq!(at(-0.306, Symmetry::Full), "x/a 0.00, y/a -0.31");
        assert_eq!(at(0.306, Symmetry::Full), "x/a 0.00, y/a 0.31");
        assert_eq!(at(0.0, Symmetry::Full), "x/a 0.00");
    }
}
