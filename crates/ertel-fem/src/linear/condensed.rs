//! Sparse Cholesky factorisation that leaves the stiffness of a chosen part condensed.
//!
//! ```text
//!   K = | K_ii K_ic |    order: interior by nested dissection, then the chosen unknowns c;
//!       | K_ci K_cc |    what the interior leaves is K_cc − K_ci K_ii⁻¹ K_ic = S
//! ```
//! S is the exact discrete stiffness that a load on c feels. The factorisation is multifrontal and
//! assembles the elements where they are first needed: the factor itself need not be kept, and the
//! matrix is never formed.

use std::sync::{Mutex, MutexGuard, PoisonError};

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt;
use faer::linalg::cholesky::llt::factor::LltRegularization;
use faer::linalg::matmul::triangular::{self, BlockStructure};
use faer::linalg::triangular_solve::{
    solve_lower_triangular_in_place, solve_upper_triangular_in_place,
};
use faer::prelude::{Reborrow, ReborrowMut};
use faer::{Accum, ColMut, MatMut, MatRef, Par};
use rayon::prelude::*;

use crate::assembly::{CONSTRAINED, DofMap, NodeGraph};
use crate::linear::Stop;
use crate::linear::compliance::Compliance;
use crate::linear::fronts::{Blocks, Front, Fronts};
use crate::linear::ordering::OrderingError;
use crate::space::Space;

/// The factorisation failed.
#[derive(Clone, Debug, thiserror::Error)]
pub enum CholeskyError {
    /// The ordering failed.
    #[error(transparent)]
    Ordering(#[from] OrderingError),
    /// A pivot was not positive: the body is not held, or an element is inverted.
    #[error("stiffness of {n} unknowns is not positive definite: {reason}")]
    NotPositiveDefinite {
        /// Unknowns.
        n: usize,
        /// What the library said.
        reason: String,
    },
    /// Told to stop.
    #[error("interrupted")]
    Interrupted,
}

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

/// What a factorisation keeps.
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
            // What stays with the caller has memory of its own.
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
                for (b, j) in places.iter().enumerate() {
                    for (a, i) in places.iter().enumerate() {
                        if *j != NOWHERE && *i != NOWHERE && i >= j {
                            entries[*j * order + *i] += block[a * size + b];
                        }
                    }
                }
            }
            add_children(&fronts, front, &left, entries);
            drop(left);
            let n = front.n_own;
            if last {
                return Ok(room);
            }
            let operations = n as f64 * (order as f64).powi(2);
            let par = if operations > LARGE {
                Par::rayon(0)
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
        let mut memory = MemBuffer::new(llt::inverse::inverse_scratch::<f64>(n, Par::rayon(0)));
        llt::inverse::inverse(
            inverse.rb_mut(),
            MatRef::from_column_major_slice(&factor, n, n),
            Par::rayon(0),
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

    /// Numbers of the factor, without the condensed part.
    pub fn factor_nonzeros(&self) -> usize {
        let own = |f: &Front| f.n_own * (f.n_own + 1) / 2 + f.n_own * f.boundary.len();
        let n_inner = self.fronts.order.len() - self.n_condensed();
        let inner = self.fronts.fronts.iter().filter(|f| f.first < n_inner);
        inner.map(own).sum()
    }
}

/// What a front leaves to its parent: the lower triangle over its boundary, column by column. The last front
/// leaves its whole square.
type Left = Vec<f64>;

/// Order of a front from which its columns are dealt to the cores.
const WIDE: usize = 600;

/// Calls `f` on each column of a square matrix.
fn on_columns(entries: &mut [f64], order: usize, f: impl Fn(usize, &mut [f64]) + Sync) {
    let f = |(j, column): (usize, &mut [f64])| f(j, column);
    if order < WIDE {
        entries
            .chunks_exact_mut(order.max(1))
            .enumerate()
            .for_each(f);
    } else {
        entries.par_chunks_exact_mut(order).enumerate().for_each(f);
    }
}

/// Lower triangle of the columns from the n-th on, packed.
fn lower_triangle(columns: &[f64], order: usize, n: usize) -> Vec<f64> {
    let m = order - n;
    let length = m * (m + 1) / 2;
    let columns = columns.chunks_exact(order.max(1)).zip(n..);
    if m < WIDE {
        let mut packed = Vec::with_capacity(length);
        for (column, j) in columns {
            packed.extend_from_slice(&column[j..]);
        }
        return packed;
    }
    let mut packed = vec![0.0; length];
    let mut rest = &mut packed[..];
    let mut targets = Vec::with_capacity(m);
    for (column, j) in columns {
        let (target, beyond) = rest.split_at_mut(order - j);
        targets.push((target, &column[j..]));
        rest = beyond;
    }
    targets
        .into_par_iter()
        .for_each(|(target, column)| target.copy_from_slice(column));
    packed
}

/// Adds what the children of a front left to its lower triangle.
fn add_children(fronts: &Fronts, front: &Front, left: &[Left], entries: &mut [f64]) {
    let order = front.size();
    let start = |j: usize, m: usize| j * m - j * j.saturating_sub(1) / 2;
    let children = || {
        let maps = front
            .children
            .iter()
            .map(|child| &fronts.fronts[*child].in_parent[..]);
        maps.zip(left)
    };
    let add = |target: &mut [f64], map: &[u32], left: &[f64], j: usize| {
        for (row, v) in map[j..].iter().zip(&left[start(j, map.len())..]) {
            target[*row as usize] += v;
        }
    };
    if order < WIDE {
        for (map, left) in children() {
            for (j, column) in map.iter().enumerate() {
                add(
                    &mut entries[*column as usize * order..][..order],
                    map,
                    left,
                    j,
                );
            }
        }
        return;
    }
    // For each column of the front, that of each child.
    let of_children: Vec<Vec<usize>> = children()
        .map(|(map, _)| {
            let mut columns = vec![NOWHERE; order];
            for (j, column) in map.iter().enumerate() {
                columns[*column as usize] = j;
            }
            columns
        })
        .collect();
    on_columns(entries, order, |k, target| {
        for ((map, left), columns) in children().zip(&of_children) {
            if columns[k] != NOWHERE {
                add(target, map, left, columns[k]);
            }
        }
    });
}

/// Rooms in which fronts are eliminated, used again and again: asking the system for memory would take a good part
/// of the time. Each has room for any front; the system gives what is used of it.
struct Workspace {
    size: usize,
    rooms: Mutex<Vec<Vec<f64>>>,
}

impl Workspace {
    /// Rooms for so many numbers each.
    fn new(size: usize) -> Workspace {
        Workspace {
            size,
            rooms: Mutex::default(),
        }
    }

    fn rooms(&self) -> MutexGuard<'_, Vec<Vec<f64>>> {
        self.rooms.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// A room, of whatever content.
    fn take(&self) -> Vec<f64> {
        let used = self.rooms().pop();
        used.unwrap_or_else(|| vec![0.0; self.size])
    }

    fn give(&self, room: Vec<f64>) {
        self.rooms().push(room);
    }
}

/// Lower factor of a dense matrix, in its place.
fn factor(mut entries: Vec<f64>, n: usize) -> Result<Vec<f64>, CholeskyError> {
    let matrix = MatMut::from_column_major_slice_mut(&mut entries, n, n);
    cholesky(matrix, Par::rayon(0))
        .map_err(|reason| CholeskyError::NotPositiveDefinite { n, reason })?;
    Ok(entries)
}

/// Whether a front holds the condensed unknowns.
fn is_last(fronts: &Fronts, condensed: &[usize], k: usize) -> bool {
    !condensed.is_empty() && k + 1 == fronts.fronts.len()
}

/// Fronts of the body: its nodes by nested dissection, then the condensed unknowns.
fn elimination(
    space: &Space,
    graph: &NodeGraph,
    dofs: &DofMap,
    condensed: &[usize],
) -> Result<Fronts, OrderingError> {
    let n = graph.n_nodes();
    let mut last = vec![NOWHERE; dofs.n_dofs];
    for (k, d) in condensed.iter().enumerate() {
        last[*d] = n + k;
    }
    let mut unknowns = vec![Vec::new(); n + condensed.len()];
    let mut groups = vec![NOWHERE; n]; // the condensed unknown of a node
    for node in 0..n {
        for d in dofs.of_node(node).iter().filter(|d| **d != CONSTRAINED) {
            match last[*d as usize] {
                NOWHERE => unknowns[node].push(*d),
                group => {
                    groups[node] = group;
                    unknowns[group].push(*d);
                }
            }
        }
    }
    let mut extended = NodeGraph {
        offsets: vec![0],
        neighbours: Vec::with_capacity(graph.neighbours.len() + condensed.len() * 20),
    };
    for node in 0..n {
        let near = graph.of(node);
        extended.neighbours.extend_from_slice(near);
        let beyond = near.iter().map(|o| groups[*o as usize]);
        let beyond = beyond.filter(|g| *g != NOWHERE).map(|g| g as u32);
        extended.neighbours.extend(beyond);
        extended.offsets.push(extended.neighbours.len());
    }
    // The condensed unknowns are one front whatever their neighbours are.
    for _ in condensed {
        extended.offsets.push(extended.neighbours.len());
    }
    Fronts::new(&Blocks {
        graph: &extended,
        unknowns,
        n_inner: n,
        carriers: Some(space.carriers()),
    })
}

const NOWHERE: usize = usize::MAX;

/// Each element goes to the front that eliminates the first of its unknowns.
fn elements_of_fronts(space: &Space, dofs: &DofMap, fronts: &Fronts) -> Vec<Vec<u32>> {
    let owners = fronts.owners();
    let mut elements = vec![Vec::new(); fronts.fronts.len()];
    for cell in 0..space.n_elements() {
        let unknowns = space.nodes_of(cell).iter();
        let unknowns = unknowns.flat_map(|n| dofs.of_node(*n as usize));
        let first = unknowns
            .filter(|d| **d != CONSTRAINED)
            .map(|d| fronts.position[*d as usize])
            .min();
        if let Some(first) = first {
            elements[owners[first as usize] as usize].push(cell as u32);
        }
    }
    elements
}

/// Index in a front of each row of an element matrix.
fn places(space: &Space, dofs: &DofMap, fronts: &Fronts, front: &Front, cell: usize) -> Vec<usize> {
    let unknowns = space.nodes_of(cell).iter();
    unknowns
        .flat_map(|n| dofs.of_node(*n as usize))
        .map(|d| match *d {
            CONSTRAINED => NOWHERE,
            d => front.index_of(fronts.position[d as usize] as usize),
        })
        .collect()
}

/// Eliminates the first `n` unknowns of a front, lower triangle, in place.
fn eliminate(mut matrix: MatMut<f64>, n: usize, par: Par) -> Result<(), String> {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assembly::assemble_symmetric;
    use crate::linear::NEVER;
    use crate::mesh::SimplexMesh;
    use crate::space::Space;
    use approx::assert_relative_eq;
    use faer::Mat;
    use faer::linalg::solvers::Solve;

    /// A strip of triangles with a symmetric positive definite element matrix, against dense
    /// linear algebra: condensed entries, compliance and full solve.
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
        let element = |cell: usize, out: &mut [f64]| {
            for i in 0..12 {
                for j in 0..12 {
                    out[i * 12 + j] = 0.1 * ((i * j + cell) as f64).cos().abs().min(0.3)
                        + if i == j { 4.0 } else { 0.0 };
                }
            }
        };
        let matrix = assemble_symmetric(&space, &graph, &dofs, element);
        let n = matrix.n;
        let condensed: Vec<usize> = (0..n).filter(|d| d % 3 == 0).collect();
        let factorise =
            |keep| CondensedStiffness::new(&space, &graph, &dofs, &condensed, keep, element, NEVER);
        let stiffness = factorise(Keep::Factor).unwrap();

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
        let ours = factorise(Keep::Factor).unwrap().into_compliance().unwrap();
        let condensed_only = factorise(Keep::Condensed).unwrap();
        assert_eq!(ours, condensed_only.into_compliance().unwrap());
        for i in 0..m {
            for j in 0..m {
                assert_relative_eq!(ours.get(j, i), compliance[(j, i)], epsilon = 1e-13);
                let entry = stiffness.condensed_entry(i, j);
                assert_relative_eq!(entry, schur[(i, j)], epsilon = 1e-11);
            }
        }
        let mut rhs: Vec<f64> = (0..n).map(|i| (i as f64).sin()).collect();
        let exact: Vec<f64> = (0..n)
            .map(|i| (0..n).map(|j| inverse[(i, j)] * (j as f64).sin()).sum())
            .collect();
        stiffness.solve_full(&mut rhs).unwrap();
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
        let element = |_: usize, out: &mut [f64]| {
            out.copy_from_slice(&[1.0, -2.0, 0.0, -2.0, 1.0, 0.0, 0.0, 0.0, 1.0]);
        };
        assert!(matches!(
            CondensedStiffness::new(&space, &graph, &dofs, &[2], Keep::Condensed, element, NEVER),
            Err(CholeskyError::NotPositiveDefinite { .. })
        ));
    }
}
