//! Elimination of the fronts, in single precision.

use faer::linalg::matmul::matmul;
use faer::prelude::{Reborrow, ReborrowMut};
use faer::{Accum, Mat, MatMut, Par};

use super::FrontalPattern;

impl FrontalPattern {
    /// Factorises the front `k`, given what its children leave.
    pub(super) fn factorise(
        &self,
        k: usize,
        values: &[f64],
        kept: &mut [f32],
        left: Vec<Left>,
    ) -> Result<Left, FrontalError> {
        let front = &self.fronts.fronts[k];
        let (n, size) = (front.n_own, front.size());
        let mut matrix = Mat::<f32>::zeros(size, size);
        for (entry, index) in &self.scatter[k] {
            let (i, j) = (*index as usize % size, *index as usize / size);
            matrix[(i, j)] += values[*entry as usize] as f32;
        }
        for (child, left) in front.children.iter().zip(&left) {
            let map = &self.fronts.fronts[*child].in_parent;
            for (j, column) in map.iter().enumerate() {
                let target = matrix.col_as_slice_mut(*column as usize);
                let source = &left.matrix.col_as_slice(left.n_own + j)[left.n_own..];
                for (row, v) in map.iter().zip(source) {
                    target[*row as usize] += v;
                }
            }
        }
        drop(left);
        eliminate(matrix.as_mut(), n, kept).ok_or(FrontalError { size: n })?;
        Ok(Left { matrix, n_own: n })
    }
}

/// Matrix of a front after its elimination: the update of the parent begins at (n_own, n_own).
pub(super) struct Left {
    matrix: Mat<f32>,
    n_own: usize,
}

/// Eliminates the first `n` unknowns of a front in place; `storage` takes A⁻¹, V and W.
fn eliminate(mut matrix: MatMut<f32>, n: usize, storage: &mut [f32]) -> Option<()> {
    let m = matrix.nrows() - n;
    let (inverse, rest) = storage.split_at_mut(n * n);
    let (v, w) = rest.split_at_mut(n * m);
    let mut inverse = MatMut::from_column_major_slice_mut(inverse, n, n);
    let mut v = MatMut::from_column_major_slice_mut(v, m, n);
    let mut w = MatMut::from_column_major_slice_mut(w, n, m);
    let (a, b, c, mut d) = matrix.rb_mut().split_at_mut(n, n);
    invert(a, inverse.rb_mut())?;
    let par = Par::Seq;
    matmul(w.rb_mut(), Accum::Replace, inverse.rb(), b.rb(), 1.0, par);
    matmul(v.rb_mut(), Accum::Replace, c.rb(), inverse.rb(), 1.0, par);
    matmul(d.rb_mut(), Accum::Add, v.rb(), b.rb(), -1.0, par);
    Some(())
}

/// Inverse by LU with row interchanges; `None` when singular.
fn invert(mut a: MatMut<f32>, mut inverse: MatMut<f32>) -> Option<()> {
    use faer::dyn_stack::{MemBuffer, MemStack};
    use faer::linalg::lu::partial_pivoting::factor;
    let n = a.nrows();
    let (mut perm, mut perm_inverse) = (vec![0usize; n], vec![0usize; n]);
    let mut memory = MemBuffer::new(factor::lu_in_place_scratch::<usize, f32>(
        n,
        n,
        Par::Seq,
        Default::default(),
    ));
    factor::lu_in_place(
        a.rb_mut(),
        &mut perm,
        &mut perm_inverse,
        Par::Seq,
        MemStack::new(&mut memory),
        Default::default(),
    );
    inverse.fill(0.0);
    for (i, p) in perm.iter().enumerate() {
        inverse[(i, *p)] = 1.0;
    }
    let regular = (0..n).all(|i| a[(i, i)].is_normal());
    faer::linalg::triangular_solve::solve_unit_lower_triangular_in_place(
        a.rb(),
        inverse.rb_mut(),
        Par::Seq,
    );
    faer::linalg::triangular_solve::solve_upper_triangular_in_place(a.rb(), inverse, Par::Seq);
    regular.then_some(())
}

/// The matrix could not be factorised in the order of its pattern.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("frontal LU broke down: a block of {size} unknowns is singular")]
pub struct FrontalError {
    /// Unknowns of the block.
    pub size: usize,
}
