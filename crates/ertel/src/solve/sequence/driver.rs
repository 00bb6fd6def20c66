//! Which stage comes next, until the last has converged.
//!
//! The driver knows neither meshes nor equations: a [`StageSolver`] solves a stage, [`Driver::decide`] draws the conclusion, and
//! the driver does as decided.

use std::collections::VecDeque;

use super::stage::{Role, Stage};
use super::strategies::halfway::halfway;
use super::strategies::lower_order::quadratic;
use super::strategies::{Fallback, Outline, diffusion, fallbacks};
use crate::solve::adapt::Refinement;
use crate::solve::{Observer, SolveError};

/// Steps that may be halved in one continuation.
const MAX_HALVED_STEPS: usize = 6;

/// The same for fluids whose shear rate grows exponentially with the stress, whose steps are small and cheap.
const MAX_HALVED_EXPONENTIAL_STEPS: usize = 12;

/// What solves a stage.
pub(super) trait StageSolver {
    /// What a stage comes to.
    type Solution: Attempt;

    /// Solves a stage, and says how to refine its mesh if the errors are too large.
    ///
    /// # Errors
    /// Where the stage cannot be begun. That Newton's method fails is an outcome.
    fn solve(
        &mut self,
        task: Task<Self::Solution>,
        observer: &mut dyn Observer,
    ) -> Result<StageEnd<Self::Solution>, SolveError>;

    /// Brings a solution that was only measured to the tolerance of the case, or marks it as rough.
    ///
    /// # Errors
    /// Only [`SolveError::Interrupted`].
    fn finish(
        &mut self,
        solution: &mut Self::Solution,
        observer: &mut dyn Observer,
    ) -> Result<(), SolveError>;
}

/// What the driver asks of the state a stage came to.
pub(super) trait Attempt {
    /// The stage.
    fn stage(&self) -> &Stage;
    /// Whether it came to the tolerance of the stage.
    fn converged(&self) -> bool;
    /// Whether there is film everywhere.
    fn has_film(&self) -> bool;
    /// Whether an unconverged state is still near a contact.
    fn is_usable(&self) -> bool;
}

/// A stage to solve.
pub(super) struct Task<'a, S> {
    pub stage: &'a Stage,
    /// Where it starts, unless from the dry contact.
    pub from: Option<&'a S>,
    /// Halvings of each element of the mesh before that make its own, where it is a refined one.
    pub halvings: &'a [u32],
    /// Stages known to come after it.
    pub stages_to_come: usize,
}

/// How a stage ended.
pub(super) struct StageEnd<S> {
    pub outcome: Result<(), SolveError>,
    pub solution: S,
    /// How to refine its mesh, if errors are too large.
    pub refinement: Option<Refinement>,
}

/// Where a solve stands.
pub(super) struct Driver<S: StageSolver> {
    pub(super) solver: S,
    outline: Outline,
    /// Stages to come.
    queue: VecDeque<Stage>,
    /// What to try if these fail.
    fallbacks: VecDeque<Fallback>,
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
    /// Whether it starts from the solution of another problem.
    warm: bool,
}

/// What follows from the end of a stage.
#[derive(Clone, Debug, PartialEq)]
enum Decision {
    /// It is solved: go on from there, on a refined mesh if its errors are too large.
    Accept,
    /// A restart on a refined mesh came far enough: go on from there, and keep the solution on the mesh before.
    GoOnRefined,
    /// Give the refined mesh up: the solution on the mesh before stands, with an error bar that says what it is worth.
    StopRefining,
    /// Give the case's own pressures up: those of lower order stand.
    KeepLowerOrder,
    /// The refined mesh once more, from a diffusive start.
    RestartRefined,
    /// The start failed: no time is lost on strategies that go on from it.
    ReplaceStart,
    /// The step was too long: this one first.
    Halve(Box<Stage>),
    /// It did not converge, but came near enough to go on from.
    GoOn,
    /// It can be done without.
    Skip,
    /// A continuation came to its end, but for this stage of lower order.
    Lower(Box<Stage>),
    /// The next strategy.
    FallBack,
}

impl<S: StageSolver> Driver<S> {
    /// The usual stages, from the dry contact.
    pub fn new(outline: Outline, solver: S) -> Driver<S> {
        Driver {
            solver,
            queue: outline.usual.iter().copied().collect(),
            fallbacks: fallbacks(&outline).into(),
            outline,
            first_failure: None,
            attempts: 0,
            current: None,
            before_refinement: None,
            refinement: Refinement {
                halvings: Vec::new(),
                for_pressure_alone: false,
            },
            halved_steps: 0,
            restarted: 0,
            raised: false,
            warm: false,
        }
    }

    /// One stage that starts from the solution of a similar problem on its mesh, and refinements after it.
    pub fn warm(outline: Outline, solver: S, from: S::Solution, stage: Stage) -> Driver<S> {
        Driver {
            queue: VecDeque::from([stage]),
            fallbacks: VecDeque::new(),
            current: Some(from),
            warm: true,
            ..Driver::new(outline, solver)
        }
    }

    /// Runs the stages to the end; returns the solution and the solver, which keeps the records.
    ///
    /// # Errors
    /// That of the usual stages when all strategies fail; [`SolveError::Interrupted`]; what keeps a stage from being begun.
    pub fn run(mut self, observer: &mut dyn Observer) -> Result<(S::Solution, S), SolveError> {
        while let Some(stage) = self.queue.pop_front() {
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
        match solution.filter(Attempt::converged) {
            Some(solution) => Ok((solution, self.solver)),
            // Every queue ends with a final stage; what follows a failure may not reach its end.
            None => Err(self
                .first_failure
                .expect("stages that end without failure end with a solution")),
        }
    }

    /// What follows from the end of a stage.
    fn decide(&self, stage: &Stage, end: &StageEnd<S::Solution>) -> Decision {
        let (solved, attempt) = (end.outcome.is_ok(), &end.solution);
        let leads = stage.role.leads();
        let refined = stage.refinements > 0;
        if refined && leads {
            return match solved || attempt.is_usable() {
                true => Decision::GoOnRefined,
                false => Decision::StopRefining,
            };
        }
        if self.raises(stage) && !(solved && attempt.has_film()) {
            return Decision::KeepLowerOrder;
        }
        if solved {
            return Decision::Accept;
        }
        if refined {
            // Films that are as accurate as asked for need no second try.
            let tried = self.restarted == stage.refinements || self.refinement.for_pressure_alone;
            return match tried {
                true => Decision::StopRefining,
                false => Decision::RestartRefined,
            };
        }
        if leads && self.attempts == 1 {
            return Decision::ReplaceStart;
        }
        if let Some(step) = self.halfway(stage) {
            return Decision::Halve(Box::new(step));
        }
        if leads && attempt.is_usable() {
            return Decision::GoOn;
        }
        if stage.role == Role::Estimate || stage.role.compares() {
            return Decision::Skip;
        }
        match self.lower(stage) {
            Some(lower) => Decision::Lower(Box::new(lower)),
            None => Decision::FallBack,
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
                self.refinement = refinement;
                self.queue.push_back(Stage {
                    refinements: stage.refinements + 1,
                    undamped: false,
                    given_up_early: false,
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
            Some(fallback) => self.queue = fallback.stages.into(),
            None => return Err(self.first_failure.take().unwrap_or(SolveError::Interrupted)),
        }
        Ok(())
    }

    /// Half of the step to a stage.
    fn halfway(&self, stage: &Stage) -> Option<Stage> {
        let most = match self.outline.exponential {
            true => MAX_HALVED_EXPONENTIAL_STEPS,
            false => MAX_HALVED_STEPS,
        };
        let from = self.current.as_ref().filter(|_| self.halved_steps < most)?;
        halfway(from.stage(), stage)
    }

    /// A failed final stage with pressures of lower order, where a continuation has led to it.
    fn lower(&self, stage: &Stage) -> Option<Stage> {
        let from = self.current.as_ref()?;
        let led = stage.role == Role::Final
            && self.first_failure.is_some()
            && from.converged()
            && from.stage().role != Role::Start
            && from.stage().has_fluid_and_sliding_of(stage)
            && from.stage().is_on_mesh_of(stage);
        quadratic(stage).filter(|_| led)
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

    /// Whether a stage has the case's own pressures where a solution with those of lower order stands on its mesh.
    fn raises(&self, stage: &Stage) -> bool {
        let from = self.current.as_ref().map(Attempt::stage);
        let below = |from: &Stage| {
            from.role == Role::Final
                && from.pressure_order < stage.pressure_order
                && from.is_on_mesh_of(stage)
        };
        self.raised && from.is_some_and(below)
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
