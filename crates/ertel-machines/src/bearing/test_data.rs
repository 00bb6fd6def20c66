//! Data that several tests of bearings use.

use super::geometry::{RollerProfile, TaperedGeometry};

/// Fields of the rows of a table, without its comments and its head.
pub fn rows(table: &str) -> Vec<Vec<&str>> {
    (table.lines())
        .filter(|row| !row.starts_with(['#', 'n']))
        .map(|row| row.split(',').collect())
        .collect()
}

/// A tapered roller bearing of 46 mm with a cup angle of 14 degrees.
pub fn tapered() -> TaperedGeometry {
    TaperedGeometry {
        roller_diameter: 8e-3,
        length: 11e-3,
        pitch_diameter: 46e-3,
        number: 16,
        cup_angle: 14_f64.to_radians(),
        profile: RollerProfile::Logarithmic,
    }
}
