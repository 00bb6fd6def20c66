//! Balances that a solution should satisfy, each as a separate error.

use serde::Serialize;

/// Two sides of a balance, and by how much they differ.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Balance {
    /// One side.
    pub value: f64,
    /// The other, computed another way.
    pub other: f64,
    /// (value − other)/the larger of both; 0 where both are 0.
    pub error: f64,
}

impl Balance {
    /// Of both sides.
    pub fn of(value: f64, other: f64) -> Balance {
        let size = value.abs().max(other.abs());
        Balance {
            value,
            other,
            error: if size > 0.0 {
                (value - other) / size
            } else {
                0.0
            },
        }
    }
}

/// Balances of a solution.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Checks {
    /// Work of the surfaces, W (W/m), against its sinks: the dissipation of shear and the work of the pressure where the bodies end; in
    /// thermal contacts the heat made by shear and compression, over all of the contact area.
    pub power: Balance,
    /// Traction coefficient at body 2 less that at body 1, and −∫p ∂h_0/∂x dA over the load, for the undeformed gap h_0: over all of the
    /// contact area.
    pub rolling: Balance,
    /// |∫p − load|/load, that of the summary.
    #[serde(rename = "load_balance_error")]
    pub load: f64,
    /// Mass balance upstream of the centre: (inflow through the inlet edge − side leakage − flow through the section x = 0)/inflow, that of the summary.
    #[serde(rename = "film_balance_error")]
    pub mass: f64,
    /// (heat made − heat carried off)/(heat of shear + size of the heat of compression); `None` in isothermal contacts.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[serde(rename = "heat_balance_error")]
    pub heat: Option<f64>,
}

/// Range of the integrals of shear: traction, moment and friction power.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct SummedTo {
    /// How far the bodies face each other along the principal direction of the contact nearest to the motion, m.
    pub body_end_x: f64,
    /// The same along the other one; `None` of lines and rollers, whose film ends with them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub body_end_y: Option<f64>,
    /// Whether the integrals end there; else with the contact area.
    pub ends_with_bodies: bool,
}
