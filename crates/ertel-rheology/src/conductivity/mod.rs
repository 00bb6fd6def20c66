//! Thermal conductivity as a function of pressure and temperature, of lubricants and of solids, in W/(m·K).

mod larsson_andersson;
mod scaling;

pub use larsson_andersson::LarssonAndersson;
pub use scaling::{Scaling, ScalingConstants};

use crate::Scalar;
use crate::property::{Property, PropertyLaw};

/// Thermal conductivity k (W/(m·K)).
#[derive(Debug, Clone, PartialEq)]
pub struct Conductivity;

/// The conductivity laws.
///
/// ```text
/// constant             k = k₀
/// linear               k = k₀ [1 + a_T (T - T_R) + a_p p]
/// larsson-andersson    k = k₀ [1 + d₁ p / (1 + d₂ p)]
/// scaling              k = B + C κ^(-s),   κ = (V/V_R) [1 + A (T/T_R) (V/V_R)^q]
/// ```
pub type ConductivityLaw = PropertyLaw<Conductivity>;

impl Property for Conductivity {
    const KEY: &'static str = "k_0";
    type LarssonAndersson = LarssonAndersson;
    type Scaling = Scaling;

    #[inline]
    fn larsson_andersson<D: Scalar>(law: &LarssonAndersson, pressure: D, _temperature: D) -> D {
        law.conductivity(pressure)
    }

    #[inline]
    fn scaling<D: Scalar>(law: &Scaling, pressure: D, temperature: D) -> D {
        law.conductivity(pressure, temperature)
    }
}

impl ConductivityLaw {
    /// Conductivity (W/(m·K)) at `pressure` (Pa above ambient) and `temperature` (K).
    #[inline]
    pub fn conductivity<D: Scalar>(&self, pressure: D, temperature: D) -> D {
        self.value(pressure, temperature)
    }
}
