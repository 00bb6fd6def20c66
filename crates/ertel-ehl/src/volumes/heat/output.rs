//! Temperatures and heat of a solve for results, SI.

use super::figures::sums;
use crate::engine::{Film, Observer, Problem, SolveError};
use crate::params::ThermalParams;
use crate::post::thermal::cross_film::profiles;
use crate::post::thermal::{temperatures, thermal_of};
use crate::solution::{Coupling, Estimate, Figure, Measured, Thermal, ThermalReduction};
use crate::volumes::engine::{FiniteVolumes, Volumes};
use crate::volumes::fields::{nodes, profile};
use crate::volumes::figures::{Slowest, bar};
use crate::volumes::film::PatchedFilm;
use crate::volumes::plan::Plan;
use crate::volumes::reduction::on_grids;

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
        profiles: profiles(problem, |at| film.at(at), &params.profiles),
        ..thermal_of(heat, measured, sums(problem, &volumes.levels).error())
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
    let of = |figure| on_grids(figure, volumes, isothermal);
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
