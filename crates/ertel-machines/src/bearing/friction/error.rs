//! Why there is no moment.

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

pub(super) fn positive(name: &'static str, value: f64) -> Result<f64, Error> {
    match value > 0.0 && value.is_finite() {
        true => Ok(value),
        false => Err(Error::Positive { name, value }),
    }
}

pub(super) fn not_negative(name: &'static str, value: f64) -> Result<f64, Error> {
    match value >= 0.0 && value.is_finite() {
        true => Ok(value),
        false => Err(Error::Negative { name, value }),
    }
}
