//! Temperatures and heat of a solve for results, SI.

use super::figures::balance;
use crate::engine::{Film, Observer, Problem, SolveError};
use crate::params::ThermalParams;
use crate::post::thermal::cross_film::profile_of;
use crate::post::thermal::temperatures;
use crate::solution::{
    Coupling, Estimate, Figure, HeatBalance, Measured, Thermal, ThermalReduction,
};
use crate::volumes::engine::{FiniteVolumes, Plan, Volumes};
use crate::volumes::fields::{nodes, profile};
use crate::volumes::figures::{Slowest, bar};
use crate::volumes::film::PatchedFilm;

/// Temperatures and heat; `None` for an isothermal solution.
pub fn thermal(
    problem: &Problem<Plan>,
    volumes: &Volumes,
    film: &PatchedFilm,
    measured: &Measured,
    isothermal: Option<&Volumes>,
    params: &ThermalParams,
) -> Option<Thermal> {
    let finest = volumes.levels.last()?;
    let (warm, heat) = (finest.warm.as_ref()?, problem.heat.as_ref()?);
    let film_nodes = problem.fluid.nodes()?;
    let effort = &warm.effort;
    let of_line = profile(film);
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
            error: balance(problem, &volumes.levels).error(),
        },
        reduction: isothermal.and_then(|cold| reduction(problem, volumes, cold)),
        coupling: Coupling {
            rounds: effort.rounds,
            contraction: effort.contraction,
            change: effort.change,
            tolerance: (problem.plan.heat).in_force(problem.plan.target_error),
            n_temperatures: warm.temperatures.film.len(),
            iterations: effort.iterations,
            krylov_iterations: effort.krylov_iterations,
        },
        centreline: temperatures(film_nodes, &of_line.fields),
        surface: temperatures(film_nodes, &nodes(&problem.shape, film)),
        profiles: (params.profiles.iter())
            .filter_map(|point| {
                let body_1 = &heat.bodies[0].velocity;
                let fields = |at| film.at(at);
                let symmetry = problem.shape.symmetry;
                profile_of(
                    symmetry,
                    fields,
                    &problem.fluid,
                    &problem.scales,
                    body_1,
                    *point,
                )
            })
            .collect(),
        field: None,
    })
}

/// The same contact without heat, on all grids but the finest one; `None` where that is not solved.
///
/// # Errors
/// When the observer cancels.
pub fn isothermal(
    mut problem: Problem<Plan>,
    grids: usize,
    observer: &mut dyn Observer,
) -> Result<Option<Volumes>, SolveError> {
    problem.heat = None;
    problem.plan.most_grids = grids.saturating_sub(1).max(LEAST);
    // All of these grids.
    problem.plan.target_error = 0.0;
    match FiniteVolumes.solve(&problem, observer) {
        Err(SolveError::Interrupted) => Err(SolveError::Interrupted),
        end => Ok(end.ok()),
    }
}

/// Fewest grids on which films are compared.
const LEAST: usize = 4;

/// Effect of heat on films and traction, grid by grid.
fn reduction(
    problem: &Problem<Plan>,
    volumes: &Volumes,
    isothermal: &Volumes,
) -> Option<ThermalReduction> {
    let last = (isothermal.stats.len().min(volumes.stats.len())).checked_sub(1)?;
    let of = |figure| -> Option<Estimate> {
        let on_grid = |l: usize| {
            let [warm, cold] =
                [volumes, isothermal].map(|of| of.stats.get(l)?.figures.value(figure));
            Some(1.0 - warm? / cold?)
        };
        let values = [0, 1, 2].map(|back| on_grid(last.checked_sub(back)?));
        Some(Estimate {
            value: values[0]?,
            error: bar(values, false, Slowest::of(figure)),
        })
    };
    let traction = |back: usize| {
        let stats = isothermal.stats.get(last.checked_sub(back)?)?;
        stats.figures.value(Figure::TractionCoefficient)
    };
    Some(ThermalReduction {
        film_central: of(Figure::FilmCentral)?,
        film_minimum: of(Figure::FilmMinimum)?,
        traction: of(Figure::TractionCoefficient).filter(|_| problem.fluid.slides()),
        isothermal_traction: Estimate {
            value: traction(0)?,
            error: bar(
                [traction(0), traction(1), traction(2)],
                false,
                Slowest::of(Figure::TractionCoefficient),
            ),
        },
    })
}
