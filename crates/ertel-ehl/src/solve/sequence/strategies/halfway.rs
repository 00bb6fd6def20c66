//! Half of a continuation step that was too long.

use super::shear_law::SOFTNESS;
use crate::solution::Role;
use crate::solve::sequence::stage::Stage;
use crate::solve::system::FilmConstants;
use crate::solve::tuning::continuation::{NEAR_SLIDING, NEAR_SOFTNESS, NEAR_SPEED};

/// Between a stage and the one before of a continuation, if they differ enough.
pub(in super::super) fn halfway(from: &Stage, to: &Stage) -> Option<Stage> {
    let diffusion = |s: &Stage| s.constants.isotropic_diffusion;
    let viscosity_exponent = 0.5 * (from.viscosity_exponent + to.viscosity_exponent);
    let isotropic_diffusion = (diffusion(from) * diffusion(to)).sqrt();
    // A Newtonian fluid is softer than any.
    let softness = |s: &Stage| match s.newtonian && !to.newtonian {
        true => SOFTNESS[0] * SOFTNESS[0] / SOFTNESS[1],
        false => s.softness,
    };
    let between = (softness(from) * softness(to)).sqrt();
    // Heat begins with little sliding.
    let slid = if from.heated == to.heated {
        from.sliding
    } else {
        0.0
    };
    let sliding = 0.5 * (slid + to.sliding);
    let lambda = (from.constants.lambda * to.constants.lambda).sqrt();
    let film_scale = (from.constants.film_scale * to.constants.film_scale).sqrt();
    let near = to.viscosity_exponent - viscosity_exponent < 0.02
        && isotropic_diffusion < 1.4 * diffusion(to)
        && lambda < NEAR_SPEED * to.constants.lambda
        && between < NEAR_SOFTNESS * to.softness
        && to.sliding < NEAR_SLIDING * sliding;
    (to.role == Role::Path && !near).then_some(Stage {
        viscosity_exponent,
        softness: between,
        sliding,
        constants: FilmConstants {
            isotropic_diffusion,
            lambda,
            film_scale,
            ..to.constants
        },
        ..*to
    })
}
