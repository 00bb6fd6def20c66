//! Equivalent loads of ball bearings.

use super::Error;
use super::table::clamped;
use crate::bearing::geometry::BallGeometry;

/// F_a/(Z D²), MPa, of ISO 281:2007, table 3.
const RELATIVE_LOAD: [f64; 9] = [0.172, 0.345, 0.689, 1.03, 1.38, 2.07, 3.45, 5.17, 6.89];
/// Nominal angles of the table, degrees, and X, Y and e at each; Y and e of 0 to 15 degrees depend on the relative load.
const ANGLES: [f64; 10] = [0.0, 5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 35.0, 40.0, 45.0];
const X: [f64; 10] = [0.56, 0.56, 0.46, 0.44, 0.43, 0.41, 0.39, 0.37, 0.35, 0.33];
const Y_LOW: [[f64; 9]; 4] = [
    [2.3, 1.99, 1.71, 1.55, 1.45, 1.31, 1.15, 1.04, 1.0],
    [2.3, 1.99, 1.71, 1.55, 1.45, 1.31, 1.15, 1.04, 1.0],
    [1.88, 1.71, 1.52, 1.41, 1.34, 1.23, 1.1, 1.01, 1.0],
    [1.47, 1.4, 1.3, 1.23, 1.19, 1.12, 1.02, 1.0, 1.0],
];
const E_LOW: [[f64; 9]; 4] = [
    [0.19, 0.22, 0.26, 0.28, 0.3, 0.34, 0.38, 0.42, 0.44],
    [0.19, 0.22, 0.26, 0.28, 0.3, 0.34, 0.38, 0.42, 0.44],
    [0.29, 0.32, 0.36, 0.38, 0.4, 0.44, 0.49, 0.54, 0.54],
    [0.38, 0.4, 0.43, 0.46, 0.47, 0.5, 0.55, 0.56, 0.56],
];
const Y_HIGH: [f64; 6] = [1.0, 0.87, 0.76, 0.66, 0.57, 0.5];
const E_HIGH: [f64; 6] = [0.57, 0.68, 0.8, 0.95, 1.14, 1.34];

/// Factors of the dynamic equivalent load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Factors {
    /// X above e.
    pub radial: f64,
    /// Y above e.
    pub axial: f64,
    /// e: the ratio F_a/F_r up to which P = F_r.
    pub limit: f64,
}

impl Factors {
    /// P = F_r where F_a/F_r ≤ e, else X F_r + Y F_a; N.
    pub fn equivalent_load(&self, radial: f64, axial: f64) -> f64 {
        match axial <= self.limit * radial {
            true => radial,
            false => self.radial * radial + self.axial * axial,
        }
    }
}

/// X, Y and e of single-row ball bearings at the nominal contact angle (rad) under F_a/(Z D²) (Pa), both interpolated.
///
/// Source: ISO 281:2007, table 3. Beyond the table's loads its last values hold.
///
/// # Errors
/// Angles beyond 45 degrees.
pub fn factors(nominal_angle: f64, relative_load: f64) -> Result<Factors, Error> {
    let degrees = nominal_angle.to_degrees();
    if !(0.0..=45.0).contains(&degrees) {
        return Err(Error::Range {
            name: "nominal contact angle in degrees",
            value: degrees,
            low: 0.0,
            high: 45.0,
        });
    }
    let load = relative_load * 1e-6;
    let column = |low: &[[f64; 9]; 4], high: &[f64; 6]| {
        let low = low.iter().map(|row| clamped(&RELATIVE_LOAD, row, load));
        let all: Vec<f64> = low.chain(high.iter().copied()).collect();
        clamped(&ANGLES, &all, degrees)
    };
    Ok(Factors {
        radial: clamped(&ANGLES, &X, degrees),
        axial: column(&Y_LOW, &Y_HIGH),
        limit: column(&E_LOW, &E_HIGH),
    })
}

/// Dynamic equivalent radial load P of a single-row ball bearing under F_r and F_a, N, at the nominal contact angle (rad).
///
/// P = F_r where F_a/F_r ≤ e, else X F_r + Y F_a
///
/// # Errors
/// Angles beyond 45 degrees.
pub fn dynamic_equivalent_load(
    geometry: &BallGeometry,
    nominal_angle: f64,
    radial: f64,
    axial: f64,
) -> Result<f64, Error> {
    let (radial, axial) = (radial.abs(), axial.abs());
    Ok(dynamic_factors(geometry, nominal_angle, axial)?.equivalent_load(radial, axial))
}

/// [`factors`] under an axial load, N.
///
/// # Errors
/// Angles beyond 45 degrees.
pub fn dynamic_factors(
    geometry: &BallGeometry,
    nominal_angle: f64,
    axial: f64,
) -> Result<Factors, Error> {
    let area = geometry.number as f64 * geometry.ball_diameter.powi(2);
    factors(nominal_angle, axial / area)
}

/// Static equivalent radial load P_0, N, with the factors X_0 and Y_0 of the bearing's type.
///
/// P_0 = max(X_0 F_r + Y_0 F_a, F_r)
///
/// Source: ISO 76. X_0 and Y_0: makers' catalogues; 0.6 and 0.5 of deep groove, 0.5 and 0.26 of 40-degree angular contact ball bearings
/// (Schaeffler, HR 1, 2006).
pub fn static_equivalent_load([x, y]: [f64; 2], radial: f64, axial: f64) -> f64 {
    let (radial, axial) = (radial.abs(), axial.abs());
    (x * radial + y * axial).max(radial)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bearing::geometry::Play;
    use approx::assert_relative_eq;

    /// Entries of the table, and both interpolations by hand: 2.5 degrees as 0; 12.5 degrees at 0.345 MPa Y = (1.71 + 1.40)/2; 0 degrees at
    /// 0.517 MPa Y = (1.99 + 1.71)/2.
    #[test]
    fn table_three() {
        let at = |degrees: f64, load: f64| factors(degrees.to_radians(), load * 1e6).unwrap();
        assert_relative_eq!(at(40.0, 1.0).axial, 0.57, max_relative = 1e-12);
        assert_relative_eq!(at(40.0, 1.0).limit, 1.14, max_relative = 1e-12);
        assert_relative_eq!(at(2.5, 3.45).axial, 1.15, max_relative = 1e-12);
        assert_relative_eq!(at(12.5, 0.345).axial, 1.555, max_relative = 1e-12);
        assert_relative_eq!(at(0.0, 0.517).axial, 1.85, max_relative = 1e-12);
        assert_relative_eq!(at(0.0, 99.0).limit, 0.44, max_relative = 1e-12);
        assert!(factors(50_f64.to_radians(), 1e6).is_err());
    }

    /// 6206 under 2 kN and 1 kN: F_a/(Z D²) = 1.2247 MPa, between 1.03 and 1.38: Y = 1.55 − 0.5562 · 0.1 = 1.49438, P = 1120 + 1494.4 N;
    /// under 2 kN and 0.4 kN (0.4899 MPa, e = 0.2368) P = F_r.
    #[test]
    fn equivalent_loads_by_hand() {
        let bearing = BallGeometry {
            ball_diameter: 9.525e-3,
            pitch_diameter: 46e-3,
            number: 9,
            groove: [0.52, 0.52],
            play: Play::Clearance(0.0),
        };
        let p = |radial, axial| dynamic_equivalent_load(&bearing, 0.0, radial, axial).unwrap();
        assert_relative_eq!(p(2000.0, 1000.0), 2614.4, max_relative = 1e-4);
        assert_eq!(p(2000.0, 400.0), 2000.0);
        assert_eq!(static_equivalent_load([0.6, 0.5], 1000.0, 200.0), 1000.0);
        assert_eq!(static_equivalent_load([0.6, 0.5], 1000.0, 2000.0), 1600.0);
    }
}
