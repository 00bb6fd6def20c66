//! Nested dissection by METIS.

use std::sync::{Mutex, PoisonError};

use super::{OrderingError, others};
use crate::assembly::NodeGraph;

/// METIS draws from the C library's one random sequence, seeded at its start: two calls at a time
/// would disturb each other's order, and with it the last digits of every result.
static ONE_AT_A_TIME: Mutex<()> = Mutex::new(());

/// Nested-dissection order of the nodes.
///
/// # Errors
/// When METIS fails (out of memory).
#[allow(unsafe_code)]
pub(crate) fn metis(graph: &NodeGraph) -> Result<Vec<usize>, OrderingError> {
    let n = graph.n_nodes();
    let (offsets, neighbours) = others(graph);
    let signed = |list: Vec<u32>| list.into_iter().map(|v| v as i32).collect::<Vec<i32>>();
    let (mut offsets, mut neighbours) = (signed(offsets), signed(neighbours));
    if neighbours.is_empty() {
        return Ok((0..n).collect());
    }
    let mut size = n as i32;
    let mut options = [0i32; metis_sys::METIS_NOPTIONS as usize];
    let mut order = vec![0i32; n];
    let mut inverse = vec![0i32; n];
    let _guard = ONE_AT_A_TIME.lock().unwrap_or_else(PoisonError::into_inner);
    // SAFETY: all arrays have the lengths METIS documents (n + 1, Σdegrees, n, n) and outlive the
    // call; a null vertex weight means unit weights. METIS uses a fixed seed, so the order is
    // reproducible while no other call runs.
    let code = unsafe {
        metis_sys::METIS_SetDefaultOptions(options.as_mut_ptr());
        metis_sys::METIS_NodeND(
            &mut size,
            offsets.as_mut_ptr(),
            neighbours.as_mut_ptr(),
            std::ptr::null_mut(),
            options.as_mut_ptr(),
            order.as_mut_ptr(),
            inverse.as_mut_ptr(),
        )
    };
    if code != metis_sys::rstatus_et_METIS_OK {
        return Err(OrderingError { n_nodes: n, code });
    }
    Ok(order.into_iter().map(|v| v as usize).collect())
}
