//! Studies of more than one contact.

pub mod curve;
pub mod journal;
pub mod monte_carlo;
pub mod plan;
mod sweep;
mod table;

pub use curve::{CurveObserver, CurveSolution, Outcome, PointSolution, solve_curve};
pub use sweep::{
    Collector, FILES, FOLDERS, Shard, SweepError, SweepObserver, SweepParams, SweepProgress,
    SweepSummary, finished_points, merge, sweep, sweep_part,
};
pub(crate) use table::ISOTHERMAL;
pub use table::{POINTS, STUDY_FORMAT, StudyEcho, TABLE};
