//! Speeds in rolling bearings: cage, elements, entrainment, spin and differential slip.
//!
//! Axes: z along the bearing, r outwards. Positive contact angles tilt the force on the inner ring's groove towards +z. The elements roll on
//! both rings; skidding is left out.

mod ball;
mod heathcote;
mod roller;

pub use ball::{BallMotion, RacewayControl};
pub use heathcote::{deformed_radius, heathcote_number, heathcote_slip};
pub use roller::RollerMotion;

/// Speeds of both rings, rad/s, in the same direction of rotation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Speeds {
    /// ω_i.
    pub inner: f64,
    /// ω_o.
    pub outer: f64,
}

impl Speeds {
    /// ω_i − ω_o.
    pub fn relative(&self) -> f64 {
        self.inner - self.outer
    }
}
