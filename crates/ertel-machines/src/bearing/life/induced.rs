//! Bearings that carry axial load in one direction only, and the axial force that a radial load induces in them.

use super::{Error, dynamic_factors, roller_factors};
use crate::bearing::Geometry;
use crate::bearing::catalogue::Series;
use crate::bearing::geometry::{BallGeometry, Play};

/// Smallest nominal contact angle of angular contact ball bearings, degrees: suffix C (NSK, Rolling Bearings, catalogue E1102).
const LEAST_ANGLE: f64 = 15.0;

/// Nominal contact angle α that ratings take, rad: that of the series, of tapered rollers that of the cup; else the given one of ball bearings, and 0 of
/// those whose angle follows from a clearance.
pub fn nominal_angle(geometry: &Geometry, series: Option<Series>) -> f64 {
    let of_series = series.and_then(Series::nominal_angle);
    match geometry {
        Geometry::Ball(BallGeometry { play, .. }) => of_series.unwrap_or(match play {
            Play::FreeAngle(angle) => *angle,
            Play::Clearance(_) => 0.0,
        }),
        Geometry::CylindricalRoller(_) | Geometry::TaperedRoller(_) => geometry.free_angle(),
    }
}

/// Whether a bearing carries axial load in one direction only: tapered roller bearings, and single-row angular contact ball bearings, one shoulder of which is
/// relieved.
pub fn is_one_sided(geometry: &Geometry, series: Option<Series>) -> bool {
    match geometry {
        Geometry::Ball(_) => nominal_angle(geometry, series).to_degrees() > LEAST_ANGLE - 1e-9,
        Geometry::CylindricalRoller(_) => false,
        Geometry::TaperedRoller(_) => true,
    }
}

/// Axial factor Y, and the axial force that a radial load (N) induces in a bearing that [`is_one_sided`], N: the least axial load that keeps its rings together.
///
/// F_a = F_r/(2Y)
///
/// Source: makers' catalogues (SKF, NSK: 0.88 F_r at 40 degrees); Y by ISO 281:2007, tables 3 and 8; of angles whose Y depends on the load, that at F_r tan α.
///
/// # Errors
/// Angles beyond the standard's tables.
pub fn induced_axial_load(
    geometry: &Geometry,
    series: Option<Series>,
    radial: f64,
) -> Result<(f64, f64), Error> {
    let angle = nominal_angle(geometry, series);
    let factors = match geometry {
        Geometry::Ball(ball) => dynamic_factors(ball, angle, radial * angle.tan())?,
        Geometry::CylindricalRoller(_) | Geometry::TaperedRoller(_) => roller_factors(angle)?,
    };
    Ok((factors.axial, 0.5 * radial / factors.axial))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bearing::catalogue::find;
    use approx::assert_relative_eq;

    /// 7210 B under 2 kN: Y = 0.57 of table 3, 2000/1.14 = 1754.4 N. 30206: Y = 0.4 cot 14.0361° = 1.6, 625 N. Deep groove and cylindrical roller bearings
    /// have two shoulders, or none.
    #[test]
    fn induced_by_hand() {
        let of = |name: &str| {
            let entry = find(name).unwrap();
            let (geometry, series) = (entry.geometry(), Some(entry.designation.series));
            is_one_sided(&geometry, series)
                .then(|| induced_axial_load(&geometry, series, 2000.0).unwrap())
        };
        let (factor, force) = of("7210 B").unwrap();
        assert_relative_eq!(factor, 0.57, max_relative = 1e-12);
        assert_relative_eq!(force, 1754.386, max_relative = 1e-6);
        assert_relative_eq!(of("30206").unwrap().1, 625.0, max_relative = 1e-4);
        assert_eq!([of("6206 C4"), of("NU 206")], [None, None]);
    }

    /// Bearings without a series: contact angles from 15 degrees on, which are those of angular contact bearings; at 15 degrees Y depends on the load.
    #[test]
    fn without_a_series() {
        let Geometry::Ball(ball) = find("7210 B").unwrap().geometry() else {
            panic!()
        };
        let at = |degrees: f64| {
            Geometry::Ball(BallGeometry {
                play: Play::FreeAngle(degrees.to_radians()),
                ..ball
            })
        };
        assert!(is_one_sided(&at(15.0), None) && !is_one_sided(&at(12.0), None));
        let ratio = |load: f64| induced_axial_load(&at(15.0), None, load).unwrap().1 / load;
        // Y from 1.47 to 1.00
        assert!(ratio(10.0) > 0.33 && ratio(10.0) < ratio(1e4) && ratio(1e5) <= 0.5);
    }
}
