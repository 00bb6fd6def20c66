//! The graph that is ordered.

use crate::assembly::NodeGraph;

/// Neighbours of each node without itself.
pub(crate) struct Neighbours {
    /// Where those of each node begin, and the end.
    pub offsets: Vec<u32>,
    /// All of them.
    pub list: Vec<u32>,
}

impl Neighbours {
    pub(super) fn of(graph: &NodeGraph) -> Neighbours {
        let mut offsets = vec![0];
        let mut list = Vec::with_capacity(graph.neighbours.len());
        for node in 0..graph.n_nodes() {
            let others = graph.of(node).iter().copied();
            list.extend(others.filter(|m| *m as usize != node));
            offsets.push(list.len() as u32);
        }
        Neighbours { offsets, list }
    }
}
