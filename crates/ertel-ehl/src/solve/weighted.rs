//! Residuals of one state under many slightly different equations, weighted, and the traction in them, for sensitivities.
//!
//! ```text
//!   L = z·R(q; u, m),  ∫θ τ_x dA      for weights z at the pressure nodes and fields q
//!   L(u, m) ≈ L + ∂L/∂u (u − u_own) + ∫∂L/∂m (m − m_own)
//! ```
//! u are the numbers that the equations have everywhere, m = (ρ̄, ρ̄', μ̄, μ̄') the properties at each point. Derivatives by u are central
//! differences, one pair for each number that differs anywhere; those by m are exact. So inputs cost what they change: those that act by
//! scales alone next to nothing. The flow across the film is solved for once; for other u it is that to first order (see
//! [`crate::film::nearby`]).

use rayon::prelude::*;

use super::discretisation::Discretisation;
use super::element::Metric;
use super::points::{point_state, pressure_sums};
use super::region::{Elements, Share};
use super::state::{FilmConstants, State};
use super::streams::Streams;
use crate::contact::{OilLayer, Planar};
use crate::engine::region::Region;
use crate::film::cross_film::CrossFilm;
use crate::film::nearby::{self, Nearby};
use crate::film::{Closure, FilmFluid, PointFluid};
use crate::forms::dual::{Dual, Number};
use crate::forms::flow::{
    PointSliding, PointState, Properties, generalized, newtonian, pressure_stress, sliding_stress,
};
use crate::forms::oil_layer::missing;
use crate::forms::reynolds::{ElementConstants, reynolds_point};

/// The film equations of one problem.
#[derive(Clone)]
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

/// Weighted integrals of one problem's equations.
#[derive(Clone, Debug)]
pub struct WeightedSums {
    /// z·R for each list of weights.
    pub residuals: Vec<f64>,
    /// ∫θ τ_x dA of the stress at mid-film, over the part that is solved, in a p_h/R of the problem and half-widths.
    pub traction: f64,
}

/// The flow of a solution across its film at a quadrature point.
pub struct PointFlow {
    /// Fields there.
    pub state: PointState<f64>,
    /// Density and viscosity there.
    pub fluid: PointFluid,
    /// Ω.
    pub sliding_stress: [f64; 2],
    /// Closure for it.
    pub closure: Closure,
    /// H where its stream left the film, where the film has broken.
    pub left: Option<f64>,
}

/// Flow across the film at each quadrature point, element by element. Isothermal films only.
pub fn point_flows(
    d: &Discretisation,
    state: &State,
    fluid: &FilmFluid,
    entrainment: &Planar,
) -> Vec<PointFlow> {
    let streams = Streams::new(d, state, entrainment);
    let of_element = |rule: &mut CrossFilm, c: usize| -> Vec<PointFlow> {
        let points = Points::new(d, state, &[], c);
        (points.fields.into_iter())
            .map(|(place, state)| {
                let point = fluid.at(state.pressure);
                let m = Properties::around(state.pressure, &point);
                let omega = sliding_stress(&state, &m, fluid.slide().at(place));
                let closure = fluid.close(state.pressure, pressure_stress(&state), omega, rule);
                PointFlow {
                    left: (streams.left(place, state.pressure)).filter(|film| *film < state.film),
                    state,
                    fluid: point,
                    sliding_stress: omega,
                    closure,
                }
            })
            .collect()
    };
    let elements: Vec<Vec<PointFlow>> = (0..d.contact.n_elements())
        .into_par_iter()
        .with_min_len(BATCH)
        .map_init(CrossFilm::default, of_element)
        .collect();
    elements.into_iter().flatten().collect()
}

/// The sums for each of the equations, which differ little from the solution's `own`, with each list of weights at all pressure nodes
/// (zero on the edge). `flows` are those of the solution's fluid, or none where it is Newtonian and does not slide. Isothermal films only.
pub fn weighted_sums(
    d: &Discretisation,
    state: &State,
    weights: &[&[f64]],
    (own, flows): (&Equations, &[PointFlow]),
    equations: &[Equations],
) -> Vec<WeightedSums> {
    let plan = Plan::new(own, equations);
    let n_sums = weights.len() + 1;
    let n_lists = 1 + plan.variants.len() + plan.other_laws.len();
    let batches = d.contact.n_elements().div_ceil(BATCH);
    let (elements, region) = (Elements::new(d), Region::of(&d.contact.shape));
    // Added up in order: the sums do not depend on the threads.
    let sums: Vec<Vec<f64>> = (0..batches)
        .into_par_iter()
        .map_init(CrossFilm::default, |rule, batch| {
            let mut sums = vec![0.0; n_sums * n_lists];
            let last = (BATCH * (batch + 1)).min(d.contact.n_elements());
            for c in BATCH * batch..last {
                let points =
                    Points::new(d, state, weights, c).summed_over(&elements.share(&region, c));
                let flows = flows.get(c * d.rule.len()..(c + 1) * d.rule.len());
                points.add(d, &plan, (own, flows.unwrap_or_default()), rule, &mut sums);
            }
            sums
        })
        .collect();
    let mut total = vec![0.0; n_sums * n_lists];
    for batch in sums {
        total.iter_mut().zip(batch).for_each(|(t, s)| *t += s);
    }
    plan.put_together(&total, n_sums)
}

/// Quantities evaluated at each point.
struct Plan<'a> {
    nearby: Nearby<'a>,
    /// The numbers of the solution's equations.
    own: Vec<f64>,
    /// The numbers that differ anywhere, with their step.
    moved: Vec<(usize, f64)>,
    /// The solution's equations with less and more of each of these.
    variants: Vec<Variant>,
    /// The numbers of each of the equations.
    numbers: Vec<Vec<f64>>,
    /// Those of other properties, with their places among the equations.
    other_laws: Vec<(usize, &'a FilmFluid)>,
}

/// The solution's equations with one number changed.
struct Variant {
    constants: FilmConstants,
    oil_layer: Option<OilLayer>,
    slide: Planar,
    /// p_h over that of the solution, in the properties.
    pressure_unit: f64,
    /// Place and change of a number that closures depend on.
    closure: Option<(usize, f64)>,
}

/// Numbers before those that closures depend on.
const N_COMMON: usize = 11;
/// Place of p_h of the properties among them.
const PRESSURE_UNIT: usize = 10;

/// The numbers that equations have everywhere.
fn numbers(e: &Equations) -> Vec<f64> {
    let (slide, entrainment) = (e.fluid.slide(), e.constants.entrainment);
    let layer = e
        .oil_layer
        .map_or([0.0; 2], |layer| [layer.thickness, layer.lambda]);
    let common: [f64; N_COMMON] = [
        e.constants.lambda,
        e.constants.film_scale,
        slide.centre[0],
        slide.centre[1],
        slide.spin,
        entrainment.centre[0],
        entrainment.centre[1],
        entrainment.spin,
        layer[0],
        layer[1],
        e.fluid.pressure_scale(),
    ];
    let mut numbers = common.to_vec();
    numbers.extend(nearby::numbers(&e.fluid));
    numbers
}

impl Variant {
    /// The equations themselves, but for one of their numbers.
    fn new(e: &Equations, own: &[f64], index: usize, value: f64) -> Variant {
        let at = |i: usize| if i == index { value } else { own[i] };
        let planar = |first: usize| Planar {
            centre: [at(first), at(first + 1)],
            spin: at(first + 2),
        };
        Variant {
            constants: FilmConstants {
                lambda: at(0),
                film_scale: at(1),
                entrainment: planar(5),
                ..e.constants
            },
            oil_layer: e.oil_layer.map(|_| OilLayer {
                thickness: at(8),
                lambda: at(9),
            }),
            slide: planar(2),
            pressure_unit: at(PRESSURE_UNIT) / own[PRESSURE_UNIT],
            closure: (index.checked_sub(N_COMMON)).map(|i| (i, value - own[index])),
        }
    }
}

impl<'a> Plan<'a> {
    fn new(own: &'a Equations, equations: &'a [Equations]) -> Plan<'a> {
        let own_numbers = numbers(own);
        let mut other_laws = Vec::new();
        let mut all = Vec::new();
        for (i, e) in equations.iter().enumerate() {
            let mut numbers = numbers(e);
            if !e.fluid.shares_laws(&own.fluid) {
                other_laws.push((i, &e.fluid));
                numbers[PRESSURE_UNIT] = own_numbers[PRESSURE_UNIT];
            }
            all.push(numbers);
        }
        let step = |k: usize| {
            let differences = all
                .iter()
                .map(|numbers| (numbers[k] - own_numbers[k]).abs());
            differences.fold(0.0, f64::max)
        };
        let steps: Vec<f64> = (0..own_numbers.len()).map(step).collect();
        let moves: Vec<bool> = steps[N_COMMON..].iter().map(|step| *step > 0.0).collect();
        let moved: Vec<(usize, f64)> = (steps.into_iter().enumerate())
            .filter(|(_, step)| *step > 0.0)
            .collect();
        let variants = (moved.iter())
            .flat_map(|(k, step)| {
                [-step, *step]
                    .map(|step| Variant::new(own, &own_numbers, *k, own_numbers[*k] + step))
            })
            .collect();
        Plan {
            nearby: Nearby::new(&own.fluid, &moves),
            own: own_numbers,
            moved,
            variants,
            numbers: all,
            other_laws,
        }
    }

    /// The sums of each of the equations from those of the solution's own, the variants and what other laws add.
    fn put_together(&self, total: &[f64], n_sums: usize) -> Vec<WeightedSums> {
        let lists: Vec<&[f64]> = total.chunks_exact(n_sums).collect();
        let (own, variants) = (lists[0], &lists[1..=self.variants.len()]);
        let by_laws = &lists[1 + self.variants.len()..];
        (self.numbers.iter().enumerate())
            .map(|(i, numbers)| {
                let mut sums = own.to_vec();
                for ((k, step), sides) in self.moved.iter().zip(variants.chunks_exact(2)) {
                    let share = (numbers[*k] - self.own[*k]) / (2.0 * step);
                    for ((sum, below), above) in sums.iter_mut().zip(sides[0]).zip(sides[1]) {
                        *sum += share * (above - below);
                    }
                }
                if let Some(j) = self.other_laws.iter().position(|(other, _)| *other == i) {
                    sums.iter_mut().zip(by_laws[j]).for_each(|(s, by)| *s += by);
                }
                let traction = sums.pop().unwrap_or_default();
                WeightedSums {
                    residuals: sums,
                    traction,
                }
            })
            .collect()
    }
}

/// Fields and weights at the quadrature points of an element.
struct Points {
    element: usize,
    fields: Vec<([f64; 2], PointState<f64>)>,
    /// Weights of the points in the traction.
    areas: Vec<f64>,
    /// Point by point, the values of each list of weights, with the weight of the point.
    tests: Vec<[f64; N_TEST]>,
    n_weights: usize,
}

impl Points {
    fn new(d: &Discretisation, state: &State, weights: &[&[f64]], c: usize) -> Points {
        let metric = Metric::new(&d.contact.maps[c]);
        let mut fields = Vec::with_capacity(d.rule.len());
        let mut areas = Vec::with_capacity(d.rule.len());
        let mut tests = Vec::with_capacity(d.rule.len() * weights.len());
        for (q, weight) in d.rule.weights.iter().enumerate() {
            let area = weight * d.contact.maps[c].determinant;
            areas.push(area);
            for list in weights {
                let z = pressure_sums(d, list, &metric, c, q);
                tests.push([0, 1, 2, 3, 4].map(|k: usize| area * z[k]));
            }
            fields.push(point_state(d, state, &metric, c, q));
        }
        Points {
            element: c,
            fields,
            areas,
            tests,
            n_weights: weights.len(),
        }
    }

    /// With the traction as far as the bodies reach.
    fn summed_over(mut self, share: &Share) -> Points {
        for (q, area) in self.areas.iter_mut().enumerate() {
            *area *= share.at(q);
        }
        self
    }

    /// Adds this element's share of the sums.
    fn add(
        &self,
        d: &Discretisation,
        plan: &Plan,
        (own, flows): (&Equations, &[PointFlow]),
        rule: &mut CrossFilm,
        sums: &mut [f64],
    ) {
        let (cell, order) = (d.contact.cell(self.element), d.pressure.element.order());
        let ridge = d.share_at_ridge(self.element);
        let local = (own.constants).on_element(cell, order, own.oil_layer, ridge);
        let locals: Vec<ElementConstants> = (plan.variants.iter())
            .map(|v| v.constants.on_element(cell, order, v.oil_layer, ridge))
            .collect();
        let n_sums = self.n_weights + 1;
        let is_newtonian = own.fluid.is_newtonian();
        for (k, (place, s)) in self.fields.iter().enumerate() {
            let tests = &self.tests[k * self.n_weights..(k + 1) * self.n_weights];
            let area = self.areas[k];
            let flow = flows.get(k);
            let fluid = flow.map_or_else(|| own.fluid.at(s.pressure), |flow| flow.fluid);
            let mut lists = sums.chunks_exact_mut(n_sums);
            let mut add = |values: [f64; N_TEST], traction: f64| {
                let Some(list) = lists.next() else { return };
                for (sum, test) in list.iter_mut().zip(tests) {
                    *sum += values.iter().zip(test).map(|(v, t)| v * t).sum::<f64>();
                }
                list[n_sums - 1] += area * traction;
            };
            let at = AtPoint {
                place: *place,
                state: s,
                is_newtonian,
                left: flow.and_then(|flow| flow.left),
            };
            let m = Properties::around(s.pressure, &fluid);
            let slide = own.fluid.slide();
            let closure = flow.map(|flow| &flow.closure);
            let (values, traction) = at.evaluate(s, &m, slide, closure, &local);
            add(values, traction);
            let changes = flow.map(|flow| {
                let (p, g) = (s.pressure, pressure_stress(s));
                (plan.nearby).changes(p, g, flow.sliding_stress, &flow.closure, rule)
            });
            for (variant, local) in plan.variants.iter().zip(&locals) {
                let m = in_unit(&fluid, s.pressure, variant.pressure_unit);
                let closure = flow.zip(changes.as_ref()).map(|(own, changes)| {
                    let omega = sliding_stress(s, &m, variant.slide.at(*place));
                    let more = [0, 1].map(|i| omega[i] - own.sliding_stress[i]);
                    changes.moved(&own.closure, variant.closure, more)
                });
                let (values, traction) =
                    at.evaluate(s, &m, &variant.slide, closure.as_ref(), local);
                add(values, traction);
            }
            if plan.other_laws.is_empty() {
                continue;
            }
            let (values, traction) = at.by_properties(&fluid, slide, closure, &local);
            for (_, other) in &plan.other_laws {
                let other = other.at(s.pressure);
                let change = [
                    other.density[0] - fluid.density[0],
                    other.density[1] - fluid.density[1],
                    other.viscosity[0] - fluid.viscosity[0],
                    other.viscosity[1] - fluid.viscosity[1],
                ];
                let along = |dual: &Dual<4>| -> f64 {
                    dual.slopes.iter().zip(&change).map(|(by, c)| by * c).sum()
                };
                add(values.each_ref().map(along), along(&traction));
            }
        }
    }
}

/// Properties of a fluid in another unit of pressure, over its own, to first order.
fn in_unit(fluid: &PointFluid, pressure: f64, unit: f64) -> Properties<f64> {
    let m = Properties::around(pressure, fluid);
    let more = unit - 1.0;
    if more == 0.0 {
        return m;
    }
    Properties {
        density: m.density + more * pressure * fluid.density[1],
        density_slope: m.density_slope + more * (fluid.density[1] + pressure * fluid.density[2]),
        viscosity: m.viscosity + more * pressure * fluid.viscosity[1],
        viscosity_slope: m.viscosity_slope
            + more * (fluid.viscosity[1] + pressure * fluid.viscosity[2]),
    }
}

/// The equations at a quadrature point.
struct AtPoint<'a> {
    place: [f64; 2],
    state: &'a PointState<f64>,
    is_newtonian: bool,
    /// H where the stream left the film.
    left: Option<f64>,
}

impl AtPoint<'_> {
    /// Integrand of the residual and of the traction; the closure, if there is one, holds for the properties `m`, to first order if these
    /// carry derivatives.
    fn evaluate<D: Number>(
        &self,
        s: &PointState<D>,
        m: &Properties<D>,
        slide: &Planar,
        closure: Option<&Closure>,
        local: &ElementConstants,
    ) -> ([D; N_TEST], D) {
        let sliding = PointSliding::new(slide, self.place);
        let flow = match closure {
            Some(closure) if !self.is_newtonian => {
                generalized(s, m, local.lambda, &sliding, closure)
            }
            _ => newtonian(s, m, local.lambda),
        };
        let velocity = local.entrainment.at(self.place);
        let t = reynolds_point(s, m, &flow, local, velocity, 0.0);
        let mut traction = D::from(0.0);
        if let Some(closure) = closure {
            let omega = sliding_stress(s, m, sliding.value);
            traction = D::from(closure.mid_stress[0]);
            for i in 0..2 {
                traction += (omega[i] - omega[i].re()) * closure.stress_slopes[2 + i][0];
            }
            let lack = (local.oil_layer.as_ref())
                .and_then(|layer| missing(layer, s.pressure, s.film, local.filling_length));
            if let Some(lack) = lack {
                traction = traction * (-(lack.film / s.film) + 1.0);
            }
            if let Some(left) = self.left {
                traction = traction * left / s.film;
            }
        }
        let values = [
            t.value,
            t.gradient[0],
            t.gradient[1],
            t.laplacian,
            t.unresolved,
        ];
        (values, traction)
    }

    /// The same with derivatives by ρ̄, ρ̄', μ̄ and μ̄'.
    fn by_properties(
        &self,
        fluid: &PointFluid,
        slide: &Planar,
        closure: Option<&Closure>,
        local: &ElementConstants,
    ) -> ([Dual<4>; N_TEST], Dual<4>) {
        let m = Properties {
            density: Dual::variable(fluid.density[0], 0),
            density_slope: Dual::variable(fluid.density[1], 1),
            viscosity: Dual::variable(fluid.viscosity[0], 2),
            viscosity_slope: Dual::variable(fluid.viscosity[1], 3),
        };
        let s = self.state;
        let s = PointState {
            pressure: s.pressure.into(),
            pressure_gradient: s.pressure_gradient.map(Dual::from),
            pressure_curvature: s.pressure_curvature.map(Dual::from),
            film: s.film.into(),
            film_gradient: s.film_gradient.map(Dual::from),
            pressure_unresolved: s.pressure_unresolved.into(),
        };
        self.evaluate(&s, &m, slide, closure, local)
    }
}
