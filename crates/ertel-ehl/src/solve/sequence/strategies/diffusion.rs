//! Continuation in isotropic diffusion, ρ_id from that of a start to that of the case.
//!
//! Cures sharp spikes, which diffusion smooths away: at M = 10, L = 15 after Barus it halves their height, and the step from
//! there to the case is too long. Does nothing for incompressible fluids, whose ∂ρ̄/∂P is zero.

use super::Outline;
use crate::solution::Role;
use crate::solve::sequence::stage::Stage;
use crate::solve::system::FilmConstants;
use crate::solve::tuning::continuation::DIFFUSION;

/// From the usual start to the case.
pub(super) fn diffusion(outline: &Outline) -> Vec<Stage> {
    let mut stages: Vec<Stage> = steps(outline.start(), outline.last()).collect();
    stages.extend(&outline.in_earnest()[1..]);
    stages
}

/// Steps from a diffusive start towards the stage `end`.
pub(in super::super) fn steps(start: &Stage, end: &Stage) -> impl Iterator<Item = Stage> + use<> {
    let (start, end) = (*start, end.constants.isotropic_diffusion);
    let between = move |d: &f64| (end..start.constants.isotropic_diffusion).contains(d);
    DIFFUSION
        .into_iter()
        .filter(between)
        .map(move |isotropic_diffusion| Stage {
            constants: FilmConstants {
                isotropic_diffusion,
                ..start.constants
            },
            cold: false,
            role: Role::Path,
            ..start
        })
}
