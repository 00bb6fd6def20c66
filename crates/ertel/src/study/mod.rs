//! Studies of more than one contact. Points are solved in the order of a plan: those of a curve one after the other, those of
//! a study as a tree.

mod columns;
pub mod curve;
pub mod journal;
pub mod monte_carlo;
pub mod plan;
mod point;
mod sweep;
mod table;
mod walk;

pub use columns::{Cell, Column, columns};
pub use curve::{CurveObserver, CurveSolution, solve_curve, value_text};
pub use point::{Outcome, PointSolution};
pub use sweep::{
    Collector, FILES, FOLDERS, Shard, SweepError, SweepObserver, SweepParams, SweepProgress,
    SweepSummary, finished_points, merge, sweep, sweep_part,
};
pub(crate) use table::ISOTHERMAL;
pub use table::{POINTS, STUDY_FORMAT, StudyEcho, TABLE};
