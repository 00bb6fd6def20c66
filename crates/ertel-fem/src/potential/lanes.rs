//! Numbers side by side in one vector register.

use std::ops::{Add, Div, Mul, Sub};

use pulp::Simd;

/// A vector of doubles, after what proves that the processor has such vectors.
#[derive(Clone, Copy)]
pub struct Lanes<S: Simd>(pub S, pub S::f64s);

impl<S: Simd> Lanes<S> {
    /// The same number everywhere.
    #[inline(always)]
    pub fn of(simd: S, v: f64) -> Self {
        Lanes(simd, simd.splat_f64s(v))
    }

    /// `self * b + c`.
    #[inline(always)]
    pub fn times_plus(self, b: Self, c: Self) -> Self {
        Lanes(self.0, self.0.mul_add_e_f64s(self.1, b.1, c.1))
    }

    #[inline(always)]
    pub fn sqrt(self) -> Self {
        Lanes(self.0, self.0.sqrt_f64s(self.1))
    }

    #[inline(always)]
    pub fn abs(self) -> Self {
        Lanes(self.0, self.0.abs_f64s(self.1))
    }

    /// `yes` where it is less than the bound, else `no`.
    #[inline(always)]
    pub fn below(self, bound: Self, yes: Self, no: Self) -> Self {
        let mask = self.0.less_than_f64s(self.1, bound.1);
        Lanes(self.0, self.0.select_f64s(mask, yes.1, no.1))
    }
}

impl<S: Simd> Add for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Lanes(self.0, self.0.add_f64s(self.1, other.1))
    }
}

impl<S: Simd> Sub for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Lanes(self.0, self.0.sub_f64s(self.1, other.1))
    }
}

impl<S: Simd> Mul for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Lanes(self.0, self.0.mul_f64s(self.1, other.1))
    }
}

impl<S: Simd> Div for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        Lanes(self.0, self.0.div_f64s(self.1, other.1))
    }
}

/// Natural logarithms of positive normal numbers, in place.
///
/// ```text
///   x = 2^k m,  √½ ≤ m < √2:   ln x = k ln 2 + 2 artanh s,   s = (m − 1)/(m + 1),   |s| < 0.172
/// ```
#[inline(always)]
pub fn logarithms(values: &mut [f64]) {
    // 1.5·2^52, in whose last bits whole numbers stand
    const SHIFT: f64 = 6_755_399_441_055_744.0;
    for v in values {
        let bits = v.to_bits();
        let from_root = bits.wrapping_sub(std::f64::consts::FRAC_1_SQRT_2.to_bits());
        let k = (from_root as i64) >> 52;
        let m = f64::from_bits(bits.wrapping_sub((k as u64) << 52));
        let k = f64::from_bits(SHIFT.to_bits().wrapping_add(k as u64)) - SHIFT;
        let s = (m - 1.0) / (m + 1.0);
        let z = s * s;
        let mut series = 1.0 / 21.0;
        for odd in [19.0, 17.0, 15.0, 13.0, 11.0, 9.0, 7.0, 5.0, 3.0] {
            series = series * z + 1.0 / odd;
        }
        *v = k * std::f64::consts::LN_2 + 2.0 * s * (1.0 + z * series);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn logarithms_over_the_whole_range() {
        let exact: Vec<f64> = (-1400..=1400).map(|k| 0.5 * f64::from(k)).collect();
        let mut values: Vec<f64> = exact.iter().map(|v| v.exp()).collect();
        values.extend([1.0, 1.0 + 1e-9, 1.0 - 1e-9]);
        let exact: Vec<f64> = values.iter().map(|v| v.ln()).collect();
        logarithms(&mut values);
        for (v, e) in values.iter().zip(&exact) {
            assert_relative_eq!(v, e, max_relative = 4e-16);
        }
    }
}
