//! The lubricant film: its fluid in dimensionless variables, and its flow across the film thickness.

pub mod closure;
pub mod cross_film;
pub mod fluid;
pub mod fluidity;
pub mod lanes;
pub mod nearby;
mod patches;
pub mod point;
pub mod polynomial;
mod properties;
mod quintic;
pub mod stress_scales;
pub mod thermal;
pub mod thermal_closure;

pub use closure::Closure;
pub use fluid::FilmFluid;
pub use point::PointFluid;
pub use polynomial::{FilmNodes, MOST_NODES, Nodal, Polynomial};
pub use thermal::{TemperatureProfile, ThermalFluid};
