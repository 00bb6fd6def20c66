//! Internal geometry of rolling bearings.

mod ball;
mod error;
mod ring;
mod roller;
mod tapered;

pub use ball::{BallGeometry, Play};
pub use error::GeometryError;
pub(crate) use error::check_row;
pub(crate) use error::positive;
pub use ring::{Ring, radius_along};
pub use roller::{RollerGeometry, RollerProfile};
pub use tapered::TaperedGeometry;
