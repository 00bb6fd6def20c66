//! Products of small dense matrices with vectors, in the widest instructions that the processor has.
//!
//! Matrices are stored column by column. Sums are taken in an order that depends on the sizes alone.

use std::ops::{Add, AddAssign, Mul};

/// `f32` and `f64`.
pub trait Real:
    Copy + Default + Send + Sync + Add<Output = Self> + Mul<Output = Self> + AddAssign
{
}

impl Real for f32 {}
impl Real for f64 {}

pub use pulp::NullaryFnOnce as Kernel;

/// Runs a kernel, and what is inlined into it, with the widest vector instructions available.
///
/// A closure will do where it is short: a long one is not inlined, and compiled without those instructions. Others
/// are declared by [`kernel!`](crate::kernel).
#[inline]
pub fn vectorised<K: Kernel>(kernel: K) -> K::Output {
    pulp::Arch::new().dispatch(kernel)
}

/// Declares a kernel: a structure of its arguments, whose call is always inlined into [`vectorised`]. Lifetimes and
/// other parameters stand in brackets, as declared and as used.
#[macro_export]
macro_rules! kernel {
    ($name:ident [$($declared:tt)*] [$($used:tt)*] ($($argument:ident: $type:ty),* $(,)?) -> $output:ty $body:block) => {
        struct $name<$($declared)*> {
            $($argument: $type),*
        }

        impl<$($declared)*> $crate::linear::dense::Kernel for $name<$($used)*> {
            type Output = $output;

            #[inline(always)]
            fn call(self) -> $output {
                let $name { $($argument),* } = self;
                $body
            }
        }
    };
}

/// Columns that are treated at once: each pass over a vector then serves four columns.
const COLUMNS: usize = 4;

/// y += A x.
#[inline(always)]
pub fn add_product<T: Real>(a: &[T], x: &[T], y: &mut [T]) {
    let m = y.len();
    if m == 0 {
        return;
    }
    let whole = x.len() / COLUMNS * COLUMNS;
    let (a, a_rest) = a[..m * x.len()].split_at(m * whole);
    for (columns, x) in a.chunks_exact(COLUMNS * m).zip(x.chunks_exact(COLUMNS)) {
        let [c0, c1, c2, c3] = four(columns, m);
        for ((((y, c0), c1), c2), c3) in y.iter_mut().zip(c0).zip(c1).zip(c2).zip(c3) {
            *y += (*c0 * x[0] + *c1 * x[1]) + (*c2 * x[2] + *c3 * x[3]);
        }
    }
    for (column, x) in a_rest.chunks_exact(m).zip(&x[whole..]) {
        for (y, c) in y.iter_mut().zip(column) {
            *y += *c * *x;
        }
    }
}

/// y_rows += A x_columns and y_columns += Aᵀ x_rows in one pass over A, whose numbers of rows and columns are
/// multiples of `L` and of four.
#[inline(always)]
pub fn add_both<T: Real, const L: usize>(
    a: &[T],
    x_columns: &[T],
    x_rows: &[T],
    y_rows: &mut [T],
    y_columns: &mut [T],
) {
    let m = x_rows.len();
    let columns = a.chunks_exact(COLUMNS * m);
    let x_columns = x_columns.chunks_exact(COLUMNS);
    let y_columns = y_columns.chunks_exact_mut(COLUMNS);
    for ((columns, x), target) in columns.zip(x_columns).zip(y_columns) {
        let [c0, c1, c2, c3] = four(columns, m).map(|c| c.chunks_exact(L));
        let mut sums = [[T::default(); L]; COLUMNS];
        let rows = y_rows.chunks_exact_mut(L).zip(x_rows.chunks_exact(L));
        for (((((y, r), c0), c1), c2), c3) in rows.zip(c0).zip(c1).zip(c2).zip(c3) {
            for l in 0..L {
                y[l] += (c0[l] * x[0] + c1[l] * x[1]) + (c2[l] * x[2] + c3[l] * x[3]);
                sums[0][l] += c0[l] * r[l];
                sums[1][l] += c1[l] * r[l];
                sums[2][l] += c2[l] * r[l];
                sums[3][l] += c3[l] * r[l];
            }
        }
        for (y, lanes) in target.iter_mut().zip(sums) {
            let mut sum = T::default();
            for s in lanes {
                sum += s;
            }
            *y += sum;
        }
    }
}

#[inline(always)]
fn four<T>(columns: &[T], m: usize) -> [&[T]; COLUMNS] {
    let (c0, rest) = columns.split_at(m);
    let (c1, rest) = rest.split_at(m);
    let (c2, rest) = rest.split_at(m);
    [c0, c1, c2, &rest[..m]]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against plain sums, for sizes at and next to the widths of the loops.
    #[test]
    fn products_equal_plain_sums() {
        for (m, n) in [(1, 1), (3, 5), (16, 8), (37, 22), (0, 3), (4, 0)] {
            let a: Vec<f64> = (0..m * n).map(|k| (0.7 * k as f64).sin()).collect();
            let x: Vec<f64> = (0..n).map(|k| (0.3 * k as f64).cos()).collect();
            let mut y = vec![1.0; m];
            vectorised(|| add_product(&a, &x, &mut y));
            for i in 0..m {
                let exact: f64 = 1.0 + (0..n).map(|j| a[j * m + i] * x[j]).sum::<f64>();
                assert!((y[i] - exact).abs() < 1e-13);
            }
        }
    }
}
