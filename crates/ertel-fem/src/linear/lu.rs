//! Sparse LU of an unsymmetric matrix given by triplets.

use faer::linalg::solvers::SolveCore;
use faer::sparse::linalg::solvers::{Lu, SymbolicLu};
use faer::sparse::{SparseColMat, Triplet};
use faer::{Conj, MatMut};

/// The matrix could not be factorised.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("sparse LU of {n} unknowns failed: {reason}")]
pub struct LuError {
    /// Order of the matrix.
    pub n: usize,
    /// What the library said.
    pub reason: String,
}

/// Sparse LU factorisation.
pub struct SparseLu {
    n: usize,
    lu: Lu<usize, f64>,
}

impl SparseLu {
    /// Factorises the sum of the triplets (row, column, value).
    ///
    /// # Errors
    /// When the matrix is structurally or numerically singular, or memory runs out.
    pub fn new(n: usize, triplets: &[Triplet<usize, usize, f64>]) -> Result<SparseLu, LuError> {
        let fail = |reason: String| LuError { n, reason };
        let matrix = SparseColMat::<usize, f64>::try_new_from_triplets(n, n, triplets)
            .map_err(|e| fail(format!("{e:?}")))?;
        let symbolic =
            SymbolicLu::try_new(matrix.symbolic()).map_err(|e| fail(format!("{e:?}")))?;
        let lu = Lu::try_new_with_symbolic(symbolic, matrix.as_ref())
            .map_err(|e| fail(format!("{e:?}")))?;
        Ok(SparseLu { n, lu })
    }

    /// Solves in place.
    pub fn solve(&self, rhs: &mut [f64]) {
        let n = self.n;
        self.lu
            .solve_in_place_with_conj(Conj::No, MatMut::from_column_major_slice_mut(rhs, n, 1));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// By hand: [[2, 1], [4, −3]] x = (5, 5) has x = (2, 1).
    #[test]
    fn solves_a_small_unsymmetric_system() {
        let t = [
            (0, 0, 2.0),
            (0, 1, 1.0),
            (1, 0, 4.0),
            (1, 1, -2.0),
            (1, 1, -1.0),
        ]
        .map(|(i, j, v)| Triplet::new(i, j, v));
        let lu = SparseLu::new(2, &t).unwrap();
        let mut x = [5.0, 5.0];
        lu.solve(&mut x);
        assert_relative_eq!(x[0], 2.0, epsilon = 1e-14);
        assert_relative_eq!(x[1], 1.0, epsilon = 1e-14);
    }
}
