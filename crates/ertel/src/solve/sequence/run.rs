//! Which stage comes next, until the last has converged.

use std::collections::VecDeque;
use std::sync::Arc;
use std::time::Instant;

use super::rescue::rescues;
use super::stage::{Finish, StageRun};
use super::start::{cold_start, interpolate};
use super::{Problem, Role, Stage, StageSolution};
use crate::solution::LevelStats;
use crate::solve::adapt::{Refinement, grading_errors, next_refinement};
use crate::solve::discretisation::{ContactSurface, Discretisation, Means};
use crate::solve::evaluate::minimum_film;
use crate::solve::newton::{NewtonStats, Reached};
use crate::solve::{Observer, SolveError};

/// Solves stage by stage; returns the last and the effort on each.
///
/// # Errors
/// When a stage does not converge or cannot be built.
pub fn solve_stages(
    problem: &Problem,
    observer: &mut dyn Observer,
) -> Result<(StageSolution, Vec<LevelStats>), SolveError> {
    Sequence::new(problem).solve(observer)
}

/// Where a solve stands.
pub(super) struct Sequence<'a> {
    pub(super) problem: &'a Problem,
    /// Stages to come.
    pub(super) queue: VecDeque<Stage>,
    /// What to try if these fail.
    pub(super) rescues: std::vec::IntoIter<Vec<Stage>>,
    /// Why the first way failed: the error to report when all do.
    pub(super) first_failure: Option<SolveError>,
    pub(super) stats: Vec<LevelStats>,
    /// Where the next stage starts.
    pub(super) previous: Option<StageSolution>,
    /// The last solution of a final stage, while a refined mesh is being tried.
    pub(super) solved: Option<StageSolution>,
    /// The last mesh made, and for which stage.
    pub(super) mesh: Option<(Stage, Arc<ContactSurface>)>,
    /// Halvings of each element that make the next mesh.
    pub(super) halvings: Vec<u32>,
    /// Whether that mesh is for the pressure alone.
    pub(super) for_pressure_alone: bool,
    /// Steps halved on the present way.
    pub(super) detours: usize,
    /// Refinements of the mesh that has been tried once more.
    pub(super) restarted: usize,
    /// Whether the case's own pressures have been tried from those of lower order.
    pub(super) raised: bool,
    /// Refinements of the mesh that it starts on, if it starts from the solution of another problem.
    pub(super) inherited: Option<usize>,
}

/// How a stage ended.
pub(super) struct StageEnd {
    pub(super) outcome: Result<(), SolveError>,
    pub(super) solution: StageSolution,
    /// How to refine its mesh, if errors are too large.
    pub(super) refinement: Option<Refinement>,
}

impl<'a> Sequence<'a> {
    fn new(problem: &'a Problem) -> Sequence<'a> {
        Sequence {
            problem,
            queue: problem.stages.iter().copied().collect(),
            rescues: rescues(problem, true).into_iter(),
            first_failure: None,
            stats: Vec::new(),
            previous: None,
            solved: None,
            mesh: None,
            halvings: Vec::new(),
            for_pressure_alone: false,
            detours: 0,
            restarted: 0,
            raised: false,
            inherited: None,
        }
    }

    /// One stage that starts from a solution on its mesh, and refinements after it.
    pub fn from(problem: &'a Problem, previous: StageSolution, stage: Stage) -> Sequence<'a> {
        Sequence {
            queue: VecDeque::from([stage]),
            rescues: Vec::new().into_iter(),
            previous: Some(previous),
            inherited: Some(stage.refinements),
            ..Sequence::new(problem)
        }
    }

    /// Runs the stages to the end.
    pub fn solve(
        mut self,
        observer: &mut dyn Observer,
    ) -> Result<(StageSolution, Vec<LevelStats>), SolveError> {
        while let Some(stage) = self.queue.pop_front() {
            if observer.cancelled() {
                return Err(SolveError::Interrupted);
            }
            let mut end = self.run(&stage, observer)?;
            if self.inherited.is_some() && self.stats.len() == 1 {
                // What it started from solves another problem: there is nothing to go back to.
                std::mem::replace(&mut end.outcome, Ok(()))?;
            }
            self.proceed(&stage, end, observer)?;
        }
        let solution = self.previous.filter(|s| s.stage.role == Role::Final);
        let Some(solution) = solution.filter(|s| s.converged) else {
            // Every queue ends with a final stage; what follows a failure may not reach its end.
            return Err(self
                .first_failure
                .expect("a way that ends, ends with a solution"));
        };
        let stats = self.stats;
        let (film, _) = minimum_film(&solution.discretisation, &solution.state);
        if film <= 0.0 {
            // A root of the discrete equations, but no contact.
            return Err(SolveError::NotConverged {
                level: stats.len() - 1,
                iterations: stats.last().map_or(0, |l| l.newton_iterations),
                residual: solution.reached.residual,
                update: solution.reached.update,
                penalty_share: 1.0,
                reason: "the mesh is too coarse for the film, which comes out negative at a point",
            });
        }
        Ok((solution, stats))
    }

    /// The mesh of a stage with its elastic operator, and whether it had to be made.
    fn mesh(
        &mut self,
        stage: &Stage,
        observer: &dyn Observer,
    ) -> Result<(Arc<ContactSurface>, bool), SolveError> {
        let previous = self.previous.as_ref();
        let known = previous
            .map(|p| (&p.stage, &p.discretisation.contact))
            .into_iter()
            .chain(self.mesh.iter().map(|(of, mesh)| (of, mesh)))
            .find(|(of, _)| stage.is_on_mesh_of(of));
        if let Some((_, mesh)) = known {
            return Ok((Arc::clone(mesh), false));
        }
        let problem = self.problem;
        let refined = previous.filter(|p| {
            p.stage.sizes == stage.sizes && p.stage.refinements + 1 == stage.refinements
        });
        let stop = || observer.cancelled();
        let means = Means {
            cache: problem.cache.as_ref(),
            stop: &stop,
        };
        // Not both at a time
        self.mesh = None;
        let mesh = Arc::new(match refined {
            Some(p) => {
                let contact = &p.discretisation.contact;
                // The state goes over without it; other solves that share the mesh may be at work with it.
                if Arc::strong_count(contact) == 1 {
                    contact.response.release();
                }
                contact.refined(&self.halvings, means)?
            }
            None => ContactSurface::new(
                &problem.shape,
                &problem.extents,
                &stage.sizes,
                &problem.elasticity,
                means,
            )?,
        });
        self.mesh = Some((*stage, Arc::clone(&mesh)));
        Ok((mesh, true))
    }

    /// Solves a stage and measures it.
    fn run(&mut self, stage: &Stage, observer: &mut dyn Observer) -> Result<StageEnd, SolveError> {
        let clock = Instant::now();
        let problem = self.problem;
        let level = self.stats.len();
        let (contact, fresh) = self.mesh(stage, observer)?;
        let mut effort = NewtonStats::default();
        if fresh {
            (effort.seconds.mesh, effort.seconds.operator) = contact.seconds;
        }
        let mut d = Discretisation::new(&contact, stage.pressure_order);
        if let Some(heat) = problem.heat.as_ref().filter(|_| stage.heated) {
            d = d.with_heat(
                heat.surface_order,
                heat.column.clone(),
                heat.column.unheated(&heat.heat),
            );
        }
        observer.level(
            level,
            level + 1 + self.queue.len(),
            d.n_pressure,
            contact.n_displacement,
        );
        let mut state = match &self.previous {
            Some(coarse) if !stage.cold => interpolate(coarse, &d),
            _ => cold_start(problem, &d),
        };
        let run = StageRun::new(problem, stage, level, &d);
        // What is measured only, or refined further, need not be exact.
        let last = stage.role == Role::Final;
        let measured = matches!(stage.role, Role::Estimate | Role::Final);
        let rough = matches!(
            stage.role,
            Role::Estimate | Role::Comparison | Role::Isothermal
        ) || last && problem.adapt.is_some();
        let finish = if rough { Finish::Rough } else { Finish::Exact };
        let mut outcome = run.solve(finish, &mut state, &mut effort, observer);
        let wanted = problem.error_estimate && measured && outcome.is_ok();
        if wanted && observer.cancelled() {
            return Err(SolveError::Interrupted);
        }
        let indicator = if wanted {
            run.measure(&state, &mut effort)
        } else {
            None
        };
        let stats = run.stats(outcome.is_ok(), &state, &effort, indicator.as_ref(), clock);
        self.stats.push(stats);
        let refinement = match (&problem.adapt, &indicator) {
            (Some(adapt), Some(indicator)) if last => next_refinement(
                adapt,
                problem.shape.kind.body_dimension() - 1,
                &self.stats,
                grading_errors(&problem.shape, problem.elasticity.model, &stage.sizes),
                stage.refinements - self.inherited.unwrap_or(0),
                indicator,
            ),
            _ => None,
        };
        if rough && last && outcome.is_ok() && refinement.is_none() {
            // Measured, and already accurate enough: the solution itself, to the end.
            let rough = outcome.ok().and_then(|(_, coupling)| coupling);
            outcome = run
                .solve(Finish::Exact, &mut state, &mut effort, observer)
                .map(|(reached, coupling)| (reached, coupling.map(|c| c.after(rough))));
            let stats = run.stats(outcome.is_ok(), &state, &effort, indicator.as_ref(), clock);
            self.stats[level] = stats;
        }
        let (outcome, (reached, coupling)) = match outcome {
            Ok(reached) => (Ok(()), reached),
            Err(e) => {
                let reached = Reached::of_failure(&e);
                (Err(e), (reached, None))
            }
        };
        let solution = StageSolution {
            discretisation: d,
            state,
            stage: *stage,
            reached,
            converged: outcome.is_ok(),
            rough: false,
            coupling,
        };
        Ok(StageEnd {
            outcome,
            solution,
            refinement,
        })
    }
}
