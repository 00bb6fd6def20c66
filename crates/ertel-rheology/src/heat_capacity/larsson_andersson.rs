//! The heat capacity law of Larsson and Andersson.

use crate::error::{Check, LawError};
use crate::linear::{at_least_smallest, not_below_ambient};
use crate::{DensityLaw, Scalar};

/// Heat capacity of lubricants after Larsson and Andersson (Proc. IMechE J 214, 2000, 337-342), who measured it per
/// volume:
///
/// ```text
/// ρ c = (ρ c)₀ [1 + β (T - T_R)] [1 + k₁ p / (1 + k₂ p)]
/// β   = β₀ (1 + b₁ p + b₂ p²)
/// ```
///
/// The first publication was not available. The form here is the product in which `ρ c` grows with pressure at T_R, too;
/// a public program (Everitt's, see the bibliography of the database) puts the factor of the pressure on the
/// temperature term alone, and mentions measurements up to 1.1 GPa and 107 °C.
///
/// The density law of the lubricant turns it into the heat capacity per mass. The bracket of the temperature is held
/// at a tenth where it falls below, which happens only far from any measured state.
///
/// Theory: Larsson and Andersson.
#[derive(Debug, Clone, PartialEq)]
pub struct LarssonAndersson {
    /// Constants of the law.
    pub constants: VolumetricConstants,
    /// Density law of the same lubricant.
    pub density: DensityLaw,
}

/// Constants of the heat capacity per volume after Larsson and Andersson.
#[derive(Debug, Clone, PartialEq)]
pub struct VolumetricConstants {
    /// Heat capacity per volume (ρ c)₀ at ambient pressure and T_R (J/(m³·K)).
    pub rho_c_0: f64,
    /// Reference temperature T_R (K).
    pub reference_temperature: f64,
    /// Temperature coefficient β₀ at ambient pressure (1/K).
    pub beta_0: f64,
    /// Its relative slope b₁ with pressure (1/Pa).
    pub b_1: f64,
    /// Its relative curvature b₂ with pressure (1/Pa²).
    pub b_2: f64,
    /// Initial relative slope k₁ with pressure (1/Pa).
    pub k_1: f64,
    /// Coefficient k₂ by which that saturates (1/Pa).
    pub k_2: f64,
}

impl LarssonAndersson {
    /// The law with its `constants` for a lubricant of this `density`.
    ///
    /// # Errors
    ///
    /// Numbers that are not finite, (ρ c)₀ or T_R not positive, negative k₁ or k₂.
    pub fn new(constants: VolumetricConstants, density: DensityLaw) -> Result<Self, LawError> {
        let check = Check("larsson-andersson");
        check.positive("rho_c_0", constants.rho_c_0)?;
        check.positive("reference_temperature", constants.reference_temperature)?;
        check.finite("beta_0", constants.beta_0)?;
        check.finite("b_1", constants.b_1)?;
        check.finite("b_2", constants.b_2)?;
        check.not_negative("k_1", constants.k_1)?;
        check.not_negative("k_2", constants.k_2)?;
        Ok(Self { constants, density })
    }

    /// Heat capacity per volume ρ c (J/(m³·K)) at `pressure` (Pa above ambient) and `temperature` (K); below p = 0 as
    /// at p = 0.
    #[inline]
    pub fn volumetric<D: Scalar>(&self, pressure: D, temperature: D) -> D {
        let c = &self.constants;
        let p = not_below_ambient(pressure);
        let beta = (p * (p * c.b_2 + c.b_1) + 1.0) * c.beta_0;
        let warming = at_least_smallest(beta * (temperature - c.reference_temperature) + 1.0);
        let compression = p * c.k_1 / (p * c.k_2 + 1.0) + 1.0;
        warming * compression * c.rho_c_0
    }
}
