//! Pressures of lower order, which overshoot less at a spike that the mesh does not resolve.

use super::{Outline, shear_law};
use crate::solve::sequence::stage::Stage;
use crate::solve::tuning::continuation::LOWER_ORDER;

/// The usual stages with pressures of at most some order, from the beginning.
pub(super) fn lower_order(outline: &Outline, order: usize) -> Vec<Stage> {
    let lower = |stage: &Stage| Stage {
        pressure_order: stage.pressure_order.min(order),
        ..*stage
    };
    let stages = outline.in_earnest();
    match outline.exponential {
        true => {
            let from_start = shear_law::at_full_sliding(outline);
            stages[..1].iter().chain(&from_start).map(lower).collect()
        }
        false => stages.iter().map(lower).collect(),
    }
}

/// A stage with quadratic pressures, unless its own are as low.
pub(in super::super) fn quadratic(stage: &Stage) -> Option<Stage> {
    (stage.pressure_order > LOWER_ORDER).then_some(Stage {
        pressure_order: LOWER_ORDER,
        given_up_early: false,
        ..*stage
    })
}
