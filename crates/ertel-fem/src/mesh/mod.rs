//! Simplicial meshes of a body or of its contact patch by conforming bisection driven by a size field.
//!
//! - [`SimplexMesh`]: vertices and positively oriented cells, with measures and quality;
//! - `bisection`: the refinable state (ordered cells with tags), one code for triangles and tetrahedra;
//! - [`body_mesh`]: the body under a contact patch, from a box of cubes stretched onto the requested size;
//! - [`surface_mesh`]: the contact patch alone, where no body is needed;
//! - [`SizeField`]: zones of given cell size with linear growth outside.

mod bisection;
mod body;
mod error;
mod facet;
mod layout;
mod simplex;
mod size_field;
mod surface;

pub use body::{BodyMesh, body_mesh};
pub use error::MeshError;
pub use facet::{ContactMesh, FacetMesh};
pub use layout::BodyParams;
pub use simplex::SimplexMesh;
pub use size_field::{SizeField, SizeZone, Zone};
pub use surface::{SurfaceMesh, SurfaceParams, surface_mesh};

#[cfg(test)]
mod tests;
