//! Why a geometry makes no bearing, and checks that all kinds share.

use ertel_ehl::words::digits;

use super::Ring;

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
