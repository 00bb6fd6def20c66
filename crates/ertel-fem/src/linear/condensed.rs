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

    /// Entry S_ij of the condensed stiffness.
    pub fn condensed_entry(&self, i: usize, j: usize) -> f64 {
        (0..=i.min(j))
            .map(|k| self.factor[(i, k)] * self.factor[(j, k)])
            .sum()
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
