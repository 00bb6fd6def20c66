//! Numbers of expansions, entries and sums, in single and double precision.

use crate::linear::dense::Real;

/// Numbers of expansions, entries and sums.
pub(crate) trait Number: Real + Sync {
    /// Numbers in the widest vector.
    const LANES: usize;
    fn from_f64(v: f64) -> Self;
    fn to_f64(self) -> f64;
}

impl Number for f32 {
    const LANES: usize = 16;
    #[inline(always)]
    fn from_f64(v: f64) -> f32 {
        v as f32
    }
    #[inline(always)]
    fn to_f64(self) -> f64 {
        f64::from(self)
    }
}

impl Number for f64 {
    const LANES: usize = 8;
    #[inline(always)]
    fn from_f64(v: f64) -> f64 {
        v
    }
    #[inline(always)]
    fn to_f64(self) -> f64 {
        self
    }
}

/// Σ a_i b_i in the precision of the second, several sums side by side.
#[inline(always)]
pub(super) fn mixed_dot<S: Number, T: Number>(a: &[S], b: &[T]) -> T {
    const L: usize = 16;
    let convert = |v: S| T::from_f64(v.to_f64());
    let mut sums = [T::default(); L];
    let (xs, ys) = (a.chunks_exact(L), b.chunks_exact(L));
    let rest = xs.remainder().iter().zip(ys.remainder());
    for (x, y) in xs.zip(ys) {
        for l in 0..L {
            sums[l] += convert(x[l]) * y[l];
        }
    }
    // Halves onto halves: vectors, where one by one would wait for each addition.
    let mut half = L / 2;
    while half > 0 {
        for l in 0..half {
            let other = sums[l + half];
            sums[l] += other;
        }
        half /= 2;
    }
    let mut sum = sums[0];
    for (x, y) in rest {
        sum += convert(*x) * *y;
    }
    sum
}
