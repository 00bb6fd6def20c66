//! How pairs of teeth share the load.

use super::lines::{line_length, others};
use super::stiffness::StiffnessCurve;
use super::{Operation, ToothStiffness};
use crate::gear::geometry::{GearError, GearPair};

/// The law of load sharing: X in w = X F_bt/b, the load per length of contact line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LoadSharing {
    /// Evenly over all contact lines of the moment: w = (F_bt/cos β_b)/l, X = b/(l cos β_b); 1/n of straight teeth with n pairs in contact.
    Uniform,
    /// X = 1/3 at A, linear to 2/3 at B, 1 from B to D, linear from 2/3 at D to 1/3 at E: straight teeth with 1 ≤ ε_α < 2 without relief.
    /// Source: ISO/TR 15144-1.
    Thirds,
    /// Over the mean length of the contact lines: X = 1/ε_α. Source: ISO 6336-2 for ε_β ≥ 1.
    MeanLength,
    /// By the stiffness of the pairs: they approach each other by the same δ, less the reliefs C(s), in slices across the face that do not support each other.
    ///
    /// w(s) = c'(s) (δ − C(s)) where positive,  Σ_pairs ∫ w dy = F_bt
    ///
    /// Contact before A and after E, to which deflected teeth tend, is left out.
    Stiffness(ToothStiffness),
}

/// Slices across the face of helical teeth for each base pitch that their lines cross, and in addition; each slice has its own place on the path.
const SLICES: f64 = 100.0;

/// A law of load sharing made ready for a pair under a load.
pub(crate) struct Sharing<'a> {
    pair: &'a GearPair,
    law: LoadSharing,
    /// Load per face width F_bt/b, N/m.
    load: f64,
    /// c', N/m², where the law asks for it.
    stiffness: Option<StiffnessCurve>,
}

impl<'a> Sharing<'a> {
    pub fn new(
        pair: &'a GearPair,
        operation: &Operation,
        law: LoadSharing,
    ) -> Result<Sharing<'a>, GearError> {
        let mut stiffness = None;
        match law {
            LoadSharing::Uniform | LoadSharing::MeanLength => {}
            LoadSharing::Thirds => {
                if pair.base_helix_angle != 0.0 || pair.contact_ratio >= 2.0 {
                    return Err(GearError::Sharing {
                        law: "by thirds",
                        requirement: "straight teeth and contact ratios below 2",
                    });
                }
            }
            LoadSharing::Stiffness(model) => stiffness = Some(model.curve(pair, operation)?),
        }
        Ok(Sharing {
            pair,
            law,
            load: operation.base_force(pair) / pair.face_width,
            stiffness,
        })
    }

    /// X at the place s (m) of the slice at the distance y (m) from the middle of the face.
    pub fn share(&self, s: f64, y: f64) -> f64 {
        let pair = self.pair;
        let tangent = pair.base_helix_angle.tan();
        match self.law {
            LoadSharing::Uniform => {
                let length = line_length(pair, s - y * tangent);
                pair.face_width / (length * pair.base_helix_angle.cos())
            }
            LoadSharing::Thirds => thirds(pair, s),
            LoadSharing::MeanLength => 1.0 / pair.contact_ratio,
            LoadSharing::Stiffness(_) => self.stiffness.as_ref().map_or(0.0, |stiffness| {
                let approach = self.approach(stiffness, s, y);
                stiffness.at(s) * (approach - pair.relief(s)).max(0.0) / self.load
            }),
        }
    }

    /// The approach δ (m) at the moment at which the slice at y (m) touches at s (m): Σ c' (δ − C)⁺ = F_bt over all slices and pairs.
    ///
    /// With the reliefs in ascending order the first n of them are in contact: δ = (load + Σ c' C)/Σ c', each slice one part of the face width.
    fn approach(&self, stiffness: &StiffnessCurve, s: f64, y: f64) -> f64 {
        let pair = self.pair;
        let tangent = pair.base_helix_angle.tan();
        let mut springs = Vec::new();
        let slices = if tangent == 0.0 {
            1
        } else {
            (SLICES * (1.0 + pair.overlap_ratio)) as usize
        };
        for slice in 0..slices {
            let at = ((slice as f64 + 0.5) / slices as f64 - 0.5) * pair.face_width;
            let place = s + (at - y) * tangent;
            let inside = place >= pair.points.a && place <= pair.points.e;
            let own = (tangent == 0.0 || inside).then_some(place);
            let places = own.into_iter().chain(others(pair, place));
            springs.extend(places.map(|place| (pair.relief(place), stiffness.at(place))));
        }
        springs.sort_by(|one, other| one.0.total_cmp(&other.0));
        let mut force = self.load * slices as f64;
        let (mut sum, mut approach) = (0.0, f64::INFINITY);
        for (relief, spring) in springs {
            if approach <= relief {
                break;
            }
            force += spring * relief;
            sum += spring;
            approach = force / sum;
        }
        approach
    }
}

/// [`LoadSharing::Thirds`].
fn thirds(pair: &GearPair, s: f64) -> f64 {
    let points = pair.points;
    let slack = 1e-9 * pair.base_pitch;
    if s < points.b - slack {
        (1.0 + (s - points.a) / (points.b - points.a)) / 3.0
    } else if s > points.d + slack {
        (1.0 + (points.e - s) / (points.e - points.d)) / 3.0
    } else {
        1.0
    }
}
