//! The glass transition of the laws of Williams, Landel and Ferry and of Yasutomi.

use crate::Scalar;
use crate::error::{Check, LawError};

/// Constants of a liquid near its glass transition (Habchi 2008, eq. 2.19):
///
/// ```text
/// log₁₀(μ_g/μ) = C₁ x/(C₂ + x),   x = (T - T_g) F,   T_g = T_g0 + A₁ ln(1 + A₂ p)
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct GlassTransition {
    /// Viscosity μ_g at the glass transition (Pa·s).
    pub glass_viscosity: f64,
    /// Glass transition temperature T_g0 at ambient pressure (K).
    pub glass_temperature: f64,
    /// A₁ (K).
    pub a_1: f64,
    /// A₂ (1/Pa).
    pub a_2: f64,
    /// C₁ (-).
    pub c_1: f64,
    /// C₂ (K).
    pub c_2: f64,
}

impl GlassTransition {
    /// Checks the constants of a law: all positive.
    pub(super) fn check(&self, check: &Check) -> Result<(), LawError> {
        check.positive("mu_g", self.glass_viscosity)?;
        check.positive("t_g0", self.glass_temperature)?;
        check.positive("a_1", self.a_1)?;
        check.positive("a_2", self.a_2)?;
        check.positive("c_1", self.c_1)?;
        check.positive("c_2", self.c_2)
    }

    /// `T - T_g` (K) at `pressure` (Pa above ambient) and `temperature` (K).
    #[inline]
    pub(super) fn above<D: Scalar>(&self, pressure: D, temperature: D) -> D {
        -(pressure * self.a_2).ln_1p() * self.a_1 + (temperature - self.glass_temperature)
    }

    /// `dT_g/dp` (K/Pa) at `pressure` (Pa above ambient).
    #[inline]
    pub(super) fn slope<D: Scalar>(&self, pressure: D) -> D {
        (pressure * self.a_2 + 1.0).recip() * (self.a_1 * self.a_2)
    }

    /// Pressure of the glass transition (Pa above ambient) at `temperature` (K), negative below the ambient glass temperature.
    #[inline]
    pub(super) fn pressure<D: Scalar>(&self, temperature: D) -> D {
        ((temperature - self.glass_temperature) / self.a_1).exp_m1() / self.a_2
    }

    /// `ln μ`, μ in Pa·s, at `x` (K), with the number `decade` for ln 10.
    #[inline]
    pub(super) fn ln_viscosity<D: Scalar>(&self, x: D, decade: f64) -> D {
        -x / (x + self.c_2) * (self.c_1 * decade) + self.glass_viscosity.ln()
    }
}
