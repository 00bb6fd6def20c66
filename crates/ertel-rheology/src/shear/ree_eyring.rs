//! The sinh law.

use super::numbers::bounded_exp;
use crate::Scalar;
use crate::error::{Check, LawError};

/// Thermally activated flow, the sinh law named after Ree and Eyring (1955):
///
/// ```text
/// γ̇ = (τ₀/μ₁) sinh(τ_e/τ₀)
/// ```
///
/// Theory: Ree-Eyring.
#[derive(Debug, Clone, PartialEq)]
pub struct ReeEyring {
    /// Eyring stress τ₀ (Pa).
    pub eyring_stress: f64,
}

impl ReeEyring {
    /// `eyring_stress` τ₀ in Pa.
    pub fn new(eyring_stress: f64) -> Result<Self, LawError> {
        Check("ree-eyring").stress("tau_0", eyring_stress)?;
        Ok(Self { eyring_stress })
    }

    /// `μ₁/η = sinh(τ_e/τ₀)/(τ_e/τ₀)` at the square of the equivalent stress τ_e² (Pa²).
    #[inline]
    pub fn relative_fluidity<D: Scalar>(&self, stress_squared: D) -> D {
        let square = stress_squared / (self.eyring_stress * self.eyring_stress);
        if square.re() < 1.0 {
            // Σ y²ᵏ/(2k + 1)!, the last term below 1e-19.
            let mut sum = D::from(1.0);
            for k in (1..=9).rev() {
                let k = f64::from(k);
                sum = sum * square / (2.0 * k * (2.0 * k + 1.0)) + 1.0;
            }
            sum
        } else {
            let y = square.sqrt();
            (bounded_exp(y) - (-y).exp()) / (y * 2.0)
        }
    }
}
