//! Common bearings by their designation: boundary dimensions, and an internal geometry to calculate with.
//!
//! Makers publish few internal dimensions. Where a public source gives one, it is [`Origin::Published`]; all else follows a stated rule,
//! [`Origin::Estimated`], and every value can be replaced before the geometry is made.

mod clearance;
mod designation;
mod dimensions;
mod internal;
mod series;
mod tapered;

pub use clearance::{ClearanceClass, radial_clearance};
pub use designation::{Designation, DesignationError};
pub use internal::{Balls, Internal, Origin, Rollers, Sourced};
pub use series::Series;

/// Boundary dimensions, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Boundary {
    /// Bore d.
    pub bore: f64,
    /// Outside diameter D.
    pub outside: f64,
    /// Width B; of tapered roller bearings that of the cone.
    pub width: f64,
    /// Dimensions that only some kinds have.
    pub special: Special,
}

/// Dimensions that only some kinds of bearings have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Special {
    /// None: ball bearings.
    None,
    /// Diameters of the raceways of cylindrical roller bearings, m.
    Raceways {
        /// F, of the inner ring.
        inner: f64,
        /// E, of the outer ring.
        outer: f64,
    },
    /// Of tapered roller bearings.
    Taper {
        /// Width of the cup C, m.
        cup_width: f64,
        /// Width of the whole bearing T, m.
        width: f64,
        /// Contact angle α, rad: half of the cup's angle.
        contact_angle: f64,
    },
}

impl Boundary {
    /// Mean diameter (d + D)/2, m.
    pub fn mean_diameter(&self) -> f64 {
        0.5 * (self.bore + self.outside)
    }
}

/// A bearing of the catalogue.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// The designation requested.
    pub designation: Designation,
    /// Its boundary dimensions.
    pub boundary: Boundary,
    /// Its internal geometry.
    pub internal: Internal,
    /// Load ratings C and C_0, N, and who gives them.
    pub ratings: Option<Sourced<[f64; 2]>>,
}

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

/// Designations of all bearings of the catalogue, by series.
pub fn all() -> impl Iterator<Item = String> {
    Series::ALL.into_iter().flat_map(|series| {
        series
            .codes()
            .map(move |code| Designation::plain(series, code).name())
    })
}

#[cfg(test)]
#[path = "tests.rs"]
mod tests;
