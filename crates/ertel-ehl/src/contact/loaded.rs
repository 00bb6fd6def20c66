//! A loaded contact: kind, radii, load and direction of the motion.

use std::f64::consts::FRAC_PI_2;

use serde::Serialize;

use super::{ContactKind, Curvatures, Ellipse, Roller};

/// A loaded contact.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Contact {
    /// Line, circular, elliptical or roller.
    pub kind: ContactKind,
    /// Reduced radius of curvature R in the plane of x, m.
    pub radius: f64,
    /// The same in the plane of y: R again of a ball, infinite of a cylinder.
    #[serde(skip_serializing_if = "is_infinite")]
    pub radius_y: f64,
    /// Load: F in N, or w in N/m of a line.
    pub load: f64,
    /// Direction of the entrainment velocity, from x towards y, rad; 0 but for ellipses.
    pub entrainment_angle: f64,
    /// Length, relief and misalignment of a roller; `None` of all others.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub roller: Option<Box<Roller>>,
    /// Curvatures of body 1 and body 2 themselves in the planes of x and y, 1/m: positive convex, negative concave, zero flat; `None` where
    /// only reduced radii are known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub body_curvatures: Option<[Curvatures; 2]>,
}

/// Whether a number cannot be written to a file.
fn is_infinite(value: &f64) -> bool {
    value.is_infinite()
}

impl Contact {
    /// A cylinder of the reduced radius R (m) under a load per length (N/m).
    pub fn line(radius: f64, load: f64) -> Contact {
        Contact {
            kind: ContactKind::Line,
            radius,
            radius_y: f64::INFINITY,
            load,
            entrainment_angle: 0.0,
            roller: None,
            body_curvatures: None,
        }
    }

    /// A ball of the reduced radius R (m) under a load (N).
    pub fn circular(radius: f64, load: f64) -> Contact {
        Contact {
            kind: ContactKind::Circular,
            radius,
            radius_y: radius,
            load,
            entrainment_angle: 0.0,
            roller: None,
            body_curvatures: None,
        }
    }

    /// Bodies of the reduced radii R_x and R_y (m) under a load (N), with the entrainment at an angle (rad) to x.
    pub fn elliptical(radii: [f64; 2], load: f64, entrainment_angle: f64) -> Contact {
        Contact {
            kind: ContactKind::Elliptical,
            radius: radii[0],
            radius_y: radii[1],
            load,
            entrainment_angle,
            roller: None,
            body_curvatures: None,
        }
    }

    /// A roller of the reduced radius R (m) under a load (N).
    pub fn of_roller(radius: f64, load: f64, roller: Roller) -> Contact {
        Contact {
            kind: ContactKind::Roller,
            roller: Some(Box::new(roller)),
            ..Contact::line(radius, load)
        }
    }

    /// The same with the curvatures of both bodies in the planes of x and y, 1/m.
    #[must_use]
    pub fn between(self, bodies: [Curvatures; 2]) -> Contact {
        Contact {
            body_curvatures: Some(bodies),
            ..self
        }
    }

    /// How far from the centre the bodies face each other in the planes of x and y, m: no body is wider than its radius of curvature, convex
    /// or concave. Where these are not known, the reduced radii, which two convex bodies exceed.
    pub fn ends(&self) -> [f64; 2] {
        let reduced = [self.radius, self.radius_y];
        let Some([one, two]) = self.body_curvatures else {
            return reduced;
        };
        // Lines and rollers are flat in the plane of y.
        [0, 1].map(|i| one[i].abs().max(two[i].abs()).recip())
    }

    /// Load per length of a cylinder, N/m: w, or F/l of a roller; the load itself of other contacts.
    pub fn line_load(&self) -> f64 {
        self.roller
            .as_ref()
            .map_or(self.load, |roller| self.load / roller.length)
    }

    /// Line or circular.
    ///
    /// # Panics
    /// For ellipses, which have two radii, and rollers, which have a length.
    pub fn of_one_radius(kind: ContactKind, radius: f64, load: f64) -> Contact {
        match kind {
            ContactKind::Line => Contact::line(radius, load),
            ContactKind::Circular => Contact::circular(radius, load),
            _ => panic!("an ellipse has two radii, a roller a length"),
        }
    }

    /// Whether the two radii of curvature are given each, and the direction of the motion.
    pub fn has_two_radii(&self) -> bool {
        self.kind == ContactKind::Elliptical
    }

    /// Axis ratio of the Hertz zone, across the motion over along it where that is along an axis; 1 of circles and lines.
    pub fn ellipticity(&self) -> f64 {
        if !self.has_two_radii() {
            return 1.0;
        }
        let [along, across] = self.radii_along_and_across();
        let [a, b] = Ellipse::of_radii([along, across]).semi_axes(1.0, 1.0);
        b / a
    }

    /// The same contact with the principal direction nearest to the motion as its first one: the angle lies between
    /// −45 and 45 degrees then.
    #[must_use]
    pub fn along_motion(&self) -> Contact {
        let quarters = (self.entrainment_angle / FRAC_PI_2).round();
        let angle = self.entrainment_angle - quarters * FRAC_PI_2;
        let turned = quarters as i64 % 2 != 0;
        let [radius, radius_y] = match turned {
            false => [self.radius, self.radius_y],
            true => [self.radius_y, self.radius],
        };
        let body_curvatures = (self.body_curvatures).map(|bodies| match turned {
            false => bodies,
            true => bodies.map(|[x, y]| [y, x]),
        });
        Contact {
            radius,
            radius_y,
            // A quarter turn in binary digits is not quite one.
            entrainment_angle: if angle.abs() < 1e-14 { 0.0 } else { angle },
            body_curvatures,
            ..self.clone()
        }
    }

    /// Radii of curvature in the planes along and across the entrainment, m (Euler's theorem).
    ///
    /// 1/R_e = cos²θ/R_x + sin²θ/R_y,  1/R_s = sin²θ/R_x + cos²θ/R_y
    pub fn radii_along_and_across(&self) -> [f64; 2] {
        let (s, c) = self.entrainment_angle.sin_cos();
        let (x, y) = (1.0 / self.radius, 1.0 / self.radius_y);
        [c * c * x + s * s * y, s * s * x + c * c * y].map(f64::recip)
    }
}
