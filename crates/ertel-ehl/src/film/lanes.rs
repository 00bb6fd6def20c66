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

/// eˣ, to round-off for results that are neither huge nor tiny: 2ᵏeʳ, |r| ≤ ½ ln 2, by its power series.
#[inline(always)]
pub fn exp(x: Lanes) -> Lanes {
    /// Adding it rounds to an integer in the last bits.
    const ROUND: f64 = 1.5 * (1_u64 << 52) as f64;
    /// ln 2 in two parts, the first with zeros at the end.
    const LN_2: [f64; 2] = [6.931_471_803_691_238e-1, 1.908_214_929_270_587_7e-10];
    /// Number of terms.
    const N: usize = 14;
    let mut y = x;
    for v in &mut y.0 {
        let x = v.clamp(-700.0, 700.0);
        let shifted = x * std::f64::consts::LOG2_E + ROUND;
        let k = shifted - ROUND;
        let r = (x - k * LN_2[0]) - k * LN_2[1];
        let mut sum = 1.0;
        for n in (1..N).rev() {
            sum = sum * r * (1.0 / n as f64) + 1.0;
        }
        *v = sum * f64::from_bits(shifted.to_bits().wrapping_add(1023) << 52);
    }
    y
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

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Against the exponential function of the standard library.
    #[test]
    fn exponentials() {
        for i in -4000..4000 {
            let x = i as f64 * 0.0173;
            let lanes = std::array::from_fn(|k| x * (1.0 - k as f64));
            for (ours, x) in exp(Lanes(lanes)).0.iter().zip(lanes) {
                assert_relative_eq!(*ours, x.clamp(-700.0, 700.0).exp(), max_relative = 1e-14);
            }
        }
        assert!(exp(Lanes::all(f64::NAN)).0[0].is_nan());
    }
}
