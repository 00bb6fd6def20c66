//! Studies of more than one contact.

pub mod curve;

pub use curve::{CurveObserver, CurveSolution, Outcome, PointSolution, solve_curve};
