//! The quantities that continuations change, one at a time.
//!
//! ```text
//!   diffusion   ρ_id                                smooths sharp spikes; nothing for incompressible fluids, whose ∂ρ̄/∂P is zero
//!   exponent    μ̄^θ                                 a fluid that pressure thickens less, for spikes of many decades of viscosity
//!   softness    γ̇ ~ e^{(τ/τ_L − r₁)/ε}              a law whose shear rate grows less steeply with the stress: ε from 0.75 to 0.001 where stress is limited,
//!               γ̇ = (τ₀/μ₁) sinh(τ/τ₀)              τ₀ from 27 times to that of the case after Eyring
//!   sliding     u = u_e ± θ Δu/2                    heat grows roughly with θ²
//!   speed       λ                                   films that are thick at the steep ends of a roller, too
//! ```
//! A bound of the stress is sharpened like those of interior-point methods (Nocedal and Wright 2006, chapter 19).

use crate::solution::Role;
use crate::solve::sequence::stage::Stage;
use crate::solve::tuning::continuation::{
    DIFFUSION, EXPONENTS, FILM_EXPONENT, NEAR, SLIDING, SOFTNESS, SPEEDS,
};

/// A quantity that a continuation changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Knob {
    /// Isotropic diffusion ρ_id.
    Diffusion,
    /// Exponent of the viscosity.
    Exponent,
    /// Softness of an exponential shear law.
    Softness,
    /// Share of the sliding.
    Sliding,
    /// Number λ of Reynolds' equation, and the film that goes with the speed.
    Speed,
}

impl Knob {
    pub const ALL: [Knob; 5] = [
        Knob::Diffusion,
        Knob::Exponent,
        Knob::Softness,
        Knob::Sliding,
        Knob::Speed,
    ];

    /// Its values from step to step; of speeds multiples of the case's.
    pub fn values(self) -> &'static [f64] {
        match self {
            Knob::Diffusion => &DIFFUSION,
            Knob::Exponent => &EXPONENTS,
            Knob::Softness => &SOFTNESS,
            Knob::Sliding => &SLIDING,
            Knob::Speed => &SPEEDS,
        }
    }

    /// Its value in a stage.
    pub fn of(self, stage: &Stage) -> f64 {
        match self {
            Knob::Diffusion => stage.constants.isotropic_diffusion,
            Knob::Exponent => stage.viscosity_exponent,
            Knob::Softness => stage.softness,
            Knob::Sliding => stage.sliding,
            Knob::Speed => stage.constants.lambda,
        }
    }

    /// A stage with another value of it.
    pub fn set(self, mut stage: Stage, value: f64) -> Stage {
        match self {
            Knob::Diffusion => stage.constants.isotropic_diffusion = value,
            Knob::Exponent => stage.viscosity_exponent = value,
            Knob::Softness => (stage.softness, stage.newtonian) = (value, false),
            Knob::Sliding => stage.sliding = value,
            Knob::Speed => {
                stage.constants.film_scale *= (value / stage.constants.lambda).powf(FILM_EXPONENT);
                stage.constants.lambda = value;
            }
        }
        stage
    }

    /// Where it comes from in a step: a Newtonian fluid is softer than any, and heat begins with little sliding.
    fn before(self, from: &Stage, to: &Stage) -> f64 {
        match self {
            Knob::Softness if from.newtonian && !to.newtonian => {
                SOFTNESS[0] * SOFTNESS[0] / SOFTNESS[1]
            }
            Knob::Sliding if from.heated != to.heated => 0.0,
            _ => self.of(from),
        }
    }

    /// Half of the way between two values.
    fn between(self, from: f64, to: f64) -> f64 {
        match self {
            Knob::Exponent | Knob::Sliding => 0.5 * (from + to),
            Knob::Diffusion | Knob::Softness | Knob::Speed => (from * to).sqrt(),
        }
    }
}

/// Half of a continuation step that was too long, if its halves differ enough.
pub fn halfway(from: &Stage, to: &Stage) -> Option<Stage> {
    let mut half = *to;
    for knob in Knob::ALL {
        let (start, end) = (knob.before(from, to), knob.of(to));
        if start != end {
            half = knob.set(half, knob.between(start, end));
        }
    }
    let is_near = |knob: Knob| {
        let (half, end) = (knob.of(&half), knob.of(to));
        half.max(end) <= NEAR[knob as usize] * half.min(end)
    };
    let near = Knob::ALL.into_iter().all(is_near);
    (to.role == Role::Path && !near).then_some(half)
}
