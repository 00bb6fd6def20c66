//! The region where the surfaces face each other: sums over the contact area end with the bodies.
//!
//! ```text
//!   (x/l_1)² + (y/l_2)² < 1      l how far the bodies reach along the principal directions
//! ```

use crate::contact::{Shape, Turn};

/// The region up to an end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Region {
    ends: [f64; 2],
    turn: Turn,
}

impl Region {
    /// As far as the bodies reach.
    pub fn of(shape: &Shape) -> Region {
        Region {
            ends: shape.ends,
            turn: shape.gap.turn,
        }
    }

    /// Half as far, but twice as far as the Hertz zone at least, where that is nearer: the difference shows the influence of the end.
    pub fn shorter(&self, shape: &Shape) -> Region {
        let zone = [1.0, shape.zone.axis_ratio];
        Region {
            ends: [0, 1]
                .map(|i: usize| (0.5 * self.ends[i]).max((2.0 * zone[i]).min(self.ends[i]))),
            ..*self
        }
    }

    /// A place in lengths of the region, which is the unit circle there.
    #[inline]
    pub fn unit(&self, at: [f64; 2]) -> [f64; 2] {
        let [x, y] = self.turn.to_axes(at);
        [x / self.ends[0], y / self.ends[1]]
    }

    /// The place at an angle (rad) round the end, and its outward normal times the length of the end per angle; `None` where the region
    /// has no end round the centre.
    pub fn end_at(&self, angle: f64) -> Option<([f64; 2], [f64; 2])> {
        let [a, b] = self.ends;
        if !(a.is_finite() && b.is_finite()) {
            return None;
        }
        let (s, c) = angle.sin_cos();
        Some((
            self.turn.to_motion([a * c, b * s]),
            self.turn.to_motion([b * c, a * s]),
        ))
    }

    /// Where it ends along the first principal direction.
    pub fn along(&self) -> f64 {
        self.ends[0]
    }
}
