//! Profiles across the film.
//!
//! ```text
//!   γ̇(s) = S/μ (τ + sG) f(s),   u(s) = u_1 + h∫_{−½}^s γ̇ ds',   η(s) = μ/f(s)
//! ```

use crate::contact::{Planar, Symmetry};
use crate::engine::{PointFields, Problem};
use crate::film::closure::mid_stress;
use crate::film::cross_film::CrossFilm;
use crate::film::fluidity::Fluidity;
use crate::solution::CrossProfile;

/// Equal steps across the film.
const N_STEPS: usize = 40;

/// Profiles at places in half-widths; none outside of the contact area. `fields` are those of the part that is solved.
pub fn profiles<Plan>(
    problem: &Problem<Plan>,
    fields: impl Fn([f64; 2]) -> Option<PointFields>,
    places: &[[f64; 2]],
) -> Vec<CrossProfile> {
    let Some(heat) = &problem.heat else {
        return Vec::new();
    };
    let body_1 = &heat.bodies[0].velocity;
    (places.iter())
        .filter_map(|place| profile(problem, &fields, body_1, *place))
        .collect()
}

/// Profile at a place; `body_1` is the velocity of body 1, m/s, at places in half-widths.
fn profile<Plan>(
    problem: &Problem<Plan>,
    fields: impl Fn([f64; 2]) -> Option<PointFields>,
    body_1: &Planar,
    [x, y]: [f64; 2],
) -> Option<CrossProfile> {
    let (fluid, scales) = (&problem.fluid, &problem.scales);
    // Where half of the contact is solved, y ≤ 0, the other one is its mirror image.
    let mirrored = problem.shape.symmetry == Symmetry::Half && y > 0.0;
    let fields = fields([x, if mirrored { -y } else { y }])?;
    let temperatures = fluid
        .nodes()?
        .through(&fields.temperature.as_deref()?.temperature);
    let local = fluid.local(fields.pressure, fields.temperature.as_deref());
    let law = fluid.thermal_law(fields.pressure, local.thermal()?);
    let (g, omega) = local.demands(fields.place, fields.pressure_gradient, fields.flowing());
    let tau = mid_stress(&law, g, omega, &mut CrossFilm::default());
    let viscosity = local.point().viscosity[0] * scales.viscosity;
    let h = fields.flowing() * scales.film;
    // Shear rates along X and Y, 1/s, and generalized viscosity.
    let at = |s: f64| {
        let t = [0, 1].map(|i: usize| tau[i] + s * g[i]);
        let f = law.factor(s) * law.slope(t[0] * t[0] + t[1] * t[1])[0];
        let rate = t.map(|t| fluid.stress_scale() * f * t / viscosity);
        (rate, viscosity / f)
    };
    let mut profile = CrossProfile {
        x: x * scales.length,
        y: y * scales.length,
        film_thickness: h,
        ..CrossProfile::default()
    };
    let mut velocity = body_1.at(fields.place);
    let step = 1.0 / N_STEPS as f64;
    for k in 0..=N_STEPS {
        let s = k as f64 * step - 0.5;
        if k > 0 {
            let shift = 0.5 * 0.6_f64.sqrt();
            for (place, weight) in [(-shift, 5.0 / 18.0), (0.0, 8.0 / 18.0), (shift, 5.0 / 18.0)] {
                let (rate, _) = at(s + (place - 0.5) * step);
                velocity[0] += h * step * weight * rate[0];
                velocity[1] += h * step * weight * rate[1];
            }
        }
        let (rate, viscosity) = at(s);
        profile.z.push((s + 0.5) * h);
        profile.temperature.push(temperatures.at(s));
        profile.velocity_x.push(velocity[0]);
        profile
            .velocity_y
            .push(if mirrored { -velocity[1] } else { velocity[1] });
        profile.shear_rate.push(rate[0].hypot(rate[1]));
        profile.viscosity.push(viscosity);
    }
    Some(profile)
}
