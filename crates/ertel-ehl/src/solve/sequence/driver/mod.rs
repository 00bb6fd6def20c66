//! Which stage comes next, until the last has converged.
//!
//! The driver knows neither meshes nor equations: a [`StageSolver`] solves a stage, [`Driver::decide`] draws the conclusion, and
//! the driver does as decided.

mod decision;
#[cfg(test)]
mod scripted;
mod stage_solver;
#[cfg(test)]
mod tests;

use std::collections::VecDeque;

use decision::Decision;
pub(super) use stage_solver::{StageEnd, StageSolver, Task, Trial};

use super::stage::Stage;
use super::strategies::{Fallback, Outline, diffusion, fallbacks};
use crate::solution::Role;
use crate::solve::adapt::{Refinement, RefinementTarget};
use crate::solve::{Observer, SolveError};

/// Where a solve stands.
pub(super) struct Driver<S: StageSolver> {
    pub(super) solver: S,
    outline: Outline,
    /// Stages to come.
    queue: VecDeque<Stage>,
    /// What to try if these fail.
    fallbacks: VecDeque<Fallback>,
    /// What was tried of it.
    tried: Vec<&'static str>,
    /// Why the usual stages failed: the error to report when all strategies do.
    first_failure: Option<SolveError>,
    /// Stages solved or given up.
    attempts: usize,
    /// Where the next stage starts.
    current: Option<S::Solution>,
    /// The last solution of a final stage, while a refined mesh is being tried.
    before_refinement: Option<S::Solution>,
    /// How the next mesh, or that in force, was refined.
    refinement: Refinement,
    /// Steps halved in the present continuation.
    halved_steps: usize,
    /// Refinements of the mesh that has been tried once more.
    restarted: usize,
    /// Whether the case's own pressures have been tried from those of lower order.
    raised: bool,
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
            fallbacks: fallbacks(&outline).into(),
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
            ridge_diffusion: 0.0,
            warm: false,
        }
    }

    /// One stage that starts from the solution of a similar problem on its mesh, and refinements after it.
    pub fn warm(outline: Outline, solver: S, from: S::Solution, stage: Stage) -> Driver<S> {
        Driver {
            queue: VecDeque::from([stage]),
            fallbacks: VecDeque::new(),
            current: Some(from),
            ridge_diffusion: stage.constants.ridge_diffusion,
            warm: true,
            ..Driver::new(outline, solver)
        }
    }

    /// Runs the stages to the end; returns the solution and the solver, which keeps the records.
    ///
    /// # Errors
    /// That of the usual stages when all strategies fail; [`SolveError::Interrupted`]; what keeps a stage from being begun.
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
            let mut end = self.solver.solve(task, observer)?;
            self.attempts += 1;
            if matches!(end.outcome, Err(SolveError::Interrupted)) {
                return Err(SolveError::Interrupted);
            }
            if self.warm && self.attempts == 1 {
                // What it started from solves another problem: there is nothing to go back to.
                std::mem::replace(&mut end.outcome, Ok(()))?;
            }
            let decision = self.decide(&stage, &end);
            self.follow(decision, &stage, end, observer)?;
        }
        let solution = self.current.filter(|s| s.stage().role == Role::Final);
        match solution.filter(Trial::converged) {
            Some(solution) => Ok((solution, self.solver)),
            // Every queue ends with a final stage; what follows a failure may not reach its end.
            None => Err(all_failed(self.first_failure, self.tried)),
        }
    }

    /// Does as decided.
    fn follow(
        &mut self,
        decision: Decision,
        stage: &Stage,
        end: StageEnd<S::Solution>,
        observer: &mut dyn Observer,
    ) -> Result<(), SolveError> {
        let StageEnd {
            outcome,
            solution,
            refinement,
        } = end;
        match decision {
            Decision::Accept => self.accept(stage, solution, refinement),
            Decision::GoOnRefined => {
                let before = self.current.replace(solution);
                self.before_refinement = self.before_refinement.take().or(before);
            }
            Decision::StopRefining => self.stop_refining(observer)?,
            Decision::DiffuseRidge => {
                self.ridge_diffusion = self.outline.ridge_diffusion;
                self.queue.push_front(*stage);
            }
            Decision::LowerRefined(lower) => {
                // It is not for want of a better start that the case's own fail.
                self.raised = true;
                self.queue.push_back(Stage {
                    given_up_early: stage.given_up_early,
                    ..*lower
                });
            }
            Decision::RestartRefined => self.restart_refined(stage),
            Decision::KeepLowerOrder | Decision::Skip => {}
            Decision::GoOn => self.current = Some(solution),
            Decision::Halve(step) => {
                self.halved_steps += 1;
                self.queue.push_front(*stage);
                self.queue.push_front(*step);
            }
            Decision::Lower(lower) => {
                self.keep_failure(outcome);
                self.halved_steps = 0;
                self.queue = VecDeque::from([*lower]);
            }
            Decision::ReplaceStart => {
                self.keep_failure(outcome);
                self.fallbacks.retain(|fallback| !fallback.needs_start);
                self.current = Some(solution);
                self.fall_back()?;
            }
            Decision::FallBack => {
                self.keep_failure(outcome);
                self.fall_back()?;
            }
        }
        Ok(())
    }

    fn keep_failure(&mut self, outcome: Result<(), SolveError>) {
        if let Err(e) = outcome {
            self.first_failure.get_or_insert(e);
        }
    }

    /// Goes on from a solved stage.
    fn accept(&mut self, stage: &Stage, solution: S::Solution, refinement: Option<Refinement>) {
        self.current = Some(solution);
        self.before_refinement = None;
        match refinement {
            Some(refinement) => {
                if refinement.aim != RefinementTarget::Films {
                    self.ridge_diffusion = self.outline.ridge_diffusion;
                }
                // Films that are about as accurate as asked for bear no long search, nor does what can be tried with a diffused ridge.
                let given_up_early = self.outline.impatient
                    || refinement.aim != RefinementTarget::Films
                    || self.ridge_diffusion < self.outline.ridge_diffusion;
                self.refinement = refinement;
                self.queue.push_back(Stage {
                    refinements: stage.refinements + 1,
                    undamped: false,
                    given_up_early,
                    ..*stage
                });
            }
            None => self.raise(stage),
        }
    }

    /// The next strategy, or the first failure where there is none left.
    fn fall_back(&mut self) -> Result<(), SolveError> {
        self.halved_steps = 0;
        match self.fallbacks.pop_front() {
            Some(fallback) => {
                self.tried.push(fallback.name);
                self.queue = fallback.stages.into();
            }
            None => {
                let tried = std::mem::take(&mut self.tried);
                return Err(all_failed(self.first_failure.take(), tried));
            }
        }
        Ok(())
    }

    /// The case's own pressures next, on the finest mesh that those of lower order have come to; once.
    fn raise(&mut self, stage: &Stage) {
        let own = self.outline.last().pressure_order;
        if own > stage.pressure_order && !self.raised && stage.role == Role::Final && !self.warm {
            self.raised = true;
            self.queue.push_back(Stage {
                pressure_order: own,
                // Those of lower order stand, and an exponential seldom bears the overshoots of others.
                given_up_early: self.outline.exponential,
                ..*stage
            });
        }
    }

    /// A refined mesh once more, in steps of diminishing diffusion.
    fn restart_refined(&mut self, stage: &Stage) {
        self.restarted = stage.refinements;
        let restart = Stage {
            sizes: stage.sizes,
            refinements: stage.refinements,
            newtonian: stage.newtonian,
            cold: false,
            ..*self.outline.start()
        };
        self.queue.push_back(restart);
        self.queue.extend(diffusion::steps(&restart, stage));
        self.queue.push_back(*stage);
    }

    /// Gives a refined mesh up: the solution on the mesh before stands.
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
