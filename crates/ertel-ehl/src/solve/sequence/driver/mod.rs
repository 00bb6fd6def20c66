//! Sequence of a solve: a path of stages from the dry contact, other paths where that fails, then finer and finer meshes.
//!
//! ```text
//!   for each path (the usual stages, then those of `paths`):
//!       climb     a step that fails is halved, or continues from a nearly converged state; the last may have its ridge diffused, or quadratic pressures
//!       refine    where that led to the case: until the errors are small; a mesh that fails is retried with other methods, then given up
//! ```
//! A start from another problem is a stage instead of the path. The driver knows neither meshes nor equations: a [`StageSolver`] solves a stage.

mod stage_solver;
#[cfg(test)]
mod tests;

use std::collections::VecDeque;

pub(super) use stage_solver::{StageEnd, StageSolver, Task, Trial};

use super::paths::parameter::halfway;
use super::paths::{Outline, less_diffusion, paths};
use super::stage::Stage;
use crate::engine::{Observer, SolveError};
use crate::solution::Role;
use crate::solve::adapt::{Refinement, RefinementTarget};
use crate::solve::tuning::continuation::{
    GOOD_ENOUGH, MAX_HALVED_EXPONENTIAL_STEPS, MAX_HALVED_STEPS,
};

/// State of a solve.
pub(super) struct Driver<'a, S: StageSolver> {
    solver: S,
    outline: Outline,
    observer: &'a mut dyn Observer,
    /// Where the next stage starts.
    current: Option<S::Solution>,
    /// How to refine its mesh, if its errors are too large.
    refinement: Option<Refinement>,
    /// How the mesh in force was refined.
    halvings: Vec<u32>,
    /// ρ_r in force.
    ridge_diffusion: f64,
    /// Whether the usual stages have failed.
    falls_back: bool,
}

impl<'a, S: StageSolver> Driver<'a, S> {
    pub fn new(outline: Outline, solver: S, observer: &'a mut dyn Observer) -> Driver<'a, S> {
        Driver {
            solver,
            outline,
            observer,
            current: None,
            refinement: None,
            halvings: Vec::new(),
            ridge_diffusion: 0.0,
            falls_back: false,
        }
    }

    /// From the dry contact; returns the solution and the solver, which keeps the records.
    ///
    /// # Errors
    /// That of the usual stages when all paths fail; [`SolveError::Interrupted`]; the reason why a stage cannot start.
    pub fn run(mut self) -> Result<(S::Solution, S), SolveError> {
        let Some(first) = self.climb(self.outline.usual.clone())? else {
            return self.refine();
        };
        self.falls_back = true;
        // Paths that continue from a failed start are skipped.
        let has_start = self.current.is_some();
        let mut tried = Vec::new();
        for path in paths(&self.outline) {
            if path.needs_start && !has_start {
                continue;
            }
            tried.push(path.name);
            if self.climb(path.stages)?.is_none() {
                return self.refine();
            }
        }
        let first = Box::new(first);
        Err(SolveError::AllFailed { first, tried })
    }

    /// One stage from the solution of a similar problem on its mesh, and refinements after it. There is no fallback.
    ///
    /// # Errors
    /// As [`Self::run`].
    pub fn run_from(
        mut self,
        from: S::Solution,
        stage: Stage,
    ) -> Result<(S::Solution, S), SolveError> {
        self.current = Some(from);
        self.ridge_diffusion = stage.constants.ridge_diffusion;
        let end = self.solve(stage, 0)?;
        (self.refinement, self.current) = (end.outcome?, Some(end.solution));
        self.refine()
    }

    /// Solves a stage from the present state.
    fn solve(
        &mut self,
        mut stage: Stage,
        stages_to_come: usize,
    ) -> Result<StageEnd<S::Solution>, SolveError> {
        if self.observer.cancelled() {
            return Err(SolveError::Interrupted);
        }
        if stage.role == Role::Final {
            stage.constants.ridge_diffusion = self.ridge_diffusion;
        }
        let task = Task {
            stage: &stage,
            from: self.current.as_ref(),
            halvings: &self.halvings,
            stages_to_come,
        };
        let end = self.solver.solve(task, self.observer)?;
        match end.outcome {
            Err(SolveError::Interrupted) => Err(SolveError::Interrupted),
            _ => Ok(end),
        }
    }

    /// Along a path to the case; returns the error if it fails.
    fn climb(&mut self, path: Vec<Stage>) -> Result<Option<SolveError>, SolveError> {
        let (mut queue, mut n_halved) = (VecDeque::from(path), 0);
        while let Some(stage) = queue.pop_front() {
            let StageEnd { outcome, solution } = self.solve(stage, queue.len())?;
            let error = match outcome {
                Ok(refinement) => {
                    (self.refinement, self.current) = (refinement, Some(solution));
                    continue;
                }
                Err(error) => error,
            };
            let is_first = self.current.is_none() && !self.falls_back;
            if stage.role == Role::Final && self.diffuse_ridge() {
                queue.push_front(stage);
            } else if let Some(half) = self.half_step(&stage, n_halved) {
                n_halved += 1;
                queue.push_front(stage);
                queue.push_front(half);
            } else if stage.role.leads() && solution.is_usable() && !is_first {
                self.current = Some(solution);
            } else if let Some(lower) = self.lower(&stage) {
                queue = VecDeque::from([lower]);
            } else if stage.role != Role::Estimate && !stage.role.compares() {
                // Comparisons are optional.
                return Ok(Some(error));
            }
        }
        Ok(None)
    }

    /// Switches on diffusion at ridges of the pressure; returns whether it was off.
    fn diffuse_ridge(&mut self) -> bool {
        let is_new = self.ridge_diffusion < self.outline.ridge_diffusion;
        self.ridge_diffusion = self.ridge_diffusion.max(self.outline.ridge_diffusion);
        is_new
    }

    /// Half of the step to a stage, if steps may still be halved.
    fn half_step(&self, stage: &Stage, n_halved: usize) -> Option<Stage> {
        let most = match self.outline.exponential {
            _ if stage.refinements > 0 => 0,
            true => MAX_HALVED_EXPONENTIAL_STEPS,
            false => MAX_HALVED_STEPS,
        };
        let from = self.current.as_ref().filter(|_| n_halved < most)?;
        halfway(from.stage(), stage)
    }

    /// A failed final stage with quadratic pressures: where steps on its mesh have led to it, or on a refined one with a diffused ridge.
    fn lower(&self, stage: &Stage) -> Option<Stage> {
        let from = self.current.as_ref()?;
        let led = self.falls_back
            && from.converged()
            && from.stage().role != Role::Start
            && from.stage().is_on_mesh_of(stage);
        let diffused = stage.refinements > 0 && self.ridge_diffusion > 0.0;
        let lower = stage.with_quadratic_pressures();
        lower.filter(|_| stage.role == Role::Final && (led || diffused))
    }

    /// From a solution of the case on finer meshes until its errors are small. Where a mesh fails twice, the
    /// solution on the previous mesh is the result, with its error bar.
    fn refine(mut self) -> Result<(S::Solution, S), SolveError> {
        while let Some(by) = self.refinement.take() {
            let for_films = by.aim == RefinementTarget::Films;
            if !for_films {
                self.diffuse_ridge();
            }
            let may_be_diffused = self.ridge_diffusion < self.outline.ridge_diffusion;
            self.halvings = by.halvings;
            let at = *self.current.as_ref().expect("a solution").stage();
            let stage = Stage {
                refinements: at.refinements + 1,
                undamped: false,
                // No long search where films nearly meet their target, or where a diffused ridge can be tried.
                given_up_early: self.outline.roller || !for_films || may_be_diffused,
                ..at
            };
            if self.climb(vec![stage])?.is_none() {
                continue;
            }
            // Films that meet their target need no second try.
            let good_enough = by.aim == RefinementTarget::Pressure
                || self.ridge_diffusion > 0.0 && by.film_bar < GOOD_ENOUGH;
            let before = self.current.clone();
            if !good_enough && self.climb(self.restart(&stage))?.is_none() {
                continue;
            }
            self.current = before;
            // Only measured so far.
            if let Some(current) = &mut self.current {
                self.solver.finish(current, self.observer)?;
            }
        }
        let solution = self.current.expect("a path ends with a solution");
        Ok((solution, self.solver))
    }

    /// To a stage on a refined mesh in steps of diminishing diffusion.
    fn restart(&self, stage: &Stage) -> Vec<Stage> {
        let lower = stage.with_quadratic_pressures();
        let stage = lower
            .filter(|_| self.ridge_diffusion > 0.0)
            .unwrap_or(*stage);
        let start = Stage {
            sizes: stage.sizes,
            refinements: stage.refinements,
            newtonian: stage.newtonian,
            cold: false,
            ..*self.outline.start()
        };
        let mut path = vec![start];
        path.extend(less_diffusion(&start, &stage));
        path.push(stage);
        path
    }
}
