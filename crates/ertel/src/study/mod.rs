//! Studies of more than one contact.

pub mod curve;
pub mod journal;
pub mod monte_carlo;
pub mod plan;
mod sweep;
mod table;

pub use curve::{CurveObserver, CurveSolution, Outcome, PointSolution, solve_curve};
pub use sweep::{
    FILES, FOLDERS, Shard, SweepError, SweepObserver, SweepParams, SweepProgress, SweepSummary,
    finished_points, merge, sweep,
};
pub(crate) use table::ISOTHERMAL;
pub use table::{POINTS, STUDY_FORMAT, StudyEcho, TABLE};
