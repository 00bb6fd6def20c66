//! The factors as they are kept: A⁻¹, V and W of each front in single precision.

use super::FrontalPattern;
use crate::linear::dense::{add_product, multiply_transposed};

/// A⁻¹, V and W of each front, column by column.
#[derive(Debug, PartialEq)]
pub(super) struct Factors(pub(super) Vec<f32>);

impl Factors {
    /// A⁻¹ (n × n), V (m × n) and W (n × m) of a front.
    #[inline(always)]
    pub(super) fn of(&self, pattern: &FrontalPattern, front: usize) -> [Block<'_>; 3] {
        let f = &pattern.fronts.fronts[front];
        let (n, m) = (f.n_own, f.boundary.len());
        let own = &self.0[pattern.starts[front]..pattern.starts[front + 1]];
        let (inverse, rest) = own.split_at(n * n);
        let (v, w) = rest.split_at(n * m);
        [Block(inverse), Block(v), Block(w)]
    }
}

/// A dense matrix.
pub(super) struct Block<'a>(&'a [f32]);

impl Block<'_> {
    /// y = A x.
    #[inline(always)]
    pub(super) fn multiply(&self, x: &[f32], y: &mut [f32]) {
        y.fill(0.0);
        add_product(self.0, x, y);
    }

    /// y = Aᵀ x.
    #[inline(always)]
    pub(super) fn multiply_transposed(&self, x: &[f32], y: &mut [f32]) {
        multiply_transposed::<16>(self.0, x, y);
    }
}
