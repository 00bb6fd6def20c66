//! The conductivity law of Larsson and Andersson.

use crate::Scalar;
use crate::error::{Check, LawError};

/// Conductivity of lubricants after Larsson and Andersson (Proc. IMechE J 214, 2000, 337-342):
///
/// ```text
/// k = k₀ [1 + d₁ p / (1 + d₂ p)]
/// ```
///
/// Temperature has no influence.
///
/// Theory: Larsson and Andersson.
#[derive(Debug, Clone, PartialEq)]
pub struct LarssonAndersson {
    /// Conductivity k₀ at ambient pressure (W/(m·K)).
    pub k_0: f64,
    /// Initial relative slope d₁ (1/Pa).
    pub d_1: f64,
    /// Coefficient d₂ by which the growth saturates (1/Pa).
    pub d_2: f64,
}

impl LarssonAndersson {
    /// `k_0` in W/(m·K), positive; `d_1` and `d_2` in 1/Pa, zero or positive.
    pub fn new(k_0: f64, d_1: f64, d_2: f64) -> Result<Self, LawError> {
        let check = Check("larsson-andersson");
        check.positive("k_0", k_0)?;
        check.not_negative("d_1", d_1)?;
        check.not_negative("d_2", d_2)?;
        Ok(Self { k_0, d_1, d_2 })
    }

    /// Conductivity (W/(m·K)) at `pressure` (Pa above ambient); the law continues with its ambient value below p = 0.
    #[inline]
    pub fn conductivity<D: Scalar>(&self, pressure: D) -> D {
        if pressure.re() < 0.0 {
            return D::from(self.k_0);
        }
        (pressure * self.d_1 / (pressure * self.d_2 + 1.0) + 1.0) * self.k_0
    }
}
