//! Sparse LU of an unsymmetric matrix given by triplets.
//!
//! On one thread: faer's factorisation rounds otherwise on each number of threads, and results shall not depend on it.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::linalg::lu::{LuRef, NumericLu, SymbolicLu, factorize_symbolic_lu};
use faer::sparse::{SparseColMat, Triplet};
use faer::{Conj, MatMut, Par};

/// The matrix could not be factorised.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("sparse LU of {n} unknowns failed: {reason}")]
pub struct LuError {
    /// Order of the matrix.
    pub n: usize,
    /// Message of the library.
    pub reason: String,
}

/// Sparse LU factorisation.
pub struct SparseLu {
    n: usize,
    symbolic: SymbolicLu<usize>,
    numeric: NumericLu<usize, f64>,
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
        let symbolic = factorize_symbolic_lu(matrix.symbolic(), Default::default())
            .map_err(|e| fail(format!("{e:?}")))?;
        let mut numeric = NumericLu::new();
        let scratch = symbolic.factorize_numeric_lu_scratch::<f64>(Par::Seq, Default::default());
        let mut memory = MemBuffer::try_new(scratch).map_err(|e| fail(format!("{e:?}")))?;
        symbolic
            .factorize_numeric_lu(
                &mut numeric,
                matrix.as_ref(),
                Par::Seq,
                MemStack::new(&mut memory),
                Default::default(),
            )
            .map_err(|e| fail(format!("{e:?}")))?;
        Ok(SparseLu {
            n,
            symbolic,
            numeric,
        })
    }

    /// Solves in place.
    pub fn solve(&self, rhs: &mut [f64]) {
        let scratch = self.symbolic.solve_in_place_scratch::<f64>(1, Par::Seq);
        LuRef::new_unchecked(&self.symbolic, &self.numeric).solve_in_place_with_conj(
            Conj::No,
            MatMut::from_column_major_slice_mut(rhs, self.n, 1),
            Par::Seq,
            MemStack::new(&mut MemBuffer::new(scratch)),
        );
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

    /// Convection and diffusion in a cube, large enough for fronts that faer would share out among threads.
    #[test]
    fn the_same_bits_on_any_number_of_threads() {
        const SIDE: usize = 16;
        let mut t = Vec::new();
        for i in 0..SIDE * SIDE * SIDE {
            t.push(Triplet::new(i, i, 6.2));
            for (step, [up, down]) in [
                (1, [-1.7, -0.3]),
                (SIDE, [-1.2, -0.8]),
                (SIDE * SIDE, [-1.1, -0.9]),
            ] {
                if i / step % SIDE > 0 {
                    t.push(Triplet::new(i, i - step, up));
                    t.push(Triplet::new(i - step, i, down));
                }
            }
        }
        let on = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
            pool.unwrap().install(|| {
                let mut x: Vec<f64> = (0..SIDE * SIDE * SIDE).map(|i| (i as f64).sin()).collect();
                SparseLu::new(x.len(), &t).unwrap().solve(&mut x);
                x
            })
        };
        assert_eq!(on(1), on(8));
    }
}
