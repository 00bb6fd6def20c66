//! A level for Newton's method: its equations, settings, effort and state.

use std::cell::RefCell;

use super::discretisation::Discretisation;
use super::monolithic::BodyMatrices;
use super::preconditioner::{NearStiffness, Preconditioner};
use super::state::FilmConstants;
use crate::engine::SolveError;
use crate::film::FilmFluid;
use crate::solution::Timings;

/// Settings of one Newton run.
#[derive(Clone, Copy, Debug)]
pub struct NewtonParams {
    /// Largest pressure update, in p_h, at which the run has converged.
    pub update_tolerance: f64,
    /// Largest relative residual at which the run has converged.
    pub residual_tolerance: f64,
    /// Largest relative change of central and minimum film in the last step of a run that has converged; infinite where pressures decide.
    pub film_tolerance: f64,
    /// Iterations allowed.
    pub max_iterations: usize,
    /// Iterations without a smaller update after which the run stops because the updates cycle.
    pub patience: usize,
    /// Largest rise of a pressure in one step, in p_h.
    pub rise_limit: f64,
    /// Largest share of its film that a point may lose in one step.
    pub film_loss_limit: f64,
    /// Growth of the natural level (the next simplified step over this one) beyond which a step
    /// is halved.
    pub growth_limit: f64,
    /// Update, in p_h, below which steps are no longer tested for that: each test costs a linear solve.
    pub safe_update: f64,
    /// A step after which the residual is less than this share of it is not tested either, unless one had to be shortened before; 0 to
    /// test all.
    pub trusted_fall: f64,
    /// Share of the step below which it is taken as it is.
    pub smallest_share: f64,
    /// Whether a run ends where the next update is predicted to be below the tolerance.
    pub foresight: bool,
}

impl Default for NewtonParams {
    fn default() -> Self {
        NewtonParams {
            update_tolerance: 1e-8,
            residual_tolerance: 1e-8,
            film_tolerance: f64::INFINITY,
            max_iterations: 60,
            patience: 20,
            rise_limit: 0.2,
            film_loss_limit: 0.5,
            growth_limit: 1.5,
            safe_update: 0.02,
            trusted_fall: 0.5,
            smallest_share: 0.01,
            foresight: true,
        }
    }
}

/// Effort of a Newton run.
#[derive(Clone, Copy, Debug, Default)]
pub struct NewtonStats {
    /// Newton iterations.
    pub iterations: usize,
    /// Krylov iterations.
    pub krylov_iterations: usize,
    /// Preconditioners factorised.
    pub factorisations: usize,
    /// Wall time by part.
    pub seconds: Timings,
}

/// Where a run ended.
#[derive(Clone, Copy, Debug, Default)]
pub struct NewtonStatus {
    /// Relative residual of the state.
    pub residual: f64,
    /// Largest pressure update of the last iteration, in p_h.
    pub update: f64,
}

impl NewtonStatus {
    /// Where a run failed.
    pub(super) fn of_failure(error: &SolveError) -> NewtonStatus {
        match error {
            SolveError::NotConverged {
                residual, update, ..
            } => NewtonStatus {
                residual: *residual,
                update: *update,
            },
            _ => NewtonStatus {
                residual: f64::INFINITY,
                update: f64::INFINITY,
            },
        }
    }
}

/// The film equations of a run.
#[derive(Clone, Debug)]
pub struct FilmModel {
    /// Fluid.
    pub fluid: FilmFluid,
    /// Constants of the Reynolds equation.
    pub constants: FilmConstants,
}

/// Labels of a run in its records.
#[derive(Clone, Copy, Debug)]
pub struct RunLabel {
    /// Mesh level.
    pub level: usize,
    /// Share of the full penalty.
    pub penalty_share: f64,
    /// Film scale a²/R, m.
    pub film_scale: f64,
}

/// A level with the data that Newton's method keeps for it.
pub struct NewtonLevel<'a> {
    /// The discretisation.
    pub discretisation: &'a Discretisation,
    /// How its linear systems are solved.
    pub(super) method: Method,
    /// Target of ∫P.
    pub load: f64,
    /// Preconditioner of the last converged run, for similar systems.
    pub(super) kept: RefCell<Option<Preconditioner>>,
}

/// How the linear systems of a level are solved.
pub(super) enum Method {
    Condensed(NearStiffness),
    Monolithic(BodyMatrices),
}
