//! The lubricant film: its fluid in dimensionless variables.

pub mod fluid;

pub use fluid::{FilmFluid, PointFluid};
