//! Shear of the film: stresses, rates, traction and friction power.
//!
//! ```text
//!   τ_zx at mid-film and at both walls: S τ_x, S(τ ∓ G/2)_x,  S = a p_h/R, τ and G of the closure
//!   traction coefficient = ∫τ_zx dA / load                        (Habchi 2008, eq. 4.15)
//!   friction power = ∫∫ τ·γ̇ dz dA = ∫ h S²/μ₁ ∫t·tf ds dA
//! ```

use std::f64::consts::PI;

use rayon::prelude::*;

use super::discretisation::Discretisation;
use super::evaluate::{PointFields, fields_at_quadrature};
use super::system::State;
use crate::contact::{ContactKind, Scales};
use crate::film::FilmFluid;
use crate::film::cross_film::CrossFilm;
use crate::solution::BeyondEdges;
use crate::solve::discretisation::Extents;

/// Shear of the film at one point, SI.
#[derive(Clone, Copy, Debug)]
pub struct PointShear {
    /// τ_zx at mid-film, plane and ball, Pa.
    pub stress: [f64; 3],
    /// Sizes of the whole stress vector there, Pa.
    pub equivalent: [f64; 3],
    /// Generalized viscosity at mid-film, Pa·s.
    pub viscosity: f64,
    /// Heat of friction per area, W/m².
    pub power: f64,
}

/// Evaluates the shear of a film.
pub struct Shear<'a> {
    fluid: &'a FilmFluid,
    scales: &'a Scales,
    rule: CrossFilm,
}

impl<'a> Shear<'a> {
    /// Of a fluid.
    pub fn new(fluid: &'a FilmFluid, scales: &'a Scales) -> Shear<'a> {
        Shear {
            fluid,
            scales,
            rule: CrossFilm::default(),
        }
    }

    /// Shear at a point.
    pub fn at(&mut self, f: &PointFields) -> PointShear {
        let fluid = self.fluid.local(f.pressure, f.temperature.as_ref());
        let mu = fluid.point().viscosity[0];
        let (g, omega) = fluid.demands(f.pressure_gradient, f.film);
        let film = fluid.flow(g, omega, &mut self.rule);
        let mid = film.mid_stress;
        let scale = self.fluid.stress_scale();
        let at = |s: f64| [0, 1].map(|i| scale * (mid[i] + s * g[i]));
        let stresses = [at(0.0), at(-0.5), at(0.5)];
        let viscosity = mu * self.scales.viscosity;
        let squared = mid[0] * mid[0] + mid[1] * mid[1];
        PointShear {
            stress: stresses.map(|t| t[0]),
            equivalent: stresses.map(|t| t[0].hypot(t[1])),
            viscosity: viscosity / fluid.relative_fluidity(0.0, squared),
            power: f.film * self.scales.film * scale * scale / viscosity * film.work,
        }
    }
}

/// Integrals of the shear over the contact area, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Friction {
    /// Traction coefficients from the stress at mid-film, plane and ball.
    pub coefficients: [f64; 3],
    /// Traction force at mid-film, N or N/m.
    pub force: f64,
    /// Heat of friction, W or W/m.
    pub power: f64,
    /// Largest shear stress anywhere in the film, Pa.
    pub stress_maximum: f64,
    /// Shares of the Hertz zone where the stress is beyond each Newtonian limit of the fluid; `None` where it has
    /// no such limit.
    pub beyond: [Option<f64>; 2],
}

/// The sums that they are made of, over some elements.
#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    force: [f64; 3],
    power: f64,
    stress_maximum: f64,
    zone: f64,
    beyond: [f64; 2],
}

impl Sums {
    fn and(self, other: Sums) -> Sums {
        Sums {
            force: [0, 1, 2].map(|k: usize| self.force[k] + other.force[k]),
            power: self.power + other.power,
            stress_maximum: self.stress_maximum.max(other.stress_maximum),
            zone: self.zone + other.zone,
            beyond: [0, 1].map(|k: usize| self.beyond[k] + other.beyond[k]),
        }
    }
}

/// Traction and friction of a state.
pub fn friction(d: &Discretisation, state: &State, fluid: &FilmFluid, scales: &Scales) -> Friction {
    let constant = fluid.newtonian_limits(0.0);
    let of_element = |shear: &mut Shear, c: usize| {
        let mut sums = Sums::default();
        for (q, weight) in d.rule.weights.iter().enumerate() {
            let area = weight * d.contact.maps[c].determinant;
            let ([x, y, _], f) = fields_at_quadrature(d, state, c, q);
            let s = shear.at(&f);
            for (sum, stress) in sums.force.iter_mut().zip(s.stress) {
                *sum += area * stress;
            }
            sums.power += area * s.power;
            let largest = s.equivalent.into_iter().fold(0.0, f64::max);
            sums.stress_maximum = sums.stress_maximum.max(largest);
            if x.hypot(y) < 1.0 {
                sums.zone += area;
                let limits = if fluid.limits_depend_on_pressure() {
                    fluid.newtonian_limits(f.pressure)
                } else {
                    constant
                };
                for (sum, limit) in sums.beyond.iter_mut().zip(limits) {
                    if limit.is_some_and(|l| largest > l) {
                        *sum += area;
                    }
                }
            }
        }
        sums
    };
    // Added up in order: the sums do not depend on the threads.
    let elements: Vec<Sums> = (0..d.contact.n_elements())
        .into_par_iter()
        .with_min_len(BATCH)
        .map_init(|| Shear::new(fluid, scales), of_element)
        .collect();
    let sums = elements.into_iter().fold(Sums::default(), Sums::and);
    let area = scales.area(d.contact.kind);
    let load = scales.load * scales.pressure;
    Friction {
        coefficients: sums.force.map(|force| force / load),
        force: sums.force[0] * area,
        power: sums.power * area,
        stress_maximum: sums.stress_maximum,
        beyond: [0, 1].map(|k: usize| constant[k].map(|_| sums.beyond[k] / sums.zone)),
    }
}

/// What rolling drags along between the edges r_0 of the contact area and the distance r_1 to which it would go without being set by hand, where the
/// surfaces are parabolas and rigid:
///
/// ```text
///   P = −c λ X/H²,  X < 0:   ∫½H ∂P/∂X dA = πcλ ln(r_1/r_0),  H = r²/2,  c = 1/5    around a sphere
///                                         = 3cλ (1/r_0 − 1/r_1),  H = X²/2,  c = 1/3    along a cylinder
/// ```
/// (Kapitza 1955). Around a sphere it grows without end: how much oil there is tells how much friction.
pub fn beyond_edges(
    kind: ContactKind,
    extents: &Extents,
    reach: [f64; 2],
    stress_scale: f64,
    scales: &Scales,
) -> BeyondEdges {
    let radius = scales.length * scales.length / scales.film;
    let edge = extents.inlet.abs();
    let (further, full) = match kind {
        ContactKind::Circular => (
            (reach[0] / edge).max(reach[1] / extents.side),
            2.0 * scales.load,
        ),
        ContactKind::Line => (reach[0] / edge, scales.load),
    };
    if further <= 1.0 {
        return BeyondEdges::default();
    }
    let drag = scales.lambda
        * match kind {
            ContactKind::Circular => 0.2 * PI * further.ln(),
            ContactKind::Line => (1.0 - 1.0 / further) / edge,
        };
    let area = match kind {
        ContactKind::Circular => scales.length * scales.length,
        ContactKind::Line => scales.length,
    };
    let speed = scales.lambda * scales.length.powi(3) * scales.pressure
        / (12.0 * scales.viscosity * radius * radius);
    let force = drag * stress_scale * area;
    BeyondEdges {
        traction: drag * stress_scale / (full * scales.pressure),
        // Of both walls, at the mean speed.
        power: 2.0 * force * speed,
        cut: 1.0 - 1.0 / further,
    }
}

/// Elements that a thread takes at a time.
const BATCH: usize = 16;
