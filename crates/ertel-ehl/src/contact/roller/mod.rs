//! Rollers of finite length with a relief along their axis, which may be tilted against the raceway.

mod ends;
pub mod measured;
pub mod profile;
mod slices;
mod zone;

use serde::Serialize;

pub use profile::{Profile, ProfileTable, ProfileTableError};
pub use slices::Slices;
pub use zone::RollerZone;

/// A roller: length, relief and misalignment. Its axis is y, from −l/2 to l/2.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Roller {
    /// Length l, m.
    pub length: f64,
    /// Relief of roller and raceway together.
    pub profile: Profile,
    /// Tilt θ of the axis against the raceway in the plane of y and the load, rad; positive: the end at y > 0 is pressed in.
    pub misalignment: f64,
}

/// A roller supported at its ends, or without relief.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Relief {
    /// The ends clear the raceway by this share of the drop that makes the pressure uniform.
    Share(f64),
    /// The lowest point of the roller is its end.
    StandsOnEnd,
}

impl Roller {
    /// Height over the raceway without the curvature along x, m, and its slope along y, at y (m): z(y) − θ y.
    #[inline]
    pub fn height(&self, y: f64) -> [f64; 2] {
        let [z, slope] = self.profile.drop(self.length, y);
        [z - self.misalignment * y, slope - self.misalignment]
    }

    /// Whether both halves of the roller are equal.
    pub fn is_symmetric(&self) -> bool {
        self.misalignment == 0.0 && self.profile.is_symmetric()
    }

    /// Relief of the ends under a load per length w (N/m) with its Hertz half-width b (m), in terms of the drop that Lundberg's
    /// profile for this load has at its ends; the end with less counts.
    pub fn relief(&self, line_load: f64, half_width: f64, reduced_modulus: f64) -> Relief {
        const POINTS: usize = 400;
        let end = 0.5 * self.length;
        let at = |i: usize| end * (2.0 * i as f64 / POINTS as f64 - 1.0);
        let lowest = (0..=POINTS)
            .map(|i| self.height(at(i))[0])
            .fold(f64::INFINITY, f64::min);
        let ends = [-end, end].map(|y| self.height(y)[0] - lowest);
        let least = ends[0].min(ends[1]);
        if least <= 0.0 && self.misalignment != 0.0 {
            return Relief::StandsOnEnd;
        }
        let uniform = Profile::lundberg(self.length, line_load, half_width, reduced_modulus);
        Relief::Share(least / uniform.drop(self.length, end)[0])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn roller(profile: Profile, misalignment: f64) -> Roller {
        Roller {
            length: 0.016,
            profile,
            misalignment,
        }
    }

    /// Lundberg's profile at its own load has the share 1; a crown of 3.2 µm at the ends stands on its end where the tilt is as steep as
    /// the crown there, 0.8 mrad.
    #[test]
    fn relief_of_ends() {
        let (w, b, e) = (2e5, 1.2e-4, 2.3e11);
        let lundberg = roller(Profile::lundberg(0.016, w, b, e), 0.0);
        let Relief::Share(share) = lundberg.relief(w, b, e) else {
            panic!("it does not stand on its end")
        };
        assert!((share - 1.0).abs() < 1e-12);
        let crown = Profile::Crown { crown_radius: 10.0 };
        let tilted = |angle| roller(crown.clone(), angle).relief(w, b, e);
        assert!(matches!(tilted(0.75e-3), Relief::Share(_)));
        assert_eq!(tilted(0.81e-3), Relief::StandsOnEnd);
        assert_eq!(tilted(-0.81e-3), Relief::StandsOnEnd);
        let cylinder = Profile::Straight {
            straight_length: 0.016,
            end_radius: 0.01,
        };
        assert_eq!(roller(cylinder, 0.0).relief(w, b, e), Relief::Share(0.0));
    }
}
