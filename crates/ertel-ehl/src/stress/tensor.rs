//! The stress tensor at a point.

use std::f64::consts::PI;
use std::ops::{Add, AddAssign, Mul, Sub};

use serde::Serialize;

/// Stresses xx, yy, zz, xy, xz, yz at a point; tension positive, x along the motion, z into the body.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[serde(transparent)]
pub struct Stress(pub [f64; 6]);

/// Names of the components, in their order.
pub const COMPONENTS: [&str; 6] = ["xx", "yy", "zz", "xy", "xz", "yz"];

impl Stress {
    /// σ_xz, the orthogonal shear of a passage along x.
    pub fn xz(&self) -> f64 {
        self.0[4]
    }

    /// Mean of the normal stresses.
    pub fn hydrostatic(&self) -> f64 {
        (self.0[0] + self.0[1] + self.0[2]) / 3.0
    }

    /// ½ s:s of the deviator s.
    fn second_invariant(&self) -> f64 {
        let [xx, yy, zz, xy, xz, yz] = self.0;
        let normal = (xx - yy).powi(2) + (yy - zz).powi(2) + (zz - xx).powi(2);
        normal / 6.0 + xy * xy + xz * xz + yz * yz
    }

    /// Equivalent stress after von Mises.
    pub fn von_mises(&self) -> f64 {
        (3.0 * self.second_invariant()).sqrt()
    }

    /// Principal stresses, the largest first: the angle of Lode gives the roots of the cubic in closed form.
    pub fn principal(&self) -> [f64; 3] {
        let mean = self.hydrostatic();
        let radius = (self.second_invariant() / 3.0).sqrt();
        if radius == 0.0 {
            return [mean; 3];
        }
        let [xx, yy, zz, xy, xz, yz] = self.0.map(|s| s / radius);
        let [a, b, c] = [xx, yy, zz].map(|s| s - mean / radius);
        let determinant = a * (b * c - yz * yz) - xy * (xy * c - yz * xz) + xz * (xy * yz - b * xz);
        let angle = (0.5 * determinant).clamp(-1.0, 1.0).acos() / 3.0;
        let [first, last] = [angle, angle + 2.0 * PI / 3.0].map(|angle| 2.0 * radius * angle.cos());
        [mean + first, mean - first - last, mean + last]
    }

    /// Largest shear stress, half the difference of the outer principal stresses.
    pub fn largest_shear(&self) -> f64 {
        let [first, _, last] = self.principal();
        0.5 * (first - last)
    }

    /// Largest shear stress in the plane of motion, of x and z.
    pub fn shear_in_plane(&self) -> f64 {
        let [xx, _, zz, _, xz, _] = self.0;
        (0.5 * (xx - zz)).hypot(xz)
    }

    /// The deviator s in coordinates whose Euclidean norm is √(s:s).
    pub(super) fn deviator(&self) -> [f64; 5] {
        let [xx, yy, zz, xy, xz, yz] = self.0;
        let root = 2.0_f64.sqrt();
        [
            (xx - yy) / root,
            (2.0 * zz - xx - yy) / 6.0_f64.sqrt(),
            root * xy,
            root * xz,
            root * yz,
        ]
    }

    /// The stress without hydrostatic part of these coordinates.
    pub(super) fn of_deviator([a, b, xy, xz, yz]: [f64; 5]) -> Stress {
        let root = 2.0_f64.sqrt();
        let third = b / 6.0_f64.sqrt();
        Stress([
            a / root - third,
            -a / root - third,
            2.0 * third,
            xy / root,
            xz / root,
            yz / root,
        ])
    }
}

impl Add for Stress {
    type Output = Stress;
    fn add(mut self, other: Stress) -> Stress {
        self += other;
        self
    }
}

impl AddAssign for Stress {
    fn add_assign(&mut self, other: Stress) {
        for (own, other) in self.0.iter_mut().zip(other.0) {
            *own += other;
        }
    }
}

impl Sub for Stress {
    type Output = Stress;
    fn sub(self, other: Stress) -> Stress {
        self + other * -1.0
    }
}

impl Mul<f64> for Stress {
    type Output = Stress;
    fn mul(self, factor: f64) -> Stress {
        Stress(self.0.map(|s| factor * s))
    }
}
