//! Mass balance of the film between its inlet and its centre.

use crate::film::cross_film::CrossFilm;
use crate::solve::evaluate::fields_at;
use crate::solve::newton::FilmModel;
use crate::solve::sequence::StageSolution;
use crate::solve::system::System;

/// Relative mass balance upstream of the section X = 0:
/// (inflow − side leakage − flow through the section)/inflow.
///
/// Inflow and leakage are the fluxes that the edge nodes take up in the weak form; the flow
/// through the section is integrated from the discrete gradients, m_x = ρ̄H − Q_x, which the
/// weak form never asks for there. Side nodes count where X < 0.
pub fn film_balance_error(solution: &StageSolution, model: &FilmModel) -> f64 {
    let (d, state) = (&solution.discretisation, &solution.state);
    let edge_flux = System::edge_flux(d, &model.fluid, &model.constants, state);
    let e = &d.contact.extents;
    let mut net_inflow = 0.0;
    let mut inflow = 0.0;
    for (flux, p) in edge_flux.iter().zip(&d.pressure.points) {
        let inlet = p[0] < e.inlet + 1e-9 * (e.outlet - e.inlet);
        if p[0] < 0.0 {
            net_inflow += flux;
        }
        if inlet {
            inflow += flux;
        }
    }
    let flux = |y: f64| {
        let Some(f) = fields_at(d, state, [0.0, y]) else {
            return f64::NAN;
        };
        let fluid = model.fluid.local(f.pressure, f.temperature.as_ref());
        let (rho, mu) = (fluid.point().density[0], fluid.point().viscosity[0]);
        let (g, omega) = fluid.demands(f.pressure_gradient, f.film);
        let flow = fluid.flow(g, omega, &mut CrossFilm::default()).flow;
        let factor = 12.0 * rho * f.film.powi(2) / (mu * model.constants.lambda);
        rho * f.film - factor * flow[0]
    };
    let section = if d.contact.surface.dim == 1 {
        flux(0.0)
    } else {
        integrate(-e.side, 0.0, flux)
    };
    (net_inflow - section) / inflow
}

/// Three-point Gauss quadrature on 200 intervals.
fn integrate(a: f64, b: f64, f: impl Fn(f64) -> f64) -> f64 {
    let n = 200;
    let h = (b - a) / n as f64;
    let s = 0.6_f64.sqrt();
    (0..n)
        .map(|i| {
            let middle = a + (i as f64 + 0.5) * h;
            let at = |t: f64| f(middle + 0.5 * h * t);
            h / 18.0 * (5.0 * at(-s) + 8.0 * at(0.0) + 5.0 * at(s))
        })
        .sum()
}
