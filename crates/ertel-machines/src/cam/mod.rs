//! Cams and their followers: lift laws, the place and the motion of the contact, forces and pressures over a turn.
//!
//! The cam is body 2 and the follower body 1. The cam turns by the angle θ, its axis is the origin, and the follower moves along y; a point (x, y) of
//! the cam moves at ω (−y, x). Speeds are those of the surfaces relative to the contact, positive as for a cam and a flat face: u_2 = ω (r_b + s + s'')
//! and u_1 = ω s''. ' is the derivative by θ.
//!
//! ```
//! use ertel_machines::cam::{Cam, CamOperation, Follower, LiftLaw};
//!
//! # fn main() -> Result<(), ertel_machines::cam::CamError> {
//! let law = LiftLaw::Harmonic { lift: 4e-3, lobes: 2 };
//! let cam = Cam::new(law, Follower::Flat, 18e-3)?;
//! let operation = CamOperation {
//!     speed: 200.0,
//!     width: 12e-3,
//!     mass: 0.12,
//!     spring_rate: 30e3,
//!     preload: 250.0,
//!     extra_force: 0.0,
//!     reduced_modulus: 226e9,
//! };
//! for point in cam.turn(&operation, 72)? {
//!     println!("{:.1}°: {:.2} m/s", point.angle.to_degrees(), point.entrainment_speed);
//! }
//! # Ok(())
//! # }
//! ```
//!
//! Sources: Norton, Cam Design and Manufacturing Handbook, 2002, chapters 2, 3 and 7; Müller, Motortechnische Zeitschrift 27, 1966, 58–61 (entrainment).

mod error;
mod follower;
mod lift;
#[cfg(test)]
mod tests;
mod turn;

pub use error::CamError;
pub use follower::{Follower, Place};
pub use lift::{LiftLaw, MotionLaw, PeriodicSpline, ROWS, Segment, TableLift};
pub use turn::{Cam, CamBars, CamOperation, CamPoint};
