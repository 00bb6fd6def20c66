//! Solves a problem by finite elements.

use super::evaluated::Evaluated;
use super::figures::measure;
use super::sequence::{Problem, StageSolution, Start, solve_stages, solve_warm};
use crate::engine::{Film, Observer, SolveError};
use crate::solution::{LevelStats, Measured};

/// Stages of meshes from coarse to fine, Newton's method on each.
#[derive(Clone, Copy, Debug, Default)]
pub struct FiniteElements;

/// Result of finite elements.
pub struct Finished {
    /// The last stage.
    pub finest: StageSolution,
    /// Effort and figures of each stage.
    pub levels: Vec<LevelStats>,
}

impl FiniteElements {
    /// Solves a problem from the dry contact.
    ///
    /// # Errors
    /// When it does not converge, cannot be discretised, or the user wants to stop.
    pub fn solve(
        self,
        problem: &Problem,
        observer: &mut dyn Observer,
    ) -> Result<Finished, SolveError> {
        solve_stages(problem, observer).map(Finished::of)
    }

    /// Solves a problem from the solution of a similar one; `None` where it does not converge from there.
    ///
    /// # Errors
    /// When the user wants to stop.
    pub fn solve_from(
        self,
        problem: &Problem,
        start: &Start,
        observer: &mut dyn Observer,
    ) -> Result<Option<Finished>, SolveError> {
        Ok(solve_warm(problem, start, observer)?.map(Finished::of))
    }
}

impl Finished {
    /// The film, for post-processing.
    pub fn film(&self, problem: &Problem) -> impl Film {
        let (d, state) = (&self.finest.discretisation, &self.finest.state);
        Evaluated::new(&problem.shape, &problem.entrainment, d, state)
    }

    /// Figures with error bars, SI.
    pub fn measured(&self, problem: &Problem) -> Measured {
        measure(problem, &self.finest, &self.levels)
    }

    fn of((finest, levels): (StageSolution, Vec<LevelStats>)) -> Finished {
        Finished { finest, levels }
    }
}
