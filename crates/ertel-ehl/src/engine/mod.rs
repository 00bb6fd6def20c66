//! The interface between the users of a contact solution and the numerical methods.
//!
//! ```text
//!   Problem (the contact, dimensionless) + plan (meshes, tolerances, strategy)  →  numerical method  →  film, figures, error bars, effort
//! ```
//! Numerical methods are finite elements ([`crate::solve`]) and finite volumes ([`crate::volumes`]). Post-processing uses a [`Film`], which
//! both provide: the fields at its quadrature points and at any place.

pub mod around;
pub mod bars;
pub mod coupling;
mod error;
pub mod far_field;
pub mod figures;
pub mod film;
pub mod flux;
pub mod friction;
pub mod heat;
pub mod hills;
mod observer;
mod problem;
mod profile;
pub mod region;
pub mod sensitivity;
pub mod shear;

pub use error::{HeatError, MissingDatum, MissingHeatData, SolveError, Stopped};
pub use film::{Film, Point, PointFields, PointTable};
pub use observer::{NoObserver, Observer};
pub use problem::{Extents, Problem};
pub use profile::{Meniscus, Profile};
