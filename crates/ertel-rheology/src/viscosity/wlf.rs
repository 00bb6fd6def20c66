//! The modified law of Williams, Landel and Ferry.

use std::f64::consts::LN_10;

use super::GlassTransition;
use crate::Scalar;
use crate::error::{Check, LawError};

/// Viscosity after Yasutomi, Bair and Winer (1984; Habchi 2008, eq. 2.19):
///
/// ```text
/// μ   = μ_g 10^[-C₁ x / (C₂ + x)],   x = (T - T_g) F
/// T_g = T_g0 + A₁ ln(1 + A₂ p)
/// F   = 1 - B₁ ln(1 + B₂ p)
/// ```
///
/// The law holds for a liquid, above its glass transition (`T > T_g`) and with `F > 0`. Beyond the pressure where the
/// first of both fails, `x` would turn back and the viscosity fall again; from there on `ln μ` continues along its
/// tangent in pressure, so that the viscosity (then above μ_g, 10¹² Pa·s as a rule) keeps growing with a continuous
/// slope.
#[derive(Debug, Clone, PartialEq)]
pub struct ModifiedWlf {
    /// μ_g, T_g0, A₁, A₂, C₁ and C₂.
    pub glass: GlassTransition,
    /// B₁ (-).
    pub b_1: f64,
    /// B₂ (1/Pa).
    pub b_2: f64,
}

impl ModifiedWlf {
    /// Checks the constants: all positive.
    pub fn new(constants: Self) -> Result<Self, LawError> {
        let check = Check("wlf");
        constants.glass.check(&check)?;
        check.positive("b_1", constants.b_1)?;
        check.positive("b_2", constants.b_2)?;
        Ok(constants)
    }

    /// Pressure (Pa above ambient) up to which the law holds at `temperature` (K): the glass transition or the pressure
    /// where `F` vanishes, whichever comes first. Negative below the ambient glass temperature.
    #[inline]
    pub fn limiting_pressure<D: Scalar>(&self, temperature: D) -> D {
        let glass = self.glass.pressure(temperature);
        let expansion = (1.0 / self.b_1).exp_m1() / self.b_2;
        if glass.re() < expansion {
            glass
        } else {
            D::from(expansion)
        }
    }

    /// `ln μ`, μ in Pa·s, at `pressure` (Pa above ambient) and `temperature` (K).
    #[inline]
    pub fn ln_viscosity<D: Scalar>(&self, pressure: D, temperature: D) -> D {
        let limit = self.limiting_pressure(temperature);
        let p = if pressure.re() < limit.re() {
            pressure
        } else {
            limit
        };

        let above_glass = self.glass.above(p, temperature); // T - T_g
        // Of a glass at ambient pressure p is below zero, where the logarithm may have no value: its tangent at zero has.
        let expansion = match limit.re() < 0.0 {
            true => p * self.b_2,
            false => (p * self.b_2).ln_1p(),
        };
        let f = -expansion * self.b_1 + 1.0;
        let x = above_glass * f;
        let ln_mu = self.glass.ln_viscosity(x, LN_10);
        if pressure.re() < limit.re() {
            return ln_mu;
        }
        // Here x = 0, and d ln μ/dp = -ln 10 (C₁/C₂) dx/dp with dx/dp = -T_g' F + (T - T_g) F'.
        let f_slope = match limit.re() < 0.0 {
            true => D::from(self.b_1 * self.b_2),
            false => (p * self.b_2 + 1.0).recip() * (self.b_1 * self.b_2),
        };
        let slope = (self.glass.slope(p) * f + above_glass * f_slope)
            * (LN_10 * self.glass.c_1 / self.glass.c_2);
        slope * (pressure - limit) + ln_mu
    }
}
