//! The modified Carreau law in shear stress.

use super::numbers::{SMALLEST_EXPONENT, bounded_exp, ln_one_plus_power, smooth_power};
use crate::Scalar;
use crate::error::{Check, LawError};

/// Power-law thinning between two Newtonian plateaus, in shear stress (Bair's modified Carreau law; Habchi 2008,
/// eq. 4.3):
///
/// ```text
/// η = μ₂ + (μ₁ - μ₂) / [1 + (τ_e/G_c)^β_c]^((1/n_c - 1)/β_c)
/// ```
///
/// Both plateaus follow the viscosity law of the lubricant, so that `μ₂/μ₁` does not change with pressure and
/// temperature.
#[derive(Debug, Clone, PartialEq)]
pub struct Carreau {
    /// Critical stress G_c (Pa).
    pub critical_stress: f64,
    /// Exponent n_c (-): the shear stress grows with the shear rate to the power n_c far beyond G_c.
    pub exponent: f64,
    /// Width exponent β_c of the transition (-).
    pub transition: f64,
    /// Second plateau over first, `μ₂/μ₁` (-).
    pub plateau_ratio: f64,
}

/// `(τ_e/G_c)²` and power-law slope `1/n_c - 1` below which the powers are far from overflow and need no logarithms.
const LARGEST_SQUARE: f64 = 1e12;
const LARGEST_SLOPE: f64 = 10.0;

/// Range of the width exponents.
const TRANSITIONS: [f64; 2] = [0.2, 50.0];

impl Carreau {
    /// `critical_stress` G_c in Pa; `exponent` n_c in \[0.01, 1\], `transition` β_c in \[0.2, 50\] and
    /// `plateau_ratio` `μ₂/μ₁` in \[0, 1\] without dimension.
    pub fn new(
        critical_stress: f64,
        exponent: f64,
        transition: f64,
        plateau_ratio: f64,
    ) -> Result<Self, LawError> {
        let check = Check("carreau");
        check.stress("g_c", critical_stress)?;
        check_exponent(&check, exponent)?;
        check_transition(&check, "beta_c", transition)?;
        check_plateaus(&check, plateau_ratio)?;
        Ok(Self {
            critical_stress,
            exponent,
            transition,
            plateau_ratio,
        })
    }

    /// `μ₁/η` at the square of the equivalent stress τ_e² (Pa²).
    #[inline]
    pub fn relative_fluidity<D: Scalar>(&self, stress_squared: D) -> D {
        let square = stress_squared / (self.critical_stress * self.critical_stress);
        let slope = self.exponent.recip() - 1.0;
        let outer = slope / self.transition;
        let moderate =
            square.re() < LARGEST_SQUARE && self.transition < 10.0 && slope < LARGEST_SLOPE;
        let thinning = if moderate {
            (smooth_power(square, self.transition) + 1.0).powf(outer)
        } else {
            bounded_exp(ln_one_plus_power(square, self.transition) * outer)
        };
        // 1/[r + (1 - r)/thinning], r = μ₂/μ₁
        thinning / ((thinning - 1.0) * self.plateau_ratio + 1.0)
    }
}

/// Exponents of the power law between the plateaus.
pub(super) fn check_exponent(check: &Check, n: f64) -> Result<(), LawError> {
    check.that(
        (SMALLEST_EXPONENT..=1.0).contains(&n),
        "n",
        n,
        "between 0.01 and 1",
    )
}

/// Width exponents of the transition. With smaller ones the smoothing at zero stress would be seen, and the equation of
/// Carreau and Yasuda's fluidity would have more than one root.
pub(super) fn check_transition(check: &Check, key: &'static str, a: f64) -> Result<(), LawError> {
    let [lowest, highest] = TRANSITIONS;
    check.that(
        (lowest..=highest).contains(&a),
        key,
        a,
        "between 0.2 and 50",
    )
}

/// The second plateau must not lie above the first; the square of a smaller share would leave floating point.
pub(super) fn check_plateaus(check: &Check, ratio: f64) -> Result<(), LawError> {
    check.that(
        ratio == 0.0 || (1e-50..=1.0).contains(&ratio),
        "mu_2",
        ratio,
        "0, or between 1e-50 and 1, as a share of the first plateau",
    )
}
