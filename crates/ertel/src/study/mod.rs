//! Studies of more than one contact. Points are solved in the order of a plan: those of a curve one after the other, those of
//! a study as a tree.

mod columns;
pub mod curve;
mod error;
pub mod journal;
mod machine;
pub mod monte_carlo;
pub mod plan;
pub(crate) mod point;
pub(crate) mod table;
mod unresolved;
pub(crate) mod walk;

pub use crate::point::{MachinePoint, MachineSolution, Outcome, PointSolution, RunInTime};
pub use columns::{Cell, Column, columns, point_fields};
pub(crate) use columns::{joint_titles, titled};
pub(crate) use curve::RPM;
pub use curve::{CurveObserver, CurveSolution, solve_curve, value_text};
pub use error::StudyError;
use machine::MachineObserver;
pub(crate) use machine::cores;
pub use machine::{solve_in_balance, solve_machine};
pub(crate) use table::ISOTHERMAL;
pub use table::{POINTS, STUDY_FORMAT, StudyEcho, TABLE};
pub use unresolved::UnresolvedFigures;
