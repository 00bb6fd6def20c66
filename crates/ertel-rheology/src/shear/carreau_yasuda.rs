//! The Carreau-Yasuda law in shear rate.

use num_dual::Dual64;

use super::carreau::{check_exponent, check_plateaus};
use super::numbers::{bounded_exp, increasing_root, ln_one_plus_power, ln_one_plus_scaled_power};
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

/// Newton steps that carry the derivatives along; each makes one more order exact.
const N_DERIVATIVES: usize = 3;

impl CarreauYasuda {
    /// `shear_modulus` G in Pa; `exponent` n in (0, 1], `transition` a > 0 and `plateau_ratio` `μ₂/μ₁` in \[0, 1\]
    /// without dimension.
    pub fn new(
        shear_modulus: f64,
        exponent: f64,
        transition: f64,
        plateau_ratio: f64,
    ) -> Result<Self, LawError> {
        let check = Check("carreau-yasuda");
        check.positive("g", shear_modulus)?;
        check_exponent(&check, exponent)?;
        check.positive("a", transition)?;
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
        let slope = self
            .residual(Dual64::from(square.re()), Dual64::new(root, 1.0))
            .eps;
        let mut ln_fluidity = D::from(root);
        for _ in 0..N_DERIVATIVES {
            ln_fluidity -= self.residual(square, ln_fluidity) / slope;
        }
        bounded_exp(ln_fluidity)
    }

    /// `ln φ` at `square = (τ_e/G)²`.
    fn ln_fluidity(&self, square: f64) -> f64 {
        // The left side is below zero at ln φ = 0 by what it must gain at a rate between n and 1.
        let gain = -self.residual(square, 0.0);
        if gain <= 0.0 {
            return 0.0;
        }
        // The root of the law in shear stress with the same exponents is close.
        let start = ln_one_plus_power(square, self.transition)
            * ((self.exponent.recip() - 1.0) / self.transition);
        let function = |ln_fluidity: f64| {
            let residual = self.residual(Dual64::from(square), Dual64::new(ln_fluidity, 1.0));
            (residual.re, residual.eps)
        };
        increasing_root(function, gain, gain / self.exponent * (1.0 + 1e-9), start)
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
