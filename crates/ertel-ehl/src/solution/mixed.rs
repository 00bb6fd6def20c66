//! Mixed lubrication of rough surfaces, SI.

use serde::Serialize;

use super::{Estimate, Separation};

/// Film over roughness, and load and friction of the asperities: a model on the film of smooth surfaces ([`crate::mixed`]).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MixedLubrication {
    /// λ = h_min/σ, minimum film over composite rms height.
    pub lambda_minimum: Estimate,
    /// h_c/σ.
    pub lambda_central: Estimate,
    /// Lubrication regime by the lambda ratio of the minimum film.
    pub separation: Separation,
    /// Load of the asperities, where the case describes them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub asperities: Option<AsperityFigures>,
}

/// Load of the asperities after Greenwood and Tripp (1970). Error bars are of the film alone.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AsperityFigures {
    /// W_a: N, in line contacts N/m. It may exceed the load where the film of smooth surfaces is far too thin.
    pub asperity_load: Estimate,
    /// L = W_a/W, likewise.
    pub asperity_load_share: Estimate,
    /// L if the film were thinner by its central thickness everywhere, but not below nothing: about the gap of the dry contact, and more than L
    /// can become. Where it is below one, the model has no boundary lubrication.
    pub asperity_load_share_limit: f64,
    /// Asperity pressure where the film is thinnest, Pa.
    pub asperity_pressure_maximum: f64,
    /// Friction of film and asperities, with a boundary friction coefficient and sliding surfaces.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub friction: Option<MixedFriction>,
}

/// Friction coefficients along the entrainment, with the sign of the traction coefficient. Asperities have the share L of the load, at the
/// most all of it, the film has the rest.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct MixedFriction {
    /// Of the film: (1 − L) times the traction coefficient at mid-film.
    pub friction_fluid: Estimate,
    /// Of the asperities: boundary friction coefficient times their load in the direction of sliding, over the load.
    pub friction_asperities: Estimate,
    /// Both.
    pub friction_total: Estimate,
    /// The same three across the entrainment, where the contact is not symmetric about y = 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub across: Option<[Estimate; 3]>,
}

impl MixedLubrication {
    /// Friction, if the case has it.
    pub fn friction(&self) -> Option<&MixedFriction> {
        self.asperities.as_ref()?.friction.as_ref()
    }
}

impl MixedFriction {
    /// Sizes of the coefficients of film, asperities and both, both components together.
    pub fn sizes(&self) -> [f64; 3] {
        let along = [
            self.friction_fluid,
            self.friction_asperities,
            self.friction_total,
        ];
        std::array::from_fn(|i| {
            let across = self.across.map_or(0.0, |across| across[i].value);
            along[i].value.hypot(across)
        })
    }
}
