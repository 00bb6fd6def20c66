//! The angle between the motion and the principal directions of the bodies.

/// A rotation by the angle θ of the entrainment to the first principal direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn {
    cos: f64,
    sin: f64,
}

impl Turn {
    /// The motion along the first principal direction.
    pub const NONE: Turn = Turn { cos: 1.0, sin: 0.0 };

    /// By an angle, rad.
    pub fn by(angle: f64) -> Turn {
        let (sin, cos) = angle.sin_cos();
        Turn { cos, sin }
    }

    /// Whether the two directions are the same.
    pub fn is_none(&self) -> bool {
        self.sin == 0.0
    }

    /// Components along the principal directions of a vector given along and across the motion.
    #[inline(always)]
    pub fn to_axes(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.cos * x - self.sin * y, self.sin * x + self.cos * y]
    }

    /// The inverse.
    #[inline(always)]
    pub fn to_motion(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.cos * x + self.sin * y, self.cos * y - self.sin * x]
    }
}
