//! Which stage comes next, until the last has converged.
//!
//! The driver knows neither meshes nor equations: a [`StageSolver`] solves a stage, and [`Driver::after`] draws the conclusion.

mod stage_solver;
#[cfg(test)]
mod tests;

use std::collections::VecDeque;

pub(super) use stage_solver::{StageEnd, StageSolver, Task, Trial};

use super::paths::knob::halfway;
use super::paths::{Outline, Path, less_diffusion, paths};
use super::stage::Stage;
use crate::solution::Role;
use crate::solve::adapt::{Refinement, RefinementTarget};
use crate::solve::tuning::continuation::{
    GOOD_ENOUGH, MAX_HALVED_EXPONENTIAL_STEPS, MAX_HALVED_STEPS,
};
use crate::solve::{Observer, SolveError};

/// Where a solve stands.
pub(super) struct Driver<S: StageSolver> {
    pub(super) solver: S,
    outline: Outline,
    /// Stages to come.
    queue: VecDeque<Stage>,
    /// What to try if these fail.
    paths: VecDeque<Path>,
    /// What was tried of it.
    tried: Vec<&'static str>,
    /// Why the usual stages failed: the error to report when all paths do.
    first_failure: Option<SolveError>,
    /// Stages solved or given up.
    attempts: usize,
    /// Where the next stage starts.
    current: Option<S::Solution>,
    /// The last solution of a final stage, while a refined mesh is being tried.
    before_refinement: Option<S::Solution>,
    /// How the next mesh, or that in force, was refined.
    refinement: Refinement,
    /// Steps halved on the present path.
    halved_steps: usize,
    /// Refinements of the mesh that has been tried once more.
    restarted: usize,
    /// Whether the case's own pressures have been tried from those of lower order.
    raised: bool,
    /// Whether the next stage is that try.
    raising: bool,
    /// ρ_r in force.
    ridge_diffusion: f64,
    /// Whether it starts from the solution of another problem.
    warm: bool,
}

impl<S: StageSolver> Driver<S> {
    /// The usual stages, from the dry contact.
    pub fn new(outline: Outline, solver: S) -> Driver<S> {
        Driver {
            solver,
            queue: outline.usual.iter().copied().collect(),
            paths: paths(&outline).into(),
            tried: Vec::new(),
            outline,
            first_failure: None,
            attempts: 0,
            current: None,
            before_refinement: None,
            refinement: Refinement {
                halvings: Vec::new(),
                aim: RefinementTarget::Films,
                film_bar: f64::INFINITY,
            },
            halved_steps: 0,
            restarted: 0,
            raised: false,
            raising: false,
            ridge_diffusion: 0.0,
            warm: false,
        }
    }

    /// One stage that starts from the solution of a similar problem on its mesh, and refinements after it.
    pub fn warm(outline: Outline, solver: S, from: S::Solution, stage: Stage) -> Driver<S> {
        Driver {
            queue: VecDeque::from([stage]),
            paths: VecDeque::new(),
            current: Some(from),
            ridge_diffusion: stage.constants.ridge_diffusion,
            warm: true,
            ..Driver::new(outline, solver)
        }
    }

    /// Runs the stages to the end; returns the solution and the solver, which keeps the records.
    ///
    /// # Errors
    /// That of the usual stages when all paths fail; [`SolveError::Interrupted`]; what keeps a stage from being begun.
    pub fn run(mut self, observer: &mut dyn Observer) -> Result<(S::Solution, S), SolveError> {
        while let Some(mut stage) = self.queue.pop_front() {
            if stage.role == Role::Final {
                stage.constants.ridge_diffusion = self.ridge_diffusion;
            }
            if observer.cancelled() {
                return Err(SolveError::Interrupted);
            }
            let task = Task {
                stage: &stage,
                from: self.current.as_ref(),
                halvings: &self.refinement.halvings,
                stages_to_come: self.queue.len(),
            };
            let end = self.solver.solve(task, observer)?;
            self.attempts += 1;
            self.after(&stage, end, observer)?;
        }
        let solution = self.current.filter(|s| s.stage().role == Role::Final);
        match solution.filter(Trial::converged) {
            Some(solution) => Ok((solution, self.solver)),
            // Every path ends with a final stage; what follows a failure may not reach its end.
            None => Err(all_failed(self.first_failure, self.tried)),
        }
    }

    /// What follows from the end of a stage; the rows of the table in docs/theory/isothermal-contact.md.
    fn after(
        &mut self,
        stage: &Stage,
        end: StageEnd<S::Solution>,
        observer: &mut dyn Observer,
    ) -> Result<(), SolveError> {
        let (solution, error) = (end.solution, end.outcome.err());
        let (leads, refined) = (stage.role.leads(), stage.refinements > 0);
        if let Some(SolveError::Interrupted) = error {
            return Err(SolveError::Interrupted);
        }
        // A step of a restart on a refined mesh; the solution on the mesh before is kept.
        if refined && leads {
            if error.is_some() && !solution.is_usable() {
                return self.stop_refining(observer);
            }
            let before = self.current.replace(solution);
            self.before_refinement = self.before_refinement.take().or(before);
            return Ok(());
        }
        // Pressures of lower order stand.
        if std::mem::take(&mut self.raising) && (error.is_some() || !solution.has_film()) {
            return Ok(());
        }
        let Some(error) = error else {
            self.accept(stage, solution, end.refinement);
            return Ok(());
        };
        // What a warm start began from solves another problem: there is nothing to go back to.
        if self.warm && self.attempts == 1 {
            return Err(error);
        }
        if stage.role == Role::Final && self.ridge_diffusion < self.outline.ridge_diffusion {
            self.ridge_diffusion = self.outline.ridge_diffusion;
            self.queue.push_front(*stage);
            return Ok(());
        }
        if refined {
            return self.retry_refined(stage, observer);
        }
        // No time is lost on what goes on from a start that failed.
        if leads && self.attempts == 1 {
            self.paths.retain(|path| !path.needs_start);
            self.current = Some(solution);
            return self.fall_back(error);
        }
        if let Some(step) = self.half_step(stage) {
            self.halved_steps += 1;
            self.queue.push_front(*stage);
            self.queue.push_front(step);
            return Ok(());
        }
        if leads && solution.is_usable() {
            self.current = Some(solution);
            return Ok(());
        }
        // It can be done without.
        if stage.role == Role::Estimate || stage.role.compares() {
            return Ok(());
        }
        match self.lower(stage) {
            Some(lower) => {
                self.halved_steps = 0;
                self.queue = VecDeque::from([lower]);
                Ok(())
            }
            None => self.fall_back(error),
        }
    }

    /// Goes on from a solved stage, on a refined mesh if its errors are too large.
    fn accept(&mut self, stage: &Stage, solution: S::Solution, refinement: Option<Refinement>) {
        self.current = Some(solution);
        self.before_refinement = None;
        let Some(refinement) = refinement else {
            self.raise(stage);
            return;
        };
        let for_films = refinement.aim == RefinementTarget::Films;
        if !for_films {
            self.ridge_diffusion = self.outline.ridge_diffusion;
        }
        self.refinement = refinement;
        // Films that are about as accurate as asked for bear no long search, nor does what can be tried with a diffused ridge.
        let can_be_diffused = self.ridge_diffusion < self.outline.ridge_diffusion;
        self.queue.push_back(Stage {
            refinements: stage.refinements + 1,
            undamped: false,
            given_up_early: self.outline.roller || !for_films || can_be_diffused,
            ..*stage
        });
    }

    /// The next path, or the first failure where there is none left.
    fn fall_back(&mut self, error: SolveError) -> Result<(), SolveError> {
        let first = self.first_failure.take().unwrap_or(error);
        let Some(path) = self.paths.pop_front() else {
            return Err(all_failed(Some(first), std::mem::take(&mut self.tried)));
        };
        self.first_failure = Some(first);
        self.halved_steps = 0;
        self.tried.push(path.name);
        self.queue = path.stages.into();
        Ok(())
    }

    /// Half of the step to a stage, if steps may still be halved.
    fn half_step(&self, stage: &Stage) -> Option<Stage> {
        let most = match self.outline.exponential {
            true => MAX_HALVED_EXPONENTIAL_STEPS,
            false => MAX_HALVED_STEPS,
        };
        let from = self.current.as_ref().filter(|_| self.halved_steps < most)?;
        halfway(from.stage(), stage)
    }

    /// A failed final stage with quadratic pressures, where a path has led to it.
    fn lower(&self, stage: &Stage) -> Option<Stage> {
        let from = self.current.as_ref()?;
        let led = stage.role == Role::Final
            && self.first_failure.is_some()
            && from.converged()
            && from.stage().role != Role::Start
            && from.stage().is_on_mesh_of(stage);
        stage.with_quadratic_pressures().filter(|_| led)
    }

    /// The case's own pressures next, on the finest mesh that those of lower order have come to; once.
    fn raise(&mut self, stage: &Stage) {
        let own = self.outline.last().pressure_order;
        if own > stage.pressure_order && !self.raised && stage.role == Role::Final && !self.warm {
            (self.raised, self.raising) = (true, true);
            self.queue.push_back(Stage {
                pressure_order: own,
                // Those of lower order stand, and an exponential seldom bears the overshoots of others.
                given_up_early: self.outline.exponential,
                ..*stage
            });
        }
    }

    /// A refined mesh that failed once more: with quadratic pressures where its ridge is diffused already, else in steps of diminishing
    /// diffusion. Films that are as accurate as asked for need no second try.
    fn retry_refined(
        &mut self,
        stage: &Stage,
        observer: &mut dyn Observer,
    ) -> Result<(), SolveError> {
        let diffused = self.outline.ridge_diffusion > 0.0;
        if let Some(lower) = stage.with_quadratic_pressures().filter(|_| diffused) {
            // It is not for want of a better start that the case's own fail.
            self.raised = true;
            self.queue.push_back(Stage {
                given_up_early: stage.given_up_early,
                ..lower
            });
            return Ok(());
        }
        if diffused && self.refinement.film_bar < GOOD_ENOUGH
            || self.restarted == stage.refinements
            || self.refinement.aim == RefinementTarget::Pressure
        {
            return self.stop_refining(observer);
        }
        self.restarted = stage.refinements;
        let restart = Stage {
            sizes: stage.sizes,
            refinements: stage.refinements,
            newtonian: stage.newtonian,
            cold: false,
            ..*self.outline.start()
        };
        self.queue.push_back(restart);
        self.queue.extend(less_diffusion(&restart, stage));
        self.queue.push_back(*stage);
        Ok(())
    }

    /// Gives a refined mesh up: the solution on the mesh before stands, with an error bar that says what it is worth.
    fn stop_refining(&mut self, observer: &mut dyn Observer) -> Result<(), SolveError> {
        self.queue.clear();
        if let Some(solved) = self.before_refinement.take() {
            self.current = Some(solved);
        }
        let Some(current) = &mut self.current else {
            return Ok(());
        };
        // Only measured so far.
        if current.stage().role == Role::Final {
            self.solver.finish(current, observer)?;
        }
        let stage = *current.stage();
        self.raise(&stage);
        Ok(())
    }
}

/// The error of a solve that failed first for a reason, and then in all that was `tried`.
fn all_failed(first: Option<SolveError>, tried: Vec<&'static str>) -> SolveError {
    let first = first.expect("stages that end without failure end with a solution");
    match tried.is_empty() {
        true => first,
        false => SolveError::AllFailed {
            first: Box::new(first),
            tried,
        },
    }
}
