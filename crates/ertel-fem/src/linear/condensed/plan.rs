//! The order of elimination, and where the elements are assembled.

use crate::assembly::{CONSTRAINED, DofMap, NodeGraph};
use crate::linear::fronts::{Blocks, Front, Fronts};
use crate::linear::ordering::{FillReduction, OrderingError};
use crate::space::Space;

/// No place, group or column.
pub(super) const NOWHERE: usize = usize::MAX;

/// Whether a front holds the condensed unknowns.
pub(super) fn is_last(fronts: &Fronts, condensed: &[usize], k: usize) -> bool {
    !condensed.is_empty() && k + 1 == fronts.fronts.len()
}

/// Fronts of the body: its nodes by nested dissection, then the condensed unknowns.
pub(super) fn elimination(
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
        reduction: FillReduction::NestedDissection,
    })
}

/// Each element goes to the front that eliminates the first of its unknowns.
pub(super) fn elements_of_fronts(space: &Space, dofs: &DofMap, fronts: &Fronts) -> Vec<Vec<u32>> {
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
pub(super) fn places(
    space: &Space,
    dofs: &DofMap,
    fronts: &Fronts,
    front: &Front,
    cell: usize,
) -> Vec<usize> {
    let unknowns = space.nodes_of(cell).iter();
    unknowns
        .flat_map(|n| dofs.of_node(*n as usize))
        .map(|d| match *d {
            CONSTRAINED => NOWHERE,
            d => front.index_of(fronts.position[d as usize] as usize),
        })
        .collect()
}

/// Adds the matrix of an element to the lower triangle of a front, column by column.
pub(super) fn add_element(block: &[f64], places: &[usize], front: &mut [f64], order: usize) {
    let size = places.len();
    for (b, j) in places.iter().enumerate() {
        for (a, i) in places.iter().enumerate() {
            if *j != NOWHERE && *i != NOWHERE && i >= j {
                front[*j * order + *i] += block[a * size + b];
            }
        }
    }
}
