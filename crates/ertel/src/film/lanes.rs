//! Numbers side by side, for loops over the heights of a film.

use std::ops::{Add, AddAssign, Mul};

/// Number of lanes.
pub const WIDTH: usize = 8;

/// One number per lane.
#[derive(Clone, Copy, Debug, Default)]
pub struct Lanes(pub [f64; WIDTH]);

impl Lanes {
    /// The same number in each.
    #[inline(always)]
    pub fn all(value: f64) -> Lanes {
        Lanes([value; WIDTH])
    }

    /// Sum over the lanes.
    #[inline(always)]
    pub fn sum(self) -> f64 {
        let [a, b, c, d, e, f, g, h] = self.0;
        ((a + e) + (b + f)) + ((c + g) + (d + h))
    }
}

impl From<f64> for Lanes {
    #[inline(always)]
    fn from(value: f64) -> Lanes {
        Lanes::all(value)
    }
}

impl Add for Lanes {
    type Output = Lanes;

    #[inline(always)]
    fn add(mut self, other: Lanes) -> Lanes {
        for (a, b) in self.0.iter_mut().zip(other.0) {
            *a += b;
        }
        self
    }
}

impl AddAssign for Lanes {
    #[inline(always)]
    fn add_assign(&mut self, other: Lanes) {
        *self = *self + other;
    }
}

impl Mul for Lanes {
    type Output = Lanes;

    #[inline(always)]
    fn mul(mut self, other: Lanes) -> Lanes {
        for (a, b) in self.0.iter_mut().zip(other.0) {
            *a *= b;
        }
        self
    }
}

impl Mul<f64> for Lanes {
    type Output = Lanes;

    #[inline(always)]
    fn mul(mut self, factor: f64) -> Lanes {
        for a in &mut self.0 {
            *a *= factor;
        }
        self
    }
}
