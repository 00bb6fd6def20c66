//! Kernels: potential at one point of a unit density at another.

/// Kernel of a potential.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kernel {
    /// 1/r: the surface of a half-space under a point load.
    InverseDistance,
    /// −ln r: the same under a line load.
    Logarithm,
}

impl Kernel {
    /// Value at the distance r > 0.
    #[inline]
    pub fn at(self, r: f64) -> f64 {
        match self {
            Kernel::InverseDistance => 1.0 / r,
            Kernel::Logarithm => -r.ln(),
        }
    }

    /// (f, c) with K(s r) = f K(r) + c: one table serves boxes of any size.
    pub(super) fn scaled(self, s: f64) -> (f64, f64) {
        match self {
            Kernel::InverseDistance => (1.0 / s, 0.0),
            Kernel::Logarithm => (1.0, -s.ln()),
        }
    }
}
