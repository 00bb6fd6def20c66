//! Common bearings by their designation: boundary dimensions, and an internal geometry to calculate with.
//!
//! Makers publish few internal dimensions. Where a public source gives one, it is [`Origin::Published`]; all else follows a stated rule,
//! [`Origin::Estimated`], and every value can be replaced before the geometry is made.

mod clearance;
mod designation;
mod dimensions;
mod internal;
mod series;

pub use clearance::{ClearanceClass, radial_clearance};
pub use designation::{Designation, DesignationError, all};
pub use dimensions::{Boundary, Special};
pub use internal::{Entry, Internal, Origin, Rollers, Sourced};
pub use series::Series;

/// The bearing of a designation such as `6206-2RS/C3`, `7210 B`, `NU 206 E` or `30206`.
///
/// # Errors
/// Designations that are not known, with those nearest to them.
pub fn find(designation: &str) -> Result<Entry, DesignationError> {
    let designation = designation::parse(designation)?;
    let boundary = designation
        .series
        .boundary(designation.code)
        .ok_or_else(|| designation::unknown(&designation.name()))?;
    let internal = internal::internal(&designation, &boundary);
    let ratings = designation.series.ratings(designation.code);
    Ok(Entry {
        ratings: ratings.map(internal::published_ratings),
        designation,
        boundary,
        internal,
    })
}

#[cfg(test)]
#[path = "tests.rs"]
mod tests;
