//! From the solution of one problem to that of a similar one, on its mesh.

use std::sync::Arc;

use super::mesh_solver::solve_from;
use super::{Problem, Stage, StageSolution};
use crate::contact::{Inlet, pressure_profile};
use crate::elastic::{Accuracy, BodyModel, Elasticity, compliance};
use crate::engine::{Observer, SolveError};
use crate::solution::LevelStats;
use crate::solution::Role;
use crate::solve::adapt::{error_bars, grading_errors};
use crate::solve::discretisation::Discretisation;
use crate::solve::evaluate::{central_film, minimum_film};
use crate::solve::points::pressure_at;
use crate::solve::state::{FilmConstants, State};
use crate::solve::tuning::warm::{
    COARSEST, COARSEST_REFINED, FARTHEST_FILM, FINEST, LARGEST_MISS, LEAST_FILM, LONGEST_REACH,
    MISS_GROWTH, MOST_REACH, MOST_ROOM, SHORTEST_REACH,
};

/// A solution from which a similar problem can start, with its mesh and elastic operator.
pub struct Start {
    solution: StageSolution,
    elasticity: Elasticity,
    /// Start film of its problem, from which the film of the next one is predicted.
    film: f64,
    /// Largest error bar over the target, of the last solution that did not start from another.
    miss: f64,
}

impl Problem {
    /// Makes the contact area large enough for other problems, too, and the cells fine enough where nothing is
    /// refined by estimates; but not for those that ask for too much.
    pub fn make_room_for(&mut self, others: impl Iterator<Item = Problem>) {
        let (reach, stages) = (self.extents.reach(), self.plan.stages.clone());
        for other in others {
            let mut its = reach.iter().zip(other.extents.reach()).take(3);
            let is_near = its.all(|(own, wanted)| wanted <= MOST_REACH * own);
            if self.shape.inlet != Inlet::Meniscus && is_near {
                self.extents = self.extents.around(&other.extents);
            }
            if self.plan.adapt.is_some() || stages.len() != other.plan.stages.len() {
                continue;
            }
            let own = self.plan.stages.iter_mut().zip(&stages);
            for ((stage, first), other) in own.zip(&other.plan.stages) {
                let (own, first, its) = (&mut stage.sizes, &first.sizes, &other.sizes);
                if first.rim <= MOST_ROOM * its.rim && first.hertz <= MOST_ROOM * its.hertz {
                    own.hertz = own.hertz.min(its.hertz);
                    own.constriction = own.constriction.min(its.constriction);
                    own.rim = own.rim.min(its.rim);
                    own.outlet_rim = own.outlet_rim.min(its.outlet_rim);
                    own.rim_width = own.rim_width.max(its.rim_width);
                    own.edge = own.edge.min(its.edge);
                }
            }
        }
    }
}

impl Start {
    /// A start from the solution of a problem and the figures of its stages; `before`: from which start that was found, if from any.
    pub fn new(
        problem: &Problem,
        solution: StageSolution,
        stats: &[LevelStats],
        before: Option<&Start>,
    ) -> Start {
        Start {
            miss: before.map_or_else(|| miss(problem, &solution, stats), |start| start.miss),
            solution,
            elasticity: problem.elasticity.clone(),
            film: problem.start_film,
        }
    }

    /// The solution that it starts from.
    pub fn solution(&self) -> &StageSolution {
        &self.solution
    }

    /// Whether its mesh suits a problem: the same bodies, a contact area that is large enough, cells that
    /// are neither too coarse nor far too fine.
    pub fn suits(&self, problem: &Problem) -> bool {
        let Some(wanted) = problem.plan.stages.last() else {
            return false;
        };
        let contact = &self.solution.discretisation.contact;
        let close = |a: f64, b: f64| (a - b).abs() <= 1e-9 * b.abs();
        let (own, its) = (&self.elasticity, &problem.elasticity);
        let bodies = own.model == its.model
            && own.order == its.order
            && match own.model {
                // Half-spaces of equal compliance respond equally.
                BodyModel::HalfSpace => close(compliance(&own.bodies), compliance(&its.bodies)),
                BodyModel::FiniteElements => {
                    own.bodies.len() == its.bodies.len()
                        && (own.bodies.iter().zip(&its.bodies)).all(|(a, b)| a.is_close(b, 1e-9))
                }
            };
        let film = problem.start_film / self.film;
        let within = |ratio: f64, low: f64, high: f64| (low..=high).contains(&ratio);
        let (here, there) = (contact.extents.reach(), problem.extents.reach());
        let coarsest = match problem.plan.adapt {
            Some(_) => COARSEST_REFINED,
            None => COARSEST,
        };
        let (has, wants) = (&self.solution.stage.sizes, &wanted.sizes);
        let sizes = [
            has.hertz / wants.hertz,
            has.constriction / wants.constriction,
            has.rim / wants.rim,
            has.outlet_rim / wants.outlet_rim,
            has.edge / wants.edge,
        ];
        // The contact area ends at the meniscus.
        let ends_alike = problem.shape.inlet != Inlet::Meniscus || close(here[0], there[0]);
        contact.shape.is_like(&problem.shape)
            && ends_alike
            && bodies
            && within(film, 1.0 / FARTHEST_FILM, FARTHEST_FILM)
            && (here.iter().zip(there)).all(|(h, t)| within(h / t, SHORTEST_REACH, LONGEST_REACH))
            && sizes.iter().all(|s| within(*s, FINEST, coarsest))
            && has.growth <= wants.growth
            && has.depth_growth <= wants.depth_growth
    }

    /// The last stage of a problem on its mesh, with the diffusion at a ridge of its solution.
    fn stage(&self, problem: &Problem, undamped: bool) -> Option<Stage> {
        let (own, last) = (&self.solution.stage, problem.plan.stages.last()?);
        Some(Stage {
            sizes: own.sizes,
            refinements: own.refinements,
            cold: false,
            given_up_early: false,
            undamped,
            role: Role::Final,
            constants: FilmConstants {
                ridge_diffusion: own.constants.ridge_diffusion,
                ..last.constants
            },
            ..*last
        })
    }

    /// Its pressures and film as predicted for the problem.
    fn rescaled(&self, problem: &Problem) -> StageSolution {
        let mut start = self.solution.clone();
        let contact = &start.discretisation.contact;
        if contact.shape.inlet != problem.shape.inlet {
            let contact = contact.with_inlet(problem.shape.inlet);
            start.discretisation.contact = Arc::new(contact);
        }
        let d = &start.discretisation;
        let ratio = problem.start_film / self.film;
        let (centre, thinnest) = (
            central_film(d, &start.state),
            minimum_film(d, &start.state).0,
        );
        if ratio != 1.0 {
            start.state.pressure = stretched(d, &start.state, ratio.powf(2.0 / 3.0));
            start.state.deflection = d.deflect(&start.state.pressure, Accuracy::Full);
        }
        start.state.rigid_separation += ratio * centre - central_film(d, &start.state);
        // Predicted pressures leave less film at the rim than the solution.
        let least = LEAST_FILM * ratio * thinnest - minimum_film(d, &start.state).0;
        start.state.rigid_separation += least.max(0.0);
        start
    }
}

/// Pressures of a film whose length along the rim of the Hertz zone has grown by a factor q.
///
/// Near the rim pressures differ from the dry contact's over a length proportional to the power 2/3 of the film, by an
/// amount proportional to the root of that length, P − P_H ~ √q f((r − 1)/q): the dry contact's pressure falls
/// off, and its gap opens, like powers 1/2 and 3/2 of the distance.
fn stretched(d: &Discretisation, state: &State, q: f64) -> Vec<f64> {
    let points = d.pressure.points.iter().zip(&d.pressure_dofs);
    points
        .map(|(p, dof)| {
            if *dof == ertel_fem::assembly::CONSTRAINED {
                return 0.0;
            }
            let r = d.contact.shape.zone.radius([p[0], p[1]]);
            // Towards the centre everything stays in place.
            let stretch = if r < 1.0 { r / q + (1.0 - r) } else { 1.0 / q };
            let from = 1.0 + (r - 1.0) * stretch;
            let share = if r > 0.0 { from / r } else { 1.0 };
            let zone = &d.contact.shape.zone;
            let peak = zone.peak([p[0], p[1]]);
            let excess = pressure_at(d, &state.pressure, zone.drawn_in([p[0], p[1]], share))
                - peak * pressure_profile(from);
            (peak * pressure_profile(r) + q.sqrt() * excess).max(0.0)
        })
        .collect()
}

/// Solves a problem from a start that suits it: Newton's method on the mesh of the start, with whole steps or else with
/// damped ones, then the error estimate, and refinement where that is too large. `None` where Newton's method does not
/// converge from there, or the mesh cannot be brought to the accuracy that its own problem had.
///
/// # Errors
/// Only [`SolveError::Interrupted`].
pub fn solve_warm(
    problem: &Problem,
    start: &Start,
    observer: &mut dyn Observer,
) -> Result<Option<(StageSolution, Vec<LevelStats>)>, SolveError> {
    let allowed = LARGEST_MISS.max(MISS_GROWTH * start.miss);
    // Where whole steps fail, damped ones mostly lead there still, for less than a start from the dry contact.
    for undamped in [true, false] {
        let Some(stage) = start.stage(problem, undamped) else {
            return Ok(None);
        };
        let mut from = start.rescaled(problem);
        // Another contact has its ridge elsewhere.
        from.discretisation.at_ridge.clear();
        if let Some((solution, stats)) = unless_failed(solve_from(problem, from, stage, observer))?
        {
            let good = miss(problem, &solution, &stats) <= allowed;
            return Ok(good.then_some((solution, stats)));
        }
    }
    Ok(None)
}

/// Solves a problem, which must not ask for refinement, on the mesh of a start, whatever its own mesh would be: for differences that no
/// change of the mesh should blur. `None` where Newton's method does not converge.
///
/// # Errors
/// Only [`SolveError::Interrupted`].
pub fn solve_on_mesh(
    problem: &Problem,
    start: &Start,
    observer: &mut dyn Observer,
) -> Result<Option<StageSolution>, SolveError> {
    let own = &start.solution;
    let is_like = own.discretisation.contact.shape.is_like(&problem.shape);
    let Some(stage) = start.stage(problem, true).filter(|_| is_like) else {
        return Ok(None);
    };
    let stage = Stage {
        pressure_order: own.stage.pressure_order,
        ..stage
    };
    let end = solve_from(problem, start.rescaled(problem), stage, observer);
    Ok(unless_failed(end)?.map(|(solution, _)| solution))
}

/// The value of a solve, if any.
fn unless_failed<T>(end: Result<T, SolveError>) -> Result<Option<T>, SolveError> {
    match end {
        Err(SolveError::Interrupted) => Err(SolveError::Interrupted),
        end => Ok(end.ok()),
    }
}

/// Largest error bar over the target; zero where there is none.
fn miss(problem: &Problem, solution: &StageSolution, stats: &[LevelStats]) -> f64 {
    let Some(adapt) = &problem.plan.adapt else {
        return 0.0;
    };
    let grading = grading_errors(
        &problem.shape,
        problem.elasticity.model,
        &solution.stage.sizes,
    );
    error_bars(stats, grading).map_or(f64::INFINITY, |b| {
        // Errors of the edges are the same on another mesh with these edges.
        b.cells
            .iter()
            .fold(0.0, |m: f64, bar| m.max(bar / adapt.target))
    })
}
