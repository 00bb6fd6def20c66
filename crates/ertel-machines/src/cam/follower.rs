//! Where followers touch a cam, and how the surfaces move there.

use super::CamError;
use super::error::in_range;

/// A follower that moves along y.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Follower {
    /// A flat face normal to its motion. One that turns about its own axis is not covered.
    Flat,
    /// A face of a radius that does not turn.
    Curved {
        /// Radius of the face r_f, m.
        radius: f64,
        /// Distance ε of the face's centre of curvature from the line through the cam's axis, m; positive towards x.
        offset: f64,
    },
    /// A roller.
    Roller {
        /// Radius r_f, m.
        radius: f64,
        /// Distance ε of the roller's path from the cam's axis, m; positive towards x.
        offset: f64,
        /// Slip 1 − u_1/u_2; 0 rolls.
        slip: f64,
    },
}

/// The place and the motion of a contact at one angle of the cam; speeds per ω, that is in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Contact, m from the cam's axis.
    pub contact: [f64; 2],
    /// Pressure angle between the normal of the contact and the motion of the follower, rad.
    pub pressure_angle: f64,
    /// Curvature of the cam, 1/m; negative where concave; of undercut places without meaning.
    pub cam_curvature: f64,
    /// Reduced radius R, m; not positive where undercut.
    pub reduced_radius: f64,
    /// Whether the cam cannot be made: the follower would cut away this part of it.
    pub undercut: bool,
    /// Speeds of the follower's and the cam's surface over ω, m.
    pub speeds: [f64; 2],
}

impl Follower {
    /// Radius of the follower's face, m; infinite if flat.
    pub fn radius(&self) -> f64 {
        match self {
            Follower::Flat => f64::INFINITY,
            Follower::Curved { radius, .. } | Follower::Roller { radius, .. } => *radius,
        }
    }

    /// Refuses numbers that no follower has, on a base circle of the radius r_b (m).
    pub(super) fn check(&self, base_radius: f64) -> Result<(), CamError> {
        let (Follower::Curved { radius, offset } | Follower::Roller { radius, offset, .. }) = self
        else {
            return Ok(());
        };
        in_range("radius of the follower", *radius, *radius > 0.0, "positive")?;
        let inside = offset.abs() < base_radius + radius;
        let requirement = "less than the sum of the base and the follower's radius";
        in_range("offset of the follower", *offset, inside, requirement)?;
        if let Follower::Roller { slip, .. } = self {
            in_range(
                "slip of the roller",
                *slip,
                slip.abs() <= 1.0,
                "from −1 to 1",
            )?;
        }
        Ok(())
    }

    /// The contact at the lift s and its derivatives s', s'' (m) on a base circle of the radius r_b (m).
    pub fn place(&self, base_radius: f64, lift: [f64; 3]) -> Place {
        match *self {
            Follower::Flat => flat(base_radius, lift),
            Follower::Curved { radius, offset } => round(base_radius, radius, offset, lift),
            Follower::Roller {
                radius,
                offset,
                slip,
            } => {
                let place = round(base_radius, radius, offset, lift);
                let cam = place.speeds[1];
                Place {
                    speeds: [(1.0 - slip) * cam, cam],
                    ..place
                }
            }
        }
    }
}

/// The face is at y = r_b + s. A point of the cam at (x, y) moves normal to it at ω x, as fast as the follower, ω s': the contact is at x = s', and travels at ω s''.
///
/// ρ = r_b + s + s'',  u_2 = ω ρ,  u_1 = ω s''
///
/// Sources: Norton 2002, chapter 7; Müller 1966.
fn flat(base_radius: f64, [s, first, second]: [f64; 3]) -> Place {
    let radius = base_radius + s + second;
    Place {
        contact: [first, base_radius + s],
        pressure_angle: 0.0,
        cam_curvature: radius.recip(),
        reduced_radius: radius,
        undercut: radius <= 0.0,
        speeds: [second, radius],
    }
}

/// The centre of the face is at (ε, y), y = √((r_b + r_f)² − ε²) + s. Seen from the cam it moves along (y, s' − ε), which the normal of the contact is
/// normal to:
///
/// q = √(y² + (s' − ε)²),  tan φ = (s' − ε)/y,  φ' = [y s'' − (s' − ε) s']/q²
///
/// The normal turns by 1 − φ' against the cam, so the centre's path has the curvature κ_p = (1 − φ')/q and the cam, r_f inside of it,
///
/// κ = κ_p/(1 − κ_p r_f),  R = 1/(κ + 1/r_f) = r_f (1 − κ_p r_f)
///
/// The contact is at the centre less r_f (−sin φ, cos φ). It moves along the face at −ω r_f φ', and along the cam as far as the normal turns:
///
/// u_1 = ω r_f φ',  u_2 = ω [q − r_f (1 − φ')]
///
/// Where κ_p r_f ≥ 1 the cam is undercut. Sources: κ_p as in Norton 2002, chapter 7; the speeds follow from the words above, and with r_f → ∞ are those of the flat face.
fn round(base_radius: f64, r_f: f64, offset: f64, [s, first, second]: [f64; 3]) -> Place {
    let sum = base_radius + r_f;
    let y = (sum * sum - offset * offset).sqrt() + s;
    let side = first - offset;
    let q = y.hypot(side);
    let angle = side.atan2(y);
    let turning = (y * second - side * first) / (q * q);
    let path_curvature = (1.0 - turning) / q;
    let left = 1.0 - path_curvature * r_f;
    Place {
        contact: [offset + r_f * angle.sin(), y - r_f * angle.cos()],
        pressure_angle: angle,
        cam_curvature: path_curvature / left,
        reduced_radius: r_f * left,
        undercut: left <= 0.0 || y <= 0.0,
        speeds: [r_f * turning, q - r_f * (1.0 - turning)],
    }
}
