//! The pressure gradient that drives a fixed flow through a film whose temperatures change.
//!
//! ```text
//!   t(s) = τ + sκG,   ∫ tφ ds = Ω,   κΨ = Ψ₀               φ = f(|t|²)/μ̄(T(s)), G = H∇P
//!   Ψ = ∫ (s − s̄)² φ ds,   s̄ = ∫ sφ ds/∫ φ ds                 conductance: q = κGΨ where f is one
//! ```
//! While temperatures are computed for given films, pressures would be fixed, too. But at a given pressure gradient a warm
//! layer shears faster and heats up further, whereas in the contact mass is conserved: the flow through the gap is given by the
//! motion, and a less viscous film needs a smaller pressure gradient. So the flow that the pressure drives is held at that of the last
//! films (Ψ₀, of their temperatures) instead of the gradient, which changes by κ. Once film and heat agree κ is one.
//!
//! Theory: The flow is held.

use super::Heights;
use crate::film::closure::{dot, mid_stress, solve};
use crate::film::cross_film::CrossFilm;
use crate::film::fluidity::Fluidity;
use crate::film::{MOST_NODES, Nodal};

/// A film that is driven by a share of its pressure gradient.
pub(super) struct Driven<'a, L> {
    /// Its fluidity over that of the viscosity below.
    pub law: &'a L,
    /// The law at each height.
    pub factors: &'a Nodal,
    pub heights: &'a Heights,
    /// G.
    pub gradient: [f64; 2],
    /// Ω for that viscosity.
    pub slide: [f64; 2],
    /// Viscosity to which fluidities are relative, over μ_R.
    pub viscosity: f64,
}

/// The flow at a share of the pressure gradient.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Flow {
    /// κ.
    pub factor: f64,
    /// τ.
    pub mid_stress: [f64; 2],
    /// ∂τ/∂κ.
    pub mid_stress_slope: [f64; 2],
    /// Ψ.
    pub conductance: f64,
    /// ∂Ψ/∂ln κ.
    pub conductance_slope: f64,
    /// (s − s̄)² times the weight of each height, over the viscosity.
    pub weights: Nodal,
}

/// Newton iterations at most, and the change of ln κ that ends them.
const MOST_ITERATIONS: usize = 40;
const CLOSE: f64 = 1e-9;

impl<L: Fluidity> Driven<'_, L> {
    /// The flow at a share of the pressure gradient.
    #[inline(always)]
    pub fn at(&self, factor: f64, rule: &mut CrossFilm) -> Flow {
        let n = self.heights.n();
        let full = self.gradient;
        let g = full.map(|g| factor * g);
        let tau = mid_stress(self.law, g, self.slide, rule);
        let (mut moments, mut stiffness, mut pull) = ([0.0; 2], [0.0; 3], [0.0; 2]);
        let mut fluidity = [0.0; MOST_NODES];
        let mut curved = [0.0; MOST_NODES];
        for k in 0..n {
            let (s, w) = (self.heights.points()[k], self.heights.weights()[k]);
            let t = [0, 1].map(|i: usize| tau[i] + s * g[i]);
            let [f, by_square] = self.law.slope(dot(t, t)).map(|v| self.factors[k] * v);
            (fluidity[k], curved[k]) = (f, 2.0 * by_square);
            moments[0] += w * f;
            moments[1] += w * s * f;
            let (value, slope) = (w * f, w * 2.0 * by_square);
            let tensor = [
                value + slope * t[0] * t[0],
                slope * t[0] * t[1],
                value + slope * t[1] * t[1],
            ];
            for (sum, v) in stiffness.iter_mut().zip(tensor) {
                *sum += v;
            }
            pull[0] -= s * (tensor[0] * full[0] + tensor[1] * full[1]);
            pull[1] -= s * (tensor[1] * full[0] + tensor[2] * full[1]);
        }
        let centre = moments[1] / moments[0];
        let mut flow = Flow {
            factor,
            mid_stress: tau,
            mid_stress_slope: solve(stiffness, pull),
            ..Flow::default()
        };
        for k in 0..n {
            let s = self.heights.points()[k];
            let weight = self.heights.weights()[k] * (s - centre).powi(2) / self.viscosity;
            let t = [0, 1].map(|i: usize| tau[i] + s * g[i]);
            let along = [0, 1].map(|i: usize| flow.mid_stress_slope[i] + s * full[i]);
            flow.weights[k] = weight;
            flow.conductance += weight * fluidity[k];
            flow.conductance_slope += factor * weight * curved[k] * dot(t, along);
        }
        flow
    }

    /// The flow that is held at κΨ = `conductance`.
    #[inline(always)]
    pub fn held(&self, conductance: f64, rule: &mut CrossFilm) -> Flow {
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        let mut ln_factor = 0.0_f64;
        let mut flow = self.at(1.0, rule);
        for _ in 0..MOST_ITERATIONS {
            let excess = ln_factor + (flow.conductance / conductance).ln();
            let slope = 1.0 + flow.conductance_slope / flow.conductance;
            if excess > 0.0 {
                high = ln_factor;
            } else {
                low = ln_factor;
            }
            let newton = ln_factor - excess / slope;
            let next = match newton > low && newton < high {
                true => newton,
                false if (high - low).is_finite() => 0.5 * (low + high),
                false => ln_factor - excess,
            };
            let step = (next - ln_factor).abs();
            // Not a number: the caller finds out by the heat.
            if step <= CLOSE || step.is_nan() {
                break;
            }
            ln_factor = next;
            flow = self.at(ln_factor.exp(), rule);
        }
        flow
    }
}
