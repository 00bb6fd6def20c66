//! The Carreau-Yasuda law in shear rate.

use super::carreau::{check_exponent, check_plateaus, check_transition};
use super::numbers::{
    bounded_exp, increasing_root, ln_one_plus_power, ln_one_plus_power_and_slope,
    ln_one_plus_scaled_power,
};
use crate::Scalar;
use crate::error::{Check, LawError};

/// Power-law thinning between two Newtonian plateaus, in shear rate (Carreau 1972; Yasuda, Armstrong and Cohen 1981):
///
/// ```text
/// η = μ₂ + (μ₁ - μ₂) [1 + (λ γ̇)^a]^((n - 1)/a),   λ = μ₁/G
/// ```
///
/// With `φ = μ₁/η` the shear rate is `λ γ̇ = φ τ_e/G`, and φ is the root of
///
/// ```text
/// ln φ + ln{r + (1 - r) [1 + (φ τ_e/G)^a]^((n - 1)/a)} = 0,   r = μ₂/μ₁
/// ```
///
/// whose left side grows with `ln φ` at a rate between n and 1.
///
/// Theory: Carreau-Yasuda.
#[derive(Debug, Clone, PartialEq)]
pub struct CarreauYasuda {
    /// Shear modulus G (Pa): the relaxation time λ is `μ₁/G`.
    pub shear_modulus: f64,
    /// Exponent n (-): the shear stress grows with the shear rate to the power n far beyond G.
    pub exponent: f64,
    /// Yasuda's exponent a (-), 2 in Carreau's law: width of the transition.
    pub transition: f64,
    /// Second plateau over first, `μ₂/μ₁` (-).
    pub plateau_ratio: f64,
}

impl CarreauYasuda {
    /// `shear_modulus` G in Pa; `exponent` n in \[0.01, 1\], `transition` a in \[0.2, 50\] and `plateau_ratio`
    /// `μ₂/μ₁` in \[0, 1\] without dimension.
    pub fn new(
        shear_modulus: f64,
        exponent: f64,
        transition: f64,
        plateau_ratio: f64,
    ) -> Result<Self, LawError> {
        let check = Check("carreau-yasuda");
        check.stress("g", shear_modulus)?;
        check_exponent(&check, exponent)?;
        check_transition(&check, "a", transition)?;
        check_plateaus(&check, plateau_ratio)?;
        Ok(Self {
            shear_modulus,
            exponent,
            transition,
            plateau_ratio,
        })
    }

    /// `μ₁/η` at the square of the equivalent stress τ_e² (Pa²).
    #[inline]
    pub fn relative_fluidity<D: Scalar>(&self, stress_squared: D) -> D {
        let square = stress_squared / (self.shear_modulus * self.shear_modulus);
        let root = self.ln_fluidity(square.re());
        let (_, slope) = self.residual_and_slope(square.re().ln(), root);
        // Newton steps that carry the derivatives along; each makes one more order exact.
        let mut ln_fluidity = D::from(root);
        for _ in 0..D::NDERIV {
            ln_fluidity -= self.residual(square, ln_fluidity) / slope;
        }
        bounded_exp(ln_fluidity)
    }

    /// `ln φ` at `square = (τ_e/G)²`.
    fn ln_fluidity(&self, square: f64) -> f64 {
        let ln_square = square.ln();
        // The left side is below zero at ln φ = 0 by what it must gain at a rate between n and 1.
        let gain = -self.residual_and_slope(ln_square, 0.0).0;
        if gain <= 0.0 {
            return 0.0;
        }
        // The law in shear stress with the same exponents is close.
        let thinning = ln_one_plus_power(square, self.transition)
            * ((self.exponent.recip() - 1.0) / self.transition);
        let start = if self.plateau_ratio == 0.0 {
            thinning
        } else {
            -(self.plateau_ratio + (1.0 - self.plateau_ratio) * (-thinning).exp()).ln()
        };
        increasing_root(
            |ln_fluidity| self.residual_and_slope(ln_square, ln_fluidity),
            gain,
            gain / self.exponent * (1.0 + 1e-9),
            start,
        )
    }

    /// [`Self::residual`] and its slope by `ln φ` at `ln_square = ln (τ_e/G)²`.
    fn residual_and_slope(&self, ln_square: f64, ln_fluidity: f64) -> (f64, f64) {
        let (ln_bracket, slope) =
            ln_one_plus_power_and_slope(ln_square + 2.0 * ln_fluidity, self.transition);
        let outer = (self.exponent - 1.0) / self.transition;
        // d/d ln φ is twice that by the logarithm of the square.
        let (ln_power, slope) = (outer * ln_bracket, 2.0 * outer * slope);
        if self.plateau_ratio == 0.0 {
            return (ln_fluidity + ln_power, 1.0 + slope);
        }
        let thinned = (1.0 - self.plateau_ratio) * ln_power.exp();
        let share = self.plateau_ratio + thinned;
        (ln_fluidity + share.ln(), 1.0 + slope * thinned / share)
    }

    /// Left side of the equation for `ln φ`.
    #[inline]
    fn residual<D: Scalar>(&self, square: D, ln_fluidity: D) -> D {
        let ln_bracket = ln_one_plus_scaled_power(square, ln_fluidity * 2.0, self.transition);
        let ln_power = ln_bracket * ((self.exponent - 1.0) / self.transition);
        let r = self.plateau_ratio;
        if r == 0.0 {
            ln_fluidity + ln_power
        } else {
            ln_fluidity + (ln_power.exp() * (1.0 - r) + r).ln()
        }
    }
}
