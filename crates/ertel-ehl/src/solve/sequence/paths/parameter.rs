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
pub enum Parameter {
    /// Isotropic diffusion ρ_id.
    Diffusion,
    /// Exponent of the viscosity.
    Exponent,
    /// Softness of an exponential shear law.
    Softness,
    /// Share of the sliding.
    Sliding,
    /// Number λ of Reynolds' equation, and the film, which depends on the speed.
    Speed,
}

impl Parameter {
    pub const ALL: [Parameter; 5] = [
        Parameter::Diffusion,
        Parameter::Exponent,
        Parameter::Softness,
        Parameter::Sliding,
        Parameter::Speed,
    ];

    /// Its values from step to step; of speeds multiples of the case's.
    pub fn values(self) -> &'static [f64] {
        match self {
            Parameter::Diffusion => &DIFFUSION,
            Parameter::Exponent => &EXPONENTS,
            Parameter::Softness => &SOFTNESS,
            Parameter::Sliding => &SLIDING,
            Parameter::Speed => &SPEEDS,
        }
    }

    /// Its value in a stage.
    pub fn of(self, stage: &Stage) -> f64 {
        match self {
            Parameter::Diffusion => stage.constants.isotropic_diffusion,
            Parameter::Exponent => stage.viscosity_exponent,
            Parameter::Softness => stage.softness,
            Parameter::Sliding => stage.sliding,
            Parameter::Speed => stage.constants.lambda,
        }
    }

    /// A stage with another value of it.
    pub fn set(self, mut stage: Stage, value: f64) -> Stage {
        match self {
            Parameter::Diffusion => stage.constants.isotropic_diffusion = value,
            Parameter::Exponent => stage.viscosity_exponent = value,
            Parameter::Softness => (stage.softness, stage.newtonian) = (value, false),
            Parameter::Sliding => stage.sliding = value,
            Parameter::Speed => {
                stage.constants.film_scale *= (value / stage.constants.lambda).powf(FILM_EXPONENT);
                stage.constants.lambda = value;
            }
        }
        stage
    }

    /// Where it comes from in a step: a Newtonian fluid is softer than any, and heat begins with little sliding.
    fn before(self, from: &Stage, to: &Stage) -> f64 {
        match self {
            Parameter::Softness if from.newtonian && !to.newtonian => {
                SOFTNESS[0] * SOFTNESS[0] / SOFTNESS[1]
            }
            Parameter::Sliding if from.heated != to.heated => 0.0,
            _ => self.of(from),
        }
    }

    /// Midway between two values.
    fn between(self, from: f64, to: f64) -> f64 {
        match self {
            Parameter::Exponent | Parameter::Sliding => 0.5 * (from + to),
            Parameter::Diffusion | Parameter::Softness | Parameter::Speed => (from * to).sqrt(),
        }
    }
}

/// Half of a continuation step that was too long, if its halves differ enough.
pub fn halfway(from: &Stage, to: &Stage) -> Option<Stage> {
    let mut half = *to;
    for parameter in Parameter::ALL {
        let (start, end) = (parameter.before(from, to), parameter.of(to));
        if start != end {
            half = parameter.set(half, parameter.between(start, end));
        }
    }
    let is_near = |parameter: Parameter| {
        let (half, end) = (parameter.of(&half), parameter.of(to));
        half.max(end) <= NEAR[parameter as usize] * half.min(end)
    };
    let near = Parameter::ALL.into_iter().all(is_near);
    (to.role == Role::Path && !near).then_some(half)
}
