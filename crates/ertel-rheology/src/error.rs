//! Errors in the constants of a law.

use thiserror::Error;

/// Constants that no fluid can have.
///
/// `key` is the name of the constant as it is written in a data file, so that a reader of files can point at it.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum LawError {
    /// A constant is NaN or infinite.
    #[error("{law}: {key} = {value} is not a finite number")]
    NotFinite {
        /// Name of the law.
        law: &'static str,
        /// Name of the constant.
        key: &'static str,
        /// Its value in SI.
        value: f64,
    },
    /// A constant lies outside the values for which the law makes sense.
    #[error("{law}: {key} = {value} is impossible: it must be {allowed}")]
    OutOfRange {
        /// Name of the law.
        law: &'static str,
        /// Name of the constant.
        key: &'static str,
        /// Its value in SI.
        value: f64,
        /// The values allowed, in words.
        allowed: &'static str,
    },
    /// A table has the wrong shape or order.
    #[error("{law}: {key}: {problem}")]
    Table {
        /// Name of the law.
        law: &'static str,
        /// Name of the column.
        key: &'static str,
        /// The problem.
        problem: String,
    },
}

impl LawError {
    /// The name of the constant at fault.
    pub fn key(&self) -> &'static str {
        match self {
            Self::NotFinite { key, .. }
            | Self::OutOfRange { key, .. }
            | Self::Table { key, .. } => key,
        }
    }
}

/// Checks the constants of one law.
pub(crate) struct Check(pub(crate) &'static str);

impl Check {
    /// Requires a finite value.
    pub(crate) fn finite(&self, key: &'static str, value: f64) -> Result<(), LawError> {
        if value.is_finite() {
            Ok(())
        } else {
            Err(LawError::NotFinite {
                law: self.0,
                key,
                value,
            })
        }
    }

    /// Requires a finite value with `condition` true.
    pub(crate) fn that(
        &self,
        condition: bool,
        key: &'static str,
        value: f64,
        allowed: &'static str,
    ) -> Result<(), LawError> {
        self.finite(key, value)?;
        if condition {
            Ok(())
        } else {
            Err(LawError::OutOfRange {
                law: self.0,
                key,
                value,
                allowed,
            })
        }
    }

    /// Requires a finite value above zero.
    pub(crate) fn positive(&self, key: &'static str, value: f64) -> Result<(), LawError> {
        self.that(value > 0.0, key, value, "positive")
    }

    /// Requires a stress (Pa) whose square, and that of any stress of a film over it, are far from the ends of floating
    /// point.
    pub(crate) fn stress(&self, key: &'static str, value: f64) -> Result<(), LawError> {
        let allowed = "between 1e-3 Pa and 1e20 Pa";
        self.that((1e-3..=1e20).contains(&value), key, value, allowed)
    }

    /// Requires a finite value that is zero or above.
    pub(crate) fn not_negative(&self, key: &'static str, value: f64) -> Result<(), LawError> {
        self.that(value >= 0.0, key, value, "zero or positive")
    }
}
