//! Fill-reducing order of the nodes of a graph: nested dissection by METIS, or approximate minimum degree where METIS, which is
//! written in C, cannot be built.

#[cfg(any(test, target_arch = "wasm32"))]
mod amd;
#[cfg(not(target_arch = "wasm32"))]
mod metis;
#[cfg(test)]
mod tests;

#[cfg(any(test, target_arch = "wasm32"))]
pub(crate) use amd::minimum_degree;
#[cfg(not(target_arch = "wasm32"))]
pub(crate) use metis::metis;

use crate::assembly::NodeGraph;

/// The graph was refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("could not order a graph of {n_nodes} nodes (code {code})")]
pub struct OrderingError {
    /// Size of the graph.
    pub n_nodes: usize,
    /// Return code of the library.
    pub code: i32,
}

/// Neighbours of each node without itself: where those of each begin, and all of them.
fn others(graph: &NodeGraph) -> (Vec<u32>, Vec<u32>) {
    let mut offsets: Vec<u32> = vec![0];
    let mut neighbours: Vec<u32> = Vec::with_capacity(graph.neighbours.len());
    for node in 0..graph.n_nodes() {
        neighbours.extend(
            graph
                .of(node)
                .iter()
                .copied()
                .filter(|m| *m as usize != node),
        );
        offsets.push(neighbours.len() as u32);
    }
    (offsets, neighbours)
}

/// Fill-reducing order of the nodes: the k-th node to eliminate is `order[k]`.
///
/// # Errors
/// When the library fails (out of memory).
pub fn fill_reducing(graph: &NodeGraph) -> Result<Vec<usize>, OrderingError> {
    crate::platform::order_graph(graph)
}
