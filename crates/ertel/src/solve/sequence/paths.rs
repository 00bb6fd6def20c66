//! Ways from a contact that is easily solved to the case's own, by one quantity at a time.
//!
//! ```text
//!   limiting stress   γ̇ ~ e^{(τ/τ_L − r₁)/ε} beyond r₁τ_L, ε = (1 − r₁²)/(2r₁)      ε from 0.75 to 0.001
//!   Eyring's fluid    γ̇ = (τ₀/μ₁) sinh(τ/τ₀)                                        τ₀ from 27 times to that of the case
//!   sliding           u = u_e ± θ Δu/2, with the heat that goes with it              θ from 0.03 to 1
//! ```
//! With a large ε stress passes its limit by much, and the film is that of a thinning oil; as ε falls the limit becomes as sharp
//! as the law's. (Interior-point methods sharpen a bound in the same way: Nocedal and Wright 2006, chapter 19.) The way is
//! gone with the diffusion of a start, which keeps pressure gradients small: a spike of the Newtonian film would shear the walls by
//! decades too fast. Sliding heats the film roughly with θ², so that small steps of θ are small steps of the temperature, too.

use super::Stage;
use super::{Problem, Role};
use crate::solve::system::FilmConstants;

/// Softnesses of an exponential: stress of an e-fold, over that of the law, or its root for Eyring's stress. From each to the next
/// the shear rate of a stress beyond the limit gains as many e-folds as it had twice over.
const SOFTNESS: [f64; 7] = [750.0, 250.0, 81.0, 27.0, 9.0, 3.0, 1.0];

/// The one of them at which friction, and the heat of it, is already near that of the law.
pub(super) const MEDIUM_SOFTNESS: f64 = 27.0;

/// Shares θ of the sliding.
const SLIDING: [f64; 7] = [0.03, 0.1, 0.25, 0.45, 0.65, 0.85, 1.0];

/// Ratios of softnesses and of θ that need not be halved.
const NEAR_SOFTNESS: f64 = 1.2;
const NEAR_SLIDING: f64 = 1.04;

/// From a start with a Newtonian fluid to the case's own, whose shear rate grows exponentially with the stress; nothing for
/// other fluids.
pub(super) fn hardening_path(problem: &Problem, start: &Stage) -> Vec<Stage> {
    if !problem.fluid.is_exponential() {
        return Vec::new();
    }
    let step = |softness| Stage {
        softness,
        newtonian: false,
        cold: false,
        role: Role::Path,
        ..*start
    };
    SOFTNESS.into_iter().map(step).collect()
}

/// From rolling to the case's sliding, heated like the stage `end`; nothing for contacts without heat or sliding.
pub(super) fn sliding_path(problem: &Problem, end: &Stage) -> Vec<Stage> {
    if !end.heated || problem.fluid.slide() == 0.0 {
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

/// Diffusion between that of a start and none.
const DIFFUSION: [f64; 4] = [1.0, 0.25, 0.06, 0.015];

/// Steps from a diffusive start towards the stage `end`.
pub(super) fn diffusion_path(start: &Stage, end: &Stage) -> impl Iterator<Item = Stage> + use<> {
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

/// Between a stage and the one before on a way, if they differ enough.
pub(super) fn halfway(from: &Stage, to: &Stage) -> Option<Stage> {
    let diffusion = |s: &Stage| s.constants.isotropic_diffusion;
    let thickening = 0.5 * (from.thickening + to.thickening);
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
    let near = to.thickening - thickening < 0.02
        && isotropic_diffusion < 1.4 * diffusion(to)
        && between < NEAR_SOFTNESS * to.softness
        && to.sliding < NEAR_SLIDING * sliding;
    (to.role == Role::Path && !near).then_some(Stage {
        thickening,
        softness: between,
        sliding,
        constants: FilmConstants {
            isotropic_diffusion,
            ..to.constants
        },
        ..*to
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The ways grow steadily to the case itself.
    #[test]
    fn ways_lead_to_the_case() {
        for pair in SOFTNESS.windows(2) {
            let ratio = pair[0] / pair[1];
            assert!(ratio > 1.0 && ratio < 4.0, "{pair:?}");
        }
        assert_eq!(SOFTNESS[SOFTNESS.len() - 1], 1.0);
        assert!(SLIDING.windows(2).all(|pair| pair[0] < pair[1]));
        assert_eq!(SLIDING[SLIDING.len() - 1], 1.0);
    }
}
