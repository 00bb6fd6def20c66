//! The improved law of Yasutomi.

use super::GlassTransition;
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
    /// μ_g, T_g0, A₁, A₂, C₁ and C₂.
    pub glass: GlassTransition,
    /// b₁ (1/Pa).
    pub b_1: f64,
    /// b₂ (-), negative.
    pub b_2: f64,
}

/// The number of the publication for ln 10.
const DECADE: f64 = 2.303;

impl ImprovedYasutomi {
    /// Checks the constants: all positive but b₂, which is negative.
    pub fn new(constants: Self) -> Result<Self, LawError> {
        let check = Check("yasutomi");
        constants.glass.check(&check)?;
        check.positive("b_1", constants.b_1)?;
        check.that(constants.b_2 < 0.0, "b_2", constants.b_2, "negative")?;
        Ok(constants)
    }

    /// Pressure of the glass transition (Pa above ambient) at `temperature` (K): up to there the law holds. Negative
    /// below the ambient glass temperature.
    #[inline]
    pub fn limiting_pressure<D: Scalar>(&self, temperature: D) -> D {
        self.glass.pressure(temperature)
    }

    /// `ln μ`, μ in Pa·s, at `pressure` (Pa above ambient) and `temperature` (K).
    #[inline]
    pub fn ln_viscosity<D: Scalar>(&self, pressure: D, temperature: D) -> D {
        let limit = self.limiting_pressure(temperature);
        let liquid = pressure.re() < limit.re();
        let p = if liquid { pressure } else { limit };
        let f = ((p * self.b_1).ln_1p() * self.b_2).exp();
        if liquid {
            let x = self.glass.above(p, temperature) * f;
            return self.glass.ln_viscosity(x, DECADE);
        }
        // Here x = 0, and d ln μ/dp = 2.303 (C₁/C₂) T_g' F.
        let slope = self.glass.slope(p) * f * (DECADE * self.glass.c_1 / self.glass.c_2);
        slope * (pressure - limit) + self.glass.glass_viscosity.ln()
    }
}
