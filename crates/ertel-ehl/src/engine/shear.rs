//! Shear of the film at a point: stresses and rates.
//!
//! ```text
//!   τ_z at mid-film and at both walls: S τ, S(τ ∓ G/2),  S = a p_h/R, τ and G of the closure; along and across the motion
//! ```

use super::PointFields;
use crate::contact::Scales;
use crate::film::FilmFluid;
use crate::film::cross_film::CrossFilm;

/// Shear of the film at one point, SI.
#[derive(Clone, Copy, Debug)]
pub struct PointShear {
    /// τ_zx and τ_zy at mid-film, body 1 and body 2, Pa.
    pub stress: [[f64; 2]; 3],
    /// Sizes of the whole stress vector there, Pa.
    pub equivalent: [f64; 3],
    /// Generalized viscosity at mid-film, Pa·s.
    pub viscosity: f64,
    /// Stress at body 2 less that at body 1, h∇p, Pa.
    pub difference: [f64; 2],
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
        let fluid = self.fluid.local(f.pressure, f.temperature.as_deref());
        let mu = fluid.point().viscosity[0];
        let (g, omega) = fluid.demands(f.place, f.pressure_gradient, f.flowing());
        let film = fluid.flow(g, omega, &mut self.rule);
        let mid = film.mid_stress;
        let scale = self.fluid.stress_scale();
        let at = |s: f64| [0, 1].map(|i| scale * (mid[i] + s * g[i]));
        let stresses = [at(0.0), at(-0.5), at(0.5)];
        let viscosity = mu * self.scales.viscosity;
        let squared = mid[0] * mid[0] + mid[1] * mid[1];
        PointShear {
            stress: stresses,
            equivalent: stresses.map(|t| t[0].hypot(t[1])),
            viscosity: viscosity / fluid.relative_fluidity(0.0, squared),
            difference: g.map(|g| scale * g),
            power: f.flowing() * self.scales.film * scale * scale / viscosity * film.work,
        }
    }
}
