//! Constant thermal conductivity.

use crate::Scalar;
use crate::error::{Check, LawError};

/// A thermal conductivity that does not change: `k = k₀`.
///
/// Theory: Conductivity and heat capacity, Constant.
#[derive(Debug, Clone, PartialEq)]
pub struct Constant {
    /// Conductivity k₀ (W/(m·K)).
    pub k_0: f64,
}

impl Constant {
    /// Checks that `k_0` (W/(m·K)) is positive.
    pub fn new(k_0: f64) -> Result<Self, LawError> {
        Check("constant").positive("k_0", k_0)?;
        Ok(Self { k_0 })
    }

    /// Conductivity (W/(m·K)); pressure and temperature have no influence.
    #[inline]
    pub fn conductivity<D: Scalar>(&self, _pressure: D, _temperature: D) -> D {
        D::from(self.k_0)
    }
}
