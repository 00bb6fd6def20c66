//! Functions that the laws share: powers smooth at zero, an exponential that does not overflow, a root finder.

use crate::Scalar;

/// Smallest exponent n of a power law: the fluidity grows with the stress to the power 99.
pub(super) const SMALLEST_EXPONENT: f64 = 0.01;

/// Squares of relative stresses below this are too small to matter; a power of them is smoothed here.
const SMALLEST_SQUARE: f64 = 1e-12;

/// `|r|^k` of `square = r²`, smooth at zero: `r² (r² + 1e-12)^(k/2 - 1)`.
///
/// Second derivatives of the power itself are infinite at zero for `k < 4` other than 2. The relative difference is
/// `(1 - k/2) 1e-12/r²`.
///
/// Theory: Zero stress.
#[inline]
pub(super) fn smooth_power<D: Scalar>(square: D, k: f64) -> D {
    square * (square + SMALLEST_SQUARE).powf(0.5 * k - 1.0)
}

/// Logarithm of [`smooth_power`] from `ln r²`, for `r ≥ 1`, where the power may overflow.
#[inline]
pub(super) fn ln_smooth_power<D: Scalar>(ln_square: D, k: f64) -> D {
    ln_square * (0.5 * k) + (-ln_square).exp() * (SMALLEST_SQUARE * (0.5 * k - 1.0))
}

/// `ln(1 + |r|^k)` of `square = r²`, smooth at zero, and finite where the power overflows.
#[inline]
pub(super) fn ln_one_plus_power<D: Scalar>(square: D, k: f64) -> D {
    if square.re() < 1.0 {
        smooth_power(square, k).ln_1p()
    } else {
        ln_one_plus_large(ln_smooth_power(square.ln(), k))
    }
}

/// The same of `square = r² exp(ln_factor)`.
#[inline]
pub(super) fn ln_one_plus_scaled_power<D: Scalar>(square: D, ln_factor: D, k: f64) -> D {
    if square.re().ln() + ln_factor.re() < 0.0 {
        smooth_power(square * ln_factor.exp(), k).ln_1p()
    } else {
        ln_one_plus_large(ln_smooth_power(square.ln() + ln_factor, k))
    }
}

/// `ln(1 + |r|^k)` and its slope by `ln r²`, from `ln_square = ln r²`.
pub(super) fn ln_one_plus_power_and_slope(ln_square: f64, k: f64) -> (f64, f64) {
    if ln_square < 0.0 {
        let square = ln_square.exp();
        let power = smooth_power(square, k);
        // d ln u/d ln r², u the smooth power.
        let slope = 1.0 + (0.5 * k - 1.0) * square / (square + SMALLEST_SQUARE);
        (power.ln_1p(), slope * power / (1.0 + power))
    } else {
        let ln_power = ln_smooth_power(ln_square, k);
        let reciprocal = (-ln_power).exp();
        (ln_power + reciprocal.ln_1p(), 0.5 * k / (1.0 + reciprocal))
    }
}

/// `ln(1 + x)` from `ln x ≥ 0`.
#[inline]
fn ln_one_plus_large<D: Scalar>(ln_x: D) -> D {
    ln_x + (-ln_x).exp().ln_1p()
}

/// Exponent from which [`bounded_exp`] is a parabola. The product of two such numbers and of their derivatives is still
/// far from the end of floating point.
pub(super) const LARGEST_EXPONENT: f64 = 150.0;

/// `exp(x)`; above `x = 150`, where nothing physical is left, its Taylor parabola: value and two derivatives match.
#[inline]
pub(super) fn bounded_exp<D: Scalar>(x: D) -> D {
    if x.re() <= LARGEST_EXPONENT {
        x.exp()
    } else {
        let e = x - LARGEST_EXPONENT;
        (e * e * 0.5 + e + 1.0) * LARGEST_EXPONENT.exp()
    }
}

/// Root of an increasing function between `low` and `high` by Newton's method from `start`, to round-off; a step that
/// leaves the bracket is replaced by bisection. `f` returns value and slope, and both are smooth: an error of 1e-9 is
/// squared by the next step. NaN where an end of the bracket or a value of the function is NaN, or `low > high`.
pub(super) fn increasing_root(
    f: impl Fn(f64) -> (f64, f64),
    mut low: f64,
    mut high: f64,
    start: f64,
) -> f64 {
    const MAX_ITERATIONS: usize = 200;
    // An iterate that is no number must come back as one, for the solver to refuse.
    if low.is_nan() || high.is_nan() || low > high {
        return f64::NAN;
    }
    let mut x = if start.is_nan() {
        low
    } else {
        start.max(low).min(high)
    };
    for _ in 0..MAX_ITERATIONS {
        let (value, slope) = f(x);
        if value.is_nan() {
            return f64::NAN;
        }
        if value > 0.0 {
            high = x;
        } else {
            low = x;
        }
        let newton = x - value / slope;
        let is_step = slope > 0.0 && slope.is_finite();
        if is_step && (newton - x).abs() <= 1e-9 * x.abs().max(1.0) {
            return newton;
        }
        x = if is_step && newton > low && newton < high {
            newton
        } else {
            0.5 * (low + high)
        };
    }
    x
}

#[cfg(test)]
mod tests {
    use super::increasing_root;

    #[test]
    fn a_root_that_is_no_number_is_no_panic() {
        let line = |x: f64| (x - 0.5, 1.0);
        assert_eq!(increasing_root(line, 0.0, 1.0, f64::NAN), 0.5);
        for (low, high) in [(f64::NAN, 1.0), (0.0, f64::NAN), (1.0, 0.0)] {
            assert!(increasing_root(line, low, high, 0.5).is_nan());
        }
        assert!(increasing_root(|_| (f64::NAN, 1.0), 0.0, 1.0, 0.5).is_nan());
        // A step with a slope that is none is a bisection.
        let steep = |x: f64| (x - 0.3, if x < 0.4 { 1.0 } else { f64::INFINITY });
        assert_eq!(increasing_root(steep, 0.0, 1.0, 1.0), 0.3);
    }
}
