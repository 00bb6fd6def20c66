//! Newton's method on one stage.

use ertel_fem::platform::Instant;

use super::{Problem, Stage};
use crate::engine::far_field::beyond_edges;
use crate::engine::{Observer, SolveError};
use crate::solution::{LevelStats, Role};
use crate::solve::adjoint::RoughAdjoints;
use crate::solve::discretisation::Discretisation;
use crate::solve::figures::{Scope, figures};
use crate::solve::heat::coupling::{CouplingParams, CouplingStats, solve_coupled};
use crate::solve::heat::deviation::deviation;
use crate::solve::indicator::{Indicator, indicator};
use crate::solve::newton_level::{
    FilmModel, NewtonLevel, NewtonParams, NewtonStats, NewtonStatus, RunLabel,
};
use crate::solve::state::{FilmConstants, State};
pub(super) use crate::solve::tuning::stages::DIVERGENCE_LIMIT;
use crate::solve::tuning::stages::{
    EARLY_ITERATIONS, EARLY_STAGNATION, EXACT_ENOUGH, EXPONENTIAL_TOLERANCE, PATH_COUPLING,
    PATH_ROUNDS, PENALTY_CONTINUATION, PENALTY_RAMP, ROUGH_FILM_CHANGE, ROUGH_RESIDUAL,
    ROUGH_SHARE, ROUGH_UPDATE, START_ITERATIONS, START_STAGNATION, START_TOLERANCE,
    UNDAMPED_STAGNATION,
};

/// Accuracy to which Newton's method is run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Finish {
    /// To the tolerance of the case.
    Exact,
    /// As exactly as measuring or refining needs.
    Rough,
}

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
    pub fn solve(
        &self,
        finish: Finish,
        state: &mut State,
        effort: &mut NewtonStats,
        observer: &mut dyn Observer,
    ) -> Result<(NewtonStatus, Option<CouplingStats>), SolveError> {
        let (stage, params) = (&self.stage, self.params(finish));
        let from = state.clone();
        let ramp: &[f64] = match stage.role {
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
        // Where the updates cycle even with a diffused ridge, the penalty is not the cause.
        let diffused = stage.constants.ridge_diffusion > 0.0;
        let is_led_to = stage.role.leads() || stage.undamped || stage.given_up_early;
        if !circling || diffused || is_led_to {
            return outcome;
        }
        let mut trial = from;
        // A film that a coarse mesh does not resolve keeps thinning.
        let led = NewtonParams {
            film_tolerance: f64::INFINITY,
            ..params
        };
        for share in PENALTY_CONTINUATION {
            match self.run(share, &led, &mut trial, effort, observer) {
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
    fn params(&self, finish: Finish) -> NewtonParams {
        let (stage, problem) = (&self.stage, self.problem);
        let mut params = problem.plan.newton;
        if finish == Finish::Rough {
            let mut update = EXACT_ENOUGH;
            let costly = self.discretisation.contact.surface.dim > 1;
            if let Some(adapt) = problem.plan.adapt.as_ref().filter(|_| costly) {
                update = (ROUGH_SHARE * adapt.target).sqrt().min(ROUGH_UPDATE);
                params.film_tolerance = ROUGH_FILM_CHANGE * adapt.target;
            }
            params.update_tolerance = params.update_tolerance.max(update);
            params.residual_tolerance = params.residual_tolerance.max(ROUGH_RESIDUAL);
        }
        if stage.undamped {
            params.safe_update = f64::INFINITY;
            params.patience = UNDAMPED_STAGNATION;
        }
        if stage.given_up_early {
            let most = EARLY_ITERATIONS[usize::from(problem.shape.zone.roller.is_some())];
            params.patience = params.patience.min(EARLY_STAGNATION);
            params.max_iterations = params.max_iterations.min(most);
        }
        if stage.role.leads() {
            params.update_tolerance = START_TOLERANCE;
            params.residual_tolerance = f64::INFINITY;
            params.film_tolerance = f64::INFINITY;
            params.max_iterations = START_ITERATIONS;
            params.patience = START_STAGNATION;
            params.trusted_fall = 0.0;
        }
        if stage.role == Role::Path && problem.fluid.is_exponential() && !stage.newtonian {
            params.update_tolerance = EXPONENTIAL_TOLERANCE;
            params.residual_tolerance = EXPONENTIAL_TOLERANCE;
        }
        params
    }

    /// To the tolerance of the case from a state that was only measured, whose coupling with the heat counts, too.
    pub(super) fn finish(
        &self,
        rough: Option<CouplingStats>,
        state: &mut State,
        effort: &mut NewtonStats,
        observer: &mut dyn Observer,
    ) -> Result<(NewtonStatus, Option<CouplingStats>), SolveError> {
        let (reached, coupling) = self.solve(Finish::Exact, state, effort, observer)?;
        Ok((reached, coupling.map(|c| c.after(rough))))
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
        let (path, early) = (self.stage.role == Role::Path, self.stage.given_up_early);
        let mut coupling = CouplingParams {
            tolerance: plan.coupling.tolerance.max(params.update_tolerance),
            given_up_early: early,
            ..plan.coupling
        };
        // Where a continuation through easier contacts is known, or this is one, its steps are halved instead.
        if early || path {
            coupling.smallest_share = 1.0;
        }
        if path {
            coupling.tolerance = coupling.tolerance.max(PATH_COUPLING);
            coupling.by_error = false;
            coupling.max_rounds = coupling.max_rounds.min(PATH_ROUNDS);
        }
        let (reached, coupling) = solve_coupled(
            &self.newton,
            &model,
            &heat.with_sliding(self.stage.sliding),
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
        let stage = &self.stage;
        let fluid = (self.problem.fluid)
            .with_viscosity_exponent(stage.viscosity_exponent)
            .with_softness(stage.softness)
            .with_sliding(stage.sliding);
        FilmModel {
            fluid: if self.stage.newtonian {
                fluid.newtonian()
            } else {
                fluid
            },
            constants: FilmConstants {
                penalty: constants.penalty * penalty_share,
                ..constants
            },
        }
    }

    /// Errors of a solution, cell by cell; `None` where they cannot be computed.
    pub fn measure(&self, state: &State, effort: &mut NewtonStats) -> Option<Indicator> {
        let clock = Instant::now();
        let (near, kept) = (self.newton.near(), self.newton.take_preconditioner());
        let model = self.model(1.0);
        let indicator = indicator(self.discretisation, &model, state, near, kept).ok();
        effort.seconds.estimate += clock.elapsed().as_secs_f64();
        indicator
    }

    /// Approximate adjoints from the last solve and the estimate of its errors.
    pub fn rough_adjoints(&self, indicator: Option<Indicator>) -> RoughAdjoints {
        RoughAdjoints {
            preconditioner: self.newton.take_preconditioner(),
            films: indicator.map_or_else(Vec::new, |indicator| indicator.adjoints),
        }
    }

    /// Statistics for the report.
    pub fn stats(
        &self,
        converged: bool,
        state: &State,
        effort: &NewtonStats,
        indicator: Option<&Indicator>,
        clock: Instant,
    ) -> LevelStats {
        let (problem, d) = (self.problem, self.discretisation);
        let contact = &d.contact;
        // Stages that lead to others, and failed ones, need no figures.
        let extent = match self.stage.role {
            Role::Estimate | Role::Final | Role::Isothermal if converged => Scope::All,
            _ => Scope::Films,
        };
        let mut stats = LevelStats {
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
            estimate: None,
            seconds: effort.seconds,
        };
        let place = |figure| {
            let place = stats.figures.get(figure)?.place?;
            Some(place.map(|x| x / problem.scales.length))
        };
        let units = [problem.scales.pressure, problem.scales.length];
        stats.estimate = indicator.map(|i| i.estimate(d, &stats.figures, units));
        if let (Some(estimate), Some(i)) = (&mut stats.estimate, indicator) {
            let unit = problem.fluid.stress_scale();
            estimate.shear_stress = unit * i.shear_stress;
            estimate.beyond_edges = beyond_edges(
                &problem.shape,
                &problem.extents,
                problem.reach,
                unit,
                &problem.scales,
            );
        }
        let temperatures = d.heat.as_ref().map(|heat| deviation(d, heat, state, place));
        if let (Some(estimate), Some(found)) = (&mut stats.estimate, temperatures) {
            estimate.temperatures = found;
        }
        stats.seconds.other = clock.elapsed().as_secs_f64() - stats.seconds.known();
        stats
    }
}
