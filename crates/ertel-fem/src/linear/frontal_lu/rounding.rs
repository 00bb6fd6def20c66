//! Rounding of a matrix to sixteen bits.

use crate::kernel;
use crate::linear::dense::vectorised;

/// Largest whole number in use.
const LARGEST: f32 = 32_000.0;

/// a_ij ≈ whole_ij r_i c_j: r_i the largest of the row, c_j what then is the largest of the column, over [`LARGEST`].
pub(super) fn round(numbers: &[f32], by_row: &mut [f32], by_column: &mut [f32], whole: &mut [i16]) {
    vectorised(Round {
        numbers,
        by_row,
        by_column,
        whole,
    });
}

kernel! {
    Round ['a] ['a]
    (numbers: &'a [f32], by_row: &'a mut [f32], by_column: &'a mut [f32], whole: &'a mut [i16]) -> () {
        round_inlined(numbers, by_row, by_column, whole)
    }
}

#[inline(always)]
fn round_inlined(numbers: &[f32], by_row: &mut [f32], by_column: &mut [f32], whole: &mut [i16]) {
    let rows = by_row.len();
    if rows == 0 {
        return;
    }
    by_row.fill(f32::MIN_POSITIVE);
    for column in numbers.chunks_exact(rows) {
        for (r, v) in by_row.iter_mut().zip(column) {
            *r = r.max(v.abs());
        }
    }
    let inverse: Vec<f32> = by_row.iter().map(|r| 1.0 / r).collect();
    let columns = numbers.chunks_exact(rows).zip(whole.chunks_exact_mut(rows));
    for ((column, whole), c) in columns.zip(by_column) {
        let mut largest = f32::MIN_POSITIVE;
        for (v, r) in column.iter().zip(&inverse) {
            largest = largest.max((v * r).abs());
        }
        let scale = LARGEST / largest;
        for ((w, v), r) in whole.iter_mut().zip(column).zip(&inverse) {
            *w = (v * r * scale).round_ties_even() as i16;
        }
        *c = largest / LARGEST;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows and columns of very different size: each entry within half of the last digit of its row and column.
    #[test]
    fn rounding_follows_rows_and_columns() {
        let (rows, columns) = (5, 4);
        let size = |i: usize, j: usize| 10f32.powi(2 * i as i32 - 3 * j as i32);
        let a: Vec<f32> = (0..rows * columns)
            .map(|k| size(k % rows, k / rows) * (0.9 * k as f32).cos())
            .collect();
        let (mut r, mut c) = (vec![0.0; rows], vec![0.0; columns]);
        let mut whole = vec![0; rows * columns];
        round(&a, &mut r, &mut c, &mut whole);
        for (k, v) in a.iter().enumerate() {
            let (i, j) = (k % rows, k / rows);
            assert!(whole[k].abs() <= 32_000);
            let back = f32::from(whole[k]) * r[i] * c[j];
            assert!((back - v).abs() <= 0.51 * r[i] * c[j], "{v} {back}");
            assert!(r[i] * c[j] <= size(i, j) * 1e-3, "{i} {j}");
        }
    }
}
