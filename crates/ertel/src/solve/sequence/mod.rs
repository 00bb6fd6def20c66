//! Stage after stage from the dry contact to the solution: meshes from coarse to fine, a diffusive start before
//! the case's own equations, other ways where one fails.
//!
//! - `run`: each stage on its mesh, to the last;
//! - `next`: which stage comes next;
//! - `stage`: Newton's method on one of them;
//! - `start`: from which pressures;
//! - `rescue`: what is tried when that fails;
//! - `paths`: ways to the case's own contact through easier ones;
//! - `warm`: from the solution of a similar problem instead.

mod next;
mod paths;
mod rescue;
mod run;
mod stage;
mod start;
mod warm;

use serde::Serialize;

use super::SolveError;
use super::adapt::AdaptParams;
use super::discretisation::{Discretisation, Extents, LevelSizes};
use super::evaluate::minimum_film;
use super::heat::column::Column;
use super::heat::coupling::{CouplingParams, CouplingStats};
use super::newton::{NewtonParams, Reached};
use super::sizes::expected_unknowns;
use super::system::{FilmConstants, State};
use crate::contact::{Scales, Shape};
use crate::elastic::cache::OperatorCache;
use crate::elastic::{BodyModel, Elasticity};
use crate::film::FilmFluid;
use crate::forms::energy::Heat;
use crate::params::LinearSolver;

use stage::HOPELESS;

pub use run::solve_stages;
pub use warm::{Start, solve_warm};

/// One stage of a solve: a mesh, a pressure order, a formulation.
#[derive(Clone, Copy, Debug)]
pub struct Stage {
    /// Cell sizes; a stage with the sizes of the one before keeps its mesh and elastic operator.
    pub sizes: LevelSizes,
    /// Times that the mesh of these sizes has been refined locally.
    pub refinements: usize,
    /// Lagrange order of the pressure.
    pub pressure_order: usize,
    /// Constants of the Reynolds equation, penalty at full strength.
    pub constants: FilmConstants,
    /// Share of the fluid's thickening under pressure.
    pub thickening: f64,
    /// Softness of a fluid whose shear rate grows exponentially with the stress; 1 is the law itself.
    pub softness: f64,
    /// Share of the sliding of the surfaces.
    pub sliding: f64,
    /// Whether the fluid keeps its low-shear viscosity.
    pub newtonian: bool,
    /// Whether film and bodies heat up.
    pub heated: bool,
    /// Whether it starts from the Hertz pressure, whatever was reached before.
    pub cold: bool,
    /// Whether it starts near enough to the solution that Newton's steps need no damping.
    pub near: bool,
    /// Whether it is given up early, because a way to it through easier contacts is known.
    pub impatient: bool,
    /// What it is for.
    pub role: Role,
}

/// What a stage is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Role {
    /// Only starts the next one: loose tolerance, penalty ramp, and what it reaches is good
    /// enough even when it does not converge, as long as it is nearer than the dry contact.
    Start,
    /// A step on the way from a start to the case's own equations: loose tolerance, but the penalty in full.
    Path,
    /// Its figures bound the discretisation error; skipped when it does not converge.
    Estimate,
    /// A film to compare the solution with; likewise.
    Comparison,
    /// The same contact without its heat, to compare with; likewise.
    Isothermal,
    /// The solution.
    Final,
}

/// Everything a solve needs, dimensionless.
pub struct Problem {
    /// Geometry of the contact.
    pub shape: Shape,
    /// Contact area and body.
    pub extents: Extents,
    /// Distances of inlet and side, in half-widths, to which the contact area goes where they are not set by hand.
    pub reach: [f64; 2],
    /// Stages, coarse to fine.
    pub stages: Vec<Stage>,
    /// Elastic bodies.
    pub elasticity: Elasticity,
    /// Fluid.
    pub fluid: FilmFluid,
    /// Target of ∫P over the (half) contact area.
    pub load: f64,
    /// Central film of the start.
    pub start_film: f64,
    /// Scales of its variables.
    pub scales: Scales,
    /// Newton tolerances and limits.
    pub newton: NewtonParams,
    /// Condensed or monolithic.
    pub linear: LinearSolver,
    /// Where elastic operators are kept, if anywhere.
    pub cache: Option<OperatorCache>,
    /// Whether errors are estimated.
    pub error_estimate: bool,
    /// Local refinement of the final stage, if an accuracy is asked for.
    pub adapt: Option<AdaptParams>,
    /// Heat of film and bodies, where it counts.
    pub heat: Option<HeatProblem>,
}

/// The thermal side of a problem.
#[derive(Clone, Debug)]
pub struct HeatProblem {
    /// Laws, bodies and scales.
    pub heat: Heat,
    /// Order of the temperature over the contact area.
    pub surface_order: usize,
    /// Layers over a point.
    pub column: Column,
    /// Coupling with the film.
    pub coupling: CouplingParams,
}

/// What a stage came to.
#[derive(Clone)]
pub struct StageSolution {
    /// The discretisation.
    pub discretisation: Discretisation,
    /// The state on it.
    pub state: State,
    /// The stage it solves.
    pub stage: Stage,
    /// How far Newton's method came.
    pub reached: Reached,
    /// Whether it came to the tolerance of the stage.
    pub converged: bool,
    /// Whether it came only as far as measuring the errors needs, and not to the tolerance of the case.
    pub rough: bool,
    /// How its coupling with the heat went, if there is one.
    pub coupling: Option<CouplingStats>,
}

/// A refined mesh has this many times the unknowns of the first at least, where films are thin.
const ROOM_TO_REFINE: f64 = 3.0;

/// Pressure unknowns beyond which a mesh that is not refined is not begun, by half-spaces and by finite-element bodies, whose
/// operator takes gigabytes.
const MOST_UNKNOWNS: [f64; 2] = [1e6, 4e4];

/// Cell size at the rim over that in the Hertz zone, below which a film is thin.
const THIN_RIM: f64 = 0.2;

impl Problem {
    /// Refuses what no mesh that is allowed resolves, before any work.
    ///
    /// # Errors
    /// [`SolveError::TooThin`].
    pub fn check_size(&self) -> Result<(), SolveError> {
        let (Some(first), Some(last)) = (self.stages.first(), self.stages.last()) else {
            return Ok(());
        };
        let unknowns = |stage: &Stage| {
            let order = self
                .stages
                .iter()
                .map(|s| s.pressure_order)
                .max()
                .unwrap_or(1);
            expected_unknowns(&self.shape, &self.extents, &stage.sizes, order)
        };
        let (stage, limit, help) = match &self.adapt {
            Some(adapt) => (
                first,
                adapt.max_unknowns as f64 / ROOM_TO_REFINE,
                "a more viscous oil, a faster motion or a lower load makes the film thicker; [mesh] max_unknowns allows more",
            ),
            None => {
                let model = usize::from(self.elasticity.model == BodyModel::FiniteElements);
                let help = "a more viscous oil, a faster motion or a lower load makes the film thicker; [mesh] preset, \
                            rim_size and the other sizes lay down larger cells";
                (last, MOST_UNKNOWNS[model], help)
            }
        };
        let n = unknowns(stage);
        // Only where it is the rim that takes them: large areas around thick films are another matter.
        let thin = stage.sizes.rim < THIN_RIM * stage.sizes.hertz;
        if n <= limit || !thin {
            return Ok(());
        }
        let ratio = stage.constants.film_scale;
        Err(SolveError::TooThin {
            film: ratio * self.scales.film,
            ratio,
            length: stage.sizes.rim_width,
            size: stage.sizes.rim,
            unknowns: n,
            limit,
            help,
        })
    }
}

impl Role {
    /// Whether it only leads to other stages.
    pub(crate) fn leads(self) -> bool {
        matches!(self, Role::Start | Role::Path)
    }

    /// Whether it is only compared with the solution.
    pub(crate) fn compares(self) -> bool {
        matches!(self, Role::Comparison | Role::Isothermal)
    }
}

impl Stage {
    /// Whether it stands on the mesh of another stage.
    fn is_on_mesh_of(&self, other: &Stage) -> bool {
        self.sizes == other.sizes && self.refinements == other.refinements
    }
}

impl StageSolution {
    /// Whether an unconverged state is still near a contact: finite, with film everywhere, and nearer than the
    /// dry one.
    fn is_usable(&self) -> bool {
        self.has_film()
            && self.state.pressure.iter().all(|p| p.is_finite())
            && self.reached.residual <= HOPELESS
    }

    /// Whether there is film everywhere.
    fn has_film(&self) -> bool {
        let (film, _) = minimum_film(&self.discretisation, &self.state);
        film.is_finite() && film > 0.0
    }
}
