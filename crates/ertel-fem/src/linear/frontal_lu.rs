//! Multifrontal LU of an unsymmetric matrix with symmetric pattern, for preconditioning.
//!
//! ```text
//!   front  | A  B |    W = A⁻¹B, V = C A⁻¹; D − V B goes to the parent.
//!          | C  D |    A⁻¹, V and W are kept: a solve is three products per front.
//! ```
//! Rows are interchanged inside A only: the order is fixed by the pattern, once for all matrices
//! that share it. Single precision is what a preconditioner needs; its solves are bound by the memory that they
//! read, and what they read is rounded to sixteen bits, by rows and columns of about the same size.

use std::ops::RangeInclusive;
use std::sync::Arc;

use faer::linalg::matmul::matmul;
use faer::prelude::{Reborrow, ReborrowMut};
use faer::{Accum, Mat, MatMut, Par};
use rayon::prelude::*;

use crate::kernel;
use crate::linear::dense::{multiply_transposed_whole, multiply_whole, vectorised};
use crate::linear::fronts::{Blocks, Front, Fronts};
use crate::linear::ordering::OrderingError;

/// The matrix could not be factorised in the order of its pattern.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("frontal LU broke down: a block of {size} unknowns is singular")]
pub struct FrontalError {
    /// Unknowns of the block.
    pub size: usize,
}

/// Pattern of a matrix given as a list of entries, with its elimination order.
#[derive(Clone, Debug)]
pub struct FrontalPattern {
    fronts: Fronts,
    /// For each front, entry of the list and index in the front's matrix (column-major).
    scatter: Vec<Vec<(u32, u32)>>,
    /// Start of each front's A⁻¹, V, W in the storage; one more at the end.
    starts: Vec<usize>,
    /// Roots of the subtrees that a solve deals to the cores.
    parts: Vec<usize>,
    /// Ranges of the fronts above these.
    above: Vec<RangeInclusive<usize>>,
}

impl FrontalPattern {
    /// Orders the unknowns of `blocks` and finds the place of each entry (row, column).
    ///
    /// # Errors
    /// When METIS fails.
    ///
    /// # Panics
    /// When the groups of an entry are no neighbours in the graph of `blocks`.
    pub fn new(blocks: &Blocks, entries: &[(u32, u32)]) -> Result<FrontalPattern, OrderingError> {
        let fronts = Fronts::new(blocks)?;
        let owners = fronts.owners();
        let mut scatter = vec![Vec::new(); fronts.fronts.len()];
        for (k, (row, column)) in entries.iter().enumerate() {
            let row = fronts.position[*row as usize] as usize;
            let column = fronts.position[*column as usize] as usize;
            let owner = owners[row.min(column)] as usize;
            let front = &fronts.fronts[owner];
            let index = front.index_of(row) + front.size() * front.index_of(column);
            scatter[owner].push((k as u32, index as u32));
        }
        let mut starts = vec![0];
        for f in &fronts.fronts {
            let (n, m) = (f.n_own, f.boundary.len());
            starts.push(starts[starts.len() - 1] + n * (n + 2 * m));
        }
        let (parts, above) = parts(&fronts, &starts);
        Ok(FrontalPattern {
            fronts,
            scatter,
            starts,
            parts,
            above,
        })
    }

    /// Number of unknowns.
    pub fn n(&self) -> usize {
        self.fronts.order.len()
    }

    /// Numbers that a factorisation keeps.
    pub fn n_stored(&self) -> usize {
        self.starts[self.starts.len() - 1]
    }

    /// Factorises the front `k`, given what its children leave.
    fn factorise(
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

/// Matrix of a front after its elimination: what goes to the parent begins at (n_own, n_own).
struct Left {
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

/// A factorised matrix.
#[derive(Clone, Debug)]
pub struct FrontalLu {
    pattern: Arc<FrontalPattern>,
    factors: Arc<Factors>,
    x: Vec<f32>,
    /// Scratch of each part, and of the fronts above them.
    scratch: Vec<Scratch>,
}

/// A⁻¹, V and W of each front: the entry (i, j) of each is `whole` times the scales of its row and column.
#[derive(Debug, PartialEq)]
struct Factors {
    whole: Vec<i16>,
    /// Rows, then columns, of A⁻¹, V and W of each front.
    scales: Vec<f32>,
    /// Start of each front's scales.
    starts: Vec<usize>,
}

impl Factors {
    fn new(pattern: &FrontalPattern, numbers: &[f32]) -> Factors {
        let mut starts = vec![0];
        for f in &pattern.fronts.fronts {
            let (n, m) = (f.n_own, f.boundary.len());
            starts.push(starts[starts.len() - 1] + 4 * n + 2 * m);
        }
        let mut whole = vec![0; numbers.len()];
        let mut scales = vec![0.0; starts[starts.len() - 1]];
        let mut tasks = Vec::with_capacity(pattern.fronts.fronts.len());
        let (mut whole_rest, mut scales_rest) = (&mut whole[..], &mut scales[..]);
        for (k, front) in pattern.fronts.fronts.iter().enumerate() {
            let range = pattern.starts[k]..pattern.starts[k + 1];
            let (own, beyond) = whole_rest.split_at_mut(range.len());
            let (sizes, sizes_beyond) = scales_rest.split_at_mut(starts[k + 1] - starts[k]);
            tasks.push((front, &numbers[range], own, sizes));
            (whole_rest, scales_rest) = (beyond, sizes_beyond);
        }
        tasks
            .into_par_iter()
            .with_min_len(8)
            .for_each(|(front, numbers, whole, scales)| {
                let (n, m) = (front.n_own, front.boundary.len());
                let (mut whole, mut scales) = (whole, scales);
                for (part, rows) in split(numbers, n, m).into_iter().zip([n, m, n]) {
                    let columns = part.len().checked_div(rows).unwrap_or(0);
                    let (own, beyond) = whole.split_at_mut(part.len());
                    let (by_row, rest) = scales.split_at_mut(rows);
                    let (by_column, rest) = rest.split_at_mut(columns);
                    vectorised(Round {
                        numbers: part,
                        by_row,
                        by_column,
                        whole: own,
                    });
                    (whole, scales) = (beyond, rest);
                }
            });
        Factors {
            whole,
            scales,
            starts,
        }
    }

    /// A⁻¹, V and W of a front.
    #[inline(always)]
    fn of(&self, pattern: &FrontalPattern, front: usize) -> [Scaled<'_>; 3] {
        let f = &pattern.fronts.fronts[front];
        let (n, m) = (f.n_own, f.boundary.len());
        let [inverse, v, w] = split(&self.whole[pattern.starts[front]..], n, m);
        let scales = &self.scales[self.starts[front]..self.starts[front + 1]];
        let (of_inverse, scales) = scales.split_at(2 * n);
        let (of_v, of_w) = scales.split_at(n + m);
        [
            Scaled::new(inverse, of_inverse, n),
            Scaled::new(v, of_v, m),
            Scaled::new(w, of_w, n),
        ]
    }
}

/// A matrix of whole numbers with the scales of its rows and columns.
struct Scaled<'a> {
    whole: &'a [i16],
    by_row: &'a [f32],
    by_column: &'a [f32],
}

impl<'a> Scaled<'a> {
    #[inline(always)]
    fn new(whole: &'a [i16], scales: &'a [f32], rows: usize) -> Scaled<'a> {
        let (by_row, by_column) = scales.split_at(rows);
        Scaled {
            whole,
            by_row,
            by_column,
        }
    }

    /// y = A x.
    #[inline(always)]
    fn multiply(&self, x: &[f32], y: &mut [f32], scaled: &mut [f32]) {
        let scaled = times(x, self.by_column, scaled);
        multiply_whole(self.whole, scaled, y);
        for (y, r) in y.iter_mut().zip(self.by_row) {
            *y *= r;
        }
    }

    /// y = Aᵀ x.
    #[inline(always)]
    fn multiply_transposed(&self, x: &[f32], y: &mut [f32], scaled: &mut [f32]) {
        let scaled = times(x, self.by_row, scaled);
        multiply_transposed_whole::<16>(self.whole, scaled, y);
        for (y, c) in y.iter_mut().zip(self.by_column) {
            *y *= c;
        }
    }
}

#[inline(always)]
fn times<'a>(x: &[f32], scales: &[f32], scaled: &'a mut [f32]) -> &'a [f32] {
    let scaled = &mut scaled[..x.len()];
    for ((s, x), c) in scaled.iter_mut().zip(x).zip(scales) {
        *s = x * c;
    }
    scaled
}

kernel! {
    Round ['a] ['a]
    (numbers: &'a [f32], by_row: &'a mut [f32], by_column: &'a mut [f32], whole: &'a mut [i16]) -> () {
        round(numbers, by_row, by_column, whole)
    }
}

/// Largest whole number in use.
const LARGEST: f32 = 32_000.0;

/// a_ij ≈ whole_ij r_i c_j: r_i the largest of the row, c_j what then is the largest of the column, over [`LARGEST`].
#[inline(always)]
fn round(numbers: &[f32], by_row: &mut [f32], by_column: &mut [f32], whole: &mut [i16]) {
    let rows = by_row.len();
    if rows == 0 {
        return;
    }
    by_row.fill(f32::MIN_POSITIVE);
    for column in numbers.chunks_exact(rows) {
        for (r, v) in by_row.iter_mut().zip(column) {
            *r = r.max(v.abs());
        }
    }
    let inverse: Vec<f32> = by_row.iter().map(|r| 1.0 / r).collect();
    let columns = numbers.chunks_exact(rows).zip(whole.chunks_exact_mut(rows));
    for ((column, whole), c) in columns.zip(by_column) {
        let mut largest = f32::MIN_POSITIVE;
        for (v, r) in column.iter().zip(&inverse) {
            largest = largest.max((v * r).abs());
        }
        let scale = LARGEST / largest;
        for ((w, v), r) in whole.iter_mut().zip(column).zip(&inverse) {
            *w = (v * r * scale).round_ties_even() as i16;
        }
        *c = largest / LARGEST;
    }
}

/// What a sweep through a range of fronts needs.
#[derive(Clone, Debug, Default)]
struct Scratch {
    outer: Vec<f32>,
    own: Vec<f32>,
    scaled: Vec<f32>,
    /// Values beyond the range.
    beyond: Vec<f32>,
}

/// Which way a solve goes: with the matrix or its transpose.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Side {
    Matrix,
    Transposed,
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
            scaled: largest(Front::size),
            beyond: vec![0.0; n_beyond],
        };
        let below = pattern.parts.iter().map(|root| {
            let f = &fronts[*root];
            scratch(pattern.n() - f.first - f.n_own)
        });
        Ok(FrontalLu {
            pattern: Arc::clone(pattern),
            factors: Arc::new(Factors::new(pattern, &storage)),
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

    /// Down the fronts and up again; the parts on all cores.
    fn sweep(&mut self, rhs: &mut [f64], side: Side) {
        let FrontalLu {
            pattern,
            factors,
            x,
            scratch,
        } = self;
        let (pattern, factors) = (&**pattern, &**factors);
        let fronts = &pattern.fronts;
        let all = &fronts.fronts;
        for (x, unknown) in x.iter_mut().zip(&fronts.order) {
            *x = rhs[*unknown as usize] as f32;
        }
        let (parts, above) = scratch.split_at_mut(pattern.parts.len());
        let above = &mut above[0];
        let roots = || pattern.parts.iter().map(|k| (*k, &all[*k]));
        let end = |f: &Front| f.first + f.n_own;
        for (scratch, (_, root)) in parts.iter_mut().zip(roots()) {
            for s in &root.boundary {
                scratch.beyond[*s as usize - end(root)] = 0.0;
            }
        }
        pattern.on_parts(x, parts, |root, x, scratch| {
            let first = all[root].subtree;
            let base = all[first].first;
            vectorised(Down {
                pattern,
                fronts: first..=root,
                base,
                factors,
                x,
                scratch,
                side,
            });
        });
        for (scratch, (_, root)) in parts.iter().zip(roots()) {
            for s in &root.boundary {
                x[*s as usize] += scratch.beyond[*s as usize - end(root)];
            }
        }
        for range in &pattern.above {
            vectorised(Down {
                pattern,
                fronts: range.clone(),
                base: 0,
                factors,
                x: &mut *x,
                scratch: &mut *above,
                side,
            });
        }
        for range in pattern.above.iter().rev() {
            vectorised(Up {
                pattern,
                fronts: range.clone(),
                base: 0,
                factors,
                x: &mut *x,
                scratch: &mut *above,
                side,
            });
        }
        for (scratch, (_, root)) in parts.iter_mut().zip(roots()) {
            for s in &root.boundary {
                scratch.beyond[*s as usize - end(root)] = x[*s as usize];
            }
        }
        pattern.on_parts(x, parts, |root, x, scratch| {
            let first = all[root].subtree;
            let base = all[first].first;
            vectorised(Up {
                pattern,
                fronts: first..=root,
                base,
                factors,
                x,
                scratch,
                side,
            });
        });
        for (x, unknown) in x.iter().zip(&fronts.order) {
            rhs[*unknown as usize] = *x as f64;
        }
    }
}

kernel! {
    Down ['a] ['a] (
        pattern: &'a FrontalPattern,
        fronts: RangeInclusive<usize>,
        base: usize,
        factors: &'a Factors,
        x: &'a mut [f32],
        scratch: &'a mut Scratch,
        side: Side,
    ) -> () {
        pattern.down(fronts, base, factors, x, scratch, side)
    }
}

kernel! {
    Up ['a] ['a] (
        pattern: &'a FrontalPattern,
        fronts: RangeInclusive<usize>,
        base: usize,
        factors: &'a Factors,
        x: &'a mut [f32],
        scratch: &'a mut Scratch,
        side: Side,
    ) -> () {
        pattern.up(fronts, base, factors, x, scratch, side)
    }
}

impl FrontalPattern {
    /// Calls `f(root, its positions of x, scratch)` for each part, on several threads.
    fn on_parts(
        &self,
        x: &mut [f32],
        scratch: &mut [Scratch],
        f: impl Fn(usize, &mut [f32], &mut Scratch) + Sync,
    ) {
        let mut rest = x;
        let mut from = 0;
        let mut tasks = Vec::with_capacity(scratch.len());
        for (root, scratch) in self.parts.iter().zip(scratch) {
            let front = &self.fronts.fronts[*root];
            let first = self.fronts.fronts[front.subtree].first;
            let end = front.first + front.n_own;
            let (own, beyond) = std::mem::take(&mut rest)[first - from..].split_at_mut(end - first);
            tasks.push((*root, own, scratch));
            rest = beyond;
            from = end;
        }
        tasks
            .into_par_iter()
            .with_max_len(1)
            .for_each(|(root, own, scratch)| f(root, own, scratch));
    }

    /// Eliminates: x_own ← A⁻¹ x_own, x_boundary −= V x_own. The positions of `x` begin at `base`.
    #[inline(always)]
    fn down(
        &self,
        fronts: RangeInclusive<usize>,
        base: usize,
        factors: &Factors,
        x: &mut [f32],
        scratch: &mut Scratch,
        side: Side,
    ) {
        let end = base + x.len();
        for k in fronts {
            let f = &self.fronts.fronts[k];
            let (n, m) = (f.n_own, f.boundary.len());
            let [inverse, v, w] = factors.of(self, k);
            let own = &mut scratch.own[..n];
            let outer = &mut scratch.outer[..m];
            let target = &mut x[f.first - base..f.first - base + n];
            own.copy_from_slice(target);
            let scaled = &mut scratch.scaled[..];
            match side {
                Side::Matrix => {
                    v.multiply(own, outer, scaled);
                    inverse.multiply(own, target, scaled);
                }
                Side::Transposed => {
                    w.multiply_transposed(own, outer, scaled);
                    inverse.multiply_transposed(own, target, scaled);
                }
            }
            for (s, value) in f.boundary.iter().zip(&*outer) {
                match *s as usize {
                    s if s < end => x[s - base] -= value,
                    s => scratch.beyond[s - end] -= value,
                }
            }
        }
    }

    /// Substitutes back: x_own −= W x_boundary.
    #[inline(always)]
    fn up(
        &self,
        fronts: RangeInclusive<usize>,
        base: usize,
        factors: &Factors,
        x: &mut [f32],
        scratch: &mut Scratch,
        side: Side,
    ) {
        let end = base + x.len();
        for k in fronts.rev() {
            let f = &self.fronts.fronts[k];
            let (n, m) = (f.n_own, f.boundary.len());
            let [_, v, w] = factors.of(self, k);
            let own = &mut scratch.own[..n];
            let outer = &mut scratch.outer[..m];
            for (s, value) in f.boundary.iter().zip(outer.iter_mut()) {
                *value = match *s as usize {
                    s if s < end => x[s - base],
                    s => scratch.beyond[s - end],
                };
            }
            let scaled = &mut scratch.scaled[..];
            match side {
                Side::Matrix => w.multiply(outer, own, scaled),
                Side::Transposed => v.multiply_transposed(outer, own, scaled),
            }
            for (x, value) in x[f.first - base..].iter_mut().zip(&*own) {
                *x -= value;
            }
        }
    }
}

/// A⁻¹ (n × n), V (m × n) and W (n × m) of a front.
#[inline(always)]
fn split<T>(storage: &[T], n: usize, m: usize) -> [&[T]; 3] {
    [
        &storage[..n * n],
        &storage[n * n..n * (n + m)],
        &storage[n * (n + m)..n * (n + 2 * m)],
    ]
}

/// Numbers of a factor below which a solve stays on one thread.
const SMALL: usize = 300_000;

/// Parts of a larger one, at most.
const PARTS: usize = 8;

/// Roots of disjoint subtrees of about the same cost, ascending, and the ranges of the fronts above them.
fn parts(fronts: &Fronts, starts: &[usize]) -> (Vec<usize>, Vec<RangeInclusive<usize>>) {
    let cost = |k: &usize| starts[k + 1] - starts[fronts.fronts[*k].subtree];
    let total = starts[starts.len() - 1];
    let mut parts: Vec<usize> = Vec::new();
    if total > SMALL {
        let mut open = fronts.roots.clone();
        while let Some(k) = open.pop() {
            if cost(&k) * PARTS <= total {
                if cost(&k) * 8 * PARTS > total {
                    parts.push(k);
                }
            } else {
                open.extend_from_slice(&fronts.fronts[k].children);
            }
        }
    }
    parts.sort_unstable();
    let mut above = Vec::new();
    let mut from = 0;
    for k in parts.iter().copied().chain([fronts.fronts.len()]) {
        let first = fronts.fronts.get(k).map_or(k, |f| f.subtree);
        if first > from {
            above.push(from..=first - 1);
        }
        from = k + 1;
    }
    (parts, above)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assembly::NodeGraph;
    use approx::assert_relative_eq;
    use faer::linalg::solvers::Solve;

    /// A grid of groups of one to three unknowns with entries from a formula, duplicates among them:
    /// solves with the matrix and its transpose equal those of dense linear algebra to the sixteen bits
    /// that are kept.
    #[test]
    fn equals_dense_linear_algebra() {
        let (nx, ny) = (23, 17);
        let near = |i: usize, j: usize| {
            let (x, y) = (i % nx, i / nx);
            let (u, v) = (j % nx, j / nx);
            x.abs_diff(u) <= 1 && y.abs_diff(v) <= 1
        };
        let mut graph = NodeGraph {
            offsets: vec![0],
            neighbours: Vec::new(),
        };
        for i in 0..nx * ny {
            graph
                .neighbours
                .extend((0..nx * ny).filter(|j| near(i, *j)).map(|j| j as u32));
            graph.offsets.push(graph.neighbours.len());
        }
        let mut n = 0;
        let unknowns: Vec<Vec<u32>> = (0..nx * ny)
            .map(|i| {
                let own = (n..n + 1 + i as u32 % 3).collect();
                n += 1 + i as u32 % 3;
                own
            })
            .collect();
        let mut entries = Vec::new();
        let mut values = Vec::new();
        for i in 0..nx * ny {
            for j in graph.of(i) {
                for a in &unknowns[i] {
                    for b in &unknowns[*j as usize] {
                        let v = (1.3 * *a as f64 + 0.7 * *b as f64).sin();
                        entries.push((*a, *b));
                        values.push(0.5 * v);
                        entries.push((*a, *b));
                        values.push(0.5 * v + if a == b { 9.0 } else { 0.0 });
                    }
                }
            }
        }
        let n = n as usize;
        let blocks = Blocks {
            graph: &graph,
            unknowns,
            n_inner: nx * ny,
            carriers: None,
        };
        let pattern = Arc::new(FrontalPattern::new(&blocks, &entries).unwrap());
        assert!(pattern.fronts.fronts.len() > 10);
        let mut lu = FrontalLu::new(&pattern, &values).unwrap();
        let mut dense = Mat::<f64>::zeros(n, n);
        for ((i, j), v) in entries.iter().zip(&values) {
            dense[(*i as usize, *j as usize)] += v;
        }
        let b: Vec<f64> = (0..n).map(|i| (0.1 * i as f64).cos()).collect();
        let column = Mat::from_fn(n, 1, |i, _| b[i]);
        let (mut x, mut y) = (b.clone(), b.clone());
        lu.solve(&mut x);
        lu.solve_transposed(&mut y);
        let exact = dense.partial_piv_lu().solve(&column);
        let transposed = dense.transpose().to_owned().partial_piv_lu().solve(&column);
        for i in 0..n {
            assert_relative_eq!(x[i], exact[(i, 0)], epsilon = 3e-5);
            assert_relative_eq!(y[i], transposed[(i, 0)], epsilon = 3e-5);
        }
        let again = FrontalLu::new(&pattern, &values).unwrap();
        assert_eq!(again.factors, lu.factors);
    }

    /// Rows and columns of very different size: each entry within half of the last digit of its row and column.
    #[test]
    fn rounding_follows_rows_and_columns() {
        let (rows, columns) = (5, 4);
        let size = |i: usize, j: usize| 10f32.powi(2 * i as i32 - 3 * j as i32);
        let a: Vec<f32> = (0..rows * columns)
            .map(|k| size(k % rows, k / rows) * (0.9 * k as f32).cos())
            .collect();
        let (mut r, mut c) = (vec![0.0; rows], vec![0.0; columns]);
        let mut whole = vec![0; rows * columns];
        round(&a, &mut r, &mut c, &mut whole);
        for (k, v) in a.iter().enumerate() {
            let (i, j) = (k % rows, k / rows);
            assert!(whole[k].abs() <= 32_000);
            let back = f32::from(whole[k]) * r[i] * c[j];
            assert!((back - v).abs() <= 0.51 * r[i] * c[j], "{v} {back}");
            assert!(r[i] * c[j] <= size(i, j) * 1e-3, "{i} {j}");
        }
    }

    #[test]
    fn singular_block_is_refused() {
        let graph = NodeGraph {
            offsets: vec![0, 1],
            neighbours: vec![0],
        };
        let blocks = Blocks {
            graph: &graph,
            unknowns: vec![vec![0, 1]],
            n_inner: 1,
            carriers: None,
        };
        let entries = [(0, 0), (0, 1), (1, 0), (1, 1)];
        let pattern = Arc::new(FrontalPattern::new(&blocks, &entries).unwrap());
        let e = FrontalLu::new(&pattern, &[1.0, 2.0, 2.0, 4.0]).unwrap_err();
        assert_eq!(e, FrontalError { size: 2 });
    }
}
