//! Pairs of cylindrical involute gears: geometry, the path of contact, load sharing, flash temperature, losses and safety figures.
//!
//! Body 2 is the pinion and body 1 the wheel. Arrays of both gears have the pinion first. The place s on the line of action is counted from
//! the pitch point and is positive towards the pinion's tip; the slide-to-roll ratio is (u_2 − u_1)/u_m. A pinion that drives meets the wheel at
//! point A, the wheel's tip, and leaves it at point E, its own tip.
//!
//! Sources: ISO 21771:2007 (geometry); ISO 6336-1 (mesh stiffness); ISO/TR 15144-1 (local radii, speeds and loads).

pub mod flash;
pub mod friction;
pub mod fzg;
pub mod geometry;
mod loss;
pub mod path;
pub mod safety;
#[cfg(test)]
mod test_data;

pub use flash::{Flash, FlashMethod, ThermalBody, flash};
pub use geometry::{
    BasicRack, GearDimensions, GearError, GearPair, GearWarning, LinePoints, Member, Meshing,
    Relief, ReliefShape, TipAlteration,
};
pub use loss::MeshLoss;
pub use path::{
    Buttressing, LoadSharing, Operation, PathLabel, PathParams, PathPoint, ToothStiffness,
};
