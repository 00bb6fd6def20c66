//! The limiting shear stress.

use super::numbers::{LARGEST_EXPONENT, bounded_exp};
use crate::Scalar;
use crate::error::{Check, LawError};

/// A shear stress that the lubricant does not exceed, proportional to pressure (Johnson and Tevaarwerk 1977), approached
/// as in the viscous part of the law of Gecim and Winer (1980):
///
/// ```text
/// γ̇   = (τ_L/μ₁) atanh(τ_e/τ_L)
/// τ_L = τ_L0 + Λ p
/// ```
///
/// A stress at the limit has no finite shear rate, and an iterate may lie beyond. Above `r = τ_e/τ_L = 0.999` the
/// inverse hyperbolic tangent continues as an exponential with the same value and two derivatives there, `r₁ = 0.999`:
///
/// ```text
/// A(r) = atanh r₁ + {exp[2 r₁ (r - r₁)/(1 - r₁²)] - 1} / (2 r₁)
/// ```
///
/// It grows e-fold per 0.1 % of τ_L, so that `μ₁ γ̇/τ_L = 1000` needs 0.7 % more stress than the limit, and 1e6 1.4 %.
///
/// A smaller r₁ makes a softer limit, that more stress passes: a way for solvers to the law itself
/// ([`StressLimit::softened`]).
///
/// Below ambient pressure τ_L falls less and less and stays positive; two derivatives are continuous at `p = 0`.
///
/// Theory: Laws, Limiting stress.
#[derive(Debug, Clone, PartialEq)]
pub struct StressLimit {
    /// Limiting stress τ_L0 at ambient pressure (Pa).
    pub ambient_limit: f64,
    /// Its growth Λ with pressure (-).
    pub pressure_coefficient: f64,
    /// Share r₁ of the limiting stress from which the exponential takes over (-); 0.999 but in softened limits.
    pub joint: f64,
}

/// Share of the limiting stress from which the exponential takes over.
const LARGEST_RATIO: f64 = 0.999;

impl StressLimit {
    /// Share of the limiting stress up to which the law is the inverse hyperbolic tangent.
    pub const LARGEST_RATIO: f64 = LARGEST_RATIO;
    /// E-folds beyond that after which it grows as a parabola only.
    pub const MOST_FOLDS: f64 = LARGEST_EXPONENT;

    /// `ambient_limit` τ_L0 in Pa, `pressure_coefficient` Λ from 0 to 10 without dimension.
    pub fn new(ambient_limit: f64, pressure_coefficient: f64) -> Result<Self, LawError> {
        let check = Check("limiting-stress");
        check.stress("tau_l0", ambient_limit)?;
        check.that(
            (0.0..=10.0).contains(&pressure_coefficient),
            "lambda",
            pressure_coefficient,
            "between 0 and 10",
        )?;
        Ok(Self {
            ambient_limit,
            pressure_coefficient,
            joint: LARGEST_RATIO,
        })
    }

    /// The same limit with the exponential from a smaller share r₁ of it on, `joint`, above 0: stresses pass the
    /// limit by an e-fold of the shear rate per (1 − r₁²)/(2r₁) of it.
    #[must_use]
    pub fn softened(&self, joint: f64) -> Self {
        Self {
            joint,
            ..self.clone()
        }
    }

    /// Stress, over the limiting one, by which the fluidity grows e-fold beyond r₁.
    #[inline]
    pub fn e_fold(&self) -> f64 {
        (1.0 - self.joint * self.joint) / (2.0 * self.joint)
    }

    /// τ_L (Pa) at `pressure` (Pa above ambient).
    #[inline]
    pub fn limiting_stress<D: Scalar>(&self, pressure: D) -> D {
        let x = pressure * (self.pressure_coefficient / self.ambient_limit);
        let relative = if x.re() >= 0.0 {
            x + 1.0
        } else {
            // 1 + x + O(x³)
            (x * x - x + 1.0).recip()
        };
        relative * self.ambient_limit
    }

    /// `atanh(r)/r`, by which the limit multiplies the fluidity, at the square of the equivalent stress τ_e² (Pa²) and
    /// `pressure` (Pa above ambient).
    #[inline]
    pub fn factor<D: Scalar>(&self, stress_squared: D, pressure: D) -> D {
        let limit = self.limiting_stress(pressure);
        let square = stress_squared / (limit * limit);
        if square.re() < 0.01 {
            // Σ r²ᵏ/(2k + 1), the first term left out below 1e-18.
            let mut sum = D::from(0.0);
            for k in (0..=8).rev() {
                sum = sum * square + 1.0 / f64::from(2 * k + 1);
            }
            return sum;
        }
        let r = square.sqrt();
        let area = if r.re() <= self.joint {
            (r.ln_1p() - (-r).ln_1p()) * 0.5
        } else {
            let rate = self.e_fold().recip();
            let growth = bounded_exp((r - self.joint) * rate) - 1.0;
            growth / (2.0 * self.joint) + self.joint.atanh()
        };
        area / r
    }
}
