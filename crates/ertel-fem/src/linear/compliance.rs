//! Dense symmetric compliance of the loaded surface, applied on all cores.
//!
//! Rows are cut into blocks of fixed size, and each row is summed by one thread in one order: the
//! result does not depend on the number of threads.

use faer::linalg::matmul::matmul;
use faer::{Accum, ColMut, ColRef, MatRef, Par};
use rayon::prelude::*;

/// A symmetric matrix in full, in double and in single precision.
#[derive(Clone, Debug, PartialEq)]
pub struct Compliance {
    n: usize,
    double: Vec<f64>,
    single: Vec<f32>,
}

/// Rows that one task takes.
const ROWS: usize = 64;

impl Compliance {
    /// From the lower triangle of a matrix: `lower(j)` is column j from the diagonal down.
    pub fn from_lower<'a>(n: usize, lower: impl Fn(usize) -> &'a [f64] + Sync) -> Compliance {
        let mut double = vec![0.0; n * n];
        double
            .par_chunks_mut(n.max(1) * ROWS)
            .enumerate()
            .for_each(|(block, rows)| {
                let first = block * ROWS;
                let count = rows.len() / n;
                for i in 0..count {
                    // by symmetry row i from the diagonal on is column i from the diagonal down
                    rows[i * n + first + i..(i + 1) * n].copy_from_slice(lower(first + i));
                }
                for j in 0..first + count {
                    let column = lower(j);
                    for i in j.saturating_sub(first)..count {
                        rows[i * n + j] = column[first + i - j];
                    }
                }
            });
        let single = double.iter().map(|v| *v as f32).collect();
        Compliance { n, double, single }
    }

    /// Order of the matrix.
    pub fn n(&self) -> usize {
        self.n
    }

    /// Entry (i, j).
    pub fn get(&self, i: usize, j: usize) -> f64 {
        self.double[i * self.n + j]
    }

    /// Row i.
    pub fn row(&self, i: usize) -> &[f64] {
        &self.double[i * self.n..(i + 1) * self.n]
    }

    /// y = C x.
    pub fn apply(&self, x: &[f64], y: &mut [f64]) {
        rows(&self.double, x, y);
    }

    /// y = C x in single precision, a good half of the time.
    pub fn apply_single(&self, x: &[f32], y: &mut [f32]) {
        rows(&self.single, x, y);
    }
}

fn rows<T: faer::traits::RealField>(matrix: &[T], x: &[T], y: &mut [T]) {
    let n = x.len();
    y.par_chunks_mut(ROWS).enumerate().for_each(|(block, y)| {
        let start = block * ROWS * n;
        let rows = &matrix[start..start + y.len() * n];
        matmul(
            ColMut::from_slice_mut(y),
            Accum::Replace,
            MatRef::from_row_major_slice(rows, rows.len() / n, n),
            ColRef::from_slice(x),
            T::one_impl(),
            Par::Seq,
        );
    });
}
