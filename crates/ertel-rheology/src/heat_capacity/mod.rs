//! Heat capacity as a function of pressure and temperature, of lubricants and of solids, per mass in J/(kg·K).

mod larsson_andersson;
mod scaling;

pub use larsson_andersson::{LarssonAndersson, VolumetricConstants};
pub use scaling::{Scaling, ScalingConstants};

use crate::Scalar;
use crate::property::{Property, PropertyLaw};

/// Heat capacity c (J/(kg·K)).
#[derive(Debug, Clone, PartialEq)]
pub struct HeatCapacity;

/// The heat capacity laws.
///
/// ```text
/// constant             c = c₀
/// linear               c = c₀ [1 + a_T (T - T_R) + a_p p]
/// larsson-andersson    ρ c = (ρ c)₀ [1 + β₀ (1 + b₁ p + b₂ p²) (T - T_R)] [1 + k₁ p / (1 + k₂ p)]
/// scaling              ρ c = C₀ + m (T/T_R) (V/V_R)^(-w)
/// ```
pub type HeatCapacityLaw = PropertyLaw<HeatCapacity>;

impl Property for HeatCapacity {
    const KEY: &'static str = "c_0";
    type LarssonAndersson = LarssonAndersson;
    type Scaling = Scaling;

    #[inline]
    fn larsson_andersson<D: Scalar>(law: &LarssonAndersson, pressure: D, temperature: D) -> D {
        law.volumetric(pressure, temperature) / law.density.density(pressure, temperature)
    }

    #[inline]
    fn scaling<D: Scalar>(law: &Scaling, pressure: D, temperature: D) -> D {
        law.volumetric(pressure, temperature) / law.density.density(pressure, temperature)
    }
}

impl HeatCapacityLaw {
    /// Heat capacity (J/(kg·K)) at `pressure` (Pa above ambient) and `temperature` (K).
    #[inline]
    pub fn heat_capacity<D: Scalar>(&self, pressure: D, temperature: D) -> D {
        self.value(pressure, temperature)
    }
}
