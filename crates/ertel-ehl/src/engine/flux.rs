//! Flow of lubricant along the film.

use super::PointFields;
use crate::contact::Planar;
use crate::film::FilmFluid;
use crate::film::cross_film::CrossFilm;

/// Mass flow per width at a point, over ρ_R u_m a²/R:
///
/// ```text
///   m = ρ̄(H − F)ū − 12ρ̄H²/(μ̄λ) q(G, Ω)      F the missing oil of the gap, q the flow of the closure
/// ```
pub fn mass_flux(
    fluid: &FilmFluid,
    lambda: f64,
    entrainment: &Planar,
    f: &PointFields,
) -> [f64; 2] {
    let local = fluid.local(f.pressure, f.temperature.as_deref());
    let (rho, mu) = (local.point().density[0], local.point().viscosity[0]);
    let (g, omega) = local.demands(f.place, f.pressure_gradient, f.flowing());
    let flow = local.flow(g, omega, &mut CrossFilm::default()).flow;
    let factor = 12.0 * rho * f.flowing().powi(2) / (mu * lambda);
    let mean = entrainment.at(f.place);
    [0, 1].map(|i: usize| rho * (f.flowing() - f.missing) * mean[i] - factor * flow[i])
}
