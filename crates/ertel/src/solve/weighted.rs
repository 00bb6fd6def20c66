//! Residuals of one state under many slightly different equations, weighted: what sensitivities are made of.
//!
//! ```text
//!   z·R(q; θ)      for weights z at the pressure nodes, fields q, and inputs θ
//! ```
//! Fields and weights are interpolated once for all equations; no derivatives are taken.

use rayon::prelude::*;

use super::discretisation::Discretisation;
use super::element::Metric;
use super::system::{FilmConstants, State};
use crate::contact::OilLayer;
use crate::film::FilmFluid;
use crate::film::cross_film::CrossFilm;
use crate::forms::flow::{
    PointSliding, PointState, Properties, generalized, newtonian, pressure_stress, sliding_stress,
};
use crate::forms::reynolds::reynolds_point;

/// The film equations of one problem.
pub struct Equations {
    /// Its fluid.
    pub fluid: FilmFluid,
    /// Coefficients of the Reynolds equation.
    pub constants: FilmConstants,
    /// The layer of oil that arrives, if that is less than the contact takes.
    pub oil_layer: Option<OilLayer>,
}

/// Values of a test function: W, W_x, W_y, ΔW, κW.
const N_TEST: usize = 5;

/// Elements that a thread takes at a time.
const BATCH: usize = 32;

/// z·R for each of the equations and, within them, each list of weights at all pressure nodes (zero on the edge). Isothermal films only.
pub fn weighted_residuals(
    d: &Discretisation,
    state: &State,
    weights: &[&[f64]],
    equations: &[Equations],
) -> Vec<Vec<f64>> {
    let n_sums = weights.len() * equations.len();
    let batches = d.contact.n_elements().div_ceil(BATCH);
    // Added up in order: the sums do not depend on the threads.
    let sums: Vec<Vec<f64>> = (0..batches)
        .into_par_iter()
        .map_init(CrossFilm::default, |rule, batch| {
            let mut sums = vec![0.0; n_sums];
            let last = (BATCH * (batch + 1)).min(d.contact.n_elements());
            for c in BATCH * batch..last {
                let points = Points::new(d, state, weights, c);
                for (equations, sums) in equations.iter().zip(sums.chunks_exact_mut(weights.len()))
                {
                    points.add(d, equations, rule, sums);
                }
            }
            sums
        })
        .collect();
    let mut total = vec![0.0; n_sums];
    for batch in sums {
        total.iter_mut().zip(batch).for_each(|(t, s)| *t += s);
    }
    (total.chunks_exact(weights.len()))
        .map(<[f64]>::to_vec)
        .collect()
}

/// Fields and weights at the quadrature points of an element.
struct Points {
    element: usize,
    fields: Vec<([f64; 2], PointState<f64>)>,
    /// Point by point, the values of each list of weights, with the weight of the point.
    tests: Vec<[f64; N_TEST]>,
}

impl Points {
    fn new(d: &Discretisation, state: &State, weights: &[&[f64]], c: usize) -> Points {
        let metric = Metric::new(&d.contact.maps[c]);
        let (n, m) = (d.pressure_table.n_nodes, d.deflection_table.n_nodes);
        let (nodes, below) = (d.pressure.nodes_of(c), d.contact.deflection.nodes_of(c));
        let mut fields = Vec::with_capacity(d.rule.len());
        let mut tests = Vec::with_capacity(d.rule.len() * weights.len());
        for (q, weight) in d.rule.weights.iter().enumerate() {
            let table = &d.pressure_table;
            let at_nodes = |values: &[f64]| {
                let mut sums = [0.0; 8];
                for (j, node) in nodes.iter().enumerate() {
                    let (k, v) = (q * n + j, values[*node as usize]);
                    let [gx, gy] = metric.gradient(&table.gradients[k]);
                    let [xx, xy, yy] = metric.second(&table.hessians[k]);
                    let basis = [
                        table.values[k],
                        gx,
                        gy,
                        metric.laplacian(&table.hessians[k]),
                        d.pressure_unseen[k],
                        xx,
                        xy,
                        yy,
                    ];
                    sums.iter_mut().zip(basis).for_each(|(s, b)| *s += v * b);
                }
                sums
            };
            let p = at_nodes(&state.pressure);
            let area = weight * d.contact.maps[c].determinant;
            for list in weights {
                let z = at_nodes(list);
                tests.push([0, 1, 2, 3, 4].map(|k: usize| area * z[k]));
            }
            let table = &d.deflection_table;
            let (mut place, mut film) = ([0.0; 2], [state.rigid_separation, 0.0, 0.0]);
            for (j, node) in below.iter().enumerate() {
                let (k, v) = (q * m + j, state.deflection[*node as usize]);
                let [gx, gy] = metric.gradient(&table.gradients[k]);
                let basis = [table.values[k], gx, gy];
                film.iter_mut().zip(basis).for_each(|(s, b)| *s += v * b);
                for (x, at) in place
                    .iter_mut()
                    .zip(d.contact.deflection.points[*node as usize])
                {
                    *x += table.values[k] * at;
                }
            }
            let gap = &d.contact.shape.gap;
            let slopes = gap.gradient(place);
            fields.push((
                place,
                PointState {
                    pressure: p[0],
                    pressure_gradient: [p[1], p[2]],
                    pressure_unseen: p[4],
                    pressure_curvature: [p[5], p[6], p[7]],
                    film: film[0] + gap.value(place),
                    film_gradient: [film[1] + slopes[0], film[2] + slopes[1]],
                },
            ));
        }
        Points {
            element: c,
            fields,
            tests,
        }
    }

    /// Adds this element's share of z·R, for each list of weights.
    fn add(&self, d: &Discretisation, e: &Equations, rule: &mut CrossFilm, sums: &mut [f64]) {
        let (size, order) = (d.contact.sizes[self.element], d.pressure.element.order());
        let local = e.constants.on_element(size, order, e.oil_layer);
        let tests = self.tests.chunks_exact(sums.len());
        for ((place, s), tests) in self.fields.iter().zip(tests) {
            let m = Properties::around(s.pressure, &e.fluid.at(s.pressure));
            let flow = match e.fluid.is_newtonian() {
                true => newtonian(s, &m, local.lambda),
                false => {
                    let slide = PointSliding::new(e.fluid.slide(), *place);
                    let (g, omega) = (pressure_stress(s), sliding_stress(s, &m, slide.value));
                    let closure = e.fluid.close(s.pressure, g, omega, rule);
                    generalized(s, &m, local.lambda, &slide, &closure)
                }
            };
            let velocity = local.entrainment.at(*place);
            let t = reynolds_point(s, &m, &flow, &local, velocity, 0.0);
            let value = [t.value, t.gradient[0], t.gradient[1], t.laplacian, t.unseen];
            for (sum, test) in sums.iter_mut().zip(tests) {
                *sum += value.iter().zip(test).map(|(v, t)| v * t).sum::<f64>();
            }
        }
    }
}
