//! Nested dissection by feral-metis (George 1973; Karypis and Kumar 1998).

use feral_metis::{CscPattern, metis_order};

use super::Neighbours;

/// Nested-dissection order; `None` when the library finds none.
pub(crate) fn nested_dissection(graph: &Neighbours) -> Option<Vec<u32>> {
    let signed = |list: &[u32]| list.iter().map(|v| *v as i32).collect::<Vec<i32>>();
    let (offsets, list) = (signed(&graph.offsets), signed(&graph.list));
    let pattern = CscPattern::new(offsets.len() - 1, &offsets, &list)?;
    let order = metis_order(&pattern).ok()?;
    Some(order.into_iter().map(|node| node as u32).collect())
}
