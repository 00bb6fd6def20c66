//! From the solution of one problem to that of a similar one.

use super::meshes::{discretised, solve_from};
use super::stage_run::StageRun;
use super::start::interpolate;
use super::{Problem, StageSolution};
use crate::engine::{Observer, SolveError};
use crate::solution::LevelStats;
use crate::solve::evaluate::{central_film, minimum_film};
use crate::solve::newton_level::NewtonStats;
use crate::solve::tuning::stages::{FARTHEST_FILM, LEAST_FILM};

/// A solution from which a similar problem can start.
pub struct Start {
    solution: StageSolution,
    /// Start film of its problem, from which the film of the next one is predicted.
    film: f64,
}

impl Start {
    /// A start from the solution of a problem.
    pub fn new(problem: &Problem, solution: StageSolution) -> Start {
        Start {
            solution,
            film: problem.start_film,
        }
    }

    /// The solution that it starts from.
    pub fn solution(&self) -> &StageSolution {
        &self.solution
    }

    /// Whether a problem has a contact of the same kind and a film that is not far off.
    pub fn suits(&self, problem: &Problem) -> bool {
        let ratio = problem.start_film / self.film;
        let contact = &self.solution.discretisation.contact;
        contact.shape.is_like(&problem.shape)
            && (1.0 / FARTHEST_FILM..=FARTHEST_FILM).contains(&ratio)
    }

    /// Its pressures, with a film as predicted for the problem.
    fn rescaled(&self, problem: &Problem) -> StageSolution {
        let mut start = self.solution.clone();
        let d = &start.discretisation;
        let ratio = problem.start_film / self.film;
        let [centre, thinnest] = [
            central_film(d, &start.state),
            minimum_film(d, &start.state).0,
        ];
        let higher = (ratio - 1.0) * centre;
        // Of the thinnest film a share stays.
        let least = LEAST_FILM * ratio * thinnest - thinnest;
        start.state.rigid_separation += higher.max(least);
        start
    }
}

/// Solves a problem from a start that suits it, on its meshes. `None` where Newton's method does not converge from there.
///
/// # Errors
/// Only [`SolveError::Interrupted`].
pub fn solve_warm(
    problem: &Problem,
    start: &Start,
    observer: &mut dyn Observer,
) -> Result<Option<(StageSolution, Vec<LevelStats>)>, SolveError> {
    unless_failed(solve_from(problem, start.rescaled(problem), observer))
}

/// Solves a problem on the mesh of a start, whatever its own mesh would be: for differences that no change of the mesh should blur. `None`
/// where Newton's method does not converge or the shape in half-widths is another one.
///
/// # Errors
/// Only [`SolveError::Interrupted`].
pub fn solve_on_mesh(
    problem: &Problem,
    start: &Start,
    observer: &mut dyn Observer,
) -> Result<Option<StageSolution>, SolveError> {
    let own = &start.solution;
    let contact = &own.discretisation.contact;
    let last = problem.plan.stages.last();
    let Some(last) = last.filter(|_| contact.shape.is_like(&problem.shape)) else {
        return Ok(None);
    };
    let mut stage = *last;
    (stage.sizes, stage.halvings) = (own.stage.sizes, own.stage.halvings);
    let contact = match contact.shape.inlet == problem.shape.inlet {
        true => contact.clone(),
        false => contact.with_inlet(problem.shape.inlet).into(),
    };
    let d = discretised(problem, &stage, &contact);
    let mut state = interpolate(&start.rescaled(problem), &d);
    let run = StageRun::new(problem, &stage, 0, &d);
    let end = run.solve(&mut state, &mut NewtonStats::default(), observer);
    Ok(
        unless_failed(end)?.map(|(reached, coupling)| StageSolution {
            discretisation: d,
            state,
            stage,
            reached,
            mesh_end: None,
            coupling,
        }),
    )
}

/// The value of a solve, if any.
fn unless_failed<T>(end: Result<T, SolveError>) -> Result<Option<T>, SolveError> {
    match end {
        Err(SolveError::Interrupted) => Err(SolveError::Interrupted),
        end => Ok(end.ok()),
    }
}
