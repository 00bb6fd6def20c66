//! The meshes of a solve: what each reached, its estimated errors, and what it took.

use crate::params::Method;
use serde::Serialize;

use super::{Figure, Figures, Role};

/// One mesh level of the solve.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LevelStats {
    /// Whether Newton's method converged here; a start or an estimate may do without.
    pub converged: bool,
    /// Cells of the body.
    pub n_body_cells: usize,
    /// Elements on the contact area.
    pub n_contact_elements: usize,
    /// Pressure unknowns.
    pub n_pressure_dofs: usize,
    /// Displacement unknowns.
    pub n_displacement_dofs: usize,
    /// Normal displacements on the contact area.
    pub n_contact_dofs: usize,
    /// Lagrange order of the pressure.
    pub pressure_order: usize,
    /// Purpose.
    pub role: Role,
    /// Newton iterations.
    pub newton_iterations: usize,
    /// Krylov iterations, all Newton iterations together.
    pub krylov_iterations: usize,
    /// Factorisations of the preconditioner or the monolithic matrix.
    pub factorisations: usize,
    /// Figures reached: all of a solution, an estimate and an isothermal stage that have converged, else films and
    /// largest pressure.
    #[serde(flatten)]
    pub figures: Figures,
    /// Estimated errors, uncalibrated; `None` where none were.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub estimate: Option<ErrorEstimate>,
    /// Wall seconds: mesh, elastic operator, assembly, preconditioner, Krylov, error estimate, the rest.
    pub seconds: Timings,
}

/// Estimated errors on one mesh, uncalibrated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct ErrorEstimate {
    /// Relative errors of central and minimum film from the cells.
    pub films: [f64; 2],
    /// Relative change of both films by the diffusion at ridges.
    #[serde(skip_serializing_if = "are_zero")]
    pub ridge: [f64; 2],
    /// The same from the edges of the contact area, and from pressures below zero behind the film.
    pub edges: [f64; 2],
    /// Relative error of both films from pressures that the cells do not resolve.
    pub unresolved: f64,
    /// Root-mean-square error of the pressure over the dry contact, over p_h.
    pub pressure: f64,
    /// Root-mean-square error of the pressure in the cells around its largest value, Pa.
    pub largest: f64,
    /// The same around the top of the central hill, Pa.
    pub central_pressure: f64,
    /// By how much the ridge may be higher, Pa; zero without one.
    pub ridge_pressure: f64,
    /// Root-mean-square error around the spike on the centreline, Pa; zero without one.
    pub spike: f64,
    /// The same around the edge pressures at y < 0 and y > 0 of a roller, Pa; zero without them.
    #[serde(skip_serializing_if = "are_zero")]
    pub ends: [f64; 2],
    /// Error of the largest shear stress from the slopes of the pressure, Pa.
    pub shear_stress: f64,
    /// Share of the Hertz zone that its boundary is uncertain by for the points at which the film is evaluated.
    pub share_of_point: f64,
    /// Rolling friction beyond the edges of the contact area.
    pub beyond_edges: BeyondEdges,
    /// Errors of the temperatures; zero where there are none, and where they are not of linear elements.
    pub temperatures: TemperatureErrors,
}

/// Whether there is nothing to write.
fn are_zero(values: &[f64; 2]) -> bool {
    *values == [0.0; 2]
}

/// Share of the rolling friction between edges of the contact area that are set by hand and the default ones.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct BeyondEdges {
    /// Traction coefficient at each wall.
    pub traction: f64,
    /// Friction power, W or W/m.
    pub power: f64,
    /// Share of the distance to the edges that is cut off.
    pub cut: f64,
}

/// How far temperatures of linear elements are from those by recovered gradients, K.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct TemperatureErrors {
    /// At most, around the largest and the lowest temperature of the film, and the largest ones of body 1 and body 2.
    pub local: [f64; 4],
    /// Root mean square over the Hertz zone, at mid-film.
    pub rms: f64,
}

/// Wall-clock split of the work, s.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Timings {
    /// Meshing.
    pub mesh: f64,
    /// Elastic operator: assembly and factorisation.
    pub operator: f64,
    /// Assembly of the Reynolds equation and its Jacobian.
    pub assembly: f64,
    /// Factorisation of the preconditioner (or the monolithic matrix).
    pub factorisation: f64,
    /// Linear solves.
    pub krylov: f64,
    /// Temperatures.
    pub heat: f64,
    /// Error estimate: adjoints and misfits.
    pub estimate: f64,
    /// Everything else: spaces, starts, step limits, figures of the level.
    pub other: f64,
}

impl Timings {
    /// Sum of all parts but the rest.
    pub fn known(&self) -> f64 {
        self.mesh
            + self.operator
            + self.assembly
            + self.factorisation
            + self.krylov
            + self.heat
            + self.estimate
    }
}

/// Solver statistics of the whole run.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Stats {
    /// How the film was discretised.
    pub method: Method,
    /// Whether it started from the solution of another case; else from the dry contact.
    pub warm: bool,
    /// One entry per mesh level, coarse to fine.
    pub levels: Vec<LevelStats>,
    /// Wall time of the solve, s.
    pub wall_seconds: f64,
    /// Peak resident memory of the process, bytes; `None` where the system does not report it.
    pub peak_memory: Option<u64>,
}

impl Stats {
    /// The level of the solution; failed attempts after it follow it.
    pub fn solved(&self) -> Option<&LevelStats> {
        solved(&self.levels)
    }
}

impl LevelStats {
    /// Central and minimum film thickness, m; not a number where there is none.
    pub fn films(&self) -> [f64; 2] {
        let film = |figure| self.figures.value(figure).unwrap_or(f64::NAN);
        [film(Figure::FilmCentral), film(Figure::FilmMinimum)]
    }

    /// Whether it has the same mesh and elements as another.
    pub(crate) fn has_mesh_of(&self, other: &LevelStats) -> bool {
        self.n_contact_elements == other.n_contact_elements
            && self.pressure_order == other.pressure_order
    }
}

/// The last level that is a solution.
pub(crate) fn solved(levels: &[LevelStats]) -> Option<&LevelStats> {
    (levels.iter().rev()).find(|l| l.converged && l.role == Role::Final)
}
