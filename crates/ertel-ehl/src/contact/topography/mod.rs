//! Heights of a surface at the points of a grid: form, filters, holes and parameters.
//!
//! ISO 25178-2 (parameters), ISO 16610-21 and 16610-61 (Gaussian filters of profiles and surfaces).

mod filter;
mod generated;
mod heights;
mod holes;
mod level;
mod parameters;
mod spectrum;

pub use filter::Pass;
pub use generated::{Generated, SelfAffine};
pub use heights::Topography;
pub use level::Levelling;
pub use parameters::Parameters;
pub use spectrum::{Spectrum, radial_spectrum, spectrum};
