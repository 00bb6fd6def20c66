//! Dense Cholesky factorisation, of a front or of a whole matrix.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt;
use faer::linalg::cholesky::llt::factor::LltRegularization;
use faer::linalg::matmul::triangular::{self, BlockStructure};
use faer::linalg::triangular_solve::solve_lower_triangular_in_place;
use faer::prelude::{Reborrow, ReborrowMut};
use faer::{Accum, MatMut, Par};

use crate::linear::ordering::OrderingError;
use crate::platform::all_cores;

/// Lower factor of a dense matrix, in its place.
pub(super) fn factor(mut entries: Vec<f64>, n: usize) -> Result<Vec<f64>, CholeskyError> {
    let matrix = MatMut::from_column_major_slice_mut(&mut entries, n, n);
    cholesky(matrix, all_cores())
        .map_err(|reason| CholeskyError::NotPositiveDefinite { n, reason })?;
    Ok(entries)
}

/// Eliminates the first `n` unknowns of a front, lower triangle, in place.
pub(super) fn eliminate(mut matrix: MatMut<f64>, n: usize, par: Par) -> Result<(), String> {
    let (mut a, _, mut c, mut d) = matrix.rb_mut().split_at_mut(n, n);
    cholesky(a.rb_mut(), par)?;
    // C L⁻ᵀ
    solve_lower_triangular_in_place(a.rb(), c.rb_mut().transpose_mut(), par);
    triangular::matmul(
        d.rb_mut(),
        BlockStructure::TriangularLower,
        Accum::Add,
        c.rb(),
        BlockStructure::Rectangular,
        c.rb().transpose(),
        BlockStructure::Rectangular,
        -1.0,
        par,
    );
    Ok(())
}

/// Dense Cholesky factorisation of a lower triangle, in place.
fn cholesky(matrix: MatMut<f64>, par: Par) -> Result<(), String> {
    let n = matrix.nrows();
    if n == 0 {
        return Ok(());
    }
    let scratch = llt::factor::cholesky_in_place_scratch::<f64>(n, par, Default::default());
    llt::factor::cholesky_in_place(
        matrix,
        LltRegularization::default(),
        par,
        MemStack::new(&mut MemBuffer::new(scratch)),
        Default::default(),
    )
    .map(drop)
    .map_err(|e| format!("{e:?}"))
}

/// The factorisation failed.
#[derive(Clone, Debug, thiserror::Error)]
pub enum CholeskyError {
    /// The ordering failed.
    #[error(transparent)]
    Ordering(#[from] OrderingError),
    /// A pivot was not positive: the body is not fixed, or an element is inverted.
    #[error("stiffness of {n} unknowns is not positive definite: {reason}")]
    NotPositiveDefinite {
        /// Unknowns.
        n: usize,
        /// Message of the library.
        reason: String,
    },
    /// Stopped on request.
    #[error("interrupted")]
    Interrupted,
}
