//! From a problem to its solution: meshes from coarse to fine, Newton's method on each.

pub mod adapt;
pub mod adjoint;
pub mod bars;
pub mod contact_surface;
pub mod discretisation;
pub mod dry;
mod element;
mod engine;
pub mod evaluate;
pub mod evaluated;
pub mod figures;
mod halvings;
pub mod heat;
pub mod indicator;
mod minima;
pub mod monolithic;
mod neighbours;
pub mod newton;
pub mod newton_level;
mod peaks;
pub mod points;
pub mod preconditioner;
pub mod profile;
pub mod region;
pub mod results;
mod ridge;
pub mod sensitivity;
pub mod sequence;
pub mod sizes;
pub mod state;
mod step;
pub mod streams;
pub mod system;
pub mod tuning;
pub mod weighted;

pub use engine::{Finished, FiniteElements};
