//! Multifrontal LU of an unsymmetric matrix with symmetric pattern, for preconditioning.
//!
//! ```text
//!   front  | A  B |    W = A⁻¹B, V = C A⁻¹; D − V B goes to the parent.
//!          | C  D |    A⁻¹, V and W are kept: a solve is three products per front.
//! ```
//! Rows are interchanged inside A only: the order is fixed by the pattern, once for all matrices
//! that share it. Single precision is what a preconditioner needs.

mod factorise;
mod factors;
mod pattern;
mod sweep;
#[cfg(test)]
mod tests;

use std::sync::Arc;

use crate::linear::fronts::Front;
use factorise::Left;
use factors::Factors;
use sweep::{Scratch, Side};

pub use pattern::FrontalPattern;

/// The matrix could not be factorised in the order of its pattern.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("frontal LU broke down: a block of {size} unknowns is singular")]
pub struct FrontalError {
    /// Unknowns of the block.
    pub size: usize,
}

/// A factorised matrix.
#[derive(Clone, Debug)]
pub struct FrontalLu {
    pattern: Arc<FrontalPattern>,
    factors: Arc<Factors>,
    x: Vec<f32>,
    /// Scratch of each part, and of the fronts above them.
    scratch: Vec<Scratch>,
}

impl FrontalLu {
    /// Factorises the matrix whose entries, in the order of the pattern's list, are `values`; equal
    /// places add up.
    ///
    /// # Errors
    /// When a diagonal block is singular.
    pub fn new(pattern: &Arc<FrontalPattern>, values: &[f64]) -> Result<FrontalLu, FrontalError> {
        let mut storage = vec![0.0; pattern.n_stored()];
        let front =
            |k: usize, kept: &mut [f32], left: Vec<Left>| pattern.factorise(k, values, kept, left);
        pattern
            .fronts
            .eliminate(&pattern.starts, &mut storage, &front)?;
        let fronts = &pattern.fronts.fronts;
        let largest = |f: fn(&Front) -> usize| vec![0.0; fronts.iter().map(f).max().unwrap_or(0)];
        let scratch = |n_beyond: usize| Scratch {
            outer: largest(|f| f.boundary.len()),
            own: largest(|f| f.n_own),
            beyond: vec![0.0; n_beyond],
        };
        let below = pattern.parts.iter().map(|root| {
            let f = &fronts[*root];
            scratch(pattern.n() - f.first - f.n_own)
        });
        Ok(FrontalLu {
            pattern: Arc::clone(pattern),
            factors: Arc::new(Factors::new(storage)),
            x: vec![0.0; pattern.n()],
            scratch: below.chain([scratch(0)]).collect(),
        })
    }

    /// Solves in place, approximately.
    pub fn solve(&mut self, rhs: &mut [f64]) {
        self.sweep(rhs, Side::Matrix);
    }

    /// Solves with the transposed matrix in place, approximately.
    pub fn solve_transposed(&mut self, rhs: &mut [f64]) {
        self.sweep(rhs, Side::Transposed);
    }
}
