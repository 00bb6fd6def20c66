//! Geometry of a cylindrical involute pair, external or internal, with profile shift.

mod checks;
mod dimensions;
mod error;
mod involute;
mod pair;
#[cfg(test)]
mod tests;

pub(crate) use dimensions::in_range;
pub use dimensions::{BasicRack, GearDimensions, Meshing, Relief, ReliefShape, TipAlteration};
pub use error::{GearError, GearWarning, Member};
pub use involute::{inverse_involute, involute};
pub use pair::{GearPair, LinePoints};
