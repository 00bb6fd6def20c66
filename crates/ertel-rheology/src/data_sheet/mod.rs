//! Estimates for oils known only by their data sheet.
//!
//! Data missing from a data sheet are taken from published correlations and typical values. Each is an
//! [`Estimate`]: a number with the range in which the truth is expected, and where both come from.

mod base_oil;
mod blend;
mod estimate;
mod heat;
mod index_table;
mod shear;
mod viscosity_index;

pub use base_oil::BaseOil;
pub use blend::{BLENDING_TEMPERATURES, Blend, BlendError};
pub use estimate::{Estimate, Spread};
pub use heat::HeatEstimate;
pub use shear::ShearEstimate;
pub use viscosity_index::{viscosity_at_40, viscosity_at_100, viscosity_index};

/// Viscosity grades of ISO 3448: kinematic viscosity at 40 degC in mm²/s, within 10 %.
pub const ISO_VG: [f64; 20] = [
    2.2, 3.2, 4.6, 6.8, 10.0, 15.0, 22.0, 32.0, 46.0, 68.0, 100.0, 150.0, 220.0, 320.0, 460.0,
    680.0, 1000.0, 1500.0, 2200.0, 3200.0,
];
/// Their names, which round the first four.
pub(crate) const ISO_VG_NAMES: [f64; 20] = [
    2.0, 3.0, 5.0, 7.0, 10.0, 15.0, 22.0, 32.0, 46.0, 68.0, 100.0, 150.0, 220.0, 320.0, 460.0,
    680.0, 1000.0, 1500.0, 2200.0, 3200.0,
];
/// Relative deviation allowed between the viscosity of an oil and that of its grade.
pub const ISO_VG_TOLERANCE: f64 = 0.1;

/// Density of water at 15 degC (kg/m³), to which relative densities refer.
pub const WATER_AT_15: f64 = 999.1;

#[cfg(test)]
mod tests;
