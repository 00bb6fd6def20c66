//! Derivatives of figures by inputs at a solution, by one adjoint for each figure.
//!
//! ```text
//!   R(q; θ) = 0,  j(q; θ):      dj/dθ = ∂j/∂θ − z·∂R/∂θ − s ∂(∫P − load)/∂θ,      Jᵀ(z, s) = ∂j/∂q
//! ```
//! The figures are those of the discrete solution on its mesh, which is fixed in half-widths of the contact: the change of the
//! mesh error is neglected. Partial derivatives by θ are central differences of residuals and figures at the fields of the solution;
//! no equation is solved for them. Where an input changes the shape of the contact in half-widths (axis ratio of an ellipse, length of a
//! roller), mesh and elastic response are rebuilt on either side, and derivatives are good to about 1e-4 of the largest (ellipses) or
//! 1e-3 (rollers; their pressure to 1 %). Isothermal films only: there is no adjoint of the heat.

use std::sync::Arc;

use super::adjoint::{Adjoint, Exactness, Functional, RoughAdjoints, adjoints};
use super::contact_surface::ContactSurface;
use super::discretisation::Discretisation;
use super::element::Metric;
use super::evaluate::minimum_film;
use super::evaluated::Evaluated;
use super::newton_level::FilmModel;
use super::peaks::peaks;
use super::points::fields_in;
use super::preconditioner::{NearStiffness, Preconditioner};
use super::region::Elements;
use super::sequence::{Plan, Problem, StageSolution};
use super::state::{FilmConstants, State};
use super::system::System;
use super::weighted::{Equations, PointFlow, point_flows, weighted_sums};
use crate::contact::{Inlet, Planar, Scales};
use crate::elastic::{Accuracy, BodyModel};
use crate::engine::SolveError;
use crate::engine::friction::friction;
use crate::engine::region::Region;
use crate::engine::sensitivity::{Derivatives, NoDerivative, Perturbed};
use crate::film::FilmFluid;
use crate::forms::oil_layer::{filling_length, missing};
use crate::solution::Figure;
use ertel_fem::linear::NEVER;

/// How exactly the adjoints are solved for: around thick films equations far away, with coefficients of many times those in the contact,
/// leave a residual that rounding errors of products do not fall below, and sensitivities are given to a thousandth.
const EXACTNESS: [Exactness; 3] = [
    Exactness {
        tolerance: 1e-7,
        weighed: false,
    },
    Exactness {
        tolerance: 1e-7,
        weighed: true,
    },
    Exactness {
        tolerance: 1e-5,
        weighed: true,
    },
];

/// Figures that have sensitivities; of the pressure its smooth maximum: at a ridge, derivatives are those of the mesh.
pub const FIGURES: [Figure; 4] = [
    Figure::FilmCentral,
    Figure::FilmMinimum,
    Figure::PressureCentral,
    Figure::TractionCoefficient,
];

/// A figure with its adjoint.
struct Goal {
    figure: Figure,
    adjoint: Adjoint,
}

/// Derivatives at a solution.
pub struct Sensitivity<'a> {
    solution: &'a StageSolution,
    problem: &'a Problem,
    goals: Vec<Goal>,
    flows: Vec<PointFlow>,
    /// Elements and reference coordinates of the figures that are read at a place.
    places: [Option<(usize, [f64; 3])>; 3],
}

impl<'a> Sensitivity<'a> {
    /// Solves for the adjoints of those of [`FIGURES`] that are `wanted` of an isothermal solution, from rough ones if there are any; traction
    /// has one only where surfaces slide.
    ///
    /// # Errors
    /// When the Krylov iterations run out.
    ///
    /// # Panics
    /// For films that heat up.
    pub fn new(
        problem: &'a Problem,
        solution: &'a StageSolution,
        rough: Option<RoughAdjoints>,
        wanted: impl Fn(Figure) -> bool,
    ) -> Result<Sensitivity<'a>, SolveError> {
        assert!(problem.heat.is_none(), "isothermal films only");
        let (d, state) = (&solution.discretisation, &solution.state);
        let model = FilmModel {
            fluid: problem.fluid.clone(),
            constants: solution.stage.constants,
        };
        let system = System::assemble(d, &model.fluid, &model.constants, state, None);
        let (kept, films) = rough.map_or((None, Vec::new()), |r| (r.preconditioner, r.films));
        let (_, thinnest) = minimum_film(d, state);
        let (_, top) = peaks(d, state, |_| true).map_or((0.0, [0.0; 2]), |peaks| peaks.central);
        let mut figures = FIGURES.to_vec();
        figures.retain(|f| *f != Figure::TractionCoefficient || problem.fluid.slides());
        figures.retain(|f| wanted(*f));
        // Rough adjoints are those of both films.
        let films = match figures.starts_with(&FIGURES[..2]) {
            true => films,
            false => Vec::new(),
        };
        let flows = flows(d, state, &model.fluid, &problem.entrainment);
        let functionals: Vec<Functional> = (figures.iter())
            .map(|figure| match figure {
                Figure::FilmCentral => Functional::film_at(d, [0.0; 2]),
                Figure::FilmMinimum => Functional::film_at(d, thinnest),
                Figure::PressureCentral => Functional::pressure_at(d, top),
                _ => traction(d, &flows, &model.fluid, &problem.scales),
            })
            .collect();
        let solve = |by, exactness| adjoints(d, &system, by, &functionals, &films, exactness);
        let adjoints = match kept.map(|by| solve(by, EXACTNESS[0])) {
            Some(Ok(adjoints)) => adjoints,
            // None, or of no use any more.
            _ => {
                let fresh = Preconditioner::new(d, &NearStiffness::new(d), &system)?;
                let [first, rest @ ..] = EXACTNESS;
                rest.into_iter()
                    .fold(solve(fresh.clone(), first), |found, exactness| {
                        found.or_else(|_| solve(fresh.clone(), exactness))
                    })?
            }
        };
        let goals = (figures.into_iter().zip(adjoints))
            .map(|(figure, adjoint)| Goal { figure, adjoint })
            .collect();
        let find = |place| d.contact.locator.find(&d.contact.surface, place);
        Ok(Sensitivity {
            solution,
            problem,
            goals,
            flows,
            places: [[0.0; 2], thinnest, top].map(find),
        })
    }

    /// Why derivatives by an input are not available.
    fn obstacle(&self, sides: &Perturbed<Plan>) -> Option<NoDerivative> {
        let close = |a: f64, b: f64| (a - b).abs() <= 1e-9 * b.abs();
        let own = &self.problem.elasticity;
        for problem in &sides.problems {
            let finite = own.model == BodyModel::FiniteElements;
            let mut bodies = own.bodies.iter().zip(&problem.elasticity.bodies);
            if finite && !bodies.all(|(a, b)| a.is_close(b, 1e-9)) {
                return Some(NoDerivative::FiniteElements);
            }
            if self.problem.shape.inlet == Inlet::Meniscus
                && !close(self.problem.extents.inlet, problem.extents.inlet)
            {
                return Some(NoDerivative::Edge);
            }
        }
        None
    }

    /// j − z·R − s(∫P − load) of each figure at the fields of the solution, in the equations of each problem.
    fn lagrangians(
        &self,
        d: &Discretisation,
        state: &State,
        flows: &[PointFlow],
        problems: &[&Problem],
    ) -> Vec<Vec<f64>> {
        let equations: Vec<Equations> = problems.iter().map(|p| self.equations(p)).collect();
        let weights: Vec<&[f64]> = (self.goals.iter())
            .map(|goal| goal.adjoint.film.as_slice())
            .collect();
        let own = self.equations(self.problem);
        let sums = weighted_sums(d, state, &weights, (&own, flows), &equations);
        let carried = d.integral(&state.pressure);
        (problems.iter().zip(sums))
            .map(|(problem, sums)| {
                let goals = self.goals.iter().zip(sums.residuals);
                goals
                    .map(|(goal, residual)| {
                        let scales = &problem.scales;
                        let figure = match goal.figure {
                            Figure::TractionCoefficient => {
                                let traction = sums.traction + moved_end(d, flows, problem);
                                let force = problem.fluid.stress_scale() * traction;
                                force / (scales.load * scales.pressure)
                            }
                            figure => self.figure(figure, d, state, scales),
                        };
                        let excess = goal.adjoint.load * (carried - problem.load);
                        figure - self.unit(goal.figure) * (residual + excess)
                    })
                    .collect()
            })
            .collect()
    }

    /// The same on a mesh of the changed shape, where deflections follow from the pressures.
    fn reshaped(&self, problem: &Problem) -> Result<Vec<f64>, NoDerivative> {
        let own = &self.solution.discretisation;
        let contact = ContactSurface::reshaped(&own.contact, &problem.shape, NEVER)
            .ok_or(NoDerivative::Mesh)?;
        let d = Discretisation::new(&Arc::new(contact), own.pressure.element.order());
        if d.pressure.n_nodes() != own.pressure.n_nodes() || d.n_pressure != own.n_pressure {
            return Err(NoDerivative::Mesh);
        }
        let state = State {
            deflection: d.deflect(&self.solution.state.pressure, Accuracy::Full),
            ..self.solution.state.clone()
        };
        let flows = flows(&d, &state, &self.problem.fluid, &problem.entrainment);
        let mut values = self.lagrangians(&d, &state, &flows, &[problem]);
        values.pop().ok_or(NoDerivative::Mesh)
    }

    fn equations(&self, problem: &Problem) -> Equations {
        // All of them, but for the steps that led to the solution.
        let (own, its) = (&self.solution.stage.constants, problem.plan.stages.last());
        let theirs = its.map_or(*own, |stage| stage.constants);
        Equations {
            fluid: problem.fluid.clone(),
            constants: FilmConstants {
                lambda: theirs.lambda,
                entrainment: theirs.entrainment,
                film_scale: theirs.film_scale,
                ..*own
            },
            oil_layer: problem.shape.inlet.layer().copied(),
        }
    }

    /// SI unit of the dimensionless figure that the adjoint is of.
    fn unit(&self, figure: Figure) -> f64 {
        let scales = &self.problem.scales;
        match figure {
            Figure::FilmCentral | Figure::FilmMinimum => scales.film,
            Figure::PressureCentral => scales.pressure,
            _ => 1.0,
        }
    }

    /// A figure that is read at a place, from the fields of the solution in other scales, SI.
    fn figure(&self, figure: Figure, d: &Discretisation, state: &State, scales: &Scales) -> f64 {
        let at = |place: Option<(usize, [f64; 3])>| {
            place.map(|(cell, xi)| fields_in(d, state, cell, xi))
        };
        let [centre, thinnest, top] = self.places;
        let film = |place| scales.film * at(place).map_or(f64::NAN, |f| f.film);
        match figure {
            Figure::FilmCentral => film(centre),
            Figure::FilmMinimum => film(thinnest),
            _ => scales.pressure * at(top).map_or(f64::NAN, |f| f.pressure),
        }
    }
}

impl Derivatives<Plan> for Sensitivity<'_> {
    fn figures(&self) -> Vec<Figure> {
        self.goals.iter().map(|goal| goal.figure).collect()
    }

    fn value(&self, figure: Figure) -> f64 {
        let (d, state) = (&self.solution.discretisation, &self.solution.state);
        let scales = &self.problem.scales;
        match figure {
            Figure::TractionCoefficient => {
                let (shape, flow) = (&self.problem.shape, &self.problem.entrainment);
                let film = Evaluated::new(shape, flow, d, state);
                let sums = friction(self.problem, &self.problem.fluid, &film);
                sums.here.coefficients[0][0]
            }
            figure => self.figure(figure, d, state, scales),
        }
    }

    fn derivatives(&self, inputs: &[Perturbed<Plan>]) -> Vec<Result<Vec<f64>, NoDerivative>> {
        let (d, state) = (&self.solution.discretisation, &self.solution.state);
        let here: Vec<bool> = (inputs.iter())
            .map(|sides| {
                (sides.problems.iter()).all(|p| self.problem.shape.is_like(&p.shape))
                    && self.obstacle(sides).is_none()
            })
            .collect();
        let on_mesh: Vec<&Problem> = (inputs.iter().zip(&here))
            .filter(|(_, here)| **here)
            .flat_map(|(sides, _)| &sides.problems)
            .collect();
        let mut lagrangians = self
            .lagrangians(d, state, &self.flows, &on_mesh)
            .into_iter();
        let mut derivatives = Vec::new();
        for (sides, here) in inputs.iter().zip(here) {
            let values = if here {
                [lagrangians.next(), lagrangians.next()].map(|v| v.ok_or(NoDerivative::Mesh))
            } else if let Some(obstacle) = self.obstacle(sides) {
                [Err(obstacle), Err(obstacle)]
            } else {
                (sides.problems.each_ref()).map(|problem| self.reshaped(problem))
            };
            let difference = |[below, above]: [Vec<f64>; 2]| {
                let pairs = below.iter().zip(&above);
                pairs.map(|(b, a)| (a - b) / sides.distance).collect()
            };
            let [below, above] = values;
            derivatives.push(below.and_then(|below| Ok(difference([below, above?]))));
        }
        derivatives
    }
}

/// Flow across the film of a solution, if it thins or slides.
fn flows(
    d: &Discretisation,
    state: &State,
    fluid: &FilmFluid,
    entrainment: &Planar,
) -> Vec<PointFlow> {
    match !fluid.is_newtonian() || fluid.slides() {
        true => point_flows(d, state, fluid, entrainment),
        false => Vec::new(),
    }
}

/// ∫θ τ_x dA over what lies between the end of the bodies of a problem and that of the mesh, which differ where the contact is another part of
/// the radius.
fn moved_end(d: &Discretisation, flows: &[PointFlow], problem: &Problem) -> f64 {
    let [from, to] = [&d.contact.shape, &problem.shape].map(Region::of);
    if from == to {
        return 0.0;
    }
    let elements = Elements::new(d);
    let layer = d.contact.shape.inlet.layer();
    let mut sum = 0.0;
    for (c, flows) in flows.chunks_exact(d.rule.len()).enumerate() {
        let [before, after] = [&from, &to].map(|region| elements.share(region, c));
        if before == after {
            continue;
        }
        let length = filling_length(d.contact.sizes[c], d.pressure.element.order());
        for (q, (weight, flow)) in d.rule.weights.iter().zip(flows).enumerate() {
            let f = &flow.state;
            let lack = layer.and_then(|layer| missing(layer, f.pressure, f.film, length));
            let lacking = lack.map_or(0.0, |lack| lack.film);
            let filling = flow.left.unwrap_or(f.film - lacking) / f.film;
            let area = weight * d.contact.maps[c].determinant * (after.at(q) - before.at(q));
            sum += area * filling * flow.closure.mid_stress[0];
        }
    }
    sum
}

/// Derivatives of the traction coefficient along the motion:
///
/// ```text
///   f = S/load ∫θ τ_x dA as far as the bodies reach,   τ = τ(G, Ω, P),  G = H∇P,  Ω = σμ̄/H,  θ = 1 − F(P, H)/H
/// ```
fn traction(
    d: &Discretisation,
    flows: &[PointFlow],
    fluid: &FilmFluid,
    scales: &Scales,
) -> Functional {
    let unit = fluid.stress_scale() / (scales.load * scales.pressure);
    let (n, m) = (d.pressure_table.n_nodes, d.deflection_table.n_nodes);
    let mut functional = Functional::zero(d);
    let layer = d.contact.shape.inlet.layer();
    let (elements, region) = (Elements::new(d), Region::of(&d.contact.shape));
    for (c, flows) in flows.chunks_exact(d.rule.len()).enumerate() {
        let share = elements.share(&region, c);
        let map = &d.contact.maps[c];
        let metric = Metric::new(map);
        let length = filling_length(d.contact.sizes[c], d.pressure.element.order());
        for (q, (weight, flow)) in d.rule.weights.iter().zip(flows).enumerate() {
            let (f, omega, closure) = (&flow.state, flow.sliding_stress, &flow.closure);
            let tau = closure.mid_stress[0];
            let [by_gx, by_gy, by_ox, by_oy, by_p] = closure.stress_slopes.map(|slopes| slopes[0]);
            let through_slide = by_ox * omega[0] + by_oy * omega[1];
            let [mu, mu_p, _] = flow.fluid.viscosity;
            let [px, py] = f.pressure_gradient;
            let mut by_pressure = by_p + through_slide * mu_p / mu;
            let mut by_film = by_gx * px + by_gy * py - through_slide / f.film;
            let mut filling = 1.0;
            if let Some(lack) = layer.and_then(|layer| missing(layer, f.pressure, f.film, length)) {
                filling = 1.0 - lack.film / f.film;
                by_pressure = filling * by_pressure - tau * lack.by_pressure / f.film;
                by_film = filling * by_film - tau * (lack.by_film - lack.film / f.film) / f.film;
            }
            if let Some(left) = flow.left {
                filling = left / f.film;
                by_pressure *= filling;
                by_film = filling * (by_film - tau / f.film);
            }
            let area = unit * weight * map.determinant * share.at(q);
            let by_slopes = [by_gx, by_gy].map(|by| filling * by * f.film);
            let table = &d.pressure_table;
            for (j, node) in d.pressure.nodes_of(c).iter().enumerate() {
                let k = q * n + j;
                let [gx, gy] = metric.gradient(&table.gradients[k]);
                functional.by_pressure[*node as usize] +=
                    area * (by_pressure * table.values[k] + by_slopes[0] * gx + by_slopes[1] * gy);
            }
            for (j, node) in d.contact.deflection.nodes_of(c).iter().enumerate() {
                functional.by_deflection[*node as usize] +=
                    area * by_film * d.deflection_table.values[q * m + j];
            }
            functional.by_separation += area * by_film;
        }
    }
    functional
}
