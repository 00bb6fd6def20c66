//! Stresses in the bodies under the pressure and the wall shear of a contact, and what they mean for its life.
//!
//! Each body is a half-space, with or without layers ([`Response`]); without, its modulus has no effect. x is the direction of motion, z points into the body that is looked at, tension is
//! positive, and the shear is that on the body along +x. Line contacts: plane strain, exact for loads that are linear between nodes ([`LineLoad`]).
//! Point contacts: uniform loads on the cells of a grid ([`GridLoad`]). Dry contacts: closed forms ([`HertzLoad`]).
//!
//! Theory: Stresses in the bodies.

mod analysis;
mod body;
mod depths;
mod fatigue;
mod grid;
mod hardness;
mod hertz;
mod layered;
mod life;
mod line;
mod load;
mod measures;
mod rectangle;
mod residual;
mod results;
mod sections;
mod sphere;
mod tensor;

#[cfg(test)]
mod tests;

pub use analysis::analyse;
pub use body::{Body, Contact, Reference};
pub use depths::Depths;
pub use fatigue::{DangVan, dang_van, fatemi_socie};
pub use grid::{GridLoad, Planes};
pub use hardness::{Hardness, YIELD_PER_HARDNESS};
pub use hertz::HertzLoad;
pub use layered::Response;
pub use life::{Criterion, Volume, lundberg_palmgren};
pub use line::LineLoad;
pub use load::{Level, Load, Peak, RowShear};
pub use measures::dry_contact;
pub use residual::Residual;
pub use results::{
    AtDepth, BodyStresses, DryContact, Extreme, Interface, Layer, Life, Lives, OverDepth,
    PartStresses, Profile, Section, Shakedown, ShakedownBy, Site, StressParams, Stresses,
};
pub use tensor::{COMPONENTS, Stress};
