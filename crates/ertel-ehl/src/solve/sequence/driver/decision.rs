//! What follows from the end of a stage.

use super::{Driver, StageEnd, StageSolver, Trial};
use crate::solution::Role;
use crate::solve::adapt::RefinementTarget;
use crate::solve::sequence::stage::Stage;
use crate::solve::sequence::strategies::halfway::halfway;
use crate::solve::sequence::strategies::lower_order::quadratic;
use crate::solve::tuning::continuation::{
    GOOD_ENOUGH, MAX_HALVED_EXPONENTIAL_STEPS, MAX_HALVED_STEPS,
};

/// What follows from the end of a stage.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Decision {
    /// It is solved: go on from there, on a refined mesh if its errors are too large.
    Accept,
    /// A restart on a refined mesh came far enough: go on from there, and keep the solution on the mesh before.
    GoOnRefined,
    /// Give the refined mesh up: the solution on the mesh before stands, with an error bar that says what it is worth.
    StopRefining,
    /// Give the case's own pressures up: those of lower order stand.
    KeepLowerOrder,
    /// The same stage once more, with diffusion at ridges of the pressure, and all that follow.
    DiffuseRidge,
    /// The refined mesh once more, with pressures of lower order, and those that follow.
    LowerRefined(Box<Stage>),
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
    /// What follows from the end of a stage.
    pub(super) fn decide(&self, stage: &Stage, end: &StageEnd<S::Solution>) -> Decision {
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
        if stage.role == Role::Final && self.ridge_diffusion < self.outline.ridge_diffusion {
            return Decision::DiffuseRidge;
        }
        if refined {
            let lower = quadratic(stage).filter(|_| self.outline.ridge_diffusion > 0.0);
            if let Some(lower) = lower {
                return Decision::LowerRefined(Box::new(lower));
            }
            // With a ridge that is diffused already, another start seldom leads further.
            let good_enough = self.refinement.film_bar < GOOD_ENOUGH;
            if self.outline.ridge_diffusion > 0.0 && good_enough {
                return Decision::StopRefining;
            }
            // Films that are as accurate as asked for need no second try.
            let tried = self.restarted == stage.refinements
                || self.refinement.aim == RefinementTarget::Pressure;
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
            && from.stage().has_fluid_and_motion_of(stage)
            && from.stage().is_on_mesh_of(stage);
        quadratic(stage).filter(|_| led)
    }

    /// Whether a stage has the case's own pressures where a solution with those of lower order stands on its mesh.
    fn raises(&self, stage: &Stage) -> bool {
        let from = self.current.as_ref().map(Trial::stage);
        let below = |from: &Stage| {
            from.role == Role::Final
                && from.pressure_order < stage.pressure_order
                && from.is_on_mesh_of(stage)
        };
        self.raised && from.is_some_and(below)
    }
}
