//! Thermal conductivity linear in pressure and temperature.

use crate::Scalar;
use crate::error::{Check, LawError};
use crate::linear::LinearFactor;

/// Conductivity linear in pressure and temperature:
///
/// ```text
/// k = k₀ [1 + a_T (T - T_R) + a_p p]
/// ```
///
/// A falling line is limited to a tenth of k₀, far from any state that it was fitted to.
///
/// Theory: Conductivity and heat capacity, Linear.
#[derive(Debug, Clone, PartialEq)]
pub struct Linear {
    /// Conductivity k₀ at ambient pressure and T_R (W/(m·K)).
    pub k_0: f64,
    /// The bracket.
    pub factor: LinearFactor,
}

impl Linear {
    /// Checks that `k_0` (W/(m·K)) is positive.
    pub fn new(k_0: f64, factor: LinearFactor) -> Result<Self, LawError> {
        Check("linear").positive("k_0", k_0)?;
        Ok(Self { k_0, factor })
    }

    /// Conductivity (W/(m·K)) at `pressure` (Pa above ambient) and `temperature` (K).
    #[inline]
    pub fn conductivity<D: Scalar>(&self, pressure: D, temperature: D) -> D {
        self.factor.value(pressure, temperature) * self.k_0
    }
}
