//! Approximate minimum degree by faer (Amestoy, Davis and Duff 1996).

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::amd;

use super::Neighbours;

/// Approximate-minimum-degree order; `None` when there is not enough memory.
pub(crate) fn minimum_degree(graph: &Neighbours) -> Option<Vec<u32>> {
    let n = graph.offsets.len() - 1;
    if graph.list.is_empty() {
        return Some((0..n as u32).collect());
    }
    let mut order = vec![0u32; n];
    let mut inverse = vec![0u32; n];
    let pattern =
        SymbolicSparseColMatRef::new_unsorted_checked(n, n, &graph.offsets, None, &graph.list);
    let scratch = amd::order_maybe_unsorted_scratch::<u32>(n, graph.list.len());
    let done = amd::order_maybe_unsorted(
        &mut order,
        &mut inverse,
        pattern,
        amd::Control::default(),
        MemStack::new(&mut MemBuffer::new(scratch)),
    );
    done.ok().map(|_| order)
}
