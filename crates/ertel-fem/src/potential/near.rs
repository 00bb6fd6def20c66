//! Near field: what expansions leave out, in dense blocks of the targets of one leaf.

use std::ops::Range;

use rayon::prelude::*;

use super::integrals::ElementIntegrals;
use super::tree::{Near, Tree};
use super::{Number, Sources, mixed_dot};
use crate::kernel as declare_kernel;
use crate::linear::dense::vectorised;

/// Distance from an element, in its diameters, within which it is integrated in closed form.
const REACH: f64 = 0.5;
/// Fixed number of tasks of a transposed product, whose sums are added in a fixed order.
const TASKS: usize = 8;
/// Blocks that a thread takes at a time.
const BATCH: usize = 16;

/// Targets of one leaf by the nodes of the elements around it.
#[derive(Clone, Debug)]
struct Block<S> {
    /// In the order of the tree.
    targets: Range<usize>,
    /// Nodes of the density.
    nodes: Vec<u32>,
    /// Row by row.
    values: Vec<S>,
}

/// The near field, in numbers of precision `S`.
#[derive(Clone, Debug)]
pub struct NearField<S> {
    blocks: Vec<Block<S>>,
    n_nodes: usize,
}

impl<S: Number> NearField<S> {
    /// Integrates the elements around each leaf exactly and takes off what expansions give of them already.
    pub fn new(
        sources: &Sources,
        targets: &[[f64; 2]],
        tree: &Tree,
        near: &[Vec<Near>],
        integrals: &ElementIntegrals,
    ) -> NearField<S> {
        let elements = elements_around(sources, tree, near);
        let leaves: Vec<usize> = (0..tree.cells.len())
            .filter(|c| tree.cells[*c].is_leaf() && !tree.cells[*c].targets.is_empty())
            .collect();
        // Where each source stands in the tree.
        let mut position = vec![0u32; tree.source_order.len()];
        for (k, source) in tree.source_order.iter().enumerate() {
            position[*source as usize] = k as u32;
        }
        let builder = Builder {
            sources,
            targets,
            tree,
            integrals,
            position: &position,
        };
        let mut blocks: Vec<Block<S>> = leaves
            .par_iter()
            .map(|leaf| builder.block(*leaf, &near[*leaf], &elements[*leaf]))
            .collect();
        blocks.sort_by_key(|b| b.targets.start);
        NearField {
            blocks,
            n_nodes: sources.space.n_nodes(),
        }
    }

    /// Bytes that it takes.
    pub fn bytes(&self) -> usize {
        (self.blocks.iter())
            .map(|b| size_of_val(&b.values[..]) + size_of_val(&b.nodes[..]))
            .sum()
    }

    /// Adds the near field of nodal densities to the sums at the targets, in the order of the tree.
    pub fn add<T: Number>(&self, density: &[T], sums: &mut [T]) {
        let mut rest = sums;
        let mut parts = Vec::with_capacity(self.blocks.len());
        for block in &self.blocks {
            let (own, others) = rest.split_at_mut(block.targets.len());
            parts.push((block, own));
            rest = others;
        }
        parts
            .into_par_iter()
            .with_min_len(BATCH)
            .for_each(|(block, own)| {
                vectorised(AddBlock {
                    block,
                    density,
                    own,
                });
            });
    }

    /// The transpose: from values at the targets, in the order of the tree, to nodes.
    pub fn transposed<T: Number>(&self, values: &[T]) -> Vec<T> {
        let size = self.blocks.len().div_ceil(TASKS).max(1);
        let sums: Vec<Vec<T>> = (self.blocks.par_chunks(size))
            .with_max_len(1)
            .map(|blocks| {
                let mut sum = vec![T::default(); self.n_nodes];
                for block in blocks {
                    vectorised(AddTransposed {
                        block,
                        values: &values[block.targets.clone()],
                        sum: &mut sum,
                    });
                }
                sum
            })
            .collect();
        let mut total = vec![T::default(); self.n_nodes];
        for sum in &sums {
            for (t, s) in total.iter_mut().zip(sum) {
                *t += *s;
            }
        }
        total
    }
}

declare_kernel! {
    AddBlock ['a, S: Number, T: Number] ['a, S, T]
    (block: &'a Block<S>, density: &'a [T], own: &'a mut [T]) -> () {
        let local: Vec<T> = block.nodes.iter().map(|n| density[*n as usize]).collect();
        for (sum, row) in own.iter_mut().zip(block.values.chunks_exact(local.len())) {
            *sum += mixed_dot(row, &local);
        }
    }
}

declare_kernel! {
    AddTransposed ['a, S: Number, T: Number] ['a, S, T]
    (block: &'a Block<S>, values: &'a [T], sum: &'a mut [T]) -> () {
        let mut local = vec![T::default(); block.nodes.len()];
        for (value, row) in values.iter().zip(block.values.chunks_exact(local.len())) {
            for (l, entry) in local.iter_mut().zip(row) {
                *l += T::from_f64(entry.to_f64()) * *value;
            }
        }
        for (node, l) in block.nodes.iter().zip(&local) {
            sum[*node as usize] += *l;
        }
    }
}

/// Elements (and images) of which something is near each leaf: points of theirs in near boxes, or all of them within
/// [`REACH`].
fn elements_around(sources: &Sources, tree: &Tree, near: &[Vec<Near>]) -> Vec<Vec<(u32, bool)>> {
    let per_element = sources.per_element() as u32;
    let mut around: Vec<Vec<(u32, bool)>> = near
        .par_iter()
        .map(|near| {
            let mut elements = Vec::new();
            for n in near {
                let points = &tree.source_order[tree.cells[n.from as usize].sources.clone()];
                elements.extend(points.iter().map(|s| (s / per_element, n.image)));
            }
            elements.sort_unstable();
            elements.dedup();
            elements
        })
        .collect();
    let images: &[bool] = if sources.mirrored {
        &[false, true]
    } else {
        &[false]
    };
    for element in 0..sources.n_elements() {
        let (low, high) = sources.bounds(element);
        let reach = REACH * (high[0] - low[0]).hypot(high[1] - low[1]);
        for image in images {
            let (bottom, top) = match image {
                false => (low[1], high[1]),
                true => (-high[1], -low[1]),
            };
            let corners = [
                [low[0] - reach, bottom - reach],
                [high[0] + reach, top + reach],
            ];
            tree.leaves_within(corners[0], corners[1], &mut |leaf| {
                around[leaf].push((element as u32, *image));
            });
        }
    }
    around.par_iter_mut().for_each(|elements| {
        elements.sort_unstable();
        elements.dedup();
    });
    around
}

struct Builder<'a> {
    sources: &'a Sources<'a>,
    targets: &'a [[f64; 2]],
    tree: &'a Tree,
    integrals: &'a ElementIntegrals,
    position: &'a [u32],
}

impl Builder<'_> {
    /// The block of a leaf.
    fn block<S: Number>(&self, leaf: usize, near: &[Near], elements: &[(u32, bool)]) -> Block<S> {
        let (sources, tree) = (self.sources, self.tree);
        let range = tree.cells[leaf].targets.clone();
        // Sources that expansions leave out, as ranges of the tree's order.
        let mut direct: [Vec<Range<u32>>; 2] = [Vec::new(), Vec::new()];
        for n in near {
            let s = &tree.cells[n.from as usize].sources;
            direct[usize::from(n.image)].push(s.start as u32..s.end as u32);
        }
        direct.iter_mut().for_each(|d| d.sort_by_key(|r| r.start));
        let is_direct = |source: usize, image: bool| {
            let (ranges, at) = (&direct[usize::from(image)], self.position[source]);
            let next = ranges.partition_point(|r| r.start <= at);
            next > 0 && ranges[next - 1].contains(&at)
        };
        let mut nodes: Vec<u32> = (elements.iter())
            .flat_map(|(e, _)| sources.space.nodes_of(*e as usize))
            .copied()
            .collect();
        nodes.sort_unstable();
        nodes.dedup();
        let n = sources.space.element.n_nodes();
        let per_element = sources.per_element();
        let mut rows = vec![0.0f64; range.len() * nodes.len()];
        let mut entries = vec![0.0; n];
        let mut seen: Vec<f64> = Vec::with_capacity(per_element);
        for (element, image) in elements {
            let element = *element as usize;
            let vertices = sources.vertices(element);
            let columns: Vec<usize> = (sources.space.nodes_of(element).iter())
                .map(|node| nodes.binary_search(node).expect("listed above"))
                .collect();
            let expanded: Vec<usize> = (0..per_element)
                .filter(|q| !is_direct(element * per_element + q, *image))
                .collect();
            let weighted = sources.weighted_shapes(element, &expanded);
            for (target, row) in
                (tree.target_order[range.clone()].iter()).zip(rows.chunks_exact_mut(nodes.len()))
            {
                let mut x = self.targets[*target as usize];
                if *image {
                    x[1] = -x[1];
                }
                self.integrals.at(vertices, x, &mut entries);
                if !expanded.is_empty() {
                    let points = expanded
                        .iter()
                        .map(|q| sources.points[element * per_element + q]);
                    seen.clear();
                    seen.extend(points.map(|y| {
                        sources
                            .kernel
                            .at(((x[0] - y[0]).powi(2) + (x[1] - y[1]).powi(2)).sqrt())
                    }));
                    for (entry, weights) in entries
                        .iter_mut()
                        .zip(weighted.chunks_exact(expanded.len()))
                    {
                        *entry -= mixed_dot(weights, &seen);
                    }
                }
                for (entry, column) in entries.iter().zip(&columns) {
                    row[*column] += entry;
                }
            }
        }
        Block {
            targets: range,
            nodes,
            values: rows.iter().map(|v| S::from_f64(*v)).collect(),
        }
    }
}
