//! A run in time from outside: step control, instants, their observer, and reasons to stop.

use super::checkpoint::{Checkpoint, Info, OtherGrids};
use crate::engine::{Observer, Problem, SolveError};
use crate::solution::Measured;
use crate::volumes::Plan;
use crate::volumes::level::Level;

/// Step control.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Params {
    /// Relative error of the films that the steps may make in all.
    pub tolerance: f64,
    /// Largest step in T, over the speed at which the surfaces move then.
    pub largest_step: f64,
    /// The same where something arrives at the contact that the error estimate cannot see in advance: a relief, a layer of oil, a cavity.
    pub largest_step_of_arrivals: f64,
    /// Smallest step in T.
    pub smallest_step: f64,
    /// Steps at most.
    pub most_steps: usize,
}

impl Default for Params {
    fn default() -> Params {
        Params {
            tolerance: 3e-3,
            largest_step: 20.0,
            largest_step_of_arrivals: 0.5,
            smallest_step: 1e-8,
            most_steps: 1_000_000,
        }
    }
}

/// A contact at an instant.
pub struct Instant<'a> {
    /// T.
    pub time: f64,
    /// Velocities of body 1 and body 2 over that of reference.
    pub speeds: [f64; 2],
    /// Load over that of reference.
    pub load: f64,
    /// Approach of the bodies since the start, in a²/R.
    pub approach: f64,
    /// Its rate over T.
    pub approach_velocity: f64,
    /// Force of the film over the load of reference.
    pub film_force: f64,
    /// Figures, SI, with error bars for grids and steps.
    pub measured: Measured,
    /// Length of the step that led here, 0 at the start.
    pub step: f64,
    /// Newton iterations on all grids that it took.
    pub newton_iterations: usize,
    /// Mass gained on the finest grid, over the flow through the centre at the reference speed.
    pub mass_error: f64,
    /// Whether it is a requested output time.
    pub is_asked: bool,
    /// The contact as it is, in the scales of its speed.
    pub problem: &'a Problem<Plan>,
    /// Its grids.
    pub levels: &'a [Level],
}

/// Follows a contact through time.
pub trait TransientObserver: Send + Sync {
    /// An instant is solved.
    fn instant(&mut self, instant: &Instant<'_>);

    /// Observer of the solve of the steady start.
    fn start(&mut self) -> &mut dyn Observer;

    /// Whether the user wants to stop.
    fn cancelled(&self) -> bool {
        false
    }

    /// Whether a checkpoint is wanted at this instant.
    fn wants_checkpoint(&self) -> bool {
        false
    }

    /// Called after a step for which it was wanted, and where the user stops the run, also within a step.
    fn checkpoint(&mut self, _checkpoint: Checkpoint) {}
}

/// Reasons for which a run stops.
#[derive(Debug, thiserror::Error)]
pub enum TransientError {
    /// No steady contact to begin with.
    #[error("the steady contact at the start: {0}")]
    Start(SolveError),
    /// The checkpoint is not one of this case.
    #[error(transparent)]
    OtherGrids(#[from] OtherGrids),
    /// The observer asked to stop.
    #[error("interrupted")]
    Interrupted,
    /// The grids do not resolve a relief.
    #[error(
        "the shortest length of a relief needs cells of {needed:.1e} half-widths, and [mesh] max_unknowns allows {cell:.1e}"
    )]
    Coarse {
        /// Cell of the finest grid, in half-widths.
        cell: f64,
        /// Cell that resolves it.
        needed: f64,
    },
    /// The time step became too small.
    #[error(
        "the time step became too small at {:.4e} s of {:.4e} s: the last one tried was {:.1e} s long, after {} steps",
        time * unit, duration * unit, step * unit, info.steps
    )]
    Stuck {
        /// T reached.
        time: f64,
        /// T requested.
        duration: f64,
        /// The last step tried.
        step: f64,
        /// Seconds in T.
        unit: f64,
        /// Statistics so far.
        info: Info,
    },
}

impl From<SolveError> for TransientError {
    fn from(error: SolveError) -> TransientError {
        match error {
            SolveError::Interrupted => TransientError::Interrupted,
            error => TransientError::Start(error),
        }
    }
}

impl TransientError {
    /// A remedy to suggest to the user.
    pub fn advice(&self) -> Option<&'static str> {
        match self {
            // Time is solved by finite volumes alone.
            TransientError::Start(SolveError::GridNotConverged {
                has_reliefs: false, ..
            }) => Some("a start with a thicker film: a higher speed or less load at t = 0"),
            TransientError::Start(error) => error.advice(),
            TransientError::Coarse { .. } => Some("a larger [mesh] max_unknowns"),
            TransientError::Stuck { .. } => {
                Some("a larger `tolerance`, or changes that are slower or smaller")
            }
            TransientError::OtherGrids(_) | TransientError::Interrupted => None,
        }
    }

    /// Statistics of the steps until then, if there were any.
    pub fn info(&self) -> Option<Info> {
        match self {
            TransientError::Stuck { info, .. } => Some(*info),
            _ => None,
        }
    }
}
