//! Thermal conductivity as a function of pressure and temperature, of lubricants and of solids.
//!
//! Pressure is the rise above ambient (Pa), temperature is absolute (K), conductivity is in W/(m·K). Every law is
//! positive far outside its data, too: a heat equation must not lose its sign on the way to its solution.

mod constant;
mod larsson_andersson;
mod linear;
mod scaling;

pub use crate::linear::LinearFactor;
pub use constant::Constant;
pub use larsson_andersson::LarssonAndersson;
pub use linear::Linear;
pub use scaling::{Scaling, ScalingConstants};

use crate::{Isotherms, LawError, Scalar};

/// The conductivity laws.
#[derive(Debug, Clone, PartialEq)]
pub enum ConductivityLaw {
    /// `k = k₀`
    Constant(Constant),
    /// `k = k₀ [1 + a_T (T - T_R) + a_p p]`
    Linear(Linear),
    /// `k = k₀ [1 + d₁ p / (1 + d₂ p)]`
    LarssonAndersson(LarssonAndersson),
    /// `k = B + C κ^(-s)`, `κ = (V/V_R) [1 + A (T/T_R) (V/V_R)^q]`
    Scaling(Scaling),
    /// Monotone interpolation in a table over pressure and temperature, [`Isotherms::held`].
    Table(Isotherms),
}

impl ConductivityLaw {
    /// A conductivity `k_0` (W/(m·K)) that does not change.
    ///
    /// # Errors
    ///
    /// A value that is not positive and finite.
    pub fn constant(k_0: f64) -> Result<Self, LawError> {
        Constant::new(k_0).map(Self::Constant)
    }

    /// Conductivity (W/(m·K)) at `pressure` (Pa above ambient) and `temperature` (K).
    #[inline]
    pub fn conductivity<D: Scalar>(&self, pressure: D, temperature: D) -> D {
        match self {
            Self::Constant(law) => law.conductivity(pressure, temperature),
            Self::Linear(law) => law.conductivity(pressure, temperature),
            Self::LarssonAndersson(law) => law.conductivity(pressure, temperature),
            Self::Scaling(law) => law.conductivity(pressure, temperature),
            Self::Table(law) => law.evaluate(pressure, temperature),
        }
    }

    /// The value (W/(m·K)) of a law that is one number; `None` for a law that depends on something.
    pub fn constant_value(&self) -> Option<f64> {
        match self {
            Self::Constant(law) => Some(law.k_0),
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
