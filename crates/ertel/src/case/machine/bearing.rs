//! What ball and roller bearings share: rings, and kinematics without sliding.
//!
//! Source: Harris and Kotzalas, Essential Concepts of Bearing Technology, 5th ed., 2007, chapters 2 (geometry) and 10
//! (speeds), where γ is defined and the cage speed derived.

use ertel_input::{InputError, Table};
use ertel_quantity::Dimension;

use super::{ANGULAR_SPEED, Rows};
use crate::contact::Motion;

/// Source of geometry and speeds.
pub(super) const SOURCE: &str = "Harris and Kotzalas 2007, chapters 2 and 10";

/// The ring that the rolling element is pressed against in this contact.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Ring {
    Inner,
    Outer,
}

impl Ring {
    /// Reads the key `ring`.
    pub fn read(table: &mut Table<'_>) -> Result<Ring, InputError> {
        table.required_choice("ring", &[("inner", Ring::Inner), ("outer", Ring::Outer)])
    }

    pub fn name(self) -> &'static str {
        match self {
            Ring::Inner => "inner",
            Ring::Outer => "outer",
        }
    }

    /// Reduced radius (m) in the plane of rolling of an element of the diameter `d` (m), γ being the ratio of
    /// d cos α to the pitch diameter.
    ///
    /// The raceway touches the element at the radius d_m (1 ∓ γ)/2 from the bearing's axis, and its curvature in the
    /// plane of rolling is ±(2/d) γ/(1 ∓ γ), upper signs for the inner ring:
    ///
    /// 1/R_x = 2/d ± (2/d) γ/(1 ∓ γ) = (2/d)/(1 ∓ γ)
    pub fn radius_of_rolling(self, d: f64, gamma: f64) -> f64 {
        match self {
            Ring::Inner => 0.5 * d * (1.0 - gamma),
            Ring::Outer => 0.5 * d * (1.0 + gamma),
        }
    }

    /// Name and formula of [`Ring::radius_of_rolling`].
    pub fn formula(self) -> &'static str {
        match self {
            Ring::Inner => "R_x = D (1 − γ)/2",
            Ring::Outer => "R_x = D (1 + γ)/2",
        }
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

/// Reads the speeds of both rings, and finds the motion of a contact in which the element rolls.
///
/// The element rolls on both rings, so that the cage turns at ω_m = [ω_i (1 − γ) + ω_o (1 + γ)]/2. Seen from the cage, the
/// inner raceway moves past the contact at (ω_i − ω_m) d_m (1 − γ)/2, the outer one at (ω_m − ω_o) d_m (1 + γ)/2, and
/// these are one speed, with which both surfaces of either contact move:
///
/// u = |ω_i − ω_o| d_m (1 − γ²)/4,  ω in rad/s, d_m in m, u in m/s
///
/// Its direction does not count, because x goes along with it. Skidding is left out. Comes with ω_i − ω_o.
pub(super) fn rolling(
    table: &mut Table<'_>,
    pitch_diameter: f64,
    gamma: f64,
    rows: &mut Rows,
) -> Result<(Motion, f64), InputError> {
    let inner =
        table.required_quantity("inner_ring_speed", Dimension::ANGULAR_SPEED, ANGULAR_SPEED)?;
    let outer = table
        .optional_quantity("outer_ring_speed", Dimension::ANGULAR_SPEED, ANGULAR_SPEED)?
        .unwrap_or(0.0);
    let speed = (inner - outer).abs() * pitch_diameter * (1.0 - gamma * gamma) / 4.0;
    let motion = super::motion(table, "inner_ring_speed", speed, speed)?;
    let cage = 0.5 * (inner * (1.0 - gamma) + outer * (1.0 + gamma));
    rows.number("cage [ω_i (1−γ) + ω_o (1+γ)]/2", cage, "rad/s");
    rows.number("u = |ω_i − ω_o| d_m (1 − γ²)/4", speed, "m/s");
    Ok((motion, inner - outer))
}
