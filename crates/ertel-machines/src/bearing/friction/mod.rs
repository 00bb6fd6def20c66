//! Frictional moments of whole bearings by two models that are fitted to measurements.
//!
//! They are compared with the solved friction of the single contacts: 10 to 30 % between them is good agreement. Differential slip and spin of
//! the contacts are in [`kinematics`](super::kinematics).

mod error;
mod palmgren;
mod skf;
mod skf_series;

pub use error::Error;
pub use palmgren::{PalmgrenFactors, PalmgrenMoment, PalmgrenOil, palmgren_load, palmgren_moment};
pub use skf::{SkfMoment, SkfParams, skf_moment};
pub use skf_series::SkfState;
