//! Solves a case by finite volumes.

use super::describe::{Found, describe, has_derivatives, note_sensitivities};
use super::recorder::Recorder;
use crate::case::Case;
use crate::engine::{Observer, Problem, SolveError};
use crate::params::{DEFAULT_TARGET_ERROR, MeshPreset, Method};
use crate::post::fields::centreline_of;
use crate::problem::{self, largest_cell};
use crate::sensitivity::by_derivatives;
use crate::solution::{Solution, Stats};
use crate::volumes::film::PatchedFilm;
use crate::volumes::heat::{Params, output};
use crate::volumes::roller_zone::with_rows_by_film;
use crate::volumes::tangents::Tangents;
use crate::volumes::{FiniteVolumes, Plan, fields, other_gap, reduction, summary};
use crate::wear::run_in;

/// Default limit on the unknowns of a refined grid: some seconds.
const MAX_UNKNOWNS: usize = 400_000;

/// Solves a case.
///
/// # Errors
/// As [`super::solve`].
pub(super) fn solve(case: &Case, observer: &mut dyn Observer) -> Result<Solution, SolveError> {
    let mut problem = with_rows_by_film(own_problem(case), observer)?;
    let mut recorder = Recorder {
        observer,
        history: Vec::new(),
    };
    let (solved, worn) = match &case.wear {
        None => (FiniteVolumes.solve(&problem, &mut recorder)?, None),
        Some(params) => {
            let worn = run_in(&mut problem, params, &mut recorder)?;
            (worn.solved, Some((worn.measured, worn.wear)))
        }
    };
    // The same contact, worn as it is.
    let own_problem = |case: &Case| {
        let mut own = own_problem(case);
        own.shape.gap = problem.shape.gap.clone();
        own.plan.inner = problem.plan.inner;
        own
    };
    let cell = (solved.levels.last()).map_or(0.0, |level| level.system.grid.spacing[0]);
    if cell > problem.plan.largest_cell {
        return Err(SolveError::ReliefNotResolved {
            cell,
            needed: problem.plan.largest_cell,
        });
    }
    let stats = Stats {
        method: Method::FiniteVolumes,
        warm: false,
        levels: solved.stats.clone(),
        wall_seconds: 0.0,
        peak_memory: None,
    };
    let isothermal = match &problem.heat {
        None => None,
        Some(_) => {
            let isothermal = own_problem(case);
            output::isothermal(isothermal, solved.levels.len(), recorder.observer)?
        }
    };
    let film_reduction = match (case.shear_thinning(), &isothermal, &problem.heat) {
        (None, ..) | (_, None, Some(_)) => None,
        (Some(_), thinned, _) => {
            let mut newtonian = case.clone();
            newtonian.solver.newtonian = true;
            let mut newtonian = own_problem(&newtonian);
            newtonian.heat = None;
            // On the same grids.
            newtonian.shape.zone = problem.shape.zone.clone();
            let thinned = thinned.as_ref().unwrap_or(&solved);
            reduction::film_reduction(thinned, newtonian, recorder.observer)?
        }
    };
    let is_chosen = (case.asperities.as_ref()).is_none_or(|asperities| asperities.flow_is_chosen);
    let other_gap = match is_chosen {
        true => None,
        false => {
            let mut other = own_problem(case);
            other.shape.zone = problem.shape.zone.clone();
            other_gap::other_gap(&solved, other, recorder.observer)?
        }
    };
    let film = PatchedFilm::new(&problem.shape, &solved.levels);
    let (measured, wear) = worn.unzip();
    let of_grids = solved.measured(&problem);
    let measured = (measured.unwrap_or(of_grids)).with_meniscus(&case.supply);
    let (surface, elements) = fields::surface(&problem, &film);
    let thermal = (case.thermal()).and_then(|params| {
        let isothermal = isothermal.as_ref();
        output::thermal(&problem, &solved, &film, &measured, isothermal, params)
    });
    let found = Found {
        extents: problem.extents,
        summary: summary::summarise(&problem, &solved, &measured),
        film_reduction,
        other_gap,
        thermal,
        centreline: centreline_of(
            &fields::profile(&film),
            &problem.shape,
            problem.friction_fluid(),
            &problem.scales,
        ),
        surface,
        elements,
        body: None,
        warnings: summary::warnings(&problem, &solved, &film, &of_grids),
        measured,
    };
    let mut solution = describe(case, &problem, &film, found, stats, recorder.history);
    solution.wear = wear;
    drop(film);
    if case.wants_sensitivities() {
        let own = problem::problem(case);
        let tangents = Tangents::new(&own, &solved, |figure| {
            has_derivatives(case, &solution, figure)
        });
        let found = by_derivatives(case, &own, &tangents);
        note_sensitivities(&mut solution, case, Ok(found))?;
    }
    Ok(solution)
}

/// A case with cells that resolve its surface relief.
fn own_problem(case: &Case) -> Problem<Plan> {
    let mut problem = problem::problem(case).with_plan(plan(case));
    problem.plan.largest_cell = largest_cell(&problem.shape);
    problem
}

/// Accuracy target and limit of a case.
pub(super) fn plan(case: &Case) -> Plan {
    let mesh = &case.mesh;
    let target = mesh.target_error.unwrap_or(match mesh.preset {
        MeshPreset::Coarse => 5.0 * DEFAULT_TARGET_ERROR,
        MeshPreset::Normal => DEFAULT_TARGET_ERROR,
        MeshPreset::Fine => 0.25 * DEFAULT_TARGET_ERROR,
    });
    let plan = Plan::new(target, mesh.max_unknowns.unwrap_or(MAX_UNKNOWNS));
    match case.thermal() {
        None => plan,
        Some(thermal) => Plan {
            heat: Params {
                depth: thermal.depth,
                tolerance: thermal.tolerance,
                max_rounds: thermal.max_iterations,
                ..Params::default()
            },
            ..plan
        },
    }
}
