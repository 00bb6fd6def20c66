//! Density as a function of pressure and temperature.
//!
//! Pressure is the rise above ambient (Pa), temperature is absolute (K), density is in kg/m³.

mod constant;
mod dowson_higginson;
mod murnaghan;
mod tait;

pub use constant::Constant;
pub use dowson_higginson::{DowsonHigginson, ThermalExpansion};
pub use murnaghan::Murnaghan;
pub use tait::{BulkModulusSoftening, Tait, TaitVolume};

use crate::{Isotherms, LawError, Scalar};

/// The density laws.
#[derive(Debug, Clone, PartialEq)]
pub enum DensityLaw {
    /// `ρ = ρ₀`
    Constant(Constant),
    /// `ρ = ρ₀ [1 + 0.6e-9 p / (1 + 1.7e-9 p) - β (T - T_R)]`
    DowsonHigginson(DowsonHigginson),
    /// `ρ = ρ₀ / [(1 + a_V (T - T_R)) (1 - ln(1 + (1 + K₀') p / K₀) / (1 + K₀'))]`
    Tait(Tait),
    /// `ρ = ρ₀ (1 + K₀' p / K₀)^(1/K₀') / (1 + a_V (T - T_R))`
    Murnaghan(Murnaghan),
    /// Monotone interpolation in a table over pressure and temperature, [`Isotherms::straight`].
    Table(Isotherms),
}

impl DensityLaw {
    /// An incompressible lubricant of density `rho_0` (kg/m³).
    pub fn constant(rho_0: f64) -> Result<Self, LawError> {
        Constant::new(rho_0).map(Self::Constant)
    }

    /// The Dowson-Higginson law with its universal constants, `rho_0` (kg/m³) at ambient pressure, any temperature.
    pub fn dowson_higginson(rho_0: f64) -> Result<Self, LawError> {
        DowsonHigginson::new(rho_0, None).map(Self::DowsonHigginson)
    }

    /// Density (kg/m³) at `pressure` (Pa above ambient) and `temperature` (K).
    #[inline]
    pub fn density<D: Scalar>(&self, pressure: D, temperature: D) -> D {
        match self {
            Self::Constant(law) => law.density(pressure, temperature),
            Self::DowsonHigginson(law) => law.density(pressure, temperature),
            Self::Tait(law) => law.density(pressure, temperature),
            Self::Murnaghan(law) => law.density(pressure, temperature),
            Self::Table(law) => law.evaluate(pressure, temperature),
        }
    }

    /// Density over that at ambient pressure and `reference` (K): `V_R/V`.
    #[inline]
    pub(crate) fn relative<D: Scalar>(&self, pressure: D, temperature: D, reference: f64) -> D {
        self.density(pressure, temperature) / self.density(0.0, reference)
    }

    /// Name of the law as written in data files.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Constant(_) => "constant",
            Self::DowsonHigginson(_) => "dowson-higginson",
            Self::Tait(_) => "tait",
            Self::Murnaghan(_) => "murnaghan",
            Self::Table(_) => "table",
        }
    }

    /// Whether the density changes with temperature: only then does pressure heat the lubricant.
    pub fn depends_on_temperature(&self) -> bool {
        match self {
            Self::Constant(_) => false,
            Self::DowsonHigginson(law) => {
                (law.thermal.as_ref()).is_some_and(|thermal| thermal.temperature_coefficient != 0.0)
            }
            Self::Tait(law) => law.volume.thermal.is_some(),
            Self::Murnaghan(law) => law.thermal.is_some(),
            Self::Table(law) => law.depends_on_temperature(),
        }
    }

    /// Range `(min, max)` of pressure (Pa) and of temperature (K) covered by tabulated data; `None` for a formula.
    pub fn tabulated_range(&self) -> Option<[(f64, f64); 2]> {
        match self {
            Self::Table(law) => Some(law.range()),
            _ => None,
        }
    }
}
