//! A contact to be solved by finite elements, and the solution of a stage.

use super::Stage;
use crate::elastic::BodyModel;
use crate::engine::{self, SolveError};
use crate::params::LinearSolver;
use crate::solve::discretisation::Discretisation;
use crate::solve::heat::column::Column;
use crate::solve::heat::coupling::{CouplingParams, CouplingStats};
use crate::solve::newton_level::{NewtonParams, NewtonStatus};
use crate::solve::sizes::expected_unknowns;
use crate::solve::state::State;
use crate::solve::tuning::stages::{MOST_UNKNOWNS, THIN_RIM};

/// A contact to be solved by finite elements.
pub type Problem = engine::Problem<Plan>;

/// Method of finite elements for a problem.
pub struct Plan {
    /// Stages, coarse to fine.
    pub stages: Vec<Stage>,
    /// Central film that the meshes are made for: less than that of the start where stress thins the fluid in the inlet.
    pub mesh_film: f64,
    /// Film over that of the Newtonian fluid by formulas where stress thins the fluid in the inlet; 1 where it does not.
    pub thinned_share: f64,
    /// Newton tolerances and limits.
    pub newton: NewtonParams,
    /// Condensed or monolithic.
    pub linear: LinearSolver,
    /// Accuracy until which the mesh is halved, if one is requested.
    pub target: Option<Target>,
    /// Temperatures, where heat counts.
    pub heat: Option<HeatPlan>,
}

/// How accurate films shall be, and how fine meshes may become for it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Target {
    /// Largest relative error bar of central and minimum film.
    pub error: f64,
    /// Pressure unknowns that a halved mesh may have.
    pub max_unknowns: usize,
}

/// Meshes at least: two for error bars.
pub const LEAST_MESHES: usize = 2;

/// Why no finer mesh follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshEnd {
    /// The errors meet their target, or there is none.
    Reached,
    /// A finer mesh would have more than so many pressure unknowns.
    Unknowns(usize),
    /// Newton's method does not converge on a finer mesh.
    NotConverged,
}

/// How temperatures are solved for.
#[derive(Clone, Debug)]
pub struct HeatPlan {
    /// Order of the temperature over the contact area.
    pub surface_order: usize,
    /// Layers over a point.
    pub column: Column,
    /// Coupling with the film.
    pub coupling: CouplingParams,
}

/// Solution of a stage.
#[derive(Clone)]
pub struct StageSolution {
    /// The discretisation.
    pub discretisation: Discretisation,
    /// The state on it.
    pub state: State,
    /// The stage it solves.
    pub stage: Stage,
    /// State of Newton's method at its end.
    pub reached: NewtonStatus,
    /// Why no finer mesh follows; `None` where one does.
    pub mesh_end: Option<MeshEnd>,
    /// Convergence of its coupling with the heat, if there is one.
    pub coupling: Option<CouplingStats>,
}

/// Share of the Newtonian film that stress leaves in the inlet, below which the constants of shear thinning are named as the reason of a failure:
/// films of oils are thinned by less.
const FAR_FROM_OILS: f64 = 0.5;

impl Problem {
    /// An error with its likely reason: stress that thins the fluid far more than oils.
    pub(super) fn explained(&self, error: SolveError) -> SolveError {
        let share = self.plan.thinned_share;
        match error {
            SolveError::NotConverged { .. } if share < FAR_FROM_OILS => {
                let error = Box::new(error);
                SolveError::Thinned { error, share }
            }
            other => other,
        }
    }

    /// Refuses films that no allowed mesh resolves, before any work.
    ///
    /// # Errors
    /// [`SolveError::TooThin`].
    pub fn check_size(&self) -> Result<(), SolveError> {
        let stages = &self.plan.stages;
        let (Some(first), Some(last)) = (stages.first(), stages.last()) else {
            return Ok(());
        };
        let (stage, limit, help) = match &self.plan.target {
            Some(target) => (
                first,
                target.max_unknowns as f64,
                "a more viscous oil, a faster motion or a lower load makes the film thicker; [mesh] max_unknowns allows more",
            ),
            None => {
                let model = usize::from(self.elasticity.model == BodyModel::FiniteElements);
                let help = "a more viscous oil, a faster motion or a lower load makes the film thicker; [mesh] preset, \
                            rim_size and the other sizes lay down larger cells";
                (last, MOST_UNKNOWNS[model], help)
            }
        };
        let unknowns = expected_unknowns(
            &self.shape,
            &self.extents,
            &stage.sizes,
            last.pressure_order,
        );
        // Only where it is the rim that takes them: large areas around thick films are another matter.
        let thin = stage.sizes.rim < THIN_RIM * stage.sizes.hertz;
        if unknowns <= limit || !thin {
            return Ok(());
        }
        let ratio = self.plan.mesh_film;
        Err(SolveError::TooThin {
            film: ratio * self.scales.film,
            sheared: ratio < stage.constants.film_scale,
            ratio,
            length: stage.sizes.rim_width,
            size: stage.sizes.rim,
            unknowns,
            limit,
            help,
        })
    }
}
