//! Numbers with derivatives by the variables of the Reynolds equation at a point.

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// Number type of an integrand: `f64`, or [`Dual`] for its derivatives.
pub trait Number:
    Copy
    + From<f64>
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
    + Div<f64, Output = Self>
    + AddAssign
    + SubAssign
{
    /// The value alone.
    fn re(&self) -> f64;
    /// 1/x.
    fn recip(self) -> Self;
    /// tanh x.
    fn tanh(self) -> Self;
}

impl Number for f64 {
    #[inline(always)]
    fn re(&self) -> f64 {
        *self
    }
    #[inline(always)]
    fn recip(self) -> f64 {
        f64::recip(self)
    }
    #[inline(always)]
    fn tanh(self) -> f64 {
        f64::tanh(self)
    }
}

/// A value and its derivatives by `N` quantities: arithmetic in whole vectors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual<const N: usize> {
    /// Value.
    pub re: f64,
    /// Derivatives.
    pub slopes: [f64; N],
}

impl<const N: usize> Dual<N> {
    /// The k-th variable.
    #[inline(always)]
    pub fn variable(re: f64, k: usize) -> Self {
        let mut slopes = [0.0; N];
        slopes[k] = 1.0;
        Dual { re, slopes }
    }

    /// A function of x by its value and its derivative.
    #[inline(always)]
    fn chain(self, re: f64, derivative: f64) -> Self {
        Dual {
            re,
            slopes: self.slopes.map(|s| derivative * s),
        }
    }

    /// A function of two numbers by its value and its derivatives.
    #[inline(always)]
    fn combine(self, other: Self, re: f64, by_self: f64, by_other: f64) -> Self {
        let mut slopes = [0.0; N];
        for k in 0..N {
            slopes[k] = by_self * self.slopes[k] + by_other * other.slopes[k];
        }
        Dual { re, slopes }
    }
}

impl<const N: usize> Number for Dual<N> {
    #[inline(always)]
    fn re(&self) -> f64 {
        self.re
    }
    #[inline(always)]
    fn recip(self) -> Self {
        let r = self.re.recip();
        self.chain(r, -r * r)
    }
    #[inline(always)]
    fn tanh(self) -> Self {
        let t = self.re.tanh();
        self.chain(t, 1.0 - t * t)
    }
}

impl<const N: usize> From<f64> for Dual<N> {
    #[inline(always)]
    fn from(re: f64) -> Self {
        Dual {
            re,
            slopes: [0.0; N],
        }
    }
}

impl<const N: usize> Neg for Dual<N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.chain(-self.re, -1.0)
    }
}

impl<const N: usize> Add for Dual<N> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.combine(other, self.re + other.re, 1.0, 1.0)
    }
}

impl<const N: usize> Sub for Dual<N> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.combine(other, self.re - other.re, 1.0, -1.0)
    }
}

impl<const N: usize> Mul for Dual<N> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.combine(other, self.re * other.re, other.re, self.re)
    }
}

impl<const N: usize> Div for Dual<N> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let r = other.re.recip();
        let q = self.re * r;
        self.combine(other, q, r, -q * r)
    }
}

impl<const N: usize> Add<f64> for Dual<N> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: f64) -> Self {
        Dual {
            re: self.re + other,
            ..self
        }
    }
}

impl<const N: usize> Sub<f64> for Dual<N> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: f64) -> Self {
        Dual {
            re: self.re - other,
            ..self
        }
    }
}

impl<const N: usize> Mul<f64> for Dual<N> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: f64) -> Self {
        self.chain(self.re * other, other)
    }
}

impl<const N: usize> Div<f64> for Dual<N> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: f64) -> Self {
        self.chain(self.re / other, other.recip())
    }
}

impl<const N: usize> AddAssign for Dual<N> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<const N: usize> SubAssign for Dual<N> {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Every operation against central differences, by x and by y.
    #[test]
    fn slopes_match_differences() {
        fn all<D: Number>(x: D, y: D) -> [D; 5] {
            let mut sum = x * 3.0 - 0.5;
            sum += y / 4.0;
            sum -= x;
            [
                sum,
                x / y + 0.2,
                (x * y).tanh(),
                y.recip() - x * x,
                -(x * y) + D::from(1.0),
            ]
        }
        let (x, y, step) = (0.7, 1.3, 1e-6);
        let dual = all(Dual::<8>::variable(x, 2), Dual::<8>::variable(y, 6));
        let value = all(x, y);
        let by_x = [all(x + step, y), all(x - step, y)];
        let by_y = [all(x, y + step), all(x, y - step)];
        for i in 0..5 {
            assert_relative_eq!(dual[i].re, value[i], max_relative = 1e-14);
            for (slope, d) in [(dual[i].slopes[2], by_x), (dual[i].slopes[6], by_y)] {
                let difference = (d[0][i] - d[1][i]) / (2.0 * step);
                assert_relative_eq!(slope, difference, epsilon = 1e-8);
            }
            assert_eq!(dual[i].slopes[0], 0.0);
        }
    }
}
