//! Frictional moments of whole bearings by two models that are fitted to measurements.
//!
//! They are compared with the solved friction of the single contacts: 10 to 30 % between them is good agreement. Differential slip and spin of
//! the contacts are in [`kinematics`](super::kinematics).

mod palmgren;
mod skf;
mod skf_series;

pub use palmgren::{
    PalmgrenFactors, PalmgrenMoment, PalmgrenOil, PalmgrenSeries, palmgren_load, palmgren_moment,
};
pub use skf::{SkfMoment, SkfParams, SkfState, skf_moment};
pub use skf_series::SkfSeries;

/// Why there is no moment.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum Error {
    /// A number that must be positive.
    #[error("{name} is {value}; it must be positive")]
    Positive {
        /// What.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// A number that must not be negative.
    #[error("{name} is {value}; it must not be negative")]
    Negative {
        /// What.
        name: &'static str,
        /// Its value.
        value: f64,
    },
}

fn positive(name: &'static str, value: f64) -> Result<f64, Error> {
    match value > 0.0 && value.is_finite() {
        true => Ok(value),
        false => Err(Error::Positive { name, value }),
    }
}

fn not_negative(name: &'static str, value: f64) -> Result<f64, Error> {
    match value >= 0.0 && value.is_finite() {
        true => Ok(value),
        false => Err(Error::Negative { name, value }),
    }
}
