//! Sparse Cholesky factorisation that leaves the stiffness of a chosen part condensed.
//!
//! ```text
//!   K = | K_ii K_ic |    order: interior by nested dissection, then the chosen unknowns c.
//!       | K_ci K_cc |    Trailing block of the factor: L_cc L_ccᵀ = K_cc − K_ci K_ii⁻¹ K_ic = S
//! ```
//! S is the exact discrete stiffness that a load on c feels; S⁻¹ costs two dense triangular
//! solves of its size.

use faer::linalg::cholesky::llt::factor::LltRegularization;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LltRef, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky, supernodal,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, Mat, MatMut, Par, Side};
use rayon::prelude::*;

use crate::assembly::{CONSTRAINED, DofMap, NodeGraph, SymmetricMatrix};
use crate::linear::ordering::{OrderingError, nested_dissection};

/// The factorisation failed.
#[derive(Clone, Debug, thiserror::Error)]
pub enum CholeskyError {
    /// The ordering failed.
    #[error(transparent)]
    Ordering(#[from] OrderingError),
    /// Not enough memory or index overflow in the symbolic phase.
    #[error("symbolic factorisation of {n} unknowns failed: {reason}")]
    Symbolic {
        /// Unknowns.
        n: usize,
        /// What the library said.
        reason: String,
    },
    /// A pivot was not positive: the body is not held, or an element is inverted.
    #[error("stiffness of {n} unknowns is not positive definite: {reason}")]
    NotPositiveDefinite {
        /// Unknowns.
        n: usize,
        /// What the library said.
        reason: String,
    },
}

/// Factorised stiffness with its condensed part.
pub struct CondensedStiffness {
    symbolic: SymbolicCholesky<usize>,
    values: Vec<f64>,
    /// Lower factor of the condensed stiffness.
    factor: Mat<f64>,
    /// Unknowns of the condensed part, in the order of `factor`.
    condensed: Vec<usize>,
}

impl CondensedStiffness {
    /// Factorises `matrix`, whose unknowns `condensed` come last.
    ///
    /// # Errors
    /// When memory runs out or the matrix is not positive definite.
    pub fn new(
        matrix: &SymmetricMatrix,
        graph: &NodeGraph,
        dofs: &DofMap,
        condensed: &[usize],
    ) -> Result<CondensedStiffness, CholeskyError> {
        let n = matrix.n;
        let order = elimination_order(graph, dofs, condensed)?;
        let mut inverse = vec![0usize; n];
        for (k, dof) in order.iter().enumerate() {
            inverse[*dof] = k;
        }
        let pattern =
            SymbolicSparseColMatRef::new_checked(n, n, &matrix.col_ptr, None, &matrix.row_idx);
        let symbolic = factorize_symbolic_cholesky(
            pattern,
            Side::Upper,
            SymmetricOrdering::Custom(faer::perm::PermRef::new_checked(&order, &inverse, n)),
            CholeskySymbolicParams {
                supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL,
                ..Default::default()
            },
        )
        .map_err(|e| CholeskyError::Symbolic {
            n,
            reason: format!("{e:?}"),
        })?;
        let par = Par::rayon(0);
        let mut values = vec![0.0; symbolic.len_val()];
        let mut memory = faer::dyn_stack::MemBuffer::try_new(
            symbolic.factorize_numeric_llt_scratch::<f64>(par, Default::default()),
        )
        .map_err(|_| CholeskyError::Symbolic {
            n,
            reason: "out of memory".into(),
        })?;
        symbolic
            .factorize_numeric_llt(
                &mut values,
                SparseColMatRef::new(pattern, &matrix.values),
                Side::Upper,
                LltRegularization::default(),
                par,
                faer::dyn_stack::MemStack::new(&mut memory),
                Default::default(),
            )
            .map_err(|e| CholeskyError::NotPositiveDefinite {
                n,
                reason: format!("{e:?}"),
            })?;
        let factor = trailing_block(&symbolic, &values, condensed.len());
        Ok(CondensedStiffness {
            symbolic,
            values,
            factor,
            condensed: condensed.to_vec(),
        })
    }

    /// Number of condensed unknowns.
    pub fn n_condensed(&self) -> usize {
        self.condensed.len()
    }

    /// Displacement of the condensed unknowns under loads on them: S⁻¹ f, in place.
    pub fn solve_condensed(&self, load: &mut [f64]) {
        let n = load.len();
        let mut x = MatMut::from_column_major_slice_mut(load, n, 1);
        let par = Par::Seq;
        faer::linalg::triangular_solve::solve_lower_triangular_in_place(
            self.factor.as_ref(),
            x.as_mut(),
            par,
        );
        faer::linalg::triangular_solve::solve_upper_triangular_in_place(
            self.factor.as_ref().transpose(),
            x.as_mut(),
            par,
        );
    }

    /// Entries S_ij of the condensed stiffness.
    pub fn condensed_entries(&self, pairs: &[(u32, u32)]) -> Vec<f64> {
        // Rows of the factor lie contiguous in the transpose.
        let rows = self.factor.transpose().to_owned();
        pairs
            .par_iter()
            .map(|&(i, j)| {
                let n = i.min(j) as usize + 1;
                let (a, b) = (rows.col(i as usize), rows.col(j as usize));
                a.subrows(0, n).transpose() * b.subrows(0, n)
            })
            .collect()
    }

    /// Condensed compliance S⁻¹ as a dense symmetric matrix.
    pub fn compliance(&self) -> Mat<f64> {
        let n = self.n_condensed();
        let mut inverse = Mat::<f64>::identity(n, n);
        faer::linalg::triangular_solve::solve_lower_triangular_in_place(
            self.factor.as_ref(),
            inverse.as_mut(),
            Par::rayon(0),
        );
        inverse.transpose() * &inverse
    }

    /// Solves with the whole matrix: K u = f, in place.
    pub fn solve_full(&self, load: &mut [f64]) {
        let n = load.len();
        let factor = LltRef::<usize, f64>::new(&self.symbolic, &self.values);
        let mut memory = faer::dyn_stack::MemBuffer::new(
            self.symbolic.solve_in_place_scratch::<f64>(1, Par::Seq),
        );
        factor.solve_in_place_with_conj(
            Conj::No,
            MatMut::from_column_major_slice_mut(load, n, 1),
            Par::Seq,
            faer::dyn_stack::MemStack::new(&mut memory),
        );
    }

    /// Non-zeros of the factor.
    pub fn factor_nonzeros(&self) -> usize {
        self.values.len()
    }
}

fn elimination_order(
    graph: &NodeGraph,
    dofs: &DofMap,
    condensed: &[usize],
) -> Result<Vec<usize>, OrderingError> {
    let mut is_condensed = vec![false; dofs.n_dofs];
    for d in condensed {
        is_condensed[*d] = true;
    }
    let mut order = Vec::with_capacity(dofs.n_dofs);
    for node in nested_dissection(graph)? {
        for d in dofs.of_node(node) {
            if *d != CONSTRAINED && !is_condensed[*d as usize] {
                order.push(*d as usize);
            }
        }
    }
    order.extend_from_slice(condensed);
    Ok(order)
}

fn trailing_block(
    symbolic: &SymbolicCholesky<usize>,
    values: &[f64],
    n_trailing: usize,
) -> Mat<f64> {
    let SymbolicCholeskyRaw::Supernodal(symbolic) = symbolic.raw() else {
        unreachable!("supernodal factorisation was asked for")
    };
    let factor = supernodal::SupernodalLltRef::<usize, f64>::new(symbolic, values);
    let first = symbolic.nrows() - n_trailing;
    let mut block = Mat::<f64>::zeros(n_trailing, n_trailing);
    for s in 0..symbolic.n_supernodes() {
        let node = factor.supernode(s);
        let (start, columns) = (node.start(), node.val().ncols());
        if start + columns <= first {
            continue;
        }
        let value = node.val();
        for j in first.saturating_sub(start)..columns {
            for i in j..columns {
                block[(start + i - first, start + j - first)] = value[(i, j)];
            }
            for (k, row) in node.pattern().iter().enumerate() {
                block[(row - first, start + j - first)] = value[(columns + k, j)];
            }
        }
    }
    block
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assembly::assemble_symmetric;
    use crate::mesh::SimplexMesh;
    use crate::space::Space;
    use approx::assert_relative_eq;
    use faer::linalg::solvers::Solve;

    /// A strip of triangles with a symmetric positive definite element matrix, against dense
    /// linear algebra: condensed solve, condensed entries, compliance and full solve.
    #[test]
    fn condensed_block_equals_dense_schur_complement() {
        let n_cells = 12;
        let mesh = SimplexMesh {
            dim: 2,
            axes: [0, 1, 2],
            vertices: (0..n_cells + 2)
                .map(|i| [i as f64 * 0.5, (i % 2) as f64, 0.0])
                .collect(),
            cells: (0..n_cells as u32).map(|i| [i, i + 1, i + 2, 0]).collect(),
        };
        let space = Space::new(&mesh, 2);
        let graph = NodeGraph::new(&space);
        let dofs = DofMap::new(space.n_nodes(), 2, |n, c| n > 1 || c == 1);
        let matrix = assemble_symmetric(&space, &graph, &dofs, |cell, out| {
            for i in 0..12 {
                for j in 0..12 {
                    out[i * 12 + j] = 0.1 * ((i * j + cell) as f64).cos().abs().min(0.3)
                        + if i == j { 4.0 } else { 0.0 };
                }
            }
            for i in 0..12 {
                for j in 0..i {
                    out[i * 12 + j] = out[j * 12 + i];
                }
            }
        });
        let n = matrix.n;
        let condensed: Vec<usize> = (0..n).filter(|d| d % 3 == 0).collect();
        let stiffness = CondensedStiffness::new(&matrix, &graph, &dofs, &condensed).unwrap();

        let mut dense = Mat::<f64>::zeros(n, n);
        for j in 0..n {
            for k in matrix.col_ptr[j]..matrix.col_ptr[j + 1] {
                dense[(matrix.row_idx[k], j)] = matrix.values[k];
                dense[(j, matrix.row_idx[k])] = matrix.values[k];
            }
        }
        let inverse = dense.partial_piv_lu().solve(Mat::<f64>::identity(n, n));
        let m = condensed.len();
        // The compliance seen on c is the c-c block of K⁻¹.
        let compliance = Mat::from_fn(m, m, |i, j| inverse[(condensed[i], condensed[j])]);
        let schur = compliance
            .partial_piv_lu()
            .solve(Mat::<f64>::identity(m, m));
        let ours = stiffness.compliance();
        for i in 0..m {
            let mut e = vec![0.0; m];
            e[i] = 1.0;
            stiffness.solve_condensed(&mut e);
            for j in 0..m {
                assert_relative_eq!(e[j], compliance[(j, i)], epsilon = 1e-13);
                assert_relative_eq!(ours[(j, i)], compliance[(j, i)], epsilon = 1e-13);
                let entry = stiffness.condensed_entries(&[(i as u32, j as u32)])[0];
                assert_relative_eq!(entry, schur[(i, j)], epsilon = 1e-11);
            }
        }
        let mut rhs: Vec<f64> = (0..n).map(|i| (i as f64).sin()).collect();
        let exact: Vec<f64> = (0..n)
            .map(|i| (0..n).map(|j| inverse[(i, j)] * (j as f64).sin()).sum())
            .collect();
        stiffness.solve_full(&mut rhs);
        for (a, b) in rhs.iter().zip(&exact) {
            assert_relative_eq!(a, b, epsilon = 1e-12);
        }
    }

    /// A body that nothing holds is refused, not solved.
    #[test]
    fn singular_stiffness_is_refused() {
        let mesh = SimplexMesh {
            dim: 2,
            axes: [0, 1, 2],
            vertices: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
            cells: vec![[0, 1, 2, 0]],
        };
        let space = Space::new(&mesh, 1);
        let graph = NodeGraph::new(&space);
        let dofs = DofMap::new(3, 1, |_, _| true);
        let matrix = assemble_symmetric(&space, &graph, &dofs, |_, out| {
            out.copy_from_slice(&[1.0, -2.0, 0.0, -2.0, 1.0, 0.0, 0.0, 0.0, 1.0]);
        });
        assert!(matches!(
            CondensedStiffness::new(&matrix, &graph, &dofs, &[2]),
            Err(CholeskyError::NotPositiveDefinite { .. })
        ));
    }
}
