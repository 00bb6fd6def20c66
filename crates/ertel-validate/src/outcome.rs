//! Runs of a study, and what comes of them.

use super::Deflection;
use ertel::case::Case;
use ertel::run::transient::TransientSolution;
use ertel::solution::Solution;
use ertel::study::CurveSolution;

/// Computation from a case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Task {
    /// Film and pressure.
    Solve,
    /// Deflection under the Hertz pressure.
    Deflect,
    /// The points of the case's curve, each from the last.
    Curve,
    /// The contact over time, by the case's `[transient]`.
    Transient,
}

/// One computation of a study.
#[derive(Clone, Debug)]
pub struct Run {
    /// Name within the study.
    pub name: String,
    /// The case, changes of the run included.
    pub case: Case,
    /// The computation.
    pub task: Task,
    /// Takes seconds: part of the quick selection.
    pub quick: bool,
    /// Newton iterations that a cold start is known to take.
    pub newton_iterations: Option<usize>,
}

/// Which runs are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Selection {
    /// All of them.
    All,
    /// Those that take seconds.
    Quick,
}

/// Result of a run.
#[derive(Debug)]
pub enum Outcome {
    /// A solution.
    Solved(Box<Solution>),
    /// A deflection.
    Deflected(Deflection),
    /// The points of a curve; those that failed show in the rows.
    Curve(CurveSolution),
    /// Instants up to the end.
    Transient(Box<TransientSolution>),
    /// An error message.
    Failed(String),
    /// Not selected.
    Skipped,
}
