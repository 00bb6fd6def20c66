//! Laws and database of lubricant and solid properties, in SI.
//!
//! Pressure is the rise above ambient in Pa, temperature is absolute in K. Laws are generic over [`Scalar`]: evaluated
//! with a dual number they return exact derivatives.
//!
//! ```
//! use ertel_rheology::{DensityLaw, ViscosityLaw};
//!
//! let viscosity = ViscosityLaw::roelands(0.04, 22e-9)?;
//! let density = DensityLaw::dowson_higginson(870.0)?;
//! assert_eq!(density.density(0.0, 313.0), 870.0); // kg/m³
//! let temperature = 313.0; // K
//! let mu = |pressure| viscosity.viscosity(pressure, temperature.into());
//! let (mu, slope): (f64, f64) = num_dual::first_derivative(mu, 0.0);
//! assert!((slope / mu - 22e-9).abs() < 1e-20); // α in 1/Pa
//! # Ok::<(), ertel_rheology::LawError>(())
//! ```

pub mod conductivity;
pub mod data_sheet;
#[cfg(feature = "read")]
pub mod database;
pub mod density;
mod error;
mod fluid;
pub mod heat_capacity;
mod interpolation;
mod linear;
pub mod property;
pub mod provenance;
#[cfg(feature = "read")]
mod read;
mod scalar;
pub mod shear;
mod solid;
pub mod viscosity;

pub use conductivity::ConductivityLaw;
pub use density::DensityLaw;
pub use error::LawError;
pub use fluid::{Fluid, FluidError, GLASS_VISCOSITY};
pub use heat_capacity::HeatCapacityLaw;
pub use interpolation::Isotherms;
#[cfg(feature = "read")]
pub use read::{Files, Material};
pub use scalar::Scalar;
pub use shear::ShearThinning;
pub use solid::Solid;
pub use viscosity::ViscosityLaw;

#[cfg(test)]
#[path = "../../ertel-quantity/tests/common/near.rs"]
mod near;
