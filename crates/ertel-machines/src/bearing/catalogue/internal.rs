//! Internal geometry, published or estimated.

use std::f64::consts::PI;

use super::clearance::{ClearanceClass, radial_clearance};
use super::{Boundary, Designation, Series, Special};
use crate::bearing::Geometry;
use crate::bearing::geometry::{
    BallGeometry, Play, RollerGeometry, RollerProfile, TaperedGeometry,
};

/// How a value is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// From this public source.
    Published(&'static str),
    /// By this rule.
    Estimated(&'static str),
    /// By whoever replaced it.
    Given,
}

/// A value and how it is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sourced<T> {
    /// The value, SI.
    pub value: T,
    /// How it is known.
    pub origin: Origin,
}

impl<T> Sourced<T> {
    /// A value that replaces one of the catalogue.
    pub fn given(value: T) -> Sourced<T> {
        Sourced {
            value,
            origin: Origin::Given,
        }
    }

    fn published(value: T, source: &'static str) -> Sourced<T> {
        Sourced {
            value,
            origin: Origin::Published(source),
        }
    }

    fn estimated(value: T, rule: &'static str) -> Sourced<T> {
        Sourced {
            value,
            origin: Origin::Estimated(rule),
        }
    }
}

/// Internal dimensions of a bearing; each value can be replaced by [`Sourced::given`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Internal {
    /// Of ball bearings.
    Ball(Balls),
    /// Of cylindrical roller bearings.
    Cylindrical {
        /// The rollers.
        rollers: Rollers,
        /// Radial clearance, m.
        clearance: Sourced<f64>,
    },
    /// Of tapered roller bearings.
    Tapered {
        /// The rollers.
        rollers: Rollers,
        /// Contact angle of the outer raceway, rad.
        contact_angle: Sourced<f64>,
    },
}

/// Balls, their circle and their grooves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Balls {
    /// Diameter D_w, m.
    pub diameter: Sourced<f64>,
    /// Pitch diameter d_m, m.
    pub pitch_diameter: Sourced<f64>,
    /// Number Z.
    pub number: Sourced<usize>,
    /// Radius of the inner and outer groove over the ball diameter.
    pub groove: Sourced<[f64; 2]>,
    /// Clearance, or free contact angle.
    pub play: Sourced<Play>,
}

/// Rollers and their circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rollers {
    /// Diameter D_w, of tapered rollers in the middle, m.
    pub diameter: Sourced<f64>,
    /// Contact length, m.
    pub length: Sourced<f64>,
    /// Pitch diameter d_m, through the middles of the rollers, m.
    pub pitch_diameter: Sourced<f64>,
    /// Number Z.
    pub number: Sourced<usize>,
    /// Relief.
    pub profile: Sourced<RollerProfile>,
}

impl Rollers {
    /// A cylindrical roller bearing with this radial clearance (m).
    pub fn cylindrical(&self, clearance: f64) -> RollerGeometry {
        RollerGeometry {
            roller_diameter: self.diameter.value,
            length: self.length.value,
            pitch_diameter: self.pitch_diameter.value,
            number: self.number.value,
            clearance,
            profile: self.profile.value,
        }
    }

    /// A tapered roller bearing with this contact angle of the outer raceway (rad).
    pub fn tapered(&self, cup_angle: f64) -> TaperedGeometry {
        TaperedGeometry {
            roller_diameter: self.diameter.value,
            length: self.length.value,
            pitch_diameter: self.pitch_diameter.value,
            number: self.number.value,
            cup_angle,
            profile: self.profile.value,
        }
    }
}

impl Internal {
    /// The geometry to calculate with.
    pub fn geometry(&self) -> Geometry {
        match *self {
            Internal::Ball(balls) => Geometry::Ball(BallGeometry {
                ball_diameter: balls.diameter.value,
                pitch_diameter: balls.pitch_diameter.value,
                number: balls.number.value,
                groove: balls.groove.value,
                play: balls.play.value,
            }),
            Internal::Cylindrical { rollers, clearance } => {
                Geometry::CylindricalRoller(rollers.cylindrical(clearance.value))
            }
            Internal::Tapered {
                rollers,
                contact_angle,
            } => Geometry::TaperedRoller(rollers.tapered(contact_angle.value)),
        }
    }
}

impl Entry {
    /// The geometry to calculate with.
    pub fn geometry(&self) -> Geometry {
        self.internal.geometry()
    }
}

const CWRU: &str = "bearing data of the Case Western Reserve University Bearing Data Center";
const TABLES: &str = "from published bearing frequencies";
/// Series, bore code, ball diameter and pitch diameter, mm, number of balls.
const PUBLISHED: [(Series, u8, f64, f64, usize, &str); 4] = [
    // 0.2656 in, 1.122 in; 0.3126 in, 1.537 in
    (Series::DeepGroove62, 3, 6.746, 28.5, 8, CWRU),
    (Series::DeepGroove62, 5, 7.94, 39.04, 9, CWRU),
    (Series::DeepGroove62, 6, 9.525, 46.0, 9, TABLES),
    (Series::DeepGroove62, 7, 11.112, 53.5, 9, TABLES),
];

const BALL_RULE: &str = "D_w = 0.3 (D − d)";
const PITCH_RULE: &str = "d_m = (d + D)/2";
const NUMBER_RULE: &str =
    "Z = 0.6 π d_m/D_w, rounded: balls that fit between eccentric rings (Conrad assembly)";
const FULL_NUMBER_RULE: &str = "Z = 0.8 π d_m/D_w, rounded: leaves room for the bars of a cage";
const GROOVE_RULE: &str = "f_i = 0.52, f_o = 0.53: largest value allowed by ISO 281";
const CLEARANCE_RULE: &str = "middle of the class of ISO 5753-1 before mounting";
const NO_CLASS_RULE: &str = "no clearance: the class has no values for this bearing";
const RACEWAYS: &str = "raceway diameters F and E in Schaeffler, Rolling Bearings, HR 1, 2006";
const LENGTH_RULE: &str = "L = 0.62 B";
const PROFILE_RULE: &str = "reference profile of ISO/TS 16281";
const ANGLE_SOURCE: &str = "suffix B: 40 degrees";
const TAPER_ANGLE: &str = "ISO 355";
const TAPER_DIAMETER_RULE: &str = "D_w = (D − d)/4";
const TAPER_LENGTH_RULE: &str = "L = 0.8 C";
const TAPER_NUMBER_RULE: &str = "Z = 0.9 π d_m/D_w, rounded: leaves room for the bars of a cage";
const NSK: &str = "NSK, Rolling Bearings, catalogue E1102e";

/// Ratings that a maker publishes, kN, in N.
pub(super) fn published_ratings(ratings: [f64; 2]) -> Sourced<[f64; 2]> {
    Sourced::published(ratings.map(|kilonewtons| 1e3 * kilonewtons), NSK)
}

fn middle(rollers: bool, class: ClearanceClass, bore: f64) -> Sourced<f64> {
    match radial_clearance(rollers, class, bore) {
        Some([low, high]) => Sourced::estimated(0.5 * (low + high), CLEARANCE_RULE),
        None => Sourced::estimated(0.0, NO_CLASS_RULE),
    }
}

fn filled(share: f64, pitch: f64, diameter: f64) -> usize {
    (share * PI * pitch / diameter).round() as usize
}

/// Internal geometry of a bearing of the catalogue.
pub(super) fn internal(designation: &Designation, boundary: &Boundary) -> Internal {
    match boundary.special {
        Special::None => balls(designation, boundary),
        Special::Raceways { inner, outer } => {
            let (diameter, pitch) = (0.5 * (outer - inner), 0.5 * (outer + inner));
            let number = filled(0.8, pitch, diameter);
            Internal::Cylindrical {
                rollers: Rollers {
                    diameter: Sourced::published(diameter, RACEWAYS),
                    length: Sourced::estimated(0.62 * boundary.width, LENGTH_RULE),
                    pitch_diameter: Sourced::published(pitch, RACEWAYS),
                    number: Sourced::estimated(number, FULL_NUMBER_RULE),
                    profile: Sourced::estimated(RollerProfile::Logarithmic, PROFILE_RULE),
                },
                clearance: middle(true, designation.clearance, boundary.bore),
            }
        }
        Special::Taper {
            cup_width,
            contact_angle,
            ..
        } => {
            let diameter = 0.25 * (boundary.outside - boundary.bore);
            let pitch = boundary.mean_diameter();
            let number = filled(0.9, pitch, diameter);
            Internal::Tapered {
                rollers: Rollers {
                    diameter: Sourced::estimated(diameter, TAPER_DIAMETER_RULE),
                    length: Sourced::estimated(0.8 * cup_width, TAPER_LENGTH_RULE),
                    pitch_diameter: Sourced::estimated(pitch, PITCH_RULE),
                    number: Sourced::estimated(number, TAPER_NUMBER_RULE),
                    profile: Sourced::estimated(RollerProfile::Logarithmic, PROFILE_RULE),
                },
                contact_angle: Sourced::published(contact_angle, TAPER_ANGLE),
            }
        }
    }
}

fn balls(designation: &Designation, boundary: &Boundary) -> Internal {
    let groove = Sourced::estimated([0.52, 0.53], GROOVE_RULE);
    if matches!(designation.series, Series::Angular72B | Series::Angular73B) {
        let play = Sourced::published(Play::FreeAngle(40_f64.to_radians()), ANGLE_SOURCE);
        return estimated_balls(boundary, 0.8, FULL_NUMBER_RULE, groove, play);
    }
    let gap = middle(false, designation.clearance, boundary.bore);
    let play = Sourced {
        value: Play::Clearance(gap.value),
        origin: gap.origin,
    };
    let known =
        (PUBLISHED.iter()).find(|row| row.0 == designation.series && row.1 == designation.code);
    match known {
        Some(&(_, _, ball, pitch, number, source)) => Internal::Ball(Balls {
            diameter: Sourced::published(ball * 1e-3, source),
            pitch_diameter: Sourced::published(pitch * 1e-3, source),
            number: Sourced::published(number, source),
            groove,
            play,
        }),
        None => estimated_balls(boundary, 0.6, NUMBER_RULE, groove, play),
    }
}

fn estimated_balls(
    boundary: &Boundary,
    share: f64,
    rule: &'static str,
    groove: Sourced<[f64; 2]>,
    play: Sourced<Play>,
) -> Internal {
    let diameter = 0.3 * (boundary.outside - boundary.bore);
    let pitch = boundary.mean_diameter();
    Internal::Ball(Balls {
        diameter: Sourced::estimated(diameter, BALL_RULE),
        pitch_diameter: Sourced::estimated(pitch, PITCH_RULE),
        number: Sourced::estimated(filled(share, pitch, diameter), rule),
        groove,
        play,
    })
}

/// A bearing of the catalogue.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// The designation requested.
    pub designation: Designation,
    /// Its boundary dimensions.
    pub boundary: Boundary,
    /// Its internal geometry.
    pub internal: Internal,
    /// Load ratings C and C_0, N, and who gives them.
    pub ratings: Option<Sourced<[f64; 2]>>,
}
