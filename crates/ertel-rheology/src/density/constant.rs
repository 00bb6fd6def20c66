//! Constant density.

use crate::Scalar;
use crate::error::{Check, LawError};

/// Incompressible lubricant: `ρ = ρ₀`.
///
/// Theory: Density, Constant.
#[derive(Debug, Clone, PartialEq)]
pub struct Constant {
    /// Density ρ₀ (kg/m³).
    pub rho_0: f64,
}

impl Constant {
    /// Checks that `rho_0` (kg/m³) is positive.
    pub fn new(rho_0: f64) -> Result<Self, LawError> {
        Check("constant").positive("rho_0", rho_0)?;
        Ok(Self { rho_0 })
    }

    /// Density (kg/m³); pressure and temperature have no influence.
    #[inline]
    pub fn density<D: Scalar>(&self, _pressure: D, _temperature: D) -> D {
        D::from(self.rho_0)
    }
}
