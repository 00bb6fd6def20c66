//! The data of a stage: its mesh, formulation and purpose.

use crate::solution::Role;
use crate::solve::discretisation::LevelSizes;
use crate::solve::state::FilmConstants;
use crate::solve::tuning::continuation::LOWER_ORDER;

/// One stage of a solve: a mesh, a pressure order, a formulation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stage {
    /// Cell sizes; a stage with the sizes of the one before keeps its mesh and elastic operator.
    pub sizes: LevelSizes,
    /// Times that the mesh of these sizes has been refined locally.
    pub refinements: usize,
    /// Lagrange order of the pressure.
    pub pressure_order: usize,
    /// Constants of the Reynolds equation, penalty at full strength.
    pub constants: FilmConstants,
    /// Exponent θ of the viscosity, μ̄^θ: share of ln μ̄ in force.
    pub viscosity_exponent: f64,
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
    pub undamped: bool,
    /// Whether it is given up early, because a continuation through easier contacts is known.
    pub given_up_early: bool,
    /// Purpose.
    pub role: Role,
}

impl Stage {
    /// Whether it uses the mesh of another stage.
    pub(super) fn is_on_mesh_of(&self, other: &Stage) -> bool {
        self.sizes == other.sizes && self.refinements == other.refinements
    }

    /// The same with quadratic pressures, unless its own are of as low an order.
    pub(super) fn with_quadratic_pressures(&self) -> Option<Stage> {
        (self.pressure_order > LOWER_ORDER).then_some(Stage {
            pressure_order: LOWER_ORDER,
            // Refined meshes keep their full iteration budget.
            given_up_early: self.given_up_early && self.refinements > 0,
            ..*self
        })
    }
}
