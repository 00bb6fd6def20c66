//! Heat capacity linear in pressure and temperature.

use crate::Scalar;
use crate::error::{Check, LawError};
use crate::linear::LinearFactor;

/// Heat capacity linear in pressure and temperature:
///
/// ```text
/// c = c₀ [1 + a_T (T - T_R) + a_p p]
/// ```
///
/// A falling line is limited to a tenth of c₀, far from any state that it was fitted to.
///
/// Theory: Conductivity and heat capacity, Linear.
#[derive(Debug, Clone, PartialEq)]
pub struct Linear {
    /// Heat capacity c₀ at ambient pressure and T_R (J/(kg·K)).
    pub c_0: f64,
    /// The bracket.
    pub factor: LinearFactor,
}

impl Linear {
    /// Checks that `c_0` (J/(kg·K)) is positive.
    pub fn new(c_0: f64, factor: LinearFactor) -> Result<Self, LawError> {
        Check("linear").positive("c_0", c_0)?;
        Ok(Self { c_0, factor })
    }

    /// Heat capacity (J/(kg·K)) at `pressure` (Pa above ambient) and `temperature` (K).
    #[inline]
    pub fn heat_capacity<D: Scalar>(&self, pressure: D, temperature: D) -> D {
        self.factor.value(pressure, temperature) * self.c_0
    }
}
