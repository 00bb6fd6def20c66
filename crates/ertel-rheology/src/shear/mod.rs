//! Shear thinning: the generalized Newtonian viscosity as a function of shear stress.
//!
//! A generalized Newtonian lubricant has the shear rate `γ̇ = τ/η` along the shear stress `τ`, with a viscosity `η` that
//! depends on the size of the stress alone, the equivalent stress `τ_e = |τ|`. All laws are written for the relative
//! fluidity `μ₁/η` over `τ_e²`: μ₁ is the low-shear viscosity that the viscosity law of the lubricant gives, and the
//! square has derivatives at zero stress. Stresses are in Pa, pressure is the rise above ambient (Pa), temperature is
//! absolute (K), viscosity is in Pa·s.
//!
//! The relative fluidity is 1 at zero stress, grows with the stress, and is twice continuously differentiable; it
//! stays finite up to stresses of 1e30 Pa and beyond.

mod carreau;
mod carreau_yasuda;
mod limit;
mod limits;
mod numbers;
mod rabinowitsch;
mod ree_eyring;

pub use carreau::Carreau;
pub use carreau_yasuda::CarreauYasuda;
pub use limit::StressLimit;
pub use rabinowitsch::Rabinowitsch;
pub use ree_eyring::ReeEyring;

use crate::Scalar;
use crate::error::LawError;

/// Generalized Newtonian behaviour: how stress thins the lubricant. With neither law nor limit it does not.
#[derive(Debug, Clone, PartialEq)]
pub struct ShearThinning {
    /// Thinning law.
    pub law: Option<ShearLaw>,
    /// Limiting stress; multiplies the fluidity of the law.
    pub limit: Option<StressLimit>,
}

/// The shear-thinning laws.
#[derive(Debug, Clone, PartialEq)]
pub enum ShearLaw {
    /// `η = μ₂ + (μ₁ - μ₂) / [1 + (τ_e/G_c)^β_c]^((1/n_c - 1)/β_c)`
    Carreau(Carreau),
    /// `η = μ₂ + (μ₁ - μ₂) [1 + (λ γ̇)^a]^((n - 1)/a)`, `λ = μ₁/G`
    CarreauYasuda(CarreauYasuda),
    /// `γ̇ = (τ₀/μ₁) sinh(τ_e/τ₀)`
    ReeEyring(ReeEyring),
    /// `γ̇ = (τ_e/μ₁) [1 + (τ_e/τ₀)^(1/n - 1)]`
    Rabinowitsch(Rabinowitsch),
}

/// Stresses (Pa) around which the fluidity changes its course; a quadrature over stress must resolve them.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct StressScales {
    /// Beyond it the fluidity is about a power of the stress: G_c, G, or τ₀ of the power law.
    pub knee: Option<f64>,
    /// The fluidity grows e-fold over it: Eyring's τ₀.
    pub growth: Option<f64>,
    /// Limiting stress τ_L. Beyond it the fluidity grows e-fold per 0.1 % of it.
    pub limit: Option<f64>,
}

impl ShearThinning {
    /// Whether the shear rate grows exponentially with the stress: beyond a limit, or in Eyring's fluid.
    pub fn is_exponential(&self) -> bool {
        self.limit.is_some() || matches!(self.law, Some(ShearLaw::ReeEyring(_)))
    }

    /// A law without limiting stress.
    pub fn of(law: ShearLaw) -> Self {
        Self {
            law: Some(law),
            limit: None,
        }
    }

    /// A limiting stress alone: Newtonian far below it.
    pub fn limited(limit: StressLimit) -> Self {
        Self {
            law: None,
            limit: Some(limit),
        }
    }

    /// Low-shear over generalized viscosity, `μ₁/η`, at the square of the equivalent stress, `stress_squared` (Pa²),
    /// and `pressure` (Pa above ambient). The shear rate is `γ̇ = τ/μ₁` times the result.
    ///
    /// The constants of the laws are stresses and ratios of viscosities: only the limit changes with the pressure.
    /// Derivatives up to the second by both arguments are finite, at zero stress too. Where the result passes 1e65 it
    /// continues as a parabola of its logarithm, so that no stress up to 1e30 Pa makes it overflow.
    #[inline]
    pub fn relative_fluidity<D: Scalar>(&self, stress_squared: D, pressure: D) -> D {
        match (&self.law, &self.limit) {
            (None, None) => D::from(1.0),
            (Some(law), None) => law.relative_fluidity(stress_squared),
            (None, Some(limit)) => limit.factor(stress_squared, pressure),
            (Some(law), Some(limit)) => {
                law.relative_fluidity(stress_squared) * limit.factor(stress_squared, pressure)
            }
        }
    }

    /// Whether [`ShearThinning::relative_fluidity`] depends on the pressure.
    pub fn depends_on_pressure(&self) -> bool {
        self.limit
            .as_ref()
            .is_some_and(|limit| limit.pressure_coefficient > 0.0)
    }

    /// Stresses that a quadrature across the film must resolve at `pressure` (Pa above ambient).
    pub fn scales(&self, pressure: f64) -> StressScales {
        let mut scales = StressScales::default();
        match &self.law {
            Some(ShearLaw::Carreau(law)) => scales.knee = Some(law.critical_stress),
            Some(ShearLaw::CarreauYasuda(law)) => scales.knee = Some(law.shear_modulus),
            Some(ShearLaw::ReeEyring(law)) => scales.growth = Some(law.eyring_stress),
            Some(ShearLaw::Rabinowitsch(law)) => scales.knee = Some(law.critical_stress),
            None => {}
        }
        scales.limit = self
            .limit
            .as_ref()
            .map(|limit| limit.limiting_stress(pressure));
        scales
    }

    /// The constants of law and limit, in the order of their fields, in SI.
    pub fn constants(&self) -> Vec<f64> {
        let mut constants = match &self.law {
            Some(ShearLaw::Carreau(law)) => vec![
                law.critical_stress,
                law.exponent,
                law.transition,
                law.plateau_ratio,
            ],
            Some(ShearLaw::CarreauYasuda(law)) => vec![
                law.shear_modulus,
                law.exponent,
                law.transition,
                law.plateau_ratio,
            ],
            Some(ShearLaw::ReeEyring(law)) => vec![law.eyring_stress],
            Some(ShearLaw::Rabinowitsch(law)) => vec![law.critical_stress, law.exponent],
            None => Vec::new(),
        };
        if let Some(limit) = &self.limit {
            constants.extend([limit.ambient_limit, limit.pressure_coefficient]);
        }
        constants
    }

    /// The same law with other constants, as many and in the same order as [`ShearThinning::constants`].
    ///
    /// # Errors
    /// When a law cannot have them.
    ///
    /// # Panics
    /// When there are fewer.
    pub fn with_constants(&self, constants: &[f64]) -> Result<Self, LawError> {
        let mut next = constants.iter().copied();
        let mut take = || next.next().expect("a constant for each of the law's");
        let law =
            match &self.law {
                Some(ShearLaw::Carreau(_)) => Some(ShearLaw::Carreau(Carreau::new(
                    take(),
                    take(),
                    take(),
                    take(),
                )?)),
                Some(ShearLaw::CarreauYasuda(_)) => Some(ShearLaw::CarreauYasuda(
                    CarreauYasuda::new(take(), take(), take(), take())?,
                )),
                Some(ShearLaw::ReeEyring(_)) => Some(ShearLaw::ReeEyring(ReeEyring::new(take())?)),
                Some(ShearLaw::Rabinowitsch(_)) => {
                    Some(ShearLaw::Rabinowitsch(Rabinowitsch::new(take(), take())?))
                }
                None => None,
            };
        let limit = match &self.limit {
            Some(limit) => Some(StressLimit::new(take(), take())?.softened(limit.joint)),
            None => None,
        };
        Ok(Self { law, limit })
    }

    /// Name of the law as written in data files; `limiting-stress` for a limit without law.
    pub fn name(&self) -> &'static str {
        self.law.as_ref().map_or("limiting-stress", ShearLaw::name)
    }

    /// The law in words: `carreau`, `ree-eyring with limiting stress`, `limiting-stress`.
    pub fn describe(&self) -> String {
        match (&self.law, &self.limit) {
            (Some(law), Some(_)) => format!("{} with limiting stress", law.name()),
            _ => self.name().to_owned(),
        }
    }
}

impl ShearLaw {
    /// `μ₁/η` of the law without limiting stress, at `stress_squared` (Pa²).
    #[inline]
    pub fn relative_fluidity<D: Scalar>(&self, stress_squared: D) -> D {
        match self {
            Self::Carreau(law) => law.relative_fluidity(stress_squared),
            Self::CarreauYasuda(law) => law.relative_fluidity(stress_squared),
            Self::ReeEyring(law) => law.relative_fluidity(stress_squared),
            Self::Rabinowitsch(law) => law.relative_fluidity(stress_squared),
        }
    }

    /// Name of the law as written in data files.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Carreau(_) => "carreau",
            Self::CarreauYasuda(_) => "carreau-yasuda",
            Self::ReeEyring(_) => "ree-eyring",
            Self::Rabinowitsch(_) => "rabinowitsch",
        }
    }
}
