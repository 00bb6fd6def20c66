//! The law of McEwen.

use crate::Scalar;
use crate::error::{Check, LawError};

/// Viscosity that grows more slowly than an exponential (McEwen 1952; in the notation of Bair, High Temperatures - High
/// Pressures 44, 2015, 415-429):
///
/// ```text
/// μ = μ₀ (1 + α p / q)^q
/// ```
///
/// α is the initial slope. For large `q` the law becomes that of Barus; the reciprocal asymptotic coefficient is
/// `α* = α (q - 1)/q` and exists for `q > 1`. Constants of one isotherm.
///
/// Theory: McEwen.
#[derive(Debug, Clone, PartialEq)]
pub struct McEwen {
    /// Viscosity μ₀ at ambient pressure (Pa·s).
    pub mu_0: f64,
    /// Pressure-viscosity coefficient α at ambient pressure (1/Pa).
    pub alpha: f64,
    /// Exponent q (-).
    pub q: f64,
}

impl McEwen {
    /// `mu_0` in Pa·s, `alpha` in 1/Pa, `q` without dimension.
    pub fn new(mu_0: f64, alpha: f64, q: f64) -> Result<Self, LawError> {
        let check = Check("mcewen");
        check.positive("mu_0", mu_0)?;
        check.not_negative("alpha", alpha)?;
        check.positive("q", q)?;
        Ok(Self { mu_0, alpha, q })
    }

    /// `ln μ`, μ in Pa·s, at `pressure` (Pa above ambient); temperature has no influence.
    #[inline]
    pub fn ln_viscosity<D: Scalar>(&self, pressure: D, _temperature: D) -> D {
        (pressure * (self.alpha / self.q)).ln_1p() * self.q + self.mu_0.ln()
    }
}
