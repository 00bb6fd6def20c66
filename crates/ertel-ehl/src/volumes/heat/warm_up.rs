//! The temperature-dependent coefficients of the film equation from temperatures across the film.

use rayon::prelude::*;

use super::warmth::Warmth;
use crate::film::closure::flow;
use crate::film::cross_film::CrossFilm;
use crate::film::{FilmFluid, MOST_NODES};
use crate::volumes::grid::slopes;
use crate::volumes::node::Node;
use crate::volumes::system::System;
use crate::volumes::thinning::Demand;

/// Pressure stress, in the stress of sliding, at which its effect on the flow is measured.
const SMALL: f64 = 1e-2;

/// The same in stresses of a film of one p_h over the half-width, where nothing slides.
const NO_STRESS: f64 = 1e-6;

/// Nodes that a thread takes at a time.
const BATCH: usize = 64;

/// Of all nodes of a grid at pressures and films, with the temperatures of the film.
pub fn warmth(
    system: &System,
    pressure: &[f64],
    films: &[f64],
    film_temperatures: &[f64],
) -> Vec<Warmth> {
    let all = at(system, (pressure, films), film_temperatures, |_| true);
    all.into_iter().flatten().collect()
}

/// Of selected nodes.
pub(super) fn at(
    system: &System,
    (pressure, films): (&[f64], &[f64]),
    film_temperatures: &[f64],
    wanted: impl Fn(usize) -> bool + Sync,
) -> Vec<Option<Warmth>> {
    let grid = &system.grid;
    let f = film_temperatures.len() / grid.n_nodes();
    let of_node = |rule: &mut CrossFilm, k: usize| {
        let mut profile = [0.0; MOST_NODES];
        profile[..f].copy_from_slice(&film_temperatures[k * f..][..f]);
        let [i, j] = [k % grid.n[0], k / grid.n[0]];
        let gradient = slopes(grid, pressure, i, j);
        let slide = grid.turn.to_axes(system.fluid.slide().at(grid.place(i, j)));
        let place = (pressure[k], films[k], grid.spacing[0]);
        of_film(
            &system.fluid,
            place,
            gradient,
            slide,
            &profile,
            system.lambda,
            rule,
        )
    };
    (0..grid.n_nodes())
        .into_par_iter()
        .with_min_len(BATCH)
        .map_init(CrossFilm::default, |rule, k| {
            wanted(k).then(|| of_node(rule, k))
        })
        .collect()
}

/// Of a film at a pressure and a thickness on a grid with cells of a size.
pub fn of_film(
    fluid: &FilmFluid,
    (pressure, film, cell): (f64, f64, f64),
    gradient: [f64; 2],
    slide: [f64; 2],
    profile: &crate::film::Nodal,
    lambda: f64,
    rule: &mut CrossFilm,
) -> Warmth {
    let mean = fluid
        .nodes()
        .map_or(profile[0], |nodes| nodes.mean(profile));
    let thermal = fluid.thermal_values(pressure, profile);
    let point = fluid.at_temperature(pressure, mean);
    let ([rho, ..], [mu, mu_p, _]) = (point.density, point.viscosity);
    let node = Node {
        pressure,
        film,
        ln_viscosity: [mu.ln(), mu_p / mu],
        ..Node::default()
    };
    let mut warmth = Warmth {
        temperature: mean,
        density: thermal.density.by_p[0] / rho,
        flow: [1.0; 2],
        drift: [0.0; 2],
    };
    let demand = Demand::new(&node, cell, gradient, slide);
    let standing = thermal.viscosity[0];
    let omega = demand.omega * standing / mu;
    let law = fluid.thermal_law(pressure, &thermal);
    let weight = |s: f64| thermal.moment_weight.by_p[0].at(s);
    let without = flow(&law, weight, [0.0; 2], [omega, 0.0], rule);
    let stress = without.mid_stress[0].hypot(without.mid_stress[1]);
    let least = (SMALL * stress).max(NO_STRESS);
    let [_, largest] = fluid
        .stresses_between(pressure, crate::volumes::thinning::MAX_LN_FLUIDITY)
        .unwrap_or([0.0, f64::INFINITY]);
    let g = demand.gradient.map(|g| match g.abs() {
        size if size < least => least.copysign(g),
        size => size.min(2.0 * largest).copysign(g),
    });
    let with = flow(&law, weight, g, [omega, 0.0], rule);
    let uniform = fluid
        .local(pressure, None)
        .flow(g, [demand.omega, 0.0], rule);
    for d in 0..2 {
        let factor = (with.flow[d] - without.flow[d]) / uniform.flow[d] * (mu / standing);
        if factor.is_finite() && factor > 0.0 {
            warmth.flow[d] = factor;
        }
    }
    let by_flow = -12.0 * demand.film / (standing * lambda);
    let drift = [by_flow * without.flow[0], by_flow * without.flow[1]];
    if drift.iter().all(|u| u.is_finite()) {
        let [c, s] = demand.direction;
        warmth.drift = [c * drift[0] - s * drift[1], s * drift[0] + c * drift[1]];
    }
    warmth
}
