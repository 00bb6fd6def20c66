//! Where followers touch a cam, and how the surfaces move there.

use super::CamError;
use super::error::in_range;

/// A follower of a cam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Follower {
    /// A flat face normal to its motion along y. One that turns about its own axis is not covered.
    Flat,
    /// A face of a radius that moves along y and does not turn.
    Curved {
        /// Radius of the face r_f, m.
        radius: f64,
        /// Distance ε of the face's centre of curvature from the line through the cam's axis, m; positive towards x.
        offset: f64,
    },
    /// A roller that moves along y.
    Roller {
        /// Radius r_f, m.
        radius: f64,
        /// Distance ε of the roller's path from the cam's axis, m; positive towards x.
        offset: f64,
        /// Slip 1 − u_1/u_2; 0 rolls.
        slip: f64,
    },
    /// A finger that turns about a pivot. The lift s is the arc that the centre of its face travels, and masses, springs and forces are those along this arc.
    Finger {
        /// Pivot, m from the cam's axis.
        pivot: [f64; 2],
        /// Distance from the pivot to the centre of curvature of the face, m. At s = 0 that centre is r_b + r_f from the cam's axis, at the larger y of two places.
        arm: f64,
        /// Radius of the face r_f, m.
        radius: f64,
        /// Slip of a roller; `None` of a face fixed to the finger.
        roller_slip: Option<f64>,
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
            Follower::Curved { radius, .. }
            | Follower::Roller { radius, .. }
            | Follower::Finger { radius, .. } => *radius,
        }
    }

    /// Slip of a roller.
    fn slip(&self) -> Option<f64> {
        match self {
            Follower::Flat | Follower::Curved { .. } => None,
            Follower::Roller { slip, .. } => Some(*slip),
            Follower::Finger { roller_slip, .. } => *roller_slip,
        }
    }

    /// Refuses numbers that no follower has, on a base circle of the radius r_b (m).
    pub(super) fn check(&self, base_radius: f64) -> Result<(), CamError> {
        let radius = self.radius();
        if let Some(slip) = self.slip() {
            in_range(
                "slip of the roller",
                slip,
                slip.abs() <= 1.0,
                "from −1 to 1",
            )?;
        }
        match self {
            Follower::Flat => return Ok(()),
            Follower::Curved { offset, .. } | Follower::Roller { offset, .. } => {
                let inside = offset.abs() < base_radius + radius;
                let requirement = "less than the sum of the base and the follower's radius";
                in_range("offset of the follower", *offset, inside, requirement)?;
            }
            Follower::Finger { pivot, arm, .. } => {
                in_range("arm of the finger", *arm, *arm > 0.0, "positive")?;
                let distance = pivot[0].hypot(pivot[1]);
                let sum = base_radius + radius;
                let inside = (sum - arm).abs() < distance && distance < sum + arm;
                let requirement = "such that the arm reaches the base circle";
                in_range("distance of the pivot", distance, inside, requirement)?;
            }
        }
        in_range("radius of the follower", radius, radius > 0.0, "positive")
    }

    /// The contact at the lift s and its derivatives s', s'' (m) on a base circle of the radius r_b (m).
    pub fn place(&self, base_radius: f64, lift: [f64; 3]) -> Place {
        let place = match *self {
            Follower::Flat => return flat(base_radius, lift),
            Follower::Curved { radius, offset } | Follower::Roller { radius, offset, .. } => {
                round(radius, along_y(base_radius + radius, offset, lift))
            }
            Follower::Finger {
                pivot, arm, radius, ..
            } => round(radius, about_pivot(base_radius + radius, pivot, arm, lift)),
        };
        let cam = place.speeds[1];
        Place {
            speeds: [
                self.slip()
                    .map_or(place.speeds[0], |slip| (1.0 - slip) * cam),
                cam,
            ],
            ..place
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

/// How the centre of a round face moves over the angle of the cam.
struct Centre {
    /// Place C, m, and its first two derivatives.
    path: [[f64; 2]; 3],
    /// Unit vector of its motion with the lift.
    motion: [f64; 2],
    /// How far the face turns per angle of the cam.
    turning: f64,
}

/// C = (ε, √((r_b + r_f)² − ε²) + s).
fn along_y(sum: f64, offset: f64, [s, first, second]: [f64; 3]) -> Centre {
    let y = (sum * sum - offset * offset).sqrt() + s;
    Centre {
        path: [[offset, y], [0.0, first], [0.0, second]],
        motion: [0.0, 1.0],
        turning: 0.0,
    }
}

/// C = O + l (cos ψ, sin ψ), ψ = ψ_0 ± s/l, with the pivot O and the arm l; the sign is that which moves C away from the cam at first.
fn about_pivot(sum: f64, pivot: [f64; 2], arm: f64, [s, first, second]: [f64; 3]) -> Centre {
    // Where the circles of r_b + r_f about the cam's axis and of l about the pivot cross: along the line of centres and to one side of it.
    let distance = pivot[0].hypot(pivot[1]);
    let axis = [pivot[0] / distance, pivot[1] / distance];
    let along = (sum * sum - arm * arm + distance * distance) / (2.0 * distance);
    let aside = (sum * sum - along * along).max(0.0).sqrt();
    // The larger y; of equal ones the larger x.
    let side = if axis[0] > 0.0 || (axis[0] == 0.0 && axis[1] < 0.0) {
        aside
    } else {
        -aside
    };
    let start = [
        along * axis[0] - side * axis[1],
        along * axis[1] + side * axis[0],
    ];
    let tangent = [(pivot[1] - start[1]) / arm, (start[0] - pivot[0]) / arm];
    let outward = (start[0] * tangent[0] + start[1] * tangent[1]).signum();
    let turn = outward / arm;
    let angle = (start[1] - pivot[1]).atan2(start[0] - pivot[0]) + turn * s;
    let (sine, cosine) = angle.sin_cos();
    let motion = [-outward * sine, outward * cosine];
    let inward = first * first / arm;
    Centre {
        path: [
            [pivot[0] + arm * cosine, pivot[1] + arm * sine],
            motion.map(|part| part * first),
            [
                motion[0] * second - inward * cosine,
                motion[1] * second - inward * sine,
            ],
        ],
        motion,
        turning: turn * first,
    }
}

/// A round face around the centre C, which moves against the cam at g = C' − ẑ × C; the normal n of the contact is normal to g, on its left, away from the cam.
///
/// q = |g|,  φ' = g × (C'' − ẑ × C')/q²
///
/// is how fast n turns. Against the cam it turns by 1 − φ', so the centre's path has the curvature κ_p = (1 − φ')/q and the cam, r_f inside of it,
///
/// κ = κ_p/(1 − κ_p r_f),  R = 1/(κ + 1/r_f) = r_f (1 − κ_p r_f)
///
/// The contact is at C − r_f n. It moves on the face, which itself turns by ψ', as n turns, and along the cam as far as the centre less the turning of n:
///
/// u_1 = ω r_f (φ' − ψ'),  u_2 = ω [q − r_f (1 − φ')]
///
/// Where κ_p r_f ≥ 1 the cam is undercut. Sources: κ_p of translating followers as in Norton 2002, chapter 7; the rest follows from the words above, and with r_f → ∞ leads
/// to the flat face.
fn round(r_f: f64, centre: Centre) -> Place {
    let [place, first, second] = centre.path;
    let g = [first[0] + place[1], first[1] - place[0]];
    let change = [second[0] + first[1], second[1] - first[0]];
    let q = g[0].hypot(g[1]);
    let normal = [-g[1] / q, g[0] / q];
    let turning = (g[0] * change[1] - g[1] * change[0]) / (q * q);
    let path_curvature = (1.0 - turning) / q;
    let left = 1.0 - path_curvature * r_f;
    let motion = centre.motion;
    let aligned = motion[0] * normal[0] + motion[1] * normal[1];
    Place {
        contact: [place[0] - r_f * normal[0], place[1] - r_f * normal[1]],
        pressure_angle: (motion[0] * normal[1] - motion[1] * normal[0]).atan2(aligned),
        cam_curvature: path_curvature / left,
        reduced_radius: r_f * left,
        // A normal against the motion cannot push the follower.
        undercut: left <= 0.0 || aligned <= 0.0,
        speeds: [r_f * (turning - centre.turning), q - r_f * (1.0 - turning)],
    }
}
