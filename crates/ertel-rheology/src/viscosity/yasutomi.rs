//! The improved law of Yasutomi.

use crate::Scalar;
use crate::error::{Check, LawError};

/// Viscosity after Yasutomi with the improved relative expansivity of the free volume (Bair, Mary, Bouscharain and
/// Vergne, Proc. IMechE J 227, 2013, 1056-1060):
///
/// ```text
/// μ   = μ_g exp[-2.303 C₁ x / (C₂ + x)],   x = (T - T_g) F
/// T_g = T_g0 + A₁ ln(1 + A₂ p)
/// F   = (1 + b₁ p)^b₂                      b₂ < 0
/// ```
///
/// The number 2.303 is that of the publication, not ln 10: published constants belong to it. The law holds for a
/// liquid, above its glass transition (`T > T_g`); `F` stays positive at every pressure. At the pressure of the glass
/// transition `x` vanishes and the formula approaches a pole; from there on `ln μ` continues along its tangent in
/// pressure.
///
/// Theory: Improved Yasutomi.
#[derive(Debug, Clone, PartialEq)]
pub struct ImprovedYasutomi {
    /// Viscosity μ_g at the glass transition (Pa·s).
    pub glass_viscosity: f64,
    /// Glass transition temperature T_g0 at ambient pressure (K).
    pub glass_temperature: f64,
    /// A₁ (K).
    pub a_1: f64,
    /// A₂ (1/Pa).
    pub a_2: f64,
    /// b₁ (1/Pa).
    pub b_1: f64,
    /// b₂ (-), negative.
    pub b_2: f64,
    /// C₁ (-).
    pub c_1: f64,
    /// C₂ (K).
    pub c_2: f64,
}

/// The number of the publication for ln 10.
const DECADE: f64 = 2.303;

impl ImprovedYasutomi {
    /// Checks the constants: all positive but b₂, which is negative.
    pub fn new(constants: Self) -> Result<Self, LawError> {
        let check = Check("yasutomi");
        check.positive("mu_g", constants.glass_viscosity)?;
        check.positive("t_g0", constants.glass_temperature)?;
        check.positive("a_1", constants.a_1)?;
        check.positive("a_2", constants.a_2)?;
        check.positive("b_1", constants.b_1)?;
        check.that(constants.b_2 < 0.0, "b_2", constants.b_2, "negative")?;
        check.positive("c_1", constants.c_1)?;
        check.positive("c_2", constants.c_2)?;
        Ok(constants)
    }

    /// Pressure of the glass transition (Pa above ambient) at `temperature` (K): up to there the law holds. Negative
    /// below the ambient glass temperature.
    #[inline]
    pub fn limiting_pressure<D: Scalar>(&self, temperature: D) -> D {
        ((temperature - self.glass_temperature) / self.a_1).exp_m1() / self.a_2
    }

    /// `ln μ`, μ in Pa·s, at `pressure` (Pa above ambient) and `temperature` (K).
    #[inline]
    pub fn ln_viscosity<D: Scalar>(&self, pressure: D, temperature: D) -> D {
        let limit = self.limiting_pressure(temperature);
        let liquid = pressure.re() < limit.re();
        let p = if liquid { pressure } else { limit };
        let f = ((p * self.b_1).ln_1p() * self.b_2).exp();
        if liquid {
            let above_glass =
                -(p * self.a_2).ln_1p() * self.a_1 + (temperature - self.glass_temperature);
            let x = above_glass * f;
            return -x / (x + self.c_2) * (self.c_1 * DECADE) + self.glass_viscosity.ln();
        }
        // Here x = 0, and d ln μ/dp = 2.303 (C₁/C₂) T_g' F.
        let glass_slope = (p * self.a_2 + 1.0).recip() * (self.a_1 * self.a_2);
        let slope = glass_slope * f * (DECADE * self.c_1 / self.c_2);
        slope * (pressure - limit) + self.glass_viscosity.ln()
    }
}
