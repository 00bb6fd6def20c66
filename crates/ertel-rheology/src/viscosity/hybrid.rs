//! The hybrid of the laws of McEwen and Paluch.

use super::paluch::{check_divergence, divergence};
use crate::Scalar;
use crate::error::{Check, LawError};

/// Viscosity that grows more slowly than an exponential first and faster later, with the inflection that measured
/// curves have (Bair, High Temperatures - High Pressures 44, 2015, 415-429):
///
/// ```text
/// μ = μ₀ (1 + a₀ p / q)^q exp[C_F p/(p∞ - p)]
/// ```
///
/// The product of [`McEwen`](super::McEwen) and [`Paluch`](super::Paluch), with the continuation of the latter. The
/// initial slope is `α = a₀ + C_F/p∞`. Constants of one isotherm.
///
/// Theory: hybrid.
#[derive(Debug, Clone, PartialEq)]
pub struct Hybrid {
    /// Viscosity μ₀ at ambient pressure (Pa·s).
    pub mu_0: f64,
    /// Share a₀ of McEwen's factor in the initial slope (1/Pa).
    pub a_0: f64,
    /// Exponent q (-).
    pub q: f64,
    /// Fragility C_F (-).
    pub fragility: f64,
    /// Pressure p∞ at which the viscosity diverges (Pa above ambient).
    pub divergence_pressure: f64,
}

impl Hybrid {
    /// Checks the constants: μ₀, q, C_F and p∞ positive, a₀ zero or positive.
    pub fn new(constants: Self) -> Result<Self, LawError> {
        let check = Check("mcewen-paluch");
        check.positive("mu_0", constants.mu_0)?;
        check.not_negative("a_0", constants.a_0)?;
        check.positive("q", constants.q)?;
        check_divergence(&check, constants.fragility, constants.divergence_pressure)?;
        Ok(constants)
    }

    /// `ln μ`, μ in Pa·s, at `pressure` (Pa above ambient); temperature has no influence.
    #[inline]
    pub fn ln_viscosity<D: Scalar>(&self, pressure: D, _temperature: D) -> D {
        (pressure * (self.a_0 / self.q)).ln_1p() * self.q
            + divergence(pressure, self.fragility, self.divergence_pressure)
            + self.mu_0.ln()
    }
}
