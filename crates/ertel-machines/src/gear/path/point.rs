//! Contacts at places along the line of action.

use std::fmt;

use ertel_ehl::contact::{Contact, Hertz, Motion};

use super::lines::line_length;
use super::sharing::Sharing;
use super::{LoadSharing, Operation};
use crate::gear::geometry::{GearError, GearPair, in_range};

/// A named place on the line of action.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PathLabel {
    /// Tip of the wheel: start of contact if the pinion drives.
    A,
    /// One base pitch before E: start of single contact.
    B,
    /// The pitch point.
    C,
    /// One base pitch after A: end of single contact.
    D,
    /// Tip of the pinion.
    E,
}

impl fmt::Display for PathLabel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self:?}")
    }
}

/// Which contacts [`GearPair::path`] gives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathParams {
    /// Number of equally spaced places from A to E, 2 or more; B, C and D come in addition.
    pub points: usize,
    /// Law of load sharing.
    pub sharing: LoadSharing,
    /// Where across the face, in face widths from its middle, −1/2 to 1/2: lines of helical teeth are at s + y tan β_b. It matters where the load changes with the length of lines.
    pub axial_position: f64,
}

impl Default for PathParams {
    fn default() -> PathParams {
        PathParams {
            points: 41,
            sharing: LoadSharing::Uniform,
            axial_position: 0.0,
        }
    }
}

/// A contact of two teeth: the wheel's is body 1 and the pinion's body 2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathPoint {
    /// Name, if the place has one.
    pub label: Option<PathLabel>,
    /// Place on the line of action, m from the pitch point, positive towards the pinion's tip.
    pub position: f64,
    /// Radius of curvature of the wheel across the contact line, ρ/cos β_b, m; negative where concave.
    pub radius_body_1: f64,
    /// Radius of curvature of the pinion across the contact line, m.
    pub radius_body_2: f64,
    /// Reduced radius, m: 1/R = 1/R_1 + 1/R_2.
    pub reduced_radius: f64,
    /// Speed of the wheel's surface relative to the contact, m/s.
    pub u_1: f64,
    /// Speed of the pinion's surface relative to the contact, m/s.
    pub u_2: f64,
    /// Entrainment speed u_m = (u_1 + u_2)/2, m/s.
    pub entrainment_speed: f64,
    /// Sliding speed u_2 − u_1, m/s; negative before the pitch point.
    pub sliding_speed: f64,
    /// Slide-to-roll ratio (u_2 − u_1)/u_m.
    pub slide_to_roll_ratio: f64,
    /// Share X of the load per face width F_bt/b.
    pub load_share: f64,
    /// Load per length of contact line, N/m: w = X F_bt/b.
    pub load_per_length: f64,
    /// Length of all contact lines at this moment, m.
    pub line_length: f64,
    /// Half-width of the Hertz contact, m.
    pub half_width: f64,
    /// Largest Hertz pressure, Pa; infinite at a tangent point under load, where the radius vanishes.
    pub hertz_pressure: f64,
}

impl PathPoint {
    /// The line contact of this place, x being across the contact line and along the motion.
    pub fn contact(&self) -> Contact {
        let curvatures = [self.radius_body_1, self.radius_body_2].map(|r| [r.recip(), 0.0]);
        Contact::line(self.reduced_radius, self.load_per_length).between(curvatures)
    }

    /// Specific sliding of the pinion and the wheel: ζ = (u_own − u_other)/u_own; infinite where a flank has no speed.
    ///
    /// Source: ISO 21771:2007, specific sliding.
    pub fn specific_sliding(&self) -> [f64; 2] {
        let [pinion, wheel] = [self.u_2, self.u_1];
        [1.0 - wheel / pinion, 1.0 - pinion / wheel]
    }

    /// The motion of the surfaces in it.
    pub fn motion(&self) -> Motion {
        Motion::straight(self.entrainment_speed, self.slide_to_roll_ratio)
    }
}

impl GearPair {
    /// Contacts from A to E in order.
    ///
    /// # Errors
    ///
    /// Numbers out of range, and laws of load sharing outside theirs.
    pub fn path(
        &self,
        operation: &Operation,
        params: &PathParams,
    ) -> Result<Vec<PathPoint>, GearError> {
        operation.check()?;
        let axial = params.axial_position;
        in_range(
            "axial position",
            axial,
            axial.abs() <= 0.5,
            "from −1/2 to 1/2",
        )?;
        let count = params.points as f64;
        in_range("number of points", count, params.points >= 2, "2 or more")?;
        let sharing = Sharing::new(self, operation, params.sharing)?;
        let y = axial * self.face_width;
        let place = |(s, label)| self.contact(operation, &sharing, s, y, label);
        Ok(self.places(params.points).into_iter().map(place).collect())
    }

    /// The contact at the place s (m) from the pitch point, in the middle of the face.
    ///
    /// # Errors
    ///
    /// As [`GearPair::path`], and places off the path.
    pub fn contact_at(
        &self,
        operation: &Operation,
        sharing: LoadSharing,
        s: f64,
    ) -> Result<PathPoint, GearError> {
        operation.check()?;
        let inside = s >= self.points.a && s <= self.points.e;
        in_range("place on the line of action", s, inside, "from A to E")?;
        let sharing = Sharing::new(self, operation, sharing)?;
        Ok(self.contact(operation, &sharing, s, 0.0, None))
    }

    /// The contact at the place s (m) of the slice at y (m).
    pub(crate) fn contact(
        &self,
        operation: &Operation,
        sharing: &Sharing<'_>,
        s: f64,
        y: f64,
        label: Option<PathLabel>,
    ) -> PathPoint {
        let across = self.base_helix_angle.cos();
        let [pinion, wheel] = self.curvature_radii(s).map(|radius| radius / across);
        let [u_2, u_1] = operation.surface_speeds(self, s);
        let load_share = sharing.share(s, y);
        let load_per_length = load_share * operation.base_force(self) / self.face_width;
        let reduced_radius = self.reduced_radius(s);
        let hertz = Hertz::new(
            &Contact::line(reduced_radius, load_per_length),
            operation.reduced_modulus(),
        );
        let entrainment_speed = 0.5 * (u_1 + u_2);
        PathPoint {
            label,
            position: s,
            radius_body_1: wheel,
            radius_body_2: pinion,
            reduced_radius,
            u_1,
            u_2,
            entrainment_speed,
            sliding_speed: u_2 - u_1,
            slide_to_roll_ratio: (u_2 - u_1) / entrainment_speed,
            load_share,
            load_per_length,
            line_length: line_length(self, s - y * self.base_helix_angle.tan()),
            half_width: hertz.half_width,
            // Without load 2w/(π a) is 0/0.
            hertz_pressure: if load_per_length > 0.0 {
                hertz.pressure
            } else {
                0.0
            },
        }
    }

    /// Equally spaced places from A to E with B, C and D among them.
    fn places(&self, count: usize) -> Vec<(f64, Option<PathLabel>)> {
        let points = self.points;
        let length = points.e - points.a;
        let mut places = vec![
            (points.a, Some(PathLabel::A)),
            (points.b, Some(PathLabel::B)),
            (0.0, Some(PathLabel::C)),
            (points.d, Some(PathLabel::D)),
            (points.e, Some(PathLabel::E)),
        ];
        // Profile shifts may move the pitch point out of the path.
        places.retain(|(s, _)| *s >= points.a && *s <= points.e);
        for i in 0..count {
            let s = points.a + length * i as f64 / (count - 1) as f64;
            let is_near = |(named, _): &(f64, _)| (named - s).abs() < 1e-6 * length;
            if !places.iter().any(is_near) {
                places.push((s, None));
            }
        }
        places.sort_by(|one, other| one.0.total_cmp(&other.0));
        places
    }
}
