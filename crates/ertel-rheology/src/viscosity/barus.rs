//! The law of Barus.

use crate::Scalar;
use crate::error::{Check, LawError};

/// Exponential viscosity (Barus 1893; Habchi 2008, eq. 2.17): `μ = μ₀ exp(α p)`.
///
/// Realistic at low pressures only: at a gigapascal it exceeds measured viscosities by orders of magnitude.
#[derive(Debug, Clone, PartialEq)]
pub struct Barus {
    /// Viscosity μ₀ at ambient pressure (Pa·s).
    pub mu_0: f64,
    /// Pressure-viscosity coefficient α (1/Pa).
    pub alpha: f64,
}

impl Barus {
    /// `mu_0` in Pa·s, `alpha` in 1/Pa.
    pub fn new(mu_0: f64, alpha: f64) -> Result<Self, LawError> {
        let check = Check("barus");
        check.positive("mu_0", mu_0)?;
        check.not_negative("alpha", alpha)?;
        Ok(Self { mu_0, alpha })
    }

    /// `ln μ`, μ in Pa·s, at `pressure` (Pa above ambient); temperature has no influence.
    #[inline]
    pub fn ln_viscosity<D: Scalar>(&self, pressure: D, _temperature: D) -> D {
        pressure * self.alpha + self.mu_0.ln()
    }
}
