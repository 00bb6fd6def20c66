//! Temperatures and heat of a solved stage.

use super::fields::sampled;
use super::summary::comparison_pair;
use super::temperature_field::temperature_field;
use crate::film::Nodal;
use crate::params::ThermalParams;
use crate::post::thermal::cross_film::profile_of;
use crate::post::thermal::temperatures;
use crate::solution::{
    Coupling, Estimate, Figure, FilmTemperatures, HeatBalance, LevelStats, Measured, Role, Thermal,
    ThermalReduction,
};
use crate::solve::bars;
use crate::solve::discretisation::Discretisation;
use crate::solve::heat::balance::heat_balance;
use crate::solve::heat::space::HeatSpace;
use crate::solve::points::{fields_at, fields_in};
use crate::solve::sequence::{Problem, StageSolution};
use crate::solve::system::State;

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
        centreline: temperatures(&space.column.film, &sampled(d, state).fields),
        surface: surface(d, state, space),
        profiles: (params.profiles.iter())
            .filter_map(|point| {
                let body_1 = &heat.bodies[0].velocity;
                profile_of(
                    d.contact.shape.symmetry,
                    |at| fields_at(d, state, at),
                    &problem.fluid,
                    scales,
                    body_1,
                    *point,
                )
            })
            .collect(),
        field: params
            .field
            .then(|| temperature_field(d, state, space, scales)),
    })
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
