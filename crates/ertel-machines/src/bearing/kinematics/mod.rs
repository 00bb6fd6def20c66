//! Speeds in rolling bearings: cage, elements, entrainment, spin and differential slip.
//!
//! Axes: z along the bearing, r outwards. Positive contact angles tilt the force on the inner ring's groove towards +z. The elements roll on
//! both rings; skidding is neglected.

mod ball;
mod heathcote;
mod roller;
mod speeds;

pub use ball::{BallMotion, RacewayControl};
pub use heathcote::{deformed_radius, heathcote_number, heathcote_slip};
pub use roller::RollerMotion;
pub use speeds::Speeds;

use super::Geometry;

/// Speed factor n d_m, mm/min: speed of the rings against each other times pitch diameter (m).
pub fn speed_factor(speeds: Speeds, pitch_diameter: f64) -> f64 {
    speeds.relative().abs() * 30.0 / std::f64::consts::PI * pitch_diameter * 1e3
}

/// Largest speed factor that a maker recommends for bearings with standard cages under light loads (C/P of 15 and more) in grease, mm/min. Makers' limiting speeds in
/// oil are about a fifth above those in grease.
///
/// Source: SKF, General catalogue, 2006, page 238, table 1; oil: NSK, Rolling Bearings, catalogue E1102e, bearing tables.
pub fn recommended_speed_factor(geometry: &Geometry) -> f64 {
    match geometry {
        Geometry::Ball(_) => 5.0e5,
        Geometry::CylindricalRoller(_) => 4.5e5,
        Geometry::TaperedRoller(_) => 3.5e5,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// By hand: 3000/min = 100π rad/s inside and 1000/min the other way outside at d_m = 50 mm: 4000 · 50 mm/min.
    #[test]
    fn speed_factor_by_hand() {
        let turn = std::f64::consts::PI / 30.0;
        let speeds = Speeds {
            inner: 3000.0 * turn,
            outer: -1000.0 * turn,
        };
        assert_relative_eq!(speed_factor(speeds, 50e-3), 2e5, max_relative = 1e-12);
    }
}
