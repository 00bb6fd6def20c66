//! The data of a stage: its mesh, formulation and purpose.

use crate::solution::Role;
use crate::solve::discretisation::LevelSizes;
use crate::solve::state::FilmConstants;

/// One stage of a solve: a mesh, a pressure order, a formulation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stage {
    /// Cell sizes; a stage with the sizes of the one before keeps its mesh and elastic operator.
    pub sizes: LevelSizes,
    /// Times that all cells of these sizes have been halved.
    pub halvings: usize,
    /// Lagrange order of the pressure.
    pub pressure_order: usize,
    /// Constants of the Reynolds equation, penalty at full strength.
    pub constants: FilmConstants,
    /// Whether the fluid keeps its low-shear viscosity.
    pub newtonian: bool,
    /// Whether film and bodies heat up.
    pub heated: bool,
    /// Purpose.
    pub role: Role,
}

impl Stage {
    /// Whether it uses the mesh of another stage.
    pub(super) fn is_on_mesh_of(&self, other: &Stage) -> bool {
        self.sizes == other.sizes && self.halvings == other.halvings
    }
}
