//! Continuation in the shear law, for fluids whose shear rate grows exponentially with the stress.
//!
//! ```text
//!   limiting stress   γ̇ ~ e^{(τ/τ_L − r₁)/ε} beyond r₁τ_L, ε = (1 − r₁²)/(2r₁)      ε from 0.75 to 0.001
//!   Eyring's fluid    γ̇ = (τ₀/μ₁) sinh(τ/τ₀)                                        τ₀ from 27 times to that of the case
//! ```
//! Cures the step from a Newtonian film, whose spike would shear the walls by decades too fast. With a large ε stress passes its
//! limit by much, and the film is that of a thinning oil; as ε falls the limit becomes as sharp as the law's. (Interior-point
//! methods sharpen a bound in the same way: Nocedal and Wright 2006, chapter 19.) The steps are taken with the diffusion of a
//! start, which keeps pressure gradients small.

use super::sliding::{self, goal};
use super::{Outline, diffusion};
use crate::solution::Role;
use crate::solve::sequence::stage::Stage;
use crate::solve::tuning::continuation::MEDIUM_SOFTNESS;
pub(super) use crate::solve::tuning::continuation::SOFTNESS;

/// To the fluid of the case at its full sliding, and on to the case. From a start with a Newtonian fluid, which is not part of it.
pub(super) fn at_full_sliding(outline: &Outline) -> Vec<Stage> {
    let start = outline.start();
    let mut path = steps(start);
    if let Some(hard) = path.last().copied() {
        path.extend(diffusion::steps(&hard, outline.last()));
    }
    path.extend(goals(outline));
    path
}

/// To a medium softness with little sliding, through sliding, and the rest of the way to the law when hot: heat thins the film and
/// its spikes. Nothing for contacts without heat or sliding.
pub(super) fn through_sliding(outline: &Outline) -> Vec<Stage> {
    let (start, last) = (outline.start(), outline.last());
    let medium = Stage {
        heated: true,
        softness: MEDIUM_SOFTNESS,
        newtonian: false,
        ..*start
    };
    let slides = sliding::steps(outline, &medium);
    let (true, Some(first)) = (last.heated, slides.first()) else {
        return Vec::new();
    };
    let slow = Stage {
        sliding: first.sliding,
        ..*start
    };
    let mut path = vec![*start];
    path.extend(
        steps(&slow)
            .iter()
            .filter(|s| s.softness >= MEDIUM_SOFTNESS),
    );
    path.extend(slides);
    let hard = steps(&medium);
    path.extend(hard.iter().filter(|s| s.softness < MEDIUM_SOFTNESS));
    if let Some(hard) = path.last().copied() {
        path.extend(diffusion::steps(&hard, last));
    }
    path.extend(goals(outline));
    path
}

/// To the law with little sliding, then through sliding. Nothing for contacts without heat or sliding.
pub(super) fn before_sliding(outline: &Outline) -> Vec<Stage> {
    let slides = sliding::sliding(outline);
    let Some(first) = slides.first() else {
        return Vec::new();
    };
    let start = outline.start();
    let slow = Stage {
        sliding: first.sliding,
        ..*start
    };
    let mut path = vec![*start];
    path.extend(steps(&slow));
    path.extend(slides);
    path
}

/// From a Newtonian start to the law, on the mesh of the start.
fn steps(start: &Stage) -> Vec<Stage> {
    let step = |softness| Stage {
        softness,
        newtonian: false,
        cold: false,
        role: Role::Path,
        ..*start
    };
    SOFTNESS.into_iter().map(step).collect()
}

/// What a continuation ends with: the stages that are measured.
fn goals(outline: &Outline) -> impl Iterator<Item = Stage> {
    let stages = outline.in_earnest().into_iter();
    stages
        .filter(|stage| !stage.role.compares() && !stage.role.leads())
        .map(|stage| goal(outline, &stage))
}
