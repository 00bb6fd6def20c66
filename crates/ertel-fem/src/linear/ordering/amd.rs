//! Approximate minimum degree by faer (Amestoy, Davis and Duff 1996).

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::amd;

use super::{OrderingError, others};
use crate::assembly::NodeGraph;

/// Approximate-minimum-degree order of the nodes.
///
/// # Errors
/// When there is not enough memory.
pub(crate) fn minimum_degree(graph: &NodeGraph) -> Result<Vec<usize>, OrderingError> {
    let n = graph.n_nodes();
    let (offsets, neighbours) = others(graph);
    if neighbours.is_empty() {
        return Ok((0..n).collect());
    }
    let mut order = vec![0u32; n];
    let mut inverse = vec![0u32; n];
    let pattern = SymbolicSparseColMatRef::new_unsorted_checked(n, n, &offsets, None, &neighbours);
    let scratch = amd::order_maybe_unsorted_scratch::<u32>(n, neighbours.len());
    let done = amd::order_maybe_unsorted(
        &mut order,
        &mut inverse,
        pattern,
        amd::Control::default(),
        MemStack::new(&mut MemBuffer::new(scratch)),
    );
    match done {
        Ok(_) => Ok(order.into_iter().map(|v| v as usize).collect()),
        Err(_) => Err(OrderingError {
            n_nodes: n,
            code: -1,
        }),
    }
}
