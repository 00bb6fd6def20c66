//! Effects that the model neglects, with their estimated size.

use serde::Serialize;

/// Estimates of effects that a solve neglects. A size is `None` where it cannot be estimated.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Neglected {
    /// Heat; `None` where the solve has it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub heat: Option<NeglectedHeat>,
    /// Inertia of the film over its viscous forces.
    pub inertia: f64,
    /// Hertz pressure over the limit of the weaker body.
    pub plasticity: f64,
    /// Minimum film over the rms roughness; `None` where no roughness is given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lambda: Option<f64>,
    /// Whether asperities share the load, so that roughness itself is not neglected.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub has_asperities: bool,
}

/// Heat that an isothermal contact neglects.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct NeglectedHeat {
    /// Factor by which the heat of shear in the inlet thins the film.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub film_factor: Option<f64>,
    /// Why there is no estimate.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub film_factor_missing: Option<&'static str>,
    /// Mean rise of the film in the contact by the heat of friction, K.
    pub temperature_rise: f64,
    /// Whether the rise is a lower bound: bodies without thermal data count as steel, and a lubricant without conductivity as a conductor.
    pub is_lower_bound: bool,
}
