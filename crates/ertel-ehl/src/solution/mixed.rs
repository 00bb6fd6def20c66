//! Mixed lubrication of rough surfaces, SI.

use serde::Serialize;

use super::{Estimate, Separation};

/// Film over roughness, and load and friction of the asperities ([`crate::mixed`]).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MixedLubrication {
    /// λ = h_min/σ, minimum film over composite rms height: of smooth surfaces, or with asperities the distance of the mean planes.
    pub lambda_minimum: Estimate,
    /// h_c/σ.
    pub lambda_central: Estimate,
    /// Lubrication regime by the lambda ratio of the minimum film.
    pub separation: Separation,
    /// Load of the asperities, where they share it with the film.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub asperities: Option<AsperityFigures>,
}

/// Load of the asperities, solved together with the film. Error bars are those of the grids alone.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AsperityFigures {
    /// W_a: N, in line contacts N/m.
    pub asperity_load: Estimate,
    /// L = W_a/W.
    pub asperity_load_share: Estimate,
    /// Asperity pressure where the film is thinnest, Pa.
    pub asperity_pressure_maximum: f64,
    /// Friction of film and asperities, with a boundary friction coefficient and sliding surfaces.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub friction: Option<MixedFriction>,
    /// The same contact where the oil flows through the distance of the mean planes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub other_gap: Option<OtherGap>,
}

/// Figures where the oil flows through the distance of the mean planes, not the mean gap: with those of the mean gap a range of the model, which no error bar contains.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct OtherGap {
    /// Load of the asperities over the whole load.
    pub asperity_load_share: f64,
    /// Central distance of the mean planes, m.
    pub film_central: f64,
    /// Smallest distance of the mean planes, m.
    pub film_minimum: f64,
    /// Friction of film and asperities, along the entrainment.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub friction_total: Option<f64>,
}

/// Friction coefficients along the entrainment, with the sign of the traction coefficient, over the whole load.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct MixedFriction {
    /// Of the film: the traction coefficient at mid-film.
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
