//! Internal geometry of rolling bearings.

mod ball;
mod roller;
mod tapered;

pub use ball::{BallGeometry, Play};
pub use roller::{RollerGeometry, RollerProfile};
pub use tapered::TaperedGeometry;

use ertel_ehl::words::digits;

/// A ring of a bearing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ring {
    /// The ring on the shaft.
    Inner,
    /// The ring in the housing.
    Outer,
}

impl Ring {
    /// Inner, then outer ring: the order in all pairs of this module.
    pub const BOTH: [Ring; 2] = [Ring::Inner, Ring::Outer];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Ring::Inner => "inner",
            Ring::Outer => "outer",
        }
    }

    /// Place in a pair.
    pub fn index(self) -> usize {
        match self {
            Ring::Inner => 0,
            Ring::Outer => 1,
        }
    }

    /// −1 of the inner ring, whose raceway is convex along rolling, +1 of the outer.
    pub(crate) fn sign(self) -> f64 {
        match self {
            Ring::Inner => -1.0,
            Ring::Outer => 1.0,
        }
    }
}

/// Reduced radius of an element of the diameter D (m) on a raceway in the plane of rolling, m.
///
/// ```text
///   R_x = D/2 (1 ∓ γ),  γ = D cos α/d_m;   upper sign: inner ring
/// ```
/// Source: Harris and Kotzalas, Essential Concepts of Bearing Technology, 5th ed., 2007, chapter 2.
pub fn radius_along(ring: Ring, diameter: f64, gamma: f64) -> f64 {
    0.5 * diameter * (1.0 + ring.sign() * gamma)
}

/// Why a geometry makes no bearing.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum GeometryError {
    /// A length that must be positive and finite.
    #[error("{name} is {value} m; it must be positive and finite")]
    Length {
        /// Which one.
        name: &'static str,
        /// Its value, m.
        value: f64,
    },
    /// Elements that are as wide as the pitch circle.
    #[error("elements of {diameter} m do not fit on a pitch diameter of {pitch_diameter} m")]
    Pitch {
        /// Diameter of the elements, m.
        diameter: f64,
        /// Pitch diameter, m.
        pitch_diameter: f64,
    },
    /// More elements than the pitch circle holds, or too few to carry.
    #[error("{number} elements: the pitch circle holds 3 to {most}")]
    Number {
        /// How many there are.
        number: usize,
        /// How many fit.
        most: usize,
    },
    /// A groove that is not wider than the ball.
    #[error("groove curvature ratio {value} of the {} ring; it must be above 0.5 and finite", .ring.name())]
    Groove {
        /// Which ring.
        ring: Ring,
        /// Radius of the groove over diameter of the ball.
        value: f64,
    },
    /// A free contact angle outside of 0 to 85 degrees.
    #[error("free contact angle {degrees} degrees is out of range: 0 to 85 degrees")]
    Angle {
        /// The angle, degrees.
        degrees: f64,
    },
    /// A clearance beyond that of a free contact angle of 85 degrees.
    #[error(
        "radial clearance {} µm; the largest for these balls and grooves is {} µm, with a free contact angle of 85 degrees",
        digits(1e6 * .value, 4),
        digits(1e6 * .largest, 4)
    )]
    Clearance {
        /// The clearance, m.
        value: f64,
        /// The largest one, m.
        largest: f64,
    },
    /// A profile that is not one.
    #[error("crown radius {0} m; it must exceed half of the roller length")]
    Crown(f64),
}

pub(crate) fn positive(name: &'static str, value: f64) -> Result<(), GeometryError> {
    match value > 0.0 && value.is_finite() {
        true => Ok(()),
        false => Err(GeometryError::Length { name, value }),
    }
}

/// Checks what balls and rollers share: diameters in m, number of elements.
pub(crate) fn check_row(
    diameter: f64,
    pitch_diameter: f64,
    number: usize,
) -> Result<(), GeometryError> {
    positive("element diameter", diameter)?;
    positive("pitch diameter", pitch_diameter)?;
    if diameter >= pitch_diameter {
        return Err(GeometryError::Pitch {
            diameter,
            pitch_diameter,
        });
    }
    // Chords between neighbours: d_m sin(π/Z) ≥ D.
    let most = (std::f64::consts::PI / (diameter / pitch_diameter).asin() + 1e-9) as usize;
    if number < 3 || number > most {
        return Err(GeometryError::Number { number, most });
    }
    Ok(())
}
