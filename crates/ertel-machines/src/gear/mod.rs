//! Pairs of cylindrical involute gears: geometry, the path of contact, load sharing, flash temperature, losses and safety figures.
//!
//! Body 2 is the pinion and body 1 the wheel. Arrays of both gears have the pinion first. The place s on the line of action is counted from
//! the pitch point and is positive towards the pinion's tip; the slide-to-roll ratio is (u_2 − u_1)/u_m. A pinion that drives meets the wheel at
//! point A, the wheel's tip, and leaves it at point E, its own tip.
//!
//! ```
//! use ertel_ehl::contact::Material;
//! use ertel_machines::gear::{GearDimensions, GearPair, LoadSharing, Operation, PathParams};
//!
//! # fn main() -> Result<(), ertel_machines::gear::GearError> {
//! let pair = GearPair::new(&GearDimensions {
//!     pinion_shift: 0.2,
//!     wheel_shift: Some(0.1),
//!     ..GearDimensions::spur(3e-3, [20, 41], 20_f64.to_radians(), 25e-3)
//! })?;
//! let steel = Material { youngs_modulus: 206e9, poissons_ratio: 0.3 };
//! let operation = Operation { pinion_torque: 150.0, pinion_speed: 157.0, materials: [steel; 2] };
//! let params = PathParams { sharing: LoadSharing::Thirds, ..PathParams::default() };
//! for point in pair.path(&operation, &params)? {
//!     println!("{:.3} mm: {:.0} MPa", 1e3 * point.position, 1e-6 * point.hertz_pressure);
//! }
//! # Ok(())
//! # }
//! ```
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

pub use flash::{ThermalBody, flash};
pub use geometry::{
    BasicRack, GearDimensions, GearError, GearPair, GearWarning, LinePoints, Member, Meshing,
    Relief, ReliefShape, TipAlteration,
};
pub use loss::MeshLoss;
pub use path::{LoadSharing, Operation, PathLabel, PathParams, PathPoint, ToothStiffness};
