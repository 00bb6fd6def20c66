//! Mass balance of the film, checked with fluxes that the solver does not use.

use crate::film::FilmFluid;
use crate::solve::discretisation::Discretisation;
use crate::solve::evaluate::fields_at;
use crate::solve::system::State;

/// Relative mass balance between the inlet edge and the section X = 0:
/// (inflow − side leakage − flow through the section)/inflow.
///
/// Mass flux m = ρ̄H e_x − ε∇P from the discrete gradients, integrated along the three lines by
/// composite Gauss quadrature.
pub fn film_balance_error(d: &Discretisation, state: &State, fluid: &FilmFluid, lambda: f64) -> f64 {
    let e = &d.contact.extents;
    let flux = |x: f64, y: f64| -> [f64; 2] {
        let Some(f) = fields_at(d, state, [x, y]) else { return [f64::NAN; 2] };
        let properties = fluid.at(f.pressure);
        let (rho, mu) = (properties.density[0], properties.viscosity[0]);
        let epsilon = rho * f.film.powi(3) / (mu * lambda);
        [rho * f.film - epsilon * f.pressure_gradient[0], -epsilon * f.pressure_gradient[1]]
    };
    if d.contact.surface.dim == 1 {
        let inflow = flux(e.inlet, 0.0)[0];
        return (inflow - flux(0.0, 0.0)[0]) / inflow;
    }
    let inflow = integrate(-e.side, 0.0, |y| flux(e.inlet, y)[0]);
    let section = integrate(-e.side, 0.0, |y| flux(0.0, y)[0]);
    let leakage = -integrate(e.inlet, 0.0, |x| flux(x, -e.side)[1]);
    (inflow - leakage - section) / inflow
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
