//! The factors as they are kept: whole numbers of sixteen bits with the scales of their rows and columns.

use rayon::prelude::*;

use super::FrontalPattern;
use super::rounding::round;
use crate::linear::dense::{add_product, multiply_transposed_whole};

/// A⁻¹, V and W of each front: the entry (i, j) of each is `whole` times the scales of its row and column.
#[derive(Debug, PartialEq)]
pub(super) struct Factors {
    whole: Vec<i16>,
    /// Rows, then columns, of A⁻¹, V and W of each front.
    scales: Vec<f32>,
    /// Start of each front's scales.
    starts: Vec<usize>,
}

impl Factors {
    pub(super) fn new(pattern: &FrontalPattern, numbers: &[f32]) -> Factors {
        let mut starts = vec![0];
        for f in &pattern.fronts.fronts {
            let (n, m) = (f.n_own, f.boundary.len());
            starts.push(starts[starts.len() - 1] + 4 * n + 2 * m);
        }
        let mut whole = vec![0; numbers.len()];
        let mut scales = vec![0.0; starts[starts.len() - 1]];
        let mut tasks = Vec::with_capacity(pattern.fronts.fronts.len());
        let (mut whole_rest, mut scales_rest) = (&mut whole[..], &mut scales[..]);
        for (k, front) in pattern.fronts.fronts.iter().enumerate() {
            let range = pattern.starts[k]..pattern.starts[k + 1];
            let (own, beyond) = whole_rest.split_at_mut(range.len());
            let (sizes, sizes_beyond) = scales_rest.split_at_mut(starts[k + 1] - starts[k]);
            tasks.push((front, &numbers[range], own, sizes));
            (whole_rest, scales_rest) = (beyond, sizes_beyond);
        }
        tasks
            .into_par_iter()
            .with_min_len(8)
            .for_each(|(front, numbers, whole, scales)| {
                let (n, m) = (front.n_own, front.boundary.len());
                let (mut whole, mut scales) = (whole, scales);
                for (part, rows) in split(numbers, n, m).into_iter().zip([n, m, n]) {
                    let columns = part.len().checked_div(rows).unwrap_or(0);
                    let (own, beyond) = whole.split_at_mut(part.len());
                    let (by_row, rest) = scales.split_at_mut(rows);
                    let (by_column, rest) = rest.split_at_mut(columns);
                    round(part, by_row, by_column, own);
                    (whole, scales) = (beyond, rest);
                }
            });
        Factors {
            whole,
            scales,
            starts,
        }
    }

    /// A⁻¹, V and W of a front.
    #[inline(always)]
    pub(super) fn of(&self, pattern: &FrontalPattern, front: usize) -> [Scaled<'_>; 3] {
        let f = &pattern.fronts.fronts[front];
        let (n, m) = (f.n_own, f.boundary.len());
        let [inverse, v, w] = split(&self.whole[pattern.starts[front]..], n, m);
        let scales = &self.scales[self.starts[front]..self.starts[front + 1]];
        let (of_inverse, scales) = scales.split_at(2 * n);
        let (of_v, of_w) = scales.split_at(n + m);
        [
            Scaled::new(inverse, of_inverse, n),
            Scaled::new(v, of_v, m),
            Scaled::new(w, of_w, n),
        ]
    }
}

/// A matrix of whole numbers with the scales of its rows and columns.
pub(super) struct Scaled<'a> {
    whole: &'a [i16],
    by_row: &'a [f32],
    by_column: &'a [f32],
}

impl<'a> Scaled<'a> {
    #[inline(always)]
    fn new(whole: &'a [i16], scales: &'a [f32], rows: usize) -> Scaled<'a> {
        let (by_row, by_column) = scales.split_at(rows);
        Scaled {
            whole,
            by_row,
            by_column,
        }
    }

    /// y = A x.
    #[inline(always)]
    pub(super) fn multiply(&self, x: &[f32], y: &mut [f32], scaled: &mut [f32]) {
        let scaled = times(x, self.by_column, scaled);
        y.fill(0.0);
        add_product(self.whole, scaled, y);
        for (y, r) in y.iter_mut().zip(self.by_row) {
            *y *= r;
        }
    }

    /// y = Aᵀ x.
    #[inline(always)]
    pub(super) fn multiply_transposed(&self, x: &[f32], y: &mut [f32], scaled: &mut [f32]) {
        let scaled = times(x, self.by_row, scaled);
        multiply_transposed_whole::<16>(self.whole, scaled, y);
        for (y, c) in y.iter_mut().zip(self.by_column) {
            *y *= c;
        }
    }
}

#[inline(always)]
fn times<'a>(x: &[f32], scales: &[f32], scaled: &'a mut [f32]) -> &'a [f32] {
    let scaled = &mut scaled[..x.len()];
    for ((s, x), c) in scaled.iter_mut().zip(x).zip(scales) {
        *s = x * c;
    }
    scaled
}

/// A⁻¹ (n × n), V (m × n) and W (n × m) of a front.
#[inline(always)]
fn split<T>(storage: &[T], n: usize, m: usize) -> [&[T]; 3] {
    [
        &storage[..n * n],
        &storage[n * n..n * (n + m)],
        &storage[n * (n + m)..n * (n + 2 * m)],
    ]
}
