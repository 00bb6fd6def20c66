//! The factors as they are kept.

use super::FrontalPattern;
use crate::linear::dense::add_product;

/// A⁻¹, V and W of each front, one after the other.
#[derive(Debug, PartialEq)]
pub(super) struct Factors(Vec<f32>);

impl Factors {
    pub(super) fn new(numbers: Vec<f32>) -> Factors {
        Factors(numbers)
    }

    /// A⁻¹ (n × n), V (m × n) and W (n × m) of a front.
    #[inline(always)]
    pub(super) fn of(&self, pattern: &FrontalPattern, front: usize) -> [Factor<'_>; 3] {
        let f = &pattern.fronts.fronts[front];
        let (n, m) = (f.n_own, f.boundary.len());
        let numbers = &self.0[pattern.starts[front]..];
        [
            Factor(&numbers[..n * n]),
            Factor(&numbers[n * n..n * (n + m)]),
            Factor(&numbers[n * (n + m)..n * (n + 2 * m)]),
        ]
    }
}

/// A matrix, column by column.
pub(super) struct Factor<'a>(&'a [f32]);

impl Factor<'_> {
    /// y = A x.
    #[inline(always)]
    pub(super) fn multiply(&self, x: &[f32], y: &mut [f32]) {
        y.fill(0.0);
        add_product(self.0, x, y);
    }
}
