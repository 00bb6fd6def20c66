//! The dry contact: geometry, Hertz theory, dimensionless groups and scales.

pub mod curvature;
mod ellipse;
pub mod equivalent;
pub mod gap;
pub mod groups;
pub mod hertz;
pub mod inlet;
mod kind;
mod loaded;
pub mod material;
pub mod motion;
pub mod pose;
pub mod roller;
pub mod scales;
pub mod shape;
pub mod starvation;
pub mod topography;
pub mod turn;
pub mod zone;

pub use curvature::Curvatures;
pub use ellipse::{Ellipse, pressure_profile};
pub use equivalent::equivalent_body;
pub use gap::{Gap, GapTerm};
pub use groups::Groups;
pub use hertz::Hertz;
pub use inlet::{Inlet, OilLayer, Supply};
pub use kind::{ContactKind, Family};
pub use loaded::Contact;
pub use material::{Material, reduced_modulus};
pub use motion::{Motion, Planar};
pub use pose::Pose;
pub use roller::Roller;
pub use scales::Scales;
pub use shape::{Outline, Shape, Symmetry};
pub use turn::Turn;
pub use zone::HertzZone;
