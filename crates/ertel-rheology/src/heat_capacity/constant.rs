//! Constant heat capacity.

use crate::Scalar;
use crate::error::{Check, LawError};

/// A heat capacity that does not change: `c = c₀`.
///
/// Theory: Conductivity and heat capacity, Constant.
#[derive(Debug, Clone, PartialEq)]
pub struct Constant {
    /// Heat capacity c₀ (J/(kg·K)).
    pub c_0: f64,
}

impl Constant {
    /// Checks that `c_0` (J/(kg·K)) is positive.
    pub fn new(c_0: f64) -> Result<Self, LawError> {
        Check("constant").positive("c_0", c_0)?;
        Ok(Self { c_0 })
    }

    /// Heat capacity (J/(kg·K)); pressure and temperature have no influence.
    #[inline]
    pub fn heat_capacity<D: Scalar>(&self, _pressure: D, _temperature: D) -> D {
        D::from(self.c_0)
    }
}
