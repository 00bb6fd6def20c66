//! Heat capacity as a function of pressure and temperature, of lubricants and of solids.
//!
//! Pressure is the rise above ambient (Pa), temperature is absolute (K), heat capacity is per mass, in J/(kg·K). Every
//! law is positive far outside its data, too: a heat equation must not lose its sign on the way to its solution.

mod constant;
mod larsson_andersson;
mod linear;
mod scaling;

pub use crate::linear::LinearFactor;
pub use constant::Constant;
pub use larsson_andersson::{LarssonAndersson, VolumetricConstants};
pub use linear::Linear;
pub use scaling::{Scaling, ScalingConstants};

use crate::{Isotherms, LawError, Scalar};

/// The heat capacity laws.
#[derive(Debug, Clone, PartialEq)]
pub enum HeatCapacityLaw {
    /// `c = c₀`
    Constant(Constant),
    /// `c = c₀ [1 + a_T (T - T_R) + a_p p]`
    Linear(Linear),
    /// `ρ c = (ρ c)₀ [1 + β₀ (1 + b₁ p + b₂ p²) (T - T_R)] [1 + k₁ p / (1 + k₂ p)]`
    LarssonAndersson(LarssonAndersson),
    /// `ρ c = C₀ + m (T/T_R) (V/V_R)^(-w)`
    Scaling(Scaling),
    /// Monotone interpolation in a table over pressure and temperature, [`Isotherms::held`].
    Table(Isotherms),
}

impl HeatCapacityLaw {
    /// A heat capacity `c_0` (J/(kg·K)) that does not change.
    ///
    /// # Errors
    ///
    /// A value that is not positive and finite.
    pub fn constant(c_0: f64) -> Result<Self, LawError> {
        Constant::new(c_0).map(Self::Constant)
    }

    /// Heat capacity (J/(kg·K)) at `pressure` (Pa above ambient) and `temperature` (K).
    #[inline]
    pub fn heat_capacity<D: Scalar>(&self, pressure: D, temperature: D) -> D {
        match self {
            Self::Constant(law) => law.heat_capacity(pressure, temperature),
            Self::Linear(law) => law.heat_capacity(pressure, temperature),
            Self::LarssonAndersson(law) => law.heat_capacity(pressure, temperature),
            Self::Scaling(law) => law.heat_capacity(pressure, temperature),
            Self::Table(law) => law.evaluate(pressure, temperature),
        }
    }

    /// The value (J/(kg·K)) of a law that is one number; `None` for a law that depends on something.
    pub fn constant_value(&self) -> Option<f64> {
        match self {
            Self::Constant(law) => Some(law.c_0),
            _ => None,
        }
    }

    /// Name of the law as written in data files.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Constant(_) => "constant",
            Self::Linear(_) => "linear",
            Self::LarssonAndersson(_) => "larsson-andersson",
            Self::Scaling(_) => "scaling",
            Self::Table(_) => "table",
        }
    }

    /// Range `(min, max)` of pressure (Pa) and of temperature (K) covered by tabulated data, infinite in pressure for a
    /// table over temperature alone; `None` for a formula.
    pub fn tabulated_range(&self) -> Option<[(f64, f64); 2]> {
        match self {
            Self::Table(law) => Some(law.range()),
            _ => None,
        }
    }
}
