//! The density law of Dowson and Higginson.

use crate::Scalar;
use crate::error::{Check, LawError};

/// Density after Dowson and Higginson (Habchi 2008, eq. 2.10):
///
/// ```text
/// ρ = ρ₀ [1 + c₁ p / (1 + c₂ p) - β (T - T_R)]      c₁ = 0.6e-9 1/Pa, c₂ = 1.7e-9 1/Pa
/// ```
///
/// The two compressibility constants belong to the law and are the same for every lubricant; a few authors use
/// neighbouring values, which [`DowsonHigginson::with_constants`] takes.
#[derive(Debug, Clone, PartialEq)]
pub struct DowsonHigginson {
    /// Density ρ₀ at ambient pressure and reference temperature (kg/m³).
    pub rho_0: f64,
    /// Initial compressibility c₁ (1/Pa).
    pub compressibility: f64,
    /// Coefficient c₂ by which the compression saturates (1/Pa).
    pub saturation: f64,
    /// Expansion with temperature; without it the density depends on pressure only.
    pub thermal: Option<ThermalExpansion>,
}

/// Linear loss of density with temperature: `-β (T - T_R)` relative to ρ₀.
#[derive(Debug, Clone, PartialEq)]
pub struct ThermalExpansion {
    /// Temperature T_R at which ρ₀ holds (K).
    pub reference_temperature: f64,
    /// Density-temperature coefficient β (1/K).
    pub temperature_coefficient: f64,
}

impl DowsonHigginson {
    /// The law's own initial compressibility c₁ (1/Pa).
    pub const COMPRESSIBILITY: f64 = 0.6e-9;
    /// The law's own saturation coefficient c₂ (1/Pa).
    pub const SATURATION: f64 = 1.7e-9;

    /// The law with its universal constants; `rho_0` in kg/m³.
    pub fn new(rho_0: f64, thermal: Option<ThermalExpansion>) -> Result<Self, LawError> {
        Self::with_constants(rho_0, Self::COMPRESSIBILITY, Self::SATURATION, thermal)
    }

    /// The same form with `compressibility` c₁ and `saturation` c₂ (1/Pa) of one's own; `rho_0` in kg/m³.
    pub fn with_constants(
        rho_0: f64,
        compressibility: f64,
        saturation: f64,
        thermal: Option<ThermalExpansion>,
    ) -> Result<Self, LawError> {
        let check = Check("dowson-higginson");
        check.positive("rho_0", rho_0)?;
        check.not_negative("c_1", compressibility)?;
        check.not_negative("c_2", saturation)?;
        if let Some(thermal) = &thermal {
            check.positive("reference_temperature", thermal.reference_temperature)?;
            check.finite("beta", thermal.temperature_coefficient)?;
        }
        Ok(Self {
            rho_0,
            compressibility,
            saturation,
            thermal,
        })
    }

    /// Density (kg/m³) at `pressure` (Pa above ambient) and `temperature` (K).
    #[inline]
    pub fn density<D: Scalar>(&self, pressure: D, temperature: D) -> D {
        let mut relative =
            pressure * self.compressibility / (pressure * self.saturation + 1.0) + 1.0;
        if let Some(thermal) = &self.thermal {
            relative -=
                (temperature - thermal.reference_temperature) * thermal.temperature_coefficient;
        }
        relative * self.rho_0
    }
}
