//! The main figures, SI.

use serde::Serialize;

use super::{Estimate, Located};

/// The figures that a tribologist asks for first.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Summary {
    /// Film thickness at the centre of the contact, m.
    pub film_central: Estimate,
    /// Smallest film thickness, m.
    pub film_minimum: Estimate,
    /// Where it is.
    pub film_minimum_at: Located,
    /// Smallest film thickness on the centreline y = 0, m.
    pub film_centreline_minimum: Located,
    /// Largest pressure, Pa; a lower bound where a ridge that the mesh does not resolve may exceed it.
    pub pressure_maximum: Located,
    /// Top of the smooth hill of the pressure on which the centre of the contact lies, Pa.
    pub pressure_central: Located,
    /// Largest pressure of the ridge before the outlet of a point contact, Pa; `None` without one, and in line contacts, whose ridge is the
    /// spike.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pressure_ridge: Option<Located>,
    /// Pressure spike near the outlet on the centreline, Pa; `None` when the profile has none.
    #[serde(rename = "pressure_spike")]
    pub spike: Option<Located>,
    /// Where the film breaks on the centreline, m.
    pub outlet_position: Estimate,
    /// Most negative pressure left by the cavitation penalty, Pa.
    pub pressure_minimum: f64,
    /// Mass balance upstream of the centre: (inflow through the inlet edge − side leakage − flow through the section x = 0)/inflow.
    pub film_balance_error: f64,
    /// |∫p − load|/load.
    pub load_balance_error: f64,
    /// Rigid-body separation h0 of the film equation, m.
    pub rigid_separation: f64,
}
