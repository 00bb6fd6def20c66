//! Near field: what expansions leave out, in dense blocks of the targets of one leaf.

use std::ops::Range;

use rayon::prelude::*;

use super::integrals::ElementIntegrals;
use super::near_blocks::{Builder, Scratch};
use super::number::{Number, mixed_dot};
use super::sources::Sources;
use super::tree::{Near, Tree};
use crate::kernel as declare_kernel;
use crate::linear::dense::vectorised;

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
        let builder = Builder::new(sources, targets, tree, integrals);
        let elements = builder.elements_around(near);
        let mut leaves: Vec<usize> = (0..tree.cells.len())
            .filter(|c| tree.cells[*c].is_leaf() && !tree.cells[*c].targets.is_empty())
            .collect();
        leaves.sort_by_key(|leaf| tree.cells[*leaf].targets.start);
        NearField {
            blocks: leaves
                .par_iter()
                .map_init(Scratch::default, |scratch, leaf| {
                    let rows = builder.block(*leaf, &near[*leaf], &elements[*leaf], scratch);
                    Block {
                        targets: tree.cells[*leaf].targets.clone(),
                        nodes: scratch.nodes.clone(),
                        values: rows,
                    }
                })
                .collect(),
        }
    }

    /// Bytes that it takes.
    pub fn bytes(&self) -> usize {
        (self.blocks.iter())
            .map(|b| size_of_val(&b.values[..]) + size_of_val(&b.nodes[..]))
            .sum()
    }

    /// Number of entries.
    pub fn entries(&self) -> usize {
        self.blocks.iter().map(|b| b.values.len()).sum()
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
