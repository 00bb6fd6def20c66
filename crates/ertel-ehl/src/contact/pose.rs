//! Place and direction of a body after a motion in the plane.
//!
//! ```text
//!   x = D + R(θ) x_0,   R(θ) from x towards y        x_0: where the point lay at the start
//!   dx/dt = v_0(t) + ω(t) e_z × x:   θ = ∫ω dt,  D(t_1) = ∫ R(θ(t_1) − θ(t)) v_0(t) dt
//! ```

use serde::{Deserialize, Serialize};

/// Place and direction of a body that has moved in the plane, in the units of its creator.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Serialize)]
pub struct Pose {
    /// D.
    pub shift: [f64; 2],
    /// θ, rad.
    pub angle: f64,
}

/// A vector turned by an angle, rad.
pub fn turned(angle: f64, [x, y]: [f64; 2]) -> [f64; 2] {
    if angle == 0.0 {
        return [x, y];
    }
    let (sin, cos) = angle.sin_cos();
    [cos * x - sin * y, sin * x + cos * y]
}

impl Pose {
    /// Where it was at the start.
    pub const START: Pose = Pose {
        shift: [0.0; 2],
        angle: 0.0,
    };

    /// Moved along x by a distance.
    pub const fn along_x(distance: f64) -> Pose {
        Pose {
            shift: [distance, 0.0],
            angle: 0.0,
        }
    }

    /// After a further motion.
    #[must_use]
    pub fn then(&self, next: &Pose) -> Pose {
        let carried = turned(next.angle, self.shift);
        Pose {
            shift: [0, 1].map(|i: usize| carried[i] + next.shift[i]),
            angle: self.angle + next.angle,
        }
    }

    /// Where the point of the body that is at a place lay at the start.
    pub fn at_start(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        turned(-self.angle, [x - self.shift[0], y - self.shift[1]])
    }

    /// How a vector that is fixed to the body is directed now.
    pub fn directed(&self, vector: [f64; 2]) -> [f64; 2] {
        turned(self.angle, vector)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use std::f64::consts::FRAC_PI_2;

    /// A quarter turn about (1, 0) brings (2, 0) to (1, 1); a second one brings it to (0, 0).
    #[test]
    fn quarter_turns_by_hand() {
        let quarter = Pose {
            shift: [1.0, -1.0],
            angle: FRAC_PI_2,
        };
        for (pose, place) in [(quarter, [1.0, 1.0]), (quarter.then(&quarter), [0.0, 0.0])] {
            let at_start = pose.at_start(place);
            assert_relative_eq!(at_start[0], 2.0, epsilon = 1e-15);
            assert_relative_eq!(at_start[1], 0.0, epsilon = 1e-15);
        }
        let [x, y] = quarter.directed([0.0, 1.0]);
        assert_relative_eq!(x, -1.0, epsilon = 1e-15);
        assert_relative_eq!(y, 0.0, epsilon = 1e-15);
        assert_eq!(Pose::along_x(0.5).at_start([2.0, 3.0]), [1.5, 3.0]);
    }
}
