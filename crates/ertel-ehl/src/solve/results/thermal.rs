//! Temperatures and heat of a solved stage.

use super::fields::sampled;
use super::summary::comparison_pair;
use super::temperature_field::temperature_field;
use crate::film::Nodal;
use crate::params::ThermalParams;
use crate::post::thermal::cross_film::profiles;
use crate::post::thermal::{temperatures, thermal_of};
use crate::solution::{
    Coupling, Estimate, Figure, FilmTemperatures, LevelStats, Measured, Role, Thermal,
    ThermalReduction,
};
use crate::solve::bars;
use crate::solve::discretisation::Discretisation;
use crate::solve::heat::balance::heat_balance;
use crate::solve::heat::space::HeatSpace;
use crate::solve::points::{fields_at, fields_in};
use crate::solve::sequence::{Problem, StageSolution};
use crate::solve::state::State;

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
    let sums = heat_balance(d, state, &problem.fluid, heat, scales);
    Some(Thermal {
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
        profiles: profiles(problem, |at| fields_at(d, state, at), &params.profiles),
        field: params
            .field
            .then(|| temperature_field(d, state, space, scales)),
        ..thermal_of(heat, measured, sums.error())
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
