//! Continuation in sliding, u = u_e ± θ Δu/2, with the heat that goes with it.
//!
//! Cures thermal contacts whose isothermal film overheats by hundreds of kelvins when it is heated at once. Heat grows roughly
//! with θ², so that small steps of θ are small steps of the temperature, too.

use super::lower_order::quadratic;
use super::{Outline, diffusion};
use crate::solution::Role;
use crate::solve::sequence::stage::Stage;
pub(super) use crate::solve::tuning::continuation::SLIDING;

/// Through sliding to a heated contact, on the mesh of the start; nothing for contacts without heat or sliding.
pub(super) fn sliding(outline: &Outline) -> Vec<Stage> {
    let (start, stages) = (outline.start(), outline.in_earnest());
    let Some(heated) = stages.iter().find(|stage| stage.heated) else {
        return Vec::new();
    };
    // Where an exponential would punish the overshoots of pressures, in those of the start, and with its diffusion.
    let first = match outline.exponential {
        true => Stage {
            heated: true,
            newtonian: false,
            ..*start
        },
        false => Stage {
            sizes: start.sizes,
            pressure_order: start.pressure_order.min(heated.pressure_order),
            ..*heated
        },
    };
    let mut path = steps(outline, &first);
    // Without heat first: what was reached so far slides more.
    if let Some(slow) = path.first().copied() {
        let unheated = Stage {
            heated: false,
            ..slow
        };
        path.insert(0, unheated);
    }
    if let Some(end) = path.last().copied() {
        path.extend(diffusion::steps(&end, heated));
        let heated = stages.iter().filter(|stage| stage.heated);
        path.extend(heated.map(|stage| goal(outline, stage)));
    }
    path
}

/// From rolling to the case's sliding, heated like the stage `end`; nothing for contacts without heat or sliding.
pub(super) fn steps(outline: &Outline, end: &Stage) -> Vec<Stage> {
    if !end.heated || !outline.slides {
        return Vec::new();
    }
    let step = |sliding| Stage {
        sliding,
        cold: false,
        role: Role::Path,
        ..*end
    };
    SLIDING.into_iter().map(step).collect()
}

/// A stage at the end of a continuation: that of an exponential fluid is given up early, because quadratic pressures, which
/// overshoot less, stand in for those of higher order.
pub(super) fn goal(outline: &Outline, stage: &Stage) -> Stage {
    Stage {
        given_up_early: outline.exponential && quadratic(stage).is_some(),
        ..*stage
    }
}
