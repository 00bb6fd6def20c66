//! Sparse Cholesky factorisation that leaves the stiffness of a chosen part condensed.
//!
//! ```text
//!   K = | K_ii K_ic |    order: interior by nested dissection, then the chosen unknowns c;
//!       | K_ci K_cc |    the Schur complement is K_cc − K_ci K_ii⁻¹ K_ic = S
//! ```
//! S is the exact discrete stiffness under a load on c. The factorisation is multifrontal and
//! assembles the elements where they are first needed: the factor itself need not be kept, and the
//! matrix is never formed.

mod cholesky;
mod plan;
#[cfg(test)]
mod tests;
mod triangle;
mod workspace;

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt;
use faer::linalg::triangular_solve::{
    solve_lower_triangular_in_place, solve_upper_triangular_in_place,
};
use faer::prelude::ReborrowMut;
use faer::{ColMut, MatMut, MatRef, Par};

pub use cholesky::CholeskyError;

use crate::assembly::{DofMap, NodeGraph};
use crate::linear::Stop;
use crate::linear::compliance::Compliance;
use crate::linear::fronts::{Front, Fronts};
use crate::platform::all_cores;
use crate::space::Space;
use cholesky::{eliminate, factor};
use plan::{add_element, elements_of_fronts, elimination, is_last, places};
use triangle::{Left, add_children, lower_triangle, on_columns};
use workspace::Workspace;

/// Factorised stiffness with its condensed part.
pub struct CondensedStiffness {
    fronts: Fronts,
    /// Columns of the factor, front by front; empty when they were not kept.
    columns: Vec<f64>,
    starts: Vec<usize>,
    /// Condensed stiffness S, column by column, of which the lower triangle counts.
    stiffness: Vec<f64>,
    n_condensed: usize,
    /// Memory for the inverse.
    room: Vec<f64>,
}

/// Operations in one front above which all cores work on it together.
const LARGE: f64 = 5e7;

/// Parts of a factorisation that are kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Keep {
    /// Only the condensed stiffness.
    Condensed,
    /// The whole factor, for [`CondensedStiffness::solve_full`].
    Factor,
}

impl CondensedStiffness {
    /// Factorises the sum of the element matrices; the unknowns `condensed` come last.
    ///
    /// `element_matrix(cell, out)` fills a row-major square matrix whose index is
    /// `local_node * n_components + component`; it is symmetric.
    ///
    /// `stop` is asked before each front.
    ///
    /// # Errors
    /// When the ordering fails, the matrix is not positive definite, or `stop` says so.
    pub fn new(
        space: &Space,
        graph: &NodeGraph,
        dofs: &DofMap,
        condensed: &[usize],
        keep: Keep,
        element_matrix: impl Fn(usize, &mut [f64]) + Sync,
        stop: Stop,
    ) -> Result<CondensedStiffness, CholeskyError> {
        let fronts = elimination(space, graph, dofs, condensed)?;
        let elements = elements_of_fronts(space, dofs, &fronts);
        let mut starts = vec![0];
        for (k, f) in fronts.fronts.iter().enumerate() {
            let kept = keep == Keep::Factor && !(is_last(&fronts, condensed, k));
            let length = if kept { f.n_own * f.size() } else { 0 };
            starts.push(starts[k] + length);
        }
        let mut columns = vec![0.0; starts[fronts.fronts.len()]];
        let size = space.element.n_nodes() * dofs.n_components;
        let largest = fronts.fronts.iter().map(Front::size).max();
        let work = Workspace::new(largest.unwrap_or(0).pow(2));
        let front = |k: usize, kept: &mut [f64], left: Vec<Left>| -> Result<Left, CholeskyError> {
            if stop() {
                return Err(CholeskyError::Interrupted);
            }
            let front = &fronts.fronts[k];
            let order = front.size();
            let last = is_last(&fronts, condensed, k);
            // The last front is returned to the caller, in separate memory.
            let mut room = match last {
                true => vec![0.0; order * order],
                false => work.take(),
            };
            let entries = &mut room[..order * order];
            if !last {
                // only the lower triangle is read
                on_columns(entries, order, |j, column| column[j..].fill(0.0));
            }
            let mut block = vec![0.0; size * size];
            for cell in &elements[k] {
                element_matrix(*cell as usize, &mut block);
                let places = places(space, dofs, &fronts, front, *cell as usize);
                add_element(&block, &places, entries, order);
            }
            add_children(&fronts, front, &left, entries);
            drop(left);
            let n = front.n_own;
            if last {
                return Ok(room);
            }
            let operations = n as f64 * (order as f64).powi(2);
            let par = if operations > LARGE {
                all_cores()
            } else {
                Par::Seq
            };
            let matrix = MatMut::from_column_major_slice_mut(entries, order, order);
            eliminate(matrix, n, par).map_err(|reason| CholeskyError::NotPositiveDefinite {
                n: dofs.n_dofs,
                reason,
            })?;
            if !kept.is_empty() {
                for (j, column) in kept.chunks_exact_mut(order).enumerate() {
                    column[j..].copy_from_slice(&entries[j * order + j..(j + 1) * order]);
                }
            }
            let left = lower_triangle(&entries[n * order..], order, n);
            work.give(room);
            Ok(left)
        };
        let left = fronts.eliminate(&starts, &mut columns, &front)?;
        let stiffness = match left.into_iter().next() {
            Some(left) if !condensed.is_empty() => left,
            _ => Vec::new(),
        };
        Ok(CondensedStiffness {
            fronts,
            columns,
            starts,
            stiffness,
            n_condensed: condensed.len(),
            room: match keep {
                Keep::Condensed => work.take(),
                Keep::Factor => Vec::new(),
            },
        })
    }

    /// Number of condensed unknowns.
    pub fn n_condensed(&self) -> usize {
        self.n_condensed
    }

    /// Entry S_ij of the condensed stiffness.
    pub fn condensed_entry(&self, i: usize, j: usize) -> f64 {
        self.stiffness[i.min(j) * self.n_condensed + i.max(j)]
    }

    /// Condensed compliance S⁻¹.
    ///
    /// # Errors
    /// When the condensed stiffness is not positive definite.
    pub fn into_compliance(self) -> Result<Compliance, CholeskyError> {
        let n = self.n_condensed();
        let factor = factor(self.stiffness, n)?;
        let mut room = self.room;
        if room.len() < n * n {
            room = vec![0.0; n * n];
        }
        let entries = &mut room[..n * n];
        let mut inverse = MatMut::from_column_major_slice_mut(entries, n, n);
        let mut memory = MemBuffer::new(llt::inverse::inverse_scratch::<f64>(n, all_cores()));
        llt::inverse::inverse(
            inverse.rb_mut(),
            MatRef::from_column_major_slice(&factor, n, n),
            all_cores(),
            MemStack::new(&mut memory),
        );
        drop(factor);
        Ok(Compliance::from_lower(n, |j| {
            &entries[j * n + j..(j + 1) * n]
        }))
    }

    /// Solves with the whole matrix: K u = f, in place.
    ///
    /// # Errors
    /// When the condensed stiffness is not positive definite.
    ///
    /// # Panics
    /// When the factor was not kept.
    pub fn solve_full(&self, load: &mut [f64]) -> Result<(), CholeskyError> {
        let fronts = &self.fronts;
        let mut x: Vec<f64> = fronts.order.iter().map(|u| load[*u as usize]).collect();
        let kept = |k: usize| {
            let f = &fronts.fronts[k];
            let columns = &self.columns[self.starts[k]..self.starts[k + 1]];
            MatRef::from_column_major_slice(columns, f.size(), f.n_own).split_at_row(f.n_own)
        };
        let n_inner = x.len() - self.n_condensed();
        let (x, last) = x.split_at_mut(n_inner);
        let inner = || {
            fronts
                .fronts
                .iter()
                .enumerate()
                .filter(|(_, f)| f.first < n_inner)
        };
        for (k, f) in inner() {
            let (a, c) = kept(k);
            let own = ColMut::from_slice_mut(&mut x[f.first..f.first + f.n_own]);
            solve_lower_triangular_in_place(a, own.as_mat_mut(), Par::Seq);
            for (i, s) in f.boundary.iter().enumerate() {
                let s = *s as usize;
                let sum: f64 = (0..f.n_own).map(|j| c[(i, j)] * x[f.first + j]).sum();
                if s < n_inner {
                    x[s] -= sum;
                } else {
                    last[s - n_inner] -= sum;
                }
            }
        }
        let n = self.n_condensed();
        let factor = factor(self.stiffness.clone(), n)?;
        let factor = MatRef::from_column_major_slice(&factor, n, n);
        let mut end = ColMut::from_slice_mut(last).as_mat_mut();
        solve_lower_triangular_in_place(factor, end.rb_mut(), Par::Seq);
        solve_upper_triangular_in_place(factor.transpose(), end, Par::Seq);
        let inner: Vec<_> = inner().collect();
        for (k, f) in inner.into_iter().rev() {
            let (a, c) = kept(k);
            for j in 0..f.n_own {
                let known = |s: &u32| match *s as usize {
                    s if s < n_inner => x[s],
                    s => last[s - n_inner],
                };
                let sum: f64 = (f.boundary.iter().enumerate())
                    .map(|(i, s)| c[(i, j)] * known(s))
                    .sum();
                x[f.first + j] -= sum;
            }
            let own = ColMut::from_slice_mut(&mut x[f.first..f.first + f.n_own]);
            solve_upper_triangular_in_place(a.transpose(), own.as_mat_mut(), Par::Seq);
        }
        for (value, unknown) in x.iter().chain(&*last).zip(&fronts.order) {
            load[*unknown as usize] = *value;
        }
        Ok(())
    }
}
