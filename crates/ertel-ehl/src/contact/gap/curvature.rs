//! Bodies whose radius differs from that of the scales.
//!
//! ```text
//!   g = ½ (R_r/R − 1)(x² + κy²)        R_r: the radius of the scales
//! ```

use super::Height;

/// Change of the paraboloid by a changed radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Curvature {
    /// R_r/R − 1.
    pub excess: f64,
    /// κ of the paraboloid.
    pub ratio: f64,
}

impl Curvature {
    /// Height and slopes at (x, y).
    #[inline]
    pub fn at(&self, [x, y]: [f64; 2]) -> Height {
        let Curvature { excess, ratio } = *self;
        Height {
            value: 0.5 * excess * (x * x + ratio * y * y),
            gradient: [excess * x, excess * ratio * y],
        }
    }
}
