//! Newton's method on one level, with physically limited steps.
//!
//! - Falling pressures are updated in the logarithm of viscosity, −ln(1 − dP m)/m with
//!   m = d ln μ̄/dP: linearly, one step could undo many decades of viscosity.
//! - Rising pressures are capped at a share of the Hertz pressure.
//! - The surfaces are lifted where a point would lose more than half of its film.
//! - Where shear rates grow exponentially with the stress and the residual exceeds the entrained flow, the state is far out on an
//!   exponential: a whole step reduces the residual by one e-fold, whatever the distance. Steps are lengthened while the residual falls, steps
//!   that would lead out there are shortened, and a falling residual counts as progress.
//!
//! Near the solution none of these acts beyond second order, and convergence is quadratic.
//!
//! Theory: How it is solved.

use std::cell::RefCell;

use super::discretisation::Discretisation;
use super::monolithic::BodyMatrices;
use super::newton_level::{
    FilmModel, Method, NewtonLevel, NewtonParams, NewtonStats, NewtonStatus, RunLabel,
};
use super::preconditioner::{NearStiffness, Preconditioner};
use super::state::State;
use super::step::{Step, StepSolver, dot};
use crate::elastic::Accuracy;
use crate::engine::{Observer, SolveError, Stopped};
use crate::film::FilmFluid;
use crate::params::LinearSolver;
use crate::solution::IterationRecord;
use crate::solve::evaluate::{central_film, minimum_film};
use crate::solve::points::films_and_changes;
use crate::solve::tuning::newton::{
    FAR_OUT, LONGEST_STRIDE, MOST_RISE, PREDICTED_FROM, PREDICTED_ORDER, SMALLEST_EXPONENTIAL_SHARE,
};

impl<'a> NewtonLevel<'a> {
    /// Prepares a level.
    pub fn new(
        discretisation: &'a Discretisation,
        load: f64,
        solver: LinearSolver,
    ) -> NewtonLevel<'a> {
        let method = match solver {
            LinearSolver::Condensed => Method::Condensed(NearStiffness::new(discretisation)),
            LinearSolver::Monolithic => Method::Monolithic(BodyMatrices::new(discretisation)),
        };
        NewtonLevel {
            discretisation,
            method,
            load,
            kept: RefCell::default(),
        }
    }

    /// The preconditioner of the last converged run, once.
    pub(super) fn take_preconditioner(&self) -> Option<Preconditioner> {
        self.kept.take()
    }

    /// Data shared by the preconditioners of this level, where its systems are solved by iterations.
    pub(super) fn near(&self) -> Option<&NearStiffness> {
        match &self.method {
            Method::Condensed(near) => Some(near),
            Method::Monolithic(_) => None,
        }
    }

    /// Iterates until both tolerances hold, or are predicted to hold after the step just taken. `state` is the start,
    /// then the solution.
    ///
    /// # Errors
    /// When the iterations run out, the linear solver fails, or the user interrupts.
    pub fn run(
        &self,
        model: &FilmModel,
        params: &NewtonParams,
        label: &RunLabel,
        state: &mut State,
        stats: &mut NewtonStats,
        observer: &mut dyn Observer,
    ) -> Result<NewtonStatus, SolveError> {
        let go_on = |observer: &dyn Observer| match observer.cancelled() {
            true => Err(SolveError::Interrupted),
            false => Ok(()),
        };
        go_on(observer)?;
        let mut solver = StepSolver::new(self, params, stats);
        let mut system = solver.assemble(model, state);
        let mut step = solver.newton_step(&system, state)?;
        let mut smallest_update = (0, f64::INFINITY);
        let mut smallest_residual = f64::INFINITY;
        let exponential = model.fluid.is_exponential();
        // Update of the iteration before, if its step was taken whole.
        let mut update_before = None;
        // Whether a step had to be shortened: from then on a small residual is not trusted.
        let mut shortened = false;
        for iteration in 1..=params.max_iterations {
            let residual = system.relative_residual();
            let update = max_abs(&step.pressure);
            let stopped = |reason| SolveError::NotConverged {
                level: label.level,
                iterations: iteration,
                residual,
                update,
                penalty_share: label.penalty_share,
                reason,
            };
            if !(residual.is_finite() && update.is_finite()) {
                return Err(stopped(Stopped::NotFinite));
            }
            let far_out = exponential && residual > FAR_OUT;
            if update < 0.9 * smallest_update.1 {
                smallest_update = (iteration, update);
            } else if far_out && residual < 0.5 * smallest_residual {
                smallest_update.0 = iteration;
            } else if iteration >= smallest_update.0 + params.patience {
                return Err(stopped(Stopped::Circling));
            }
            smallest_residual = smallest_residual.min(residual);
            let converged =
                update < params.update_tolerance && residual < params.residual_tolerance;
            // Small steps are not tested, unless the updates cycle.
            let circling = iteration > smallest_update.0 + 2;
            let tested = update >= params.safe_update || circling;
            let mut share = match far_out {
                true => self.stride(model, params, state, &step, &mut solver),
                false => 1.0,
            };
            let smallest_share = match exponential {
                true => SMALLEST_EXPONENTIAL_SHARE,
                false => params.smallest_share,
            };
            let (next_state, next_system) = loop {
                go_on(observer)?;
                let trial = self.advance(model, params, state, &step, share);
                let trial_system = solver.assemble(model, &trial);
                let finite = trial_system.relative_residual().is_finite();
                let there = trial_system.relative_residual();
                let fell = (!shortened && there < params.trusted_fall * residual)
                    || (far_out && there < 0.5 * residual);
                let admissible = !exponential || there < MOST_RISE * residual.max(FAR_OUT);
                if finite && admissible && (converged || !tested || fell) {
                    break (trial, trial_system);
                }
                // Natural monotonicity (Deuflhard 2004, section 3.3): the next step, were it
                // taken with this Jacobian, must not grow.
                let growth = if finite && admissible {
                    solver
                        .simplified_step(&system, &trial_system, &trial)
                        .map_or(f64::INFINITY, |s| rms(&s.pressure) / rms(&step.pressure))
                } else {
                    f64::INFINITY
                };
                let growth_limit = match update < params.safe_update {
                    true => 1.0 - 0.25 * share,
                    false => params.growth_limit,
                };
                if growth < growth_limit || (finite && admissible && share < params.smallest_share)
                {
                    break (trial, trial_system);
                }
                if share < smallest_share {
                    return Err(stopped(Stopped::NoStep));
                }
                share *= 0.5;
                shortened = true;
            };
            solver.stats.iterations += 1;
            let before = std::mem::replace(state, next_state);
            observer.iteration(&IterationRecord {
                level: label.level,
                pressure_order: self.discretisation.pressure.element.order(),
                penalty_share: label.penalty_share,
                iteration,
                residual,
                update,
                step: share,
                krylov_iterations: step.krylov_iterations,
                film_central: label.film_scale * central_film(self.discretisation, state),
                heat: None,
            });
            // The error of the state is about the next update: after two whole steps that update is
            // predicted, and the residual at it is known.
            let whole = share >= 1.0;
            let predicted = match update_before {
                Some(before) if whole && update < f64::min(before, PREDICTED_FROM) => {
                    update * (update / before).powf(PREDICTED_ORDER)
                }
                _ => f64::INFINITY,
            };
            let done = params.foresight
                && predicted < params.update_tolerance
                && next_system.relative_residual() < params.residual_tolerance;
            if (converged || done) && self.films_settled(params, &before, state) {
                self.kept.replace(solver.into_preconditioner());
                return Ok(NewtonStatus {
                    residual: next_system.relative_residual(),
                    update,
                });
            }
            update_before = whole.then_some(update);
            if iteration == params.max_iterations {
                return Err(stopped(Stopped::OutOfIterations));
            }
            go_on(observer)?;
            system = next_system;
            step = solver.newton_step(&system, state)?;
        }
        unreachable!("the last iteration returns")
    }

    /// Whether a step has changed central and minimum film by no more than a run may that has converged.
    fn films_settled(&self, params: &NewtonParams, before: &State, after: &State) -> bool {
        let films = |state| {
            let d = self.discretisation;
            [central_film(d, state), minimum_film(d, state).0]
        };
        params.film_tolerance.is_infinite()
            || (films(before).iter().zip(films(after)))
                .all(|(a, b)| (a - b).abs() <= params.film_tolerance * b.abs())
    }

    /// Multiple of a step, a power of two, up to which the residual falls by half with each doubling.
    fn stride(
        &self,
        model: &FilmModel,
        params: &NewtonParams,
        state: &State,
        step: &Step,
        solver: &mut StepSolver,
    ) -> f64 {
        let mut residual_at = |share| {
            let trial = self.advance(model, params, state, step, share);
            solver.assemble(model, &trial).relative_residual()
        };
        let mut share = 1.0;
        let mut residual = residual_at(share);
        while residual > FAR_OUT && share < LONGEST_STRIDE {
            let further = residual_at(2.0 * share);
            if further.is_nan() || further > 0.5 * residual {
                break;
            }
            (share, residual) = (2.0 * share, further);
        }
        share
    }

    /// State after a share of the step, kept within the physical limits.
    fn advance(
        &self,
        model: &FilmModel,
        params: &NewtonParams,
        state: &State,
        step: &Step,
        share: f64,
    ) -> State {
        let mut pressure: Vec<f64> = step.pressure.iter().map(|v| share * v).collect();
        self.limit_pressures(&model.fluid, state, params, &mut pressure);
        let deflection = self.discretisation.deflect(&pressure, Accuracy::Full);
        let separation = share * step.separation;
        let mut next = state.clone();
        add(&mut next.pressure, &pressure);
        add(&mut next.deflection, &deflection);
        next.rigid_separation += separation + self.lift(state, &deflection, separation, params);
        next
    }

    /// Falling pressures in the logarithm of viscosity, rising ones capped.
    fn limit_pressures(
        &self,
        fluid: &FilmFluid,
        state: &State,
        params: &NewtonParams,
        step: &mut [f64],
    ) {
        for (dp, p) in step.iter_mut().zip(&state.pressure) {
            if *dp < 0.0 {
                let f = fluid.at(*p);
                let m = f.viscosity[1] / f.viscosity[0];
                if m > 0.0 {
                    *dp = -(-*dp * m).ln_1p() / m;
                }
            } else {
                *dp = dp.min(params.rise_limit);
            }
        }
    }

    /// By how much to lift the surfaces after a step so that no point loses too much of its film.
    ///
    /// Shortening the step instead would let one point stall all others: its film keeps halving
    /// while the steps shrink to zero. The next step takes back of the lift what the load demands.
    fn lift(
        &self,
        state: &State,
        deflection_step: &[f64],
        d_separation: f64,
        params: &NewtonParams,
    ) -> f64 {
        let d = self.discretisation;
        let mut lift: f64 = 0.0;
        for c in 0..d.contact.n_elements() {
            for (h, dh) in films_and_changes(d, state, (deflection_step, d_separation), c) {
                // A start may have no film at a point: let the step restore it.
                if h > 0.0 {
                    lift = lift.max(-dh - params.film_loss_limit * h);
                }
            }
        }
        lift
    }
}

fn add(x: &mut [f64], dx: &[f64]) {
    for (a, b) in x.iter_mut().zip(dx) {
        *a += b;
    }
}

fn rms(v: &[f64]) -> f64 {
    (dot(v, v) / v.len() as f64).sqrt()
}

fn max_abs(v: &[f64]) -> f64 {
    v.iter().fold(0.0, |m, x| m.max(x.abs()))
}
