//! Functions for both ball and roller bearings: rings, and kinematics without sliding.
//!
//! Source: Harris and Kotzalas, Essential Concepts of Bearing Technology, 5th ed., 2007, chapters 2 (geometry) and 10
//! (speeds), where γ is defined and the cage speed derived.

use ertel_input::{InputError, Table};
use ertel_machines::bearing::geometry::Ring;
use ertel_machines::bearing::kinematics::{RollerMotion, Speeds};
use ertel_quantity::Dimension;

use super::{ANGULAR_SPEED, Rows};
use crate::contact::Motion;

/// Source of geometry and speeds.
pub(super) const SOURCE: &str = "Harris and Kotzalas 2007, chapters 2 and 10";

/// Reads the key `ring`: the one that the rolling element is pressed against in this contact.
pub(super) fn read_ring(table: &mut Table<'_>) -> Result<Ring, InputError> {
    table.required_choice("ring", &[("inner", Ring::Inner), ("outer", Ring::Outer)])
}

/// Name and formula of [`radius_along`](ertel_machines::bearing::geometry::radius_along).
pub(super) fn radius_formula(ring: Ring) -> &'static str {
    match ring {
        Ring::Inner => "R_x = D (1 − γ)/2",
        Ring::Outer => "R_x = D (1 + γ)/2",
    }
}

/// γ = D cos α/d_m of an element of the diameter at `key` (m), the contact angle α in rad; both diameters in m.
pub(super) fn gamma(
    table: &Table<'_>,
    key: &str,
    diameter: f64,
    pitch_diameter: f64,
    angle: f64,
) -> Result<f64, InputError> {
    if diameter >= pitch_diameter {
        return Err(table.error(key, format!("`{key}` must be less than `pitch_diameter`")));
    }
    Ok(diameter * angle.cos() / pitch_diameter)
}

/// Reads the speeds of both rings, and finds the motion of a contact in which the element rolls ([`RollerMotion`]). Its direction is irrelevant,
/// because x points along it. Skidding is neglected. Also returns the speeds of the rings.
pub(super) fn rolling(
    table: &mut Table<'_>,
    pitch_diameter: f64,
    gamma: f64,
    rows: &mut Rows,
) -> Result<(Motion, Speeds), InputError> {
    let inner =
        table.required_quantity("inner_ring_speed", Dimension::ANGULAR_SPEED, ANGULAR_SPEED)?;
    let outer = table
        .optional_quantity("outer_ring_speed", Dimension::ANGULAR_SPEED, ANGULAR_SPEED)?
        .unwrap_or(0.0);
    let speeds = Speeds { inner, outer };
    let found = RollerMotion::new(gamma, pitch_diameter, speeds);
    let speed = found.entrainment_speed;
    let motion = super::motion(table, "inner_ring_speed", speed, speed)?;
    rows.number("cage [ω_i (1−γ) + ω_o (1+γ)]/2", found.cage, "rad/s");
    rows.number("u = |ω_i − ω_o| d_m (1 − γ²)/4", speed, "m/s");
    Ok((motion, speeds))
}
