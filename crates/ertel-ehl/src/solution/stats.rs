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
    /// Wall seconds: mesh, elastic operator, assembly, preconditioner, Krylov, the rest.
    pub seconds: Timings,
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
    /// Everything else: spaces, starts, step limits, figures of the level.
    pub other: f64,
}

impl Timings {
    /// Sum of all parts but the rest.
    pub fn known(&self) -> f64 {
        self.mesh + self.operator + self.assembly + self.factorisation + self.krylov + self.heat
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
        (self.levels.iter().rev()).find(|l| l.converged && l.role == Role::Final)
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
