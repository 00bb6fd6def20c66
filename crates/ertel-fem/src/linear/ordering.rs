//! Fill-reducing order of the nodes of a graph.

mod amd;
#[cfg(not(target_arch = "wasm32"))]
mod dissection;
mod neighbours;
#[cfg(test)]
mod tests;

pub(crate) use amd::minimum_degree;
#[cfg(not(target_arch = "wasm32"))]
pub(crate) use dissection::nested_dissection;
pub(crate) use neighbours::Neighbours;

use crate::assembly::NodeGraph;

/// How an order is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FillReduction {
    /// Approximate minimum degree: for surfaces, whose factors it fills no more than dissection does, in a small part of the time.
    MinimumDegree,
    /// Nested dissection: for bodies. In a browser minimum degree, which fills their factors more.
    NestedDissection,
}

/// The graph was not ordered.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("could not order a graph of {n_nodes} nodes: is there enough memory?")]
pub struct OrderingError {
    /// Size of the graph.
    pub n_nodes: usize,
}

/// Fill-reducing order of the nodes: the k-th node to eliminate is `order[k]`. It is the same in every run.
///
/// # Errors
/// When the library fails (out of memory).
pub fn fill_reducing(graph: &NodeGraph, how: FillReduction) -> Result<Vec<usize>, OrderingError> {
    let neighbours = Neighbours::of(graph);
    let order = match how {
        FillReduction::MinimumDegree => minimum_degree(&neighbours),
        FillReduction::NestedDissection => crate::platform::dissect(&neighbours),
    };
    let order = order.ok_or(OrderingError {
        n_nodes: graph.n_nodes(),
    })?;
    Ok(order.into_iter().map(|node| node as usize).collect())
}
