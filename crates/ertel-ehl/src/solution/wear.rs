//! Wear over a sliding distance, SI.

use serde::Serialize;

use super::Estimate;

/// Wear of the bodies, and the contact over the sliding distance ([`crate::wear`]).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Wear {
    /// How reliable the numbers are.
    pub label: &'static str,
    /// Sliding distance, m.
    pub sliding_distance: f64,
    /// Steps in which the gap has changed.
    pub steps: usize,
    /// Wear of body 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub body_1: Option<BodyWear>,
    /// Wear of body 2.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub body_2: Option<BodyWear>,
    /// The contact before the first step and after each one.
    pub course: Vec<WearStep>,
}

impl Wear {
    /// Label of all wear.
    pub const LABEL: &'static str = "trend: Archard's law with an assumed coefficient";

    /// Bodies that wear, with their numbers.
    pub fn bodies(&self) -> impl Iterator<Item = (usize, &BodyWear)> {
        let all = [(1, &self.body_1), (2, &self.body_2)];
        all.into_iter()
            .filter_map(|(n, body)| Some((n, body.as_ref()?)))
    }
}

/// Wear of a body; error bars are those of the steps and of the load of the asperities.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BodyWear {
    /// k.
    pub wear_coefficient: f64,
    /// H, Pa.
    pub hardness: f64,
    /// Length of the track, m, of a body that moves through the contact.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub track_length: Option<f64>,
    /// Largest depth, m.
    pub depth: Estimate,
    /// Worn volume k/H ∫ W_a ds, m³; of line contacts m² (per length).
    pub volume: Estimate,
    /// Volume between the worn and the new surface over that, less 1.
    pub volume_deviation: f64,
    /// Length along the motion of the part with at least 1 % of the largest depth, m; of a body at rest.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub length: Option<f64>,
    /// Its width across the motion, m; not of line contacts.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub width: Option<f64>,
    /// Places along the motion through the centre, and across it, with the depths there, m.
    #[serde(skip)]
    pub profiles: [Vec<[f64; 2]>; 2],
}

/// The contact at a sliding distance.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct WearStep {
    /// Sliding distance, m.
    pub sliding_distance: f64,
    /// Load of the asperities over the whole load.
    pub asperity_load_share: f64,
    /// Central film, m.
    pub film_central: f64,
    /// Smallest film, m.
    pub film_minimum: f64,
    /// Largest pressure of oil and asperities, Pa.
    pub pressure_maximum: f64,
    /// Friction of film and asperities.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub friction_total: Option<f64>,
    /// Largest depth of body 1, m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub body_1_depth: Option<f64>,
    /// That of body 2, m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub body_2_depth: Option<f64>,
    /// Worn volume of body 1, m³ or m².
    #[serde(skip_serializing_if = "Option::is_none")]
    pub body_1_volume: Option<f64>,
    /// That of body 2, m³ or m².
    #[serde(skip_serializing_if = "Option::is_none")]
    pub body_2_volume: Option<f64>,
}
