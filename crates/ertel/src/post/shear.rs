//! Shear of the film: stresses, rates, traction and friction power.
//!
//! ```text
//!   τ_zx at mid-film and at both walls: S τ_x, S(τ ∓ G/2)_x,  S = a p_h/R, τ and G of the closure
//!   traction coefficient = ∫τ_zx dA / load                        (Habchi 2008, eq. 4.15)
//!   friction power = ∫∫ τ·γ̇ dz dA = ∫ h S²/μ₁ ∫t·tf ds dA
//! ```

use crate::contact::{ContactKind, Scales};
use crate::film::FilmFluid;
use crate::film::cross_film::CrossFilm;
use crate::solution::{ShearFields, Traction};
use crate::solve::evaluate::{PointFields, fields_at_quadrature};
use crate::solve::sequence::StageSolution;

/// Shear of the film at one point, SI.
#[derive(Clone, Copy, Debug)]
struct PointShear {
    /// τ_zx at mid-film, plane and ball, Pa.
    stress: [f64; 3],
    /// Sizes of the whole stress vector there, Pa.
    equivalent: [f64; 3],
    /// Generalized viscosity at mid-film, Pa·s.
    viscosity: f64,
    /// Heat of friction per area, W/m².
    power: f64,
}

/// Evaluates the shear of a film.
struct Shear<'a> {
    fluid: &'a FilmFluid,
    scales: &'a Scales,
    rule: CrossFilm,
}

impl<'a> Shear<'a> {
    fn new(fluid: &'a FilmFluid, scales: &'a Scales) -> Shear<'a> {
        Shear {
            fluid,
            scales,
            rule: CrossFilm::default(),
        }
    }

    fn at(&mut self, f: &PointFields) -> PointShear {
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

/// Shear at a list of points.
pub fn fields<'p>(
    fluid: &FilmFluid,
    scales: &Scales,
    points: impl IntoIterator<Item = &'p PointFields>,
) -> ShearFields {
    let mut shear = Shear::new(fluid, scales);
    let mut fields = ShearFields::default();
    for point in points {
        let s = shear.at(point);
        fields.stress_mid.push(s.stress[0]);
        fields.stress_plane.push(s.stress[1]);
        fields.stress_ball.push(s.stress[2]);
        fields.rate_mid.push(s.equivalent[0] / s.viscosity);
        fields.generalized_viscosity.push(s.viscosity);
    }
    fields
}

/// Traction and friction of a solution.
pub fn traction(solution: &StageSolution, fluid: &FilmFluid, scales: &Scales) -> Traction {
    let (d, state) = (&solution.discretisation, &solution.state);
    let mut shear = Shear::new(fluid, scales);
    let mut force = [0.0; 3];
    let mut power = 0.0;
    let mut stress_maximum = 0.0_f64;
    let mut zone = 0.0;
    let mut beyond = [0.0; 2];
    let constant = fluid.newtonian_limits(0.0);
    for c in 0..d.contact.n_elements() {
        for (q, weight) in d.rule.weights.iter().enumerate() {
            let area = weight * d.contact.maps[c].determinant;
            let ([x, y, _], f) = fields_at_quadrature(d, state, c, q);
            let s = shear.at(&f);
            for (sum, stress) in force.iter_mut().zip(s.stress) {
                *sum += area * stress;
            }
            power += area * s.power;
            let largest = s.equivalent.into_iter().fold(0.0, f64::max);
            stress_maximum = stress_maximum.max(largest);
            if x.hypot(y) < 1.0 {
                zone += area;
                let limits = if fluid.limits_depend_on_pressure() {
                    fluid.newtonian_limits(f.pressure)
                } else {
                    constant
                };
                for (sum, limit) in beyond.iter_mut().zip(limits) {
                    if limit.is_some_and(|l| largest > l) {
                        *sum += area;
                    }
                }
            }
        }
    }
    // The half domain of circular contacts stands for both.
    let area = match d.contact.kind {
        ContactKind::Circular => 2.0 * scales.length * scales.length,
        ContactKind::Line => scales.length,
    };
    let load = scales.load * scales.pressure;
    let [mid, plane, ball] = force;
    let share = |k: usize| constant[k].map(|_| beyond[k] / zone);
    Traction {
        coefficient: mid / load,
        coefficient_plane: plane / load,
        coefficient_ball: ball / load,
        force: mid * area,
        friction_power: power * area,
        shear_stress_maximum: stress_maximum,
        beyond_first_limit: share(0),
        beyond_second_limit: share(1),
    }
}
