//! Thermal conductivity by scaling with volume and temperature.

use crate::error::{Check, LawError};
use crate::linear::not_below_ambient;
use crate::{DensityLaw, Scalar};

/// Conductivity of lubricants as a function of one scaling variable (Habchi, Finite Element Modeling of
/// Elastohydrodynamic Lubrication Problems, 2018, after Bair; read in a public program that cites its page 427):
///
/// ```text
/// k = B + C κ^(-s)
/// κ = (V/V_R) [1 + A (T/T_R) (V/V_R)^q]
/// ```
///
/// `V/V_R` is the volume relative to that at ambient pressure and T_R, from the density law of the lubricant. The
/// bracket is limited to a half from below, which happens only far above measured temperatures.
///
/// Theory: Scaling.
#[derive(Debug, Clone, PartialEq)]
pub struct Scaling {
    /// Constants of the law.
    pub constants: ScalingConstants,
    /// Density law of the same lubricant.
    pub density: DensityLaw,
}

/// Constants of the conductivity by scaling.
#[derive(Debug, Clone, PartialEq)]
pub struct ScalingConstants {
    /// Part B that does not change (W/(m·K)).
    pub b: f64,
    /// Factor C of the part that does (W/(m·K)).
    pub c: f64,
    /// Exponent s of the scaling variable (-).
    pub s: f64,
    /// Weight A of temperature in the scaling variable (-).
    pub a: f64,
    /// Exponent q of the volume there (-).
    pub q: f64,
    /// Reference temperature T_R (K).
    pub reference_temperature: f64,
}

/// Lower limit of the bracket.
const SMALLEST_BRACKET: f64 = 0.5;

impl Scaling {
    /// The law with its `constants` for a lubricant of this `density`.
    ///
    /// # Errors
    ///
    /// Numbers that are not finite; B negative; C, s or T_R not positive; A not between -0.5 and 10.
    pub fn new(constants: ScalingConstants, density: DensityLaw) -> Result<Self, LawError> {
        let check = Check("scaling");
        check.not_negative("b", constants.b)?;
        check.positive("c", constants.c)?;
        check.positive("s", constants.s)?;
        check.that(
            constants.a > -SMALLEST_BRACKET && constants.a <= 10.0,
            "a",
            constants.a,
            "above -0.5, up to 10",
        )?;
        check.finite("q", constants.q)?;
        check.positive("reference_temperature", constants.reference_temperature)?;
        Ok(Self { constants, density })
    }

    /// Conductivity (W/(m·K)) at `pressure` (Pa above ambient) and `temperature` (K); below p = 0 as at p = 0.
    #[inline]
    pub fn conductivity<D: Scalar>(&self, pressure: D, temperature: D) -> D {
        let c = &self.constants;
        let p = not_below_ambient(pressure);
        let ln_volume = -self
            .density
            .relative(p, temperature, c.reference_temperature)
            .ln();
        let warmth = temperature / c.reference_temperature;
        let bracket = warmth * (ln_volume * c.q).exp() * c.a + 1.0;
        let bracket = if bracket.re() < SMALLEST_BRACKET {
            D::from(SMALLEST_BRACKET)
        } else {
            bracket
        };
        ((ln_volume + bracket.ln()) * -c.s).exp() * c.c + c.b
    }
}
