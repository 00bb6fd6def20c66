//! Why there is no rating or life.

use ertel_ehl::words::digits;

/// A range in words.
fn range(low: f64, high: f64) -> String {
    match (low == f64::NEG_INFINITY, high == f64::INFINITY) {
        (_, true) => format!("{} and more", digits(low, 4)),
        (true, _) => format!("{} and less", digits(high, 4)),
        _ => format!("{} to {}", digits(low, 4), digits(high, 4)),
    }
}

/// Why there is no rating or life.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum Error {
    /// Outside of a standard's table or range, which is not extrapolated.
    #[error("{name} is {}; the standard covers {}", digits(*.value, 4), range(*.low, *.high))]
    Range {
        /// What.
        name: &'static str,
        /// Its value.
        value: f64,
        /// First value covered.
        low: f64,
        /// Last value covered.
        high: f64,
    },
    /// A number that must be positive.
    #[error("{name} is {value}; it must be positive")]
    Positive {
        /// What.
        name: &'static str,
        /// Its value.
        value: f64,
    },
}

pub(crate) fn positive(name: &'static str, value: f64) -> Result<f64, Error> {
    match value > 0.0 && value.is_finite() {
        true => Ok(value),
        false => Err(Error::Positive { name, value }),
    }
}
