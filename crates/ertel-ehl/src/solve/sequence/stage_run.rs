//! Newton's method on one stage.

use super::{Problem, Stage};
use crate::engine::{Observer, SolveError};
use crate::solution::{LevelStats, Role};
use crate::solve::discretisation::Discretisation;
use crate::solve::figures::{Scope, figures};
use crate::solve::heat::coupling::{CouplingParams, CouplingStats, solve_coupled};
use crate::solve::newton_level::{
    FilmModel, NewtonLevel, NewtonParams, NewtonStats, NewtonStatus, RunLabel,
};
use crate::solve::state::{FilmConstants, State};
pub(super) use crate::solve::tuning::stages::DIVERGENCE_LIMIT;
use crate::solve::tuning::stages::{
    PENALTY_CONTINUATION, PENALTY_RAMP, ROUGH_RESIDUAL, ROUGH_UPDATE, START_ITERATIONS,
    START_STAGNATION, START_TOLERANCE,
};

/// A stage on its mesh.
pub struct StageRun<'a> {
    problem: &'a Problem,
    stage: Stage,
    /// Number of the stage.
    level: usize,
    discretisation: &'a Discretisation,
    newton: NewtonLevel<'a>,
}

impl<'a> StageRun<'a> {
    /// Prepares a stage.
    pub fn new(
        problem: &'a Problem,
        stage: &Stage,
        level: usize,
        discretisation: &'a Discretisation,
    ) -> StageRun<'a> {
        StageRun {
            problem,
            stage: *stage,
            level,
            discretisation,
            newton: NewtonLevel::new(discretisation, problem.load, problem.plan.linear),
        }
    }

    /// Newton's method: through the penalty ramp if the stage is a start, and with a small penalty first where the updates cycle.
    ///
    /// # Errors
    /// When it does not converge, or the user wants to stop.
    pub fn solve(
        &self,
        state: &mut State,
        effort: &mut NewtonStats,
        observer: &mut dyn Observer,
    ) -> Result<(NewtonStatus, Option<CouplingStats>), SolveError> {
        let params = self.params();
        let from = state.clone();
        let ramp: &[f64] = match self.stage.role {
            Role::Start => &PENALTY_RAMP,
            _ => &[1.0],
        };
        let mut outcome = Ok((NewtonStatus::default(), None));
        for share in ramp {
            outcome = self.run(*share, &params, state, effort, observer);
            // A stalled run may continue with more of the penalty, unless it is far from the solution.
            let is_far = |residual: f64| residual > DIVERGENCE_LIMIT;
            match outcome {
                Ok(_) => {}
                Err(SolveError::NotConverged { residual, .. }) if !is_far(residual) => {}
                Err(_) => break,
            }
        }
        let circling = matches!(outcome, Err(SolveError::NotConverged { .. }));
        if !circling || self.stage.role == Role::Start {
            return outcome;
        }
        let mut trial = from;
        for share in PENALTY_CONTINUATION {
            match self.run(share, &params, &mut trial, effort, observer) {
                Err(SolveError::Interrupted) => return Err(SolveError::Interrupted),
                // The penalty is not the cause.
                Err(_) => return outcome,
                Ok(_) => {}
            }
        }
        let gentle = self.run(1.0, &params, &mut trial, effort, observer);
        if gentle.is_ok() {
            *state = trial;
        }
        gentle
    }

    /// Tolerances and iteration limits of Newton's method by the role of the stage.
    fn params(&self) -> NewtonParams {
        let mut params = self.problem.plan.newton;
        match self.stage.role {
            Role::Start => {
                params.update_tolerance = START_TOLERANCE;
                params.residual_tolerance = f64::INFINITY;
                params.max_iterations = START_ITERATIONS;
                params.patience = START_STAGNATION;
                params.trusted_fall = 0.0;
            }
            // It is only measured; a comparison's error would count as the effect.
            Role::Estimate => {
                params.update_tolerance = params.update_tolerance.max(ROUGH_UPDATE);
                params.residual_tolerance = params.residual_tolerance.max(ROUGH_RESIDUAL);
            }
            Role::Comparison | Role::Isothermal | Role::Final => {}
        }
        params
    }

    /// Newton's method with a share of the penalty, in turn with that for the temperatures where the stage is heated.
    fn run(
        &self,
        penalty_share: f64,
        params: &NewtonParams,
        state: &mut State,
        effort: &mut NewtonStats,
        observer: &mut dyn Observer,
    ) -> Result<(NewtonStatus, Option<CouplingStats>), SolveError> {
        let label = RunLabel {
            level: self.level,
            penalty_share,
            film_scale: self.problem.scales.film,
        };
        let model = self.model(penalty_share);
        let heat = self.problem.heat.as_ref();
        let heat = heat.zip(self.problem.plan.heat.as_ref());
        let Some((heat, plan)) = heat.filter(|_| self.stage.heated) else {
            let reached = (self.newton).run(&model, params, &label, state, effort, observer)?;
            return Ok((reached, None));
        };
        let coupling = CouplingParams {
            tolerance: plan.coupling.tolerance.max(params.update_tolerance),
            ..plan.coupling
        };
        let (reached, coupling) = solve_coupled(
            &self.newton,
            &model,
            heat,
            params,
            &coupling,
            &label,
            state,
            effort,
            observer,
        )?;
        Ok((reached, Some(coupling)))
    }

    /// The film equations with a share of the cavitation penalty.
    pub fn model(&self, penalty_share: f64) -> FilmModel {
        let constants = self.stage.constants;
        let fluid = &self.problem.fluid;
        FilmModel {
            fluid: match self.stage.newtonian {
                true => fluid.newtonian(),
                false => fluid.clone(),
            },
            constants: FilmConstants {
                penalty: constants.penalty * penalty_share,
                ..constants
            },
        }
    }

    /// Effort and figures for the report.
    pub fn stats(&self, converged: bool, state: &State, effort: &NewtonStats) -> LevelStats {
        let (problem, d) = (self.problem, self.discretisation);
        let contact = &d.contact;
        // Stages that lead to others, and failed ones, need no figures.
        let extent = match self.stage.role {
            Role::Estimate | Role::Final | Role::Isothermal if converged => Scope::All,
            _ => Scope::Films,
        };
        LevelStats {
            converged,
            n_body_cells: contact
                .body()
                .map_or(0, |(body, _)| body.mesh.mesh.n_cells()),
            n_contact_elements: contact.n_elements(),
            n_pressure_dofs: d.n_pressure,
            n_displacement_dofs: contact.n_displacement,
            n_contact_dofs: contact.deflection.n_nodes(),
            pressure_order: self.stage.pressure_order,
            role: self.stage.role,
            newton_iterations: effort.iterations,
            krylov_iterations: effort.krylov_iterations,
            factorisations: effort.factorisations,
            figures: figures(problem, &self.model(1.0).fluid, d, state, extent),
            seconds: effort.seconds,
        }
    }
}
