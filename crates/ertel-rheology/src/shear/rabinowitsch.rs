//! The power law with a Newtonian start.

use super::numbers::{
    LARGEST_EXPONENT, SMALLEST_EXPONENT, bounded_exp, ln_smooth_power, smooth_power,
};
use crate::Scalar;
use crate::error::{Check, LawError};

/// Newtonian flow and power-law flow side by side:
///
/// ```text
/// γ̇ = (τ_e/μ₁) [1 + (τ_e/τ₀)^m],   m = 1/n - 1
/// ```
///
/// With `n = 1/3` the cubic law of Rabinowitsch (1929); far beyond τ₀ the power law `τ_e ∝ γ̇ⁿ`.
///
/// Theory: Rabinowitsch and power laws.
#[derive(Debug, Clone, PartialEq)]
pub struct Rabinowitsch {
    /// Stress τ₀ (Pa) at which the viscosity has halved.
    pub critical_stress: f64,
    /// Exponent n of the power law (-).
    pub exponent: f64,
}

impl Rabinowitsch {
    /// `critical_stress` τ₀ in Pa; `exponent` n from 0.01 to below 1 without dimension.
    pub fn new(critical_stress: f64, exponent: f64) -> Result<Self, LawError> {
        let check = Check("rabinowitsch");
        check.stress("tau_0", critical_stress)?;
        check.that(
            (SMALLEST_EXPONENT..1.0).contains(&exponent),
            "n",
            exponent,
            "0.01 or more and below 1",
        )?;
        Ok(Self {
            critical_stress,
            exponent,
        })
    }

    /// `μ₁/η` at the square of the equivalent stress τ_e² (Pa²).
    #[inline]
    pub fn relative_fluidity<D: Scalar>(&self, stress_squared: D) -> D {
        let square = stress_squared / (self.critical_stress * self.critical_stress);
        let m = self.exponent.recip() - 1.0;
        if 0.5 * m * square.re().ln() > LARGEST_EXPONENT {
            bounded_exp(ln_smooth_power(square.ln(), m)) + 1.0
        } else {
            smooth_power(square, m) + 1.0
        }
    }
}
