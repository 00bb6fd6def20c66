//! Mass balance of the film between its inlet and its centre.
//!
//! Theory: Mass balance.

use crate::contact::Symmetry;
use crate::engine::flux::mass_flux;
use crate::solve::newton_level::FilmModel;
use crate::solve::points::fields_at;
use crate::solve::sequence::StageSolution;
use crate::solve::state::FilmConstants;
use crate::solve::system::System;

/// Relative mass balance upstream of the section along the second axis of the Hertz zone, X = 0 where the motion is along the first:
/// (inflow − side leakage − flow through the section)/inflow.
///
/// Inflow and leakage are the reactions of the edge nodes in the weak form; the flow
/// through the section is integrated from the discrete gradients, m_x = ρ̄θH − Q_x, which the
/// weak form does not use there. Side nodes count upstream of it.
pub fn film_balance_error(solution: &StageSolution, model: &FilmModel) -> f64 {
    let (d, state) = (&solution.discretisation, &solution.state);
    let edge_flux = System::edge_flux(d, &model.fluid, &model.constants, state);
    let (e, zone) = (&d.contact.extents, &d.contact.shape.zone);
    let mut net_inflow = 0.0;
    let mut inflow = 0.0;
    for (flux, p) in edge_flux.iter().zip(&d.pressure.points) {
        let [x, _] = zone.unit([p[0], p[1]]);
        if x < 0.0 {
            net_inflow += flux;
        }
        if x < e.inlet + 1e-9 * (e.outlet - e.inlet) {
            inflow += flux;
        }
    }
    // Across the section x = 0 of the mesh, times its length for each y over the axis ratio.
    let normal = match zone.turn.is_none() {
        true => [1.0, 0.0],
        false => {
            let [x, y] = zone.place([0.0, 1.0]);
            [y / zone.axis_ratio, -x / zone.axis_ratio]
        }
    };
    let flux = |y: f64| {
        let at = zone.place([0.0, y]);
        let Some(f) = fields_at(d, state, at) else {
            return f64::NAN;
        };
        let FilmConstants {
            lambda,
            entrainment,
            ..
        } = &model.constants;
        let [along, across] = mass_flux(&model.fluid, *lambda, entrainment, &f);
        let stretch = match &zone.roller {
            None => 1.0,
            Some(roller) => roller.stretch(roller.place(y)),
        };
        stretch * (along * normal[0] + across * normal[1])
    };
    let section = match (d.contact.surface.dim, d.contact.shape.symmetry) {
        (1, _) => flux(0.0),
        (_, Symmetry::Half) => zone.axis_ratio * integrate(-e.side, 0.0, flux),
        (_, Symmetry::Full) => {
            zone.axis_ratio * (integrate(-e.side, 0.0, flux) + integrate(0.0, e.side, flux))
        }
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
