//! Heat capacity by scaling with volume and temperature.

use crate::error::{Check, LawError};
use crate::linear::not_below_ambient;
use crate::{DensityLaw, Scalar};

/// Heat capacity per volume of lubricants, linear in one scaling variable (Habchi, Finite Element Modeling of
/// Elastohydrodynamic Lubrication Problems, 2018, after Bair; read in a public program that cites its page 428):
///
/// ```text
/// ρ c = C₀ + m χ
/// χ   = (T/T_R) (V/V_R)^(-w)           w = 4 as a rule
/// ```
///
/// `V/V_R` is the volume relative to that at ambient pressure and T_R, from the density law of the lubricant, which
/// also turns `ρ c` into the heat capacity per mass.
///
/// Theory: Scaling.
#[derive(Debug, Clone, PartialEq)]
pub struct Scaling {
    /// Constants of the law.
    pub constants: ScalingConstants,
    /// Density law of the same lubricant.
    pub density: DensityLaw,
}

/// Constants of the heat capacity by scaling.
#[derive(Debug, Clone, PartialEq)]
pub struct ScalingConstants {
    /// Part C₀ that does not change (J/(m³·K)).
    pub rho_c_0: f64,
    /// Factor m of the scaling variable (J/(m³·K)).
    pub m: f64,
    /// Exponent w of the volume (-).
    pub w: f64,
    /// Reference temperature T_R (K).
    pub reference_temperature: f64,
}

impl Scaling {
    /// The law's own exponent w of the volume (-).
    pub const VOLUME_EXPONENT: f64 = 4.0;

    /// The law with its `constants` for a lubricant of this `density`.
    ///
    /// # Errors
    ///
    /// Numbers that are not finite, C₀ or T_R not positive, negative m or w.
    pub fn new(constants: ScalingConstants, density: DensityLaw) -> Result<Self, LawError> {
        let check = Check("scaling");
        check.positive("rho_c_0", constants.rho_c_0)?;
        check.not_negative("m", constants.m)?;
        check.not_negative("w", constants.w)?;
        check.positive("reference_temperature", constants.reference_temperature)?;
        Ok(Self { constants, density })
    }

    /// Heat capacity per volume ρ c (J/(m³·K)) at `pressure` (Pa above ambient) and `temperature` (K); below p = 0 as
    /// at p = 0.
    #[inline]
    pub fn volumetric<D: Scalar>(&self, pressure: D, temperature: D) -> D {
        let c = &self.constants;
        let p = not_below_ambient(pressure);
        let relative = self
            .density
            .relative(p, temperature, c.reference_temperature); // V_R/V
        let chi = temperature / c.reference_temperature * (relative.ln() * c.w).exp();
        chi * c.m + c.rho_c_0
    }
}
