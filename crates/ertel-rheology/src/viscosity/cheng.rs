//! The law of Cheng.

use crate::Scalar;
use crate::error::{Check, LawError};

/// Exponential viscosity in pressure and temperature (Cheng 1965; Habchi 2008, eq. 2.16):
///
/// ```text
/// μ = μ₀ exp[α p + β (1/T - 1/T_R) + γ p/T]          T in kelvin
/// ```
///
/// α alone may be negative, as it is for some refrigerants: the coefficient at a temperature is `α + γ/T`.
#[derive(Debug, Clone, PartialEq)]
pub struct Cheng {
    /// Viscosity μ₀ at ambient pressure and reference temperature (Pa·s).
    pub mu_0: f64,
    /// Coefficient α of pressure (1/Pa).
    pub alpha: f64,
    /// Coefficient β of temperature (K).
    pub beta: f64,
    /// Coefficient γ of both (K/Pa).
    pub gamma: f64,
    /// Reference temperature T_R (K).
    pub reference_temperature: f64,
}

impl Cheng {
    /// `mu_0` in Pa·s, `alpha` in 1/Pa, `beta` in K, `gamma` in K/Pa, `reference_temperature` in K.
    pub fn new(
        mu_0: f64,
        alpha: f64,
        beta: f64,
        gamma: f64,
        reference_temperature: f64,
    ) -> Result<Self, LawError> {
        let check = Check("cheng");
        check.positive("mu_0", mu_0)?;
        check.positive("reference_temperature", reference_temperature)?;
        check.finite("beta", beta)?;
        check.finite("gamma", gamma)?;
        check.that(
            alpha + gamma / reference_temperature >= 0.0,
            "alpha",
            alpha,
            "such that alpha + gamma/T_R is zero or positive",
        )?;
        Ok(Self {
            mu_0,
            alpha,
            beta,
            gamma,
            reference_temperature,
        })
    }

    /// `ln μ`, μ in Pa·s, at `pressure` (Pa above ambient) and `temperature` (K).
    #[inline]
    pub fn ln_viscosity<D: Scalar>(&self, pressure: D, temperature: D) -> D {
        let coldness = temperature.recip(); // 1/T
        pressure * self.alpha
            + (coldness - 1.0 / self.reference_temperature) * self.beta
            + pressure * coldness * self.gamma
            + self.mu_0.ln()
    }
}
