//! Solver of a stage: interface of the driver.

use crate::engine::{Observer, SolveError};
use crate::solve::adapt::Refinement;
use crate::solve::sequence::stage::Stage;

/// Solver of a stage.
pub(in super::super) trait StageSolver {
    /// Solution of a stage.
    type Solution: Trial;

    /// Solves a stage, and says how to refine its mesh if the errors are too large.
    ///
    /// # Errors
    /// Where the stage cannot start. Failure of Newton's method is an outcome, not an error.
    fn solve(
        &mut self,
        task: Task<Self::Solution>,
        observer: &mut dyn Observer,
    ) -> Result<StageEnd<Self::Solution>, SolveError>;

    /// Brings a solution that was only measured to the tolerance of the case, or marks it as rough.
    ///
    /// # Errors
    /// Only [`SolveError::Interrupted`].
    fn finish(
        &mut self,
        solution: &mut Self::Solution,
        observer: &mut dyn Observer,
    ) -> Result<(), SolveError>;
}

/// Properties of a stage's solution that the driver uses.
pub(in super::super) trait Trial: Clone {
    /// The stage.
    fn stage(&self) -> &Stage;
    /// Whether it reached the tolerance of the stage.
    fn converged(&self) -> bool;
    /// Whether an unconverged state is still near a contact.
    fn is_usable(&self) -> bool;
}

/// A stage to solve.
pub(in super::super) struct Task<'a, S> {
    pub stage: &'a Stage,
    /// Where it starts, unless from the dry contact.
    pub from: Option<&'a S>,
    /// Halvings of each element of the mesh before that make its own, where it is a refined one.
    pub halvings: &'a [u32],
    /// Stages known to come after it.
    pub stages_to_come: usize,
}

/// How a stage ended.
pub(in super::super) struct StageEnd<S> {
    /// How to refine its mesh, if errors are too large; or why it is not solved.
    pub outcome: Result<Option<Refinement>, SolveError>,
    pub solution: S,
}
