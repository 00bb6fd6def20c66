//! The lubricant film: its fluid in dimensionless variables, and its flow across the film thickness.

pub mod closure;
pub mod cross_film;
pub mod fluid;
pub mod fluidity;
mod properties;
mod quintic;

pub use closure::Closure;
pub use fluid::{FilmFluid, PointFluid};
