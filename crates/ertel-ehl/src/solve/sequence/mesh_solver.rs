//! Solves a stage on its mesh: makes the mesh, carries the state over, runs Newton's method, measures.

use ertel_fem::platform::Instant;
use std::sync::Arc;

use super::driver::{Driver, StageEnd, StageSolver, Task, Trial};
use super::paths::Outline;
use super::stage_run::{DIVERGENCE_LIMIT, Finish, StageRun};
use super::start::{cold_start, interpolate};
use super::{Problem, Stage, StageSolution};
use crate::engine::{Observer, SolveError, Stopped};
use crate::solution::LevelStats;
use crate::solution::Role;
use crate::solve::adapt::{Refinement, RefinementEnd, grading_errors, next_refinement};
use crate::solve::contact_surface::ContactSurface;
use crate::solve::discretisation::Discretisation;
use crate::solve::evaluate::{central_film, minimum_film};
use crate::solve::indicator::Indicator;
use crate::solve::newton_level::{NewtonStats, NewtonStatus};
use crate::solve::ridge::ridge_shares;
use crate::solve::state::State;
use crate::solve::tuning::stages::{NO_FILM, STAGES_WITHOUT_END};

/// Solves stage by stage; returns the last and the effort on each.
///
/// # Errors
/// When a stage does not converge or cannot be built.
pub fn solve_stages(
    problem: &Problem,
    observer: &mut dyn Observer,
) -> Result<(StageSolution, Vec<LevelStats>), SolveError> {
    let driver = Driver::new(Outline::of(problem), MeshSolver::new(problem, 0), observer);
    let end = driver.run().and_then(with_film);
    end.map_err(|error| problem.explained(error))
}

/// One stage that starts from a solution on its mesh, and refinements after it.
pub(super) fn solve_from(
    problem: &Problem,
    from: StageSolution,
    stage: Stage,
    observer: &mut dyn Observer,
) -> Result<(StageSolution, Vec<LevelStats>), SolveError> {
    let solver = MeshSolver::new(problem, stage.refinements);
    let driver = Driver::new(Outline::of(problem), solver, observer);
    driver.run_from(from, stage).and_then(with_film)
}

/// The solution, unless its film is negative: a root of the discrete equations, but no contact.
fn with_film(
    (solution, MeshSolver { stats, .. }): (StageSolution, MeshSolver),
) -> Result<(StageSolution, Vec<LevelStats>), SolveError> {
    let (film, _) = minimum_film(&solution.discretisation, &solution.state);
    if film > 0.0 {
        return Ok((solution, stats));
    }
    Err(SolveError::NotConverged {
        level: stats.len() - 1,
        iterations: stats.last().map_or(0, |l| l.newton_iterations),
        residual: solution.reached.residual,
        update: solution.reached.update,
        penalty_share: 1.0,
        reason: Stopped::NegativeFilm,
    })
}

/// Where the pressure of a stage has a ridge, by the solution that it starts from: from its pressure, or its ridge if on the same mesh.
fn shares_at_ridge(from: &StageSolution, d: &Discretisation) -> Vec<f64> {
    let there = &from.discretisation;
    if Arc::ptr_eq(&there.contact, &d.contact) && !there.at_ridge.is_empty() {
        return there.at_ridge.clone();
    }
    let mesh = (
        &there.contact.surface,
        &there.contact.locator,
        &there.pressure,
    );
    ridge_shares(mesh, &from.state.pressure, &d.contact.surface)
}

/// Solves stages of a problem, and keeps the records.
pub(super) struct MeshSolver<'a> {
    problem: &'a Problem,
    /// Effort and figures of each stage so far.
    stats: Vec<LevelStats>,
    /// The last mesh made, and for which stage.
    mesh: Option<(Stage, Arc<ContactSurface>)>,
    /// Refinements of the mesh that it starts on, if it starts from the solution of another problem.
    inherited: usize,
    /// Stages that have left no film at the end of a roller.
    without_end: usize,
}

impl Outline {
    /// That of a problem.
    fn of(problem: &Problem) -> Outline {
        Outline {
            usual: problem.plan.stages.clone(),
            exponential: problem.fluid.is_exponential(),
            roller: problem.shape.zone.roller.is_some(),
            // An exponential law has other difficulties.
            ridge_diffusion: match problem.fluid.is_exponential() {
                true => 0.0,
                false => problem.plan.ridge_diffusion,
            },
            slides: problem.fluid.slides(),
            refined: problem.plan.adapt.is_some(),
        }
    }
}

impl Trial for StageSolution {
    fn stage(&self) -> &Stage {
        &self.stage
    }

    fn converged(&self) -> bool {
        self.converged
    }

    /// Finite, with film everywhere, and nearer than the dry contact.
    fn is_usable(&self) -> bool {
        let (film, _) = minimum_film(&self.discretisation, &self.state);
        film.is_finite()
            && film > 0.0
            && self.state.pressure.iter().all(|p| p.is_finite())
            && self.reached.residual <= DIVERGENCE_LIMIT
    }
}

impl<'a> MeshSolver<'a> {
    fn new(problem: &'a Problem, inherited: usize) -> MeshSolver<'a> {
        MeshSolver {
            problem,
            stats: Vec::new(),
            mesh: None,
            inherited,
            without_end: 0,
        }
    }

    /// Whether the contact of a roller runs over its end, as more than one stage has found.
    ///
    /// # Errors
    /// If it does: the pressure is zero there, and the surfaces touch.
    fn check_ends(&mut self, d: &Discretisation, state: &State) -> Result<(), SolveError> {
        let Some(roller) = &self.problem.shape.zone.roller else {
            return Ok(());
        };
        let (film, [_, y]) = minimum_film(d, state);
        if roller.is_at_edge(y) && film < NO_FILM * central_film(d, state) {
            self.without_end += 1;
        }
        if self.without_end < STAGES_WITHOUT_END {
            return Ok(());
        }
        Err(SolveError::EndCarries {
            place: y.signum() * roller.half_length() * self.problem.scales.length,
            film: film * self.problem.scales.film,
        })
    }

    /// The mesh of a stage with its elastic operator, and whether it had to be made.
    fn mesh(
        &mut self,
        task: &Task<StageSolution>,
        observer: &dyn Observer,
    ) -> Result<(Arc<ContactSurface>, bool), SolveError> {
        let (stage, previous) = (task.stage, task.from);
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
        // Not both at a time
        self.mesh = None;
        let mesh = Arc::new(match refined {
            Some(p) => {
                let contact = &p.discretisation.contact;
                // The state is moved without it; other solves that share the mesh may be using it.
                if Arc::strong_count(contact) == 1 {
                    contact.response.release();
                }
                contact.refined(task.halvings, &stop)?
            }
            None => ContactSurface::new(
                &problem.shape,
                &problem.extents,
                &stage.sizes,
                &problem.elasticity,
                &stop,
            )?,
        });
        self.mesh = Some((*stage, Arc::clone(&mesh)));
        Ok((mesh, true))
    }
    /// The refinement after a stage, by the indicator of its errors, or why there is none.
    fn next_refinement(
        &self,
        stage: &Stage,
        indicator: Option<&Indicator>,
    ) -> Result<Refinement, RefinementEnd> {
        let problem = self.problem;
        match (&problem.plan.adapt, indicator) {
            (Some(adapt), Some(indicator)) => next_refinement(
                adapt,
                problem.shape.dim,
                &self.stats,
                grading_errors(&problem.shape, problem.elasticity.model, &stage.sizes),
                stage.refinements - self.inherited,
                indicator,
            ),
            _ => Err(RefinementEnd::NoEstimate),
        }
    }
}

/// Pressure space of a stage on a contact area, with temperatures where it has them.
fn discretised(problem: &Problem, stage: &Stage, contact: &Arc<ContactSurface>) -> Discretisation {
    let d = Discretisation::new(contact, stage.pressure_order);
    let heat = problem.heat.as_ref().zip(problem.plan.heat.as_ref());
    match heat.filter(|_| stage.heated) {
        Some((heat, plan)) => d.with_heat(
            plan.surface_order,
            plan.column.clone(),
            plan.column.unheated(heat),
        ),
        None => d,
    }
}

impl StageSolver for MeshSolver<'_> {
    type Solution = StageSolution;

    fn solve(
        &mut self,
        task: Task<StageSolution>,
        observer: &mut dyn Observer,
    ) -> Result<StageEnd<StageSolution>, SolveError> {
        let clock = Instant::now();
        let problem = self.problem;
        let level = self.stats.len();
        let (contact, fresh) = self.mesh(&task, observer)?;
        let stage = task.stage;
        let mut effort = NewtonStats::default();
        if fresh {
            (effort.seconds.mesh, effort.seconds.operator) = contact.seconds;
        }
        let mut d = discretised(problem, stage, &contact);
        observer.level(
            level,
            level + 1 + task.stages_to_come,
            d.n_pressure,
            contact.n_displacement,
        );
        let mut state = match task.from {
            Some(coarse) if !stage.cold => interpolate(coarse, &d),
            _ => cold_start(problem, &d),
        };
        if let Some(from) = task.from.filter(|_| stage.constants.ridge_diffusion > 0.0) {
            d.at_ridge = shares_at_ridge(from, &d);
        }
        let run = StageRun::new(problem, stage, level, &d);
        // Solutions that are only measured, or refined further, need not be exact.
        let last = stage.role == Role::Final;
        let measured = matches!(stage.role, Role::Estimate | Role::Final);
        // A comparison is not measured, and its error would count as the effect.
        let rough = stage.role == Role::Estimate || last && problem.plan.adapt.is_some();
        let finish = if rough { Finish::Rough } else { Finish::Exact };
        let mut outcome = run.solve(finish, &mut state, &mut effort, observer);
        if !matches!(outcome, Err(SolveError::Interrupted)) {
            self.check_ends(&d, &state)?;
        }
        let wanted = problem.plan.error_estimate && measured && outcome.is_ok();
        if wanted && observer.cancelled() {
            return Err(SolveError::Interrupted);
        }
        let indicator = wanted.then(|| run.measure(&state, &mut effort)).flatten();
        let stats = run.stats(outcome.is_ok(), &state, &effort, indicator.as_ref(), clock);
        self.stats.push(stats);
        let next = self.next_refinement(stage, indicator.as_ref().filter(|_| last));
        let refinement_end = next.as_ref().err().copied();
        if rough && last && outcome.is_ok() && next.is_err() {
            // Measured, and already accurate enough: the solution itself, to the end.
            let rough = outcome.ok().and_then(|(_, coupling)| coupling);
            outcome = run.finish(rough, &mut state, &mut effort, observer);
            let stats = run.stats(outcome.is_ok(), &state, &effort, indicator.as_ref(), clock);
            self.stats[level] = stats;
        }
        let (reached, coupling) = match &outcome {
            Ok(reached) => *reached,
            Err(error) => (NewtonStatus::of_failure(error), None),
        };
        let adjoints = (last && outcome.is_ok()).then(|| Box::new(run.rough_adjoints(indicator)));
        Ok(StageEnd {
            solution: StageSolution {
                adjoints,
                discretisation: d,
                state,
                stage: *stage,
                reached,
                converged: outcome.is_ok(),
                rough: false,
                refinement_end,
                coupling,
            },
            outcome: outcome.map(|_| next.ok()),
        })
    }

    fn finish(
        &mut self,
        solution: &mut StageSolution,
        observer: &mut dyn Observer,
    ) -> Result<(), SolveError> {
        let (stage, d) = (&solution.stage, &solution.discretisation);
        let run = StageRun::new(self.problem, stage, self.stats.len() - 1, d);
        let (mut state, mut effort) = (solution.state.clone(), NewtonStats::default());
        match run.finish(solution.coupling, &mut state, &mut effort, observer) {
            Ok((reached, coupling)) => {
                (solution.state, solution.reached) = (state, reached);
                (solution.adjoints, solution.coupling) = (None, coupling);
            }
            Err(SolveError::Interrupted) => return Err(SolveError::Interrupted),
            // The measured figures remain.
            Err(_) => solution.rough = true,
        }
        Ok(())
    }
}
