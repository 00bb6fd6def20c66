//! Newtonian viscosity as a function of pressure and temperature.
//!
//! Pressure is the rise above ambient (Pa), temperature is absolute (K), viscosity is in Pa·s. Every law is written for
//! the logarithm of the viscosity, which stays finite where the viscosity itself leaves the range of floating point.

mod barus;
mod cheng;
mod coefficient;
mod constant;
mod doolittle;
mod glass;
mod hybrid;
mod mcewen;
mod paluch;
mod roelands;
mod walther;
mod wlf;
mod yasutomi;

pub use barus::Barus;
pub use cheng::Cheng;
pub use constant::Constant;
pub use doolittle::{Doolittle, OccupiedVolume};
pub use glass::GlassTransition;
pub use hybrid::Hybrid;
pub use mcewen::McEwen;
pub use paluch::Paluch;
pub use roelands::{Roelands, TemperatureSlope};
pub use walther::{PressureLaw, Walther};
pub use wlf::ModifiedWlf;
pub use yasutomi::ImprovedYasutomi;

use thiserror::Error;

use crate::provenance::celsius;
use crate::{Isotherms, LawError, Scalar};

/// The viscosity laws.
#[derive(Debug, Clone, PartialEq)]
pub enum ViscosityLaw {
    /// `μ = μ₀`
    Constant(Constant),
    /// `μ = μ₀ exp(α p)`
    Barus(Barus),
    /// `μ = μ₀ exp[α p + β (1/T - 1/T_R) + γ p/T]`
    Cheng(Cheng),
    /// `μ = μ₀ exp{(ln μ₀ + 9.67) [-1 + (1 + p/p₀)^Z ((T - 138)/(T_R - 138))^(-S₀)]}`
    Roelands(Roelands),
    /// `μ = μ_g 10^[-C₁ (T - T_g) F / (C₂ + (T - T_g) F)]`
    ModifiedWlf(ModifiedWlf),
    /// `μ = μ₀ exp{B R₀ [v∞ / (V/V_R - R₀ v∞) - 1/(1 - R₀)]}`
    Doolittle(Doolittle),
    /// `μ = μ_g exp[-2.303 C₁ (T - T_g) F / (C₂ + (T - T_g) F)]`, `F = (1 + b₁ p)^b₂`
    ImprovedYasutomi(ImprovedYasutomi),
    /// `μ = μ₀ (1 + α p / q)^q`
    McEwen(McEwen),
    /// `μ = μ₀ exp[C_F p / (p∞ - p)]`
    Paluch(Paluch),
    /// `μ = μ₀ (1 + a₀ p / q)^q exp[C_F p / (p∞ - p)]`
    Hybrid(Hybrid),
    /// `μ = ν(T) ρ(0, T)` with Walther's equation, times the growth with pressure of Roelands or Barus
    Walther(Walther),
    /// Monotone interpolation of `ln μ` in a table over pressure and temperature, [`Isotherms::of_logarithms`].
    Table(Isotherms),
}

impl ViscosityLaw {
    /// A viscosity `mu_0` (Pa·s) that does not change.
    pub fn constant(mu_0: f64) -> Result<Self, LawError> {
        Constant::new(mu_0).map(Self::Constant)
    }

    /// Barus' law with `mu_0` (Pa·s) and `alpha` (1/Pa).
    pub fn barus(mu_0: f64, alpha: f64) -> Result<Self, LawError> {
        Barus::new(mu_0, alpha).map(Self::Barus)
    }

    /// Roelands' law with `mu_0` (Pa·s), `alpha` (1/Pa) and the law's own pressure constant, any temperature.
    pub fn roelands(mu_0: f64, alpha: f64) -> Result<Self, LawError> {
        Roelands::from_alpha(mu_0, alpha, Roelands::PRESSURE_CONSTANT, None).map(Self::Roelands)
    }

    /// Viscosity (Pa·s) at `pressure` (Pa above ambient) and `temperature` (K).
    ///
    /// Overflows to infinity where `ln μ` exceeds about 709; [`ViscosityLaw::ln_viscosity`] does not.
    #[inline]
    pub fn viscosity<D: Scalar>(&self, pressure: D, temperature: D) -> D {
        self.ln_viscosity(pressure, temperature).exp()
    }

    /// Natural logarithm of the viscosity in Pa·s at `pressure` (Pa above ambient) and `temperature` (K).
    #[inline]
    pub fn ln_viscosity<D: Scalar>(&self, pressure: D, temperature: D) -> D {
        match self {
            Self::Constant(law) => law.ln_viscosity(pressure, temperature),
            Self::Barus(law) => law.ln_viscosity(pressure, temperature),
            Self::Cheng(law) => law.ln_viscosity(pressure, temperature),
            Self::Roelands(law) => law.ln_viscosity(pressure, temperature),
            Self::ModifiedWlf(law) => law.ln_viscosity(pressure, temperature),
            Self::Doolittle(law) => law.ln_viscosity(pressure, temperature),
            Self::ImprovedYasutomi(law) => law.ln_viscosity(pressure, temperature),
            Self::McEwen(law) => law.ln_viscosity(pressure, temperature),
            Self::Paluch(law) => law.ln_viscosity(pressure, temperature),
            Self::Hybrid(law) => law.ln_viscosity(pressure, temperature),
            Self::Walther(law) => law.ln_viscosity(pressure, temperature),
            Self::Table(law) => law.evaluate(pressure, temperature),
        }
    }

    /// Name of the law as written in data files.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Constant(_) => "constant",
            Self::Barus(_) => "barus",
            Self::Cheng(_) => "cheng",
            Self::Roelands(_) => "roelands",
            Self::ModifiedWlf(_) => "wlf",
            Self::Doolittle(_) => "doolittle",
            Self::ImprovedYasutomi(_) => "yasutomi",
            Self::McEwen(_) => "mcewen",
            Self::Paluch(_) => "paluch",
            Self::Hybrid(_) => "mcewen-paluch",
            Self::Walther(_) => "walther",
            Self::Table(_) => "table",
        }
    }

    /// Temperature (K) at which the reference viscosity of the law holds; `None` if no constant of the law is one.
    pub fn reference_temperature(&self) -> Option<f64> {
        match self {
            Self::Cheng(law) => Some(law.reference_temperature),
            Self::Roelands(law) => law.thermal.as_ref().map(|t| t.reference_temperature),
            Self::Doolittle(law) => law.thermal.as_ref().map(|t| t.reference_temperature),
            Self::Walther(law) => Some(law.reference_temperature),
            Self::Constant(_)
            | Self::Barus(_)
            | Self::ModifiedWlf(_)
            | Self::ImprovedYasutomi(_)
            | Self::McEwen(_)
            | Self::Paluch(_)
            | Self::Hybrid(_)
            | Self::Table(_) => None,
        }
    }

    /// Whether the viscosity changes with temperature.
    pub fn depends_on_temperature(&self) -> bool {
        match self {
            Self::Constant(_)
            | Self::Barus(_)
            | Self::McEwen(_)
            | Self::Paluch(_)
            | Self::Hybrid(_) => false,
            Self::Cheng(law) => law.beta != 0.0 || law.gamma != 0.0,
            Self::Roelands(law) => law.thermal.as_ref().is_some_and(|t| t.beta != 0.0),
            Self::ModifiedWlf(_) | Self::ImprovedYasutomi(_) | Self::Walther(_) => true,
            Self::Doolittle(law) => law.thermal.is_some() || law.volume.thermal.is_some(),
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

/// The reciprocal asymptotic coefficient does not exist: the viscosity does not grow enough with pressure.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[error(
    "the viscosity does not grow enough with pressure at {} for a reciprocal asymptotic \
     pressure-viscosity coefficient",
    celsius(*.temperature)
)]
pub struct NoAsymptote {
    /// Temperature (K).
    pub temperature: f64,
}
