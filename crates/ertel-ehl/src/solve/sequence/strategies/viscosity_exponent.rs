//! Continuation in the viscosity exponent θ, μ̄^θ from a fluid that pressure thickens little to that of the case.
//!
//! Cures extreme material groups: a spike of many decades of viscosity cannot be reached from the dry contact in one go.

use super::Outline;
use crate::solution::Role;
use crate::solve::sequence::stage::Stage;
use crate::solve::tuning::continuation::EXPONENTS;

/// From a start at the least exponent to the usual start's fluid, and from there to the case.
pub(super) fn viscosity_exponent(outline: &Outline) -> Vec<Stage> {
    let mut stages = steps(outline.start());
    stages.extend(outline.path_from_start());
    stages
}

/// A start at the least exponent, and steps from it to the start itself.
pub(super) fn steps(start: &Stage) -> Vec<Stage> {
    let steps = EXPONENTS
        .iter()
        .enumerate()
        .map(|(i, viscosity_exponent)| Stage {
            viscosity_exponent: *viscosity_exponent,
            cold: i == 0,
            role: if i == 0 { Role::Start } else { Role::Path },
            ..*start
        });
    steps.collect()
}
