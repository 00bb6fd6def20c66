//! Constant viscosity.

use crate::Scalar;
use crate::error::{Check, LawError};

/// Isoviscous lubricant: `μ = μ₀`.
///
/// Theory: Viscosity, Constant.
#[derive(Debug, Clone, PartialEq)]
pub struct Constant {
    /// Viscosity μ₀ (Pa·s).
    pub mu_0: f64,
}

impl Constant {
    /// Checks that `mu_0` (Pa·s) is positive.
    pub fn new(mu_0: f64) -> Result<Self, LawError> {
        Check("constant").positive("mu_0", mu_0)?;
        Ok(Self { mu_0 })
    }

    /// `ln μ`, μ in Pa·s; pressure and temperature have no influence.
    #[inline]
    pub fn ln_viscosity<D: Scalar>(&self, _pressure: D, _temperature: D) -> D {
        D::from(self.mu_0.ln())
    }
}
