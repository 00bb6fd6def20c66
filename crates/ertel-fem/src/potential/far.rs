//! Far field: moments up the tree, across to boxes that do not touch, and down to the other points.

use std::ops::Range;

use rayon::prelude::*;

use super::Kernel;
use super::expansion::{Basis, offset_index};
use super::number::{Number, mixed_dot};
use super::tree::{self, NONE, Tree};
use crate::kernel as declare_kernel;
use crate::linear::dense::{add_product, vectorised};

/// Boxes that a thread takes at a time.
const BATCH: usize = 16;

/// Boxes whose links are sorted together: of those with one offset, four go through its matrix at once.
const CROSS_BATCH: usize = 32;

/// A link to one box of a batch.
#[derive(Clone, Copy, Debug)]
struct Link {
    offset: [i8; 2],
    image: bool,
    /// Within the batch.
    to: u32,
    from: u32,
}

/// All links, batch of target boxes by batch, in each by offset.
#[derive(Clone, Debug)]
pub struct Links {
    list: Vec<Link>,
    batches: Vec<Range<usize>>,
}

impl Links {
    /// From the links of every box.
    pub fn new(by_box: &[Vec<tree::Link>]) -> Links {
        let mut links = Links {
            list: Vec::with_capacity(by_box.iter().map(Vec::len).sum()),
            batches: Vec::new(),
        };
        for batch in by_box.chunks(CROSS_BATCH) {
            let start = links.list.len();
            for (to, own) in batch.iter().enumerate() {
                links.list.extend(own.iter().map(|link| Link {
                    offset: link.offset,
                    image: link.image,
                    to: to as u32,
                    from: link.from,
                }));
            }
            links.list[start..].sort_by_key(|link| link.offset);
            links.batches.push(start..links.list.len());
        }
        links
    }

    /// Bytes that it takes.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.list[..]) + size_of_val(&self.batches[..])
    }
}

/// Numbers of a leaf that take values of a density (or of nodes) to its moments, column by column.
#[derive(Clone, Debug, Default)]
pub struct Ends<T> {
    /// Entries of each box in `columns`; empty for boxes with children.
    pub ranges: Vec<Range<usize>>,
    /// Positions of the values.
    pub columns: Vec<u32>,
    /// One column of moments, padded, for each of them.
    pub values: Vec<T>,
}

/// All translations of one accuracy.
pub struct FarField<T> {
    /// Moments of a box, and the same rounded up to whole vectors.
    n: usize,
    stride: usize,
    /// From sources and to targets.
    pub sources: Ends<T>,
    pub targets: Ends<T>,
    /// Parent from child, by quadrant, column by column; and transposed.
    from_child: [Vec<T>; 4],
    to_child: [Vec<T>; 4],
    /// By offset.
    across: Vec<Vec<T>>,
    /// −1 where the polynomial is odd in y.
    mirror: Vec<T>,
}

impl<T: Number> FarField<T> {
    /// Translations of a basis; `n` of its functions are kept.
    pub fn new(
        basis: &Basis,
        n: usize,
        across: &[Vec<f64>],
        sources: &Ends<f64>,
        targets: &Ends<f64>,
    ) -> FarField<T> {
        let stride = n.next_multiple_of(T::LANES);
        let full = basis.len();
        // Column by column, rows padded.
        let columns = |matrix: &[f64], transposed: bool| -> Vec<T> {
            let mut padded = vec![T::default(); stride * n];
            for j in 0..n {
                for i in 0..n {
                    let (r, c) = if transposed { (j, i) } else { (i, j) };
                    padded[j * stride + i] = T::from_f64(matrix[r * full + c]);
                }
            }
            padded
        };
        let ends = |ends: &Ends<f64>| {
            let mut values = vec![T::default(); stride * ends.columns.len()];
            for (to, from) in values
                .chunks_exact_mut(stride)
                .zip(ends.values.chunks_exact(full))
            {
                for (to, from) in to[..n].iter_mut().zip(from) {
                    *to = T::from_f64(*from);
                }
            }
            Ends {
                ranges: ends.ranges.clone(),
                columns: ends.columns.clone(),
                values,
            }
        };
        let children = [0, 1, 2, 3].map(|q| basis.parent_from_child(q));
        FarField {
            n,
            stride,
            sources: ends(sources),
            targets: ends(targets),
            from_child: children.each_ref().map(|m| columns(m, false)),
            to_child: children.each_ref().map(|m| columns(m, true)),
            across: (across.iter())
                .map(|m| {
                    if m.is_empty() {
                        Vec::new()
                    } else {
                        columns(m, false)
                    }
                })
                .collect(),
            mirror: (0..stride)
                .map(|k| match basis.exponents.get(k) {
                    Some([_, b]) if b % 2 == 1 => T::from_f64(-1.0),
                    _ => T::from_f64(1.0),
                })
                .collect(),
        }
    }

    /// Bytes that it takes.
    pub fn bytes(&self) -> usize {
        let numbers = self.sources.values.len() + self.targets.values.len();
        numbers * size_of::<T>() + 4 * (self.sources.columns.len() + self.targets.columns.len())
    }

    /// Values at the targets from those at the sources.
    pub fn apply(&self, tree: &Tree, links: &Links, kernel: Kernel, values: &[T]) -> Vec<T> {
        let n_cells = tree.cells.len();
        let stride = self.stride;
        let mut moments = vec![T::default(); n_cells * stride];
        self.moments_of_leaves(&self.sources, values, &mut moments);
        for level in (1..tree.levels.len() - 1).rev() {
            let (above, below) = moments.split_at_mut(tree.levels[level] * stride);
            let first = tree.levels[level - 1];
            above[first * stride..]
                .par_chunks_mut(BATCH * stride)
                .enumerate()
                .for_each(|(batch, moments)| {
                    vectorised(Raise {
                        far: self,
                        tree,
                        first: first + BATCH * batch,
                        below,
                        moments,
                    });
                });
        }
        let mirrored: Vec<T> = match links.list.iter().any(|l| l.image) {
            true => (moments.chunks_exact(stride))
                .flat_map(|m| m.iter().zip(&self.mirror).map(|(m, s)| *m * *s))
                .collect(),
            false => Vec::new(),
        };
        let mut local = vec![T::default(); n_cells * stride];
        local
            .par_chunks_mut(CROSS_BATCH * stride)
            .zip(&links.batches)
            .enumerate()
            .for_each(|(batch, (local, range))| {
                vectorised(Cross {
                    far: self,
                    tree,
                    links: &links.list[range.clone()],
                    kernel,
                    first: CROSS_BATCH * batch,
                    moments: &moments,
                    mirrored: &mirrored,
                    local,
                });
            });
        for level in 1..tree.levels.len() - 1 {
            let (above, below) = local.split_at_mut(tree.levels[level] * stride);
            let first = tree.levels[level - 1];
            // Children of a batch of parents are a range of the next level.
            self.lower(
                tree,
                first,
                &above[first * stride..],
                tree.levels[level],
                below,
            );
        }
        self.values_at(&self.targets, &local)
    }

    fn moments_of_leaves(&self, from: &Ends<T>, values: &[T], moments: &mut [T]) {
        moments
            .par_chunks_mut(BATCH * self.stride)
            .enumerate()
            .for_each(|(batch, moments)| {
                vectorised(Gather {
                    far: self,
                    from,
                    values,
                    first: BATCH * batch,
                    moments,
                });
            });
    }

    /// Local expansions of one level handed down to the next.
    fn lower(&self, tree: &Tree, first: usize, above: &[T], first_below: usize, below: &mut [T]) {
        let stride = self.stride;
        let mut rest = below;
        let mut next = first_below;
        let mut parts = Vec::new();
        for (batch, parents) in above.chunks(BATCH * stride).enumerate() {
            let start = first + BATCH * batch;
            let cells = &tree.cells[start..start + parents.len() / stride];
            let children = cells.iter().flat_map(|c| c.children).filter(|c| *c != NONE);
            let n = children.count();
            let (own, others) = rest.split_at_mut(n * stride);
            parts.push((cells, parents, next, own));
            rest = others;
            next += n;
        }
        parts
            .into_par_iter()
            .for_each(|(cells, parents, next, own)| {
                vectorised(Lower {
                    far: self,
                    cells,
                    parents,
                    next,
                    own,
                });
            });
    }

    /// Values of local expansions at the points of their leaves, each by the column that it has there.
    fn values_at(&self, to: &Ends<T>, local: &[T]) -> Vec<T> {
        let stride = self.stride;
        let mut out = vec![T::default(); to.columns.len()];
        let mut rest = &mut out[..];
        let mut parts = Vec::new();
        for (cell, range) in to.ranges.iter().enumerate().filter(|(_, r)| !r.is_empty()) {
            let (own, others) = rest.split_at_mut(range.len());
            parts.push((cell, range.clone(), own));
            rest = others;
        }
        parts
            .into_par_iter()
            .with_min_len(BATCH)
            .for_each(|(cell, range, own)| {
                vectorised(Spread {
                    columns: &to.values[range.start * stride..range.end * stride],
                    local: &local[cell * stride..(cell + 1) * stride],
                    own,
                });
            });
        out
    }
}

declare_kernel! {
    Gather ['a, T: Number] ['a, T]
    (far: &'a FarField<T>, from: &'a Ends<T>, values: &'a [T], first: usize, moments: &'a mut [T]) -> () {
        let stride = far.stride;
        let mut buffer = Vec::new();
        for (moments, range) in moments.chunks_exact_mut(stride).zip(&from.ranges[first..]) {
            buffer.clear();
            buffer.extend(from.columns[range.clone()].iter().map(|c| values[*c as usize]));
            add_product(&from.values[range.start * stride..range.end * stride], &buffer, moments);
        }
    }
}

declare_kernel! {
    Raise ['a, T: Number] ['a, T]
    (far: &'a FarField<T>, tree: &'a Tree, first: usize, below: &'a [T], moments: &'a mut [T]) -> () {
        let (n, stride) = (far.n, far.stride);
        // `below` begins with the level after that of these boxes.
        let level = tree.cells[first].level as usize + 1;
        let offset = tree.levels[level];
        for (moments, cell) in moments.chunks_exact_mut(stride).zip(&tree.cells[first..]) {
            for (matrix, child) in far.from_child.iter().zip(cell.children) {
                if child != NONE {
                    let at = (child as usize - offset) * stride;
                    add_product(matrix, &below[at..at + n], moments);
                }
            }
        }
    }
}

declare_kernel! {
    Cross ['a, T: Number] ['a, T]
    (
        far: &'a FarField<T>,
        tree: &'a Tree,
        links: &'a [Link],
        kernel: Kernel,
        first: usize,
        moments: &'a [T],
        mirrored: &'a [T],
        local: &'a mut [T],
    ) -> () {
        let (n, stride) = (far.n, far.stride);
        let of = |link: &Link| {
            let at = link.from as usize * stride;
            let moments = if link.image { mirrored } else { moments };
            &moments[at..at + n]
        };
        let mut sums = [T::default(); CROSS_BATCH];
        for links in links.chunk_by(|a, b| a.offset == b.offset) {
            let matrix = &far.across[offset_index(links[0].offset)];
            let fours = links.chunks_exact(4);
            for link in fours.remainder() {
                let at = link.to as usize * stride;
                add_product(matrix, of(link), &mut local[at..at + stride]);
            }
            for links in fours {
                let x = [of(&links[0]), of(&links[1]), of(&links[2]), of(&links[3])];
                let to = [links[0].to, links[1].to, links[2].to, links[3].to];
                add_four_products(matrix, x, to, local, stride);
            }
            for link in links {
                sums[link.to as usize] += of(link)[0];
            }
        }
        for ((local, total), cell) in local.chunks_exact_mut(stride).zip(sums).zip(&tree.cells[first..]) {
            let (factor, constant) = kernel.scaled(tree.half_side(cell.level));
            let factor = T::from_f64(factor);
            for value in local.iter_mut() {
                *value = *value * factor;
            }
            local[0] += T::from_f64(constant) * total;
        }
    }
}

/// Adds A x of four vectors to local expansions of four boxes, so that A is read once.
#[inline(always)]
fn add_four_products<T: Number>(
    matrix: &[T],
    x: [&[T]; 4],
    to: [u32; 4],
    local: &mut [T],
    stride: usize,
) {
    const L: usize = 8;
    let n = x[0].len();
    let x = x.map(|x| &x[..n]);
    for row in (0..stride).step_by(L) {
        let mut sums = [[T::default(); L]; 4];
        for (k, column) in matrix.chunks_exact(stride).enumerate().take(n) {
            let column = &column[row..row + L];
            for v in 0..4 {
                for l in 0..L {
                    sums[v][l] += column[l] * x[v][k];
                }
            }
        }
        for v in 0..4 {
            let at = to[v] as usize * stride + row;
            for (y, s) in local[at..at + L].iter_mut().zip(&sums[v]) {
                *y += *s;
            }
        }
    }
}

declare_kernel! {
    Lower ['a, T: Number] ['a, T]
    (
        far: &'a FarField<T>,
        cells: &'a [super::tree::Cell],
        parents: &'a [T],
        next: usize,
        own: &'a mut [T],
    ) -> () {
        let (n, stride) = (far.n, far.stride);
        for (cell, parent) in cells.iter().zip(parents.chunks_exact(stride)) {
            for (matrix, child) in far.to_child.iter().zip(cell.children) {
                if child != NONE {
                    let at = (child as usize - next) * stride;
                    add_product(matrix, &parent[..n], &mut own[at..at + stride]);
                }
            }
        }
    }
}

declare_kernel! {
    Spread ['a, T: Number] ['a, T]
    (columns: &'a [T], local: &'a [T], own: &'a mut [T]) -> () {
        for (value, column) in own.iter_mut().zip(columns.chunks_exact(local.len())) {
            *value = mixed_dot(column, local);
        }
    }
}
