//! Finite elements as an [`Engine`].

use super::figures::measure;
use super::points::Evaluated;
use super::sequence::{Plan, Problem, StageSolution, Start, solve_stages, solve_warm};
use crate::engine::{Engine, Film, Observer, SolveError, Solved};
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

impl Finished {
    fn of((finest, levels): (StageSolution, Vec<LevelStats>)) -> Finished {
        Finished { finest, levels }
    }
}

impl Engine for FiniteElements {
    type Plan = Plan;
    type Solution = Finished;
    type Start = Start;
    type Error = SolveError;

    fn solve(
        &self,
        problem: &Problem,
        observer: &mut dyn Observer,
    ) -> Result<Finished, SolveError> {
        solve_stages(problem, observer).map(Finished::of)
    }

    fn solve_from(
        &self,
        problem: &Problem,
        start: &Start,
        observer: &mut dyn Observer,
    ) -> Result<Option<Finished>, SolveError> {
        Ok(solve_warm(problem, start, observer)?.map(Finished::of))
    }
}

impl Solved for Finished {
    type Plan = Plan;

    fn film(&self, problem: &Problem) -> impl Film {
        let (d, state) = (&self.finest.discretisation, &self.finest.state);
        Evaluated::new(&problem.shape, &problem.entrainment, d, state)
    }

    fn measured(&self, problem: &Problem) -> Measured {
        measure(problem, &self.finest, &self.levels)
    }

    fn levels(&self) -> &[LevelStats] {
        &self.levels
    }
}
