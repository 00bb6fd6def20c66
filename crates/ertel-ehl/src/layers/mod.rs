//! Bonded layers on the bodies: how a coated half-space deflects and warms up.
//!
//! A body under the pressure p cos kx deflects by 2C(k)p/k: short waves see the uppermost layer, C(∞) = (1 − ν₁²)/E₁, long ones the substrate. [`Coated`] has
//! C(k), exact for any number of layers, and the stresses at all depths ([`Harmonic`]). [`Images`] turn the difference from the uppermost layer into a few images of the pressure below the
//! surface, whose deflections are closed forms, as that of the half-space is. [`HeatedBody`] has the temperature of the surface by the heat that flows in.
//!
//! Theory: Layers on the bodies.

mod heat;
mod images;
mod response;
mod waves;

#[cfg(test)]
pub(crate) mod tests;

pub use heat::{HeatLayer, HeatedBody, Pulse, ThermalMaterial};
pub use images::{Fit, Image, Images, geometric};
pub use response::{Coated, Layer};
pub use waves::{Harmonic, Plane};
