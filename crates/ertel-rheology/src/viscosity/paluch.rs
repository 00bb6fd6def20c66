//! The law of Paluch.

use crate::Scalar;
use crate::error::{Check, LawError};

/// Viscosity that grows faster than an exponential towards a pressure p∞ where it diverges (Johari and Whalley 1972;
/// Paluch, Dendzik and Rzoska 1999; in the notation of Bair, High Temperatures - High Pressures 44, 2015, 415-429):
///
/// ```text
/// μ = μ∞ exp[C_F p∞/(p∞ - p)] = μ₀ exp[C_F p/(p∞ - p)],   μ₀ = μ∞ exp(C_F)
/// ```
///
/// The initial slope is `α = C_F/p∞`. Once the formula predicts `ln(μ/μ₀) > 300`, `1/(1 - p/p∞)` continues as a
/// parabola with the same value and two derivatives, so that the viscosity keeps growing. Constants of one isotherm.
///
/// Theory: Paluch.
#[derive(Debug, Clone, PartialEq)]
pub struct Paluch {
    /// Viscosity μ₀ at ambient pressure (Pa·s).
    pub mu_0: f64,
    /// Fragility C_F (-).
    pub fragility: f64,
    /// Pressure p∞ at which the viscosity diverges (Pa above ambient).
    pub divergence_pressure: f64,
}

impl Paluch {
    /// `mu_0` in Pa·s, `fragility` C_F without dimension, `divergence_pressure` p∞ in Pa.
    pub fn new(mu_0: f64, fragility: f64, divergence_pressure: f64) -> Result<Self, LawError> {
        let check = Check("paluch");
        check.positive("mu_0", mu_0)?;
        check_divergence(&check, fragility, divergence_pressure)?;
        Ok(Self {
            mu_0,
            fragility,
            divergence_pressure,
        })
    }

    /// From the viscosity factor `mu_inf` μ∞ (Pa·s) instead of that at ambient pressure.
    pub fn from_factor(
        mu_inf: f64,
        fragility: f64,
        divergence_pressure: f64,
    ) -> Result<Self, LawError> {
        Check("paluch").positive("mu_inf", mu_inf)?;
        let mu_0 = mu_inf * fragility.exp();
        Self::new(mu_0, fragility, divergence_pressure)
    }

    /// `ln μ`, μ in Pa·s, at `pressure` (Pa above ambient); temperature has no influence.
    #[inline]
    pub fn ln_viscosity<D: Scalar>(&self, pressure: D, _temperature: D) -> D {
        divergence(pressure, self.fragility, self.divergence_pressure) + self.mu_0.ln()
    }
}

/// `ln(μ/μ₀)` above which the singular reciprocal is replaced by its Taylor parabola.
const LARGEST_LN_RATIO: f64 = 300.0;

/// Checks the constants of the diverging factor.
pub(super) fn check_divergence(
    check: &Check,
    fragility: f64,
    divergence_pressure: f64,
) -> Result<(), LawError> {
    check.that(
        fragility > 0.0 && fragility <= 1000.0,
        "c_f",
        fragility,
        "above 0, up to 1000",
    )?;
    check.positive("p_inf", divergence_pressure)
}

/// `C_F p/(p∞ - p)`, continued beyond 300, at `pressure` (Pa above ambient); `divergence_pressure` p∞ in Pa.
#[inline]
pub(super) fn divergence<D: Scalar>(pressure: D, fragility: f64, divergence_pressure: f64) -> D {
    let free = -pressure / divergence_pressure + 1.0;
    let smallest = fragility / (LARGEST_LN_RATIO + fragility); // where ln(μ/μ₀) = 300
    let reciprocal = if free.re() > smallest {
        free.recip()
    } else {
        let e = free / smallest - 1.0;
        (-e + e * e + 1.0) / smallest
    };
    (reciprocal - 1.0) * fragility
}
