//! Basic load ratings and equivalent loads of roller bearings from the internal geometry.

use super::equivalent::Factors;
use super::{Error, positive};
use crate::bearing::geometry::{Ring, RollerGeometry, TaperedGeometry};

/// b_m of cylindrical and tapered roller bearings with machined rings (ISO 281:2007, table 5).
const B_M: f64 = 1.1;
/// λν of f_c: reduction for uneven pressure along the rollers.
pub(super) const UNEVEN: f64 = 0.83;
/// Largest γ of the standard's table.
const LARGEST_GAMMA: f64 = 0.30;

/// Data of a single row of rollers for ratings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RollerRow {
    /// Diameter of the rollers in the middle D, m.
    pub diameter: f64,
    /// Length of the contact L, m.
    pub length: f64,
    /// Pitch diameter d_m, m.
    pub pitch_diameter: f64,
    /// Number of rollers Z.
    pub number: usize,
    /// Nominal contact angle α, rad.
    pub angle: f64,
}

impl From<&RollerGeometry> for RollerRow {
    fn from(geometry: &RollerGeometry) -> RollerRow {
        RollerRow {
            diameter: geometry.roller_diameter,
            length: geometry.length,
            pitch_diameter: geometry.pitch_diameter,
            number: geometry.number,
            angle: 0.0,
        }
    }
}

impl From<&TaperedGeometry> for RollerRow {
    fn from(geometry: &TaperedGeometry) -> RollerRow {
        RollerRow {
            diameter: geometry.roller_diameter,
            length: geometry.length,
            pitch_diameter: geometry.pitch_diameter,
            number: geometry.number,
            angle: geometry.angle(Ring::Outer),
        }
    }
}

impl RollerRow {
    /// γ = D cos α/d_m.
    pub fn gamma(&self) -> f64 {
        self.diameter * self.angle.cos() / self.pitch_diameter
    }
}

/// Ratio of the capacities of both rings, without its constant: ((1 − γ)/(1 + γ))^(143/108).
pub(super) fn rings(gamma: f64) -> f64 {
    ((1.0 - gamma) / (1.0 + gamma)).powf(143.0 / 108.0)
}

/// f_c of radial roller bearings.
///
/// ```text
///   f_c = 207.9 λν γ^(2/9) (1 − γ)^(29/27)/(1 + γ)^(1/4) {1 + [1.04 ((1 − γ)/(1 + γ))^(143/108)]^(9/2)}^(−2/9),   λν = 0.83
/// ```
/// This is where the table of ISO 281:2007 comes from. Source: Lundberg and Palmgren, Acta Polytechnica, Mech. Eng. Series 2 No. 4 (1952); Harris and
/// Kotzalas 2007, Essential Concepts, chapter 11.
///
/// # Errors
/// γ that is not positive or beyond 0.30, where the standard's table ends.
pub fn roller_rating_factor(gamma: f64) -> Result<f64, Error> {
    if !(gamma > 0.0 && gamma <= LARGEST_GAMMA) {
        return Err(Error::Range {
            name: "γ",
            value: gamma,
            low: 0.0,
            high: LARGEST_GAMMA,
        });
    }
    let size = gamma.powf(2.0 / 9.0) * (1.0 - gamma).powf(29.0 / 27.0) / (1.0 + gamma).powf(0.25);
    let both = 1.0 + (1.04 * rings(gamma)).powf(4.5);
    Ok(207.9 * UNEVEN * size * both.powf(-2.0 / 9.0))
}

/// Basic dynamic radial load rating C_r of a single-row roller bearing, N.
///
/// C_r = b_m f_c (L cos α)^(7/9) Z^(3/4) D^(29/27),  L and D in mm
///
/// Source: ISO 281:2007, eq. for radial roller bearings.
///
/// # Errors
/// γ outside of the standard's table.
pub fn roller_rating(row: &RollerRow) -> Result<f64, Error> {
    let f_c = roller_rating_factor(row.gamma())?;
    let number = (row.number as f64).powf(0.75);
    let length = (row.length * 1e3 * row.angle.cos()).powf(7.0 / 9.0);
    let diameter = (row.diameter * 1e3).powf(29.0 / 27.0);
    Ok(B_M * f_c * length * number * diameter)
}

/// Basic static radial load rating C_0r of a single-row roller bearing, N.
///
/// C_0r = 44 (1 − γ) Z L D cos α,  L and D in mm
///
/// Source: ISO 76, eq. for radial roller bearings.
pub fn roller_static_rating(row: &RollerRow) -> f64 {
    let area = 1e6 * row.length * row.diameter * row.angle.cos();
    44.0 * (1.0 - row.gamma()) * row.number as f64 * area
}

/// X, Y and e of single-row roller bearings at the nominal contact angle α (rad), above 0.
///
/// X = 0.4,  Y = 0.4 cot α,  e = 1.5 tan α
///
/// Source: ISO 281:2007, table 8.
///
/// # Errors
/// An angle that is not positive.
pub fn roller_factors(angle: f64) -> Result<Factors, Error> {
    let tan = positive("contact angle", angle)?.tan();
    Ok(Factors {
        radial: 0.4,
        axial: 0.4 / tan,
        limit: 1.5 * tan,
    })
}

/// X_0 and Y_0 of single-row roller bearings at the nominal contact angle α (rad), above 0.
///
/// X_0 = 0.5,  Y_0 = 0.22 cot α
///
/// Source: ISO 76.
///
/// # Errors
/// An angle that is not positive.
pub fn roller_static_factors(angle: f64) -> Result<[f64; 2], Error> {
    Ok([0.5, 0.22 / positive("contact angle", angle)?.tan()])
}

/// Dynamic equivalent radial load P of a single-row roller bearing under F_r and F_a, N.
///
/// P = F_r where F_a/F_r ≤ e, else 0.4 F_r + Y F_a; F_r of cylindrical rollers, which carry no axial load
///
/// # Errors
/// Angles that are not positive, of rollers that carry axial load.
pub fn roller_equivalent_load(row: &RollerRow, radial: f64, axial: f64) -> Result<f64, Error> {
    let (radial, axial) = (radial.abs(), axial.abs());
    if axial == 0.0 {
        return Ok(radial);
    }
    Ok(roller_factors(row.angle)?.equivalent_load(radial, axial))
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    const ROW: RollerRow = RollerRow {
        diameter: 10e-3,
        length: 10e-3,
        pitch_diameter: 50e-3,
        number: 14,
        angle: 0.0,
    };

    /// Entries of the standard's table of f_c, as catalogues print it: within its rounding.
    #[test]
    fn table_of_the_standard() {
        for (gamma, expected) in [
            (0.01, 52.1),
            (0.05, 74.1),
            (0.10, 84.2),
            (0.15, 88.2),
            (0.20, 88.7),
            (0.25, 87.0),
            (0.30, 83.8),
        ] {
            let found = roller_rating_factor(gamma).unwrap();
            assert!((found - expected).abs() < 0.06, "{gamma}: {found}");
        }
        assert!(roller_rating_factor(0.31).is_err() && roller_rating_factor(0.0).is_err());
    }

    /// By hand at γ = 0.2: 1.1 · 88.706 · 10^(7/9) · 14^(3/4) · 10^(29/27) = 97.577 · 5.99484 · 7.237624 · 11.85957 = 50210 N; static 44 · 0.8 · 14 · 100
    /// = 49280 N.
    #[test]
    fn ratings_by_hand() {
        assert_relative_eq!(roller_rating(&ROW).unwrap(), 50_210.0, max_relative = 1e-3);
        assert_relative_eq!(roller_static_rating(&ROW), 49_280.0, max_relative = 1e-12);
        assert_eq!(roller_equivalent_load(&ROW, -500.0, 0.0), Ok(500.0));
    }

    /// 30206 in NSK's tables: e = 0.37, Y = 1.6, Y_0 = 0.88 at 14.0361 degrees; 0.4 · 1 + 1.6 · 2 kN.
    #[test]
    fn factors_of_a_catalogue() {
        let angle = 14.036_1_f64.to_radians();
        let factors = roller_factors(angle).unwrap();
        assert_relative_eq!(factors.limit, 0.375, max_relative = 1e-4);
        assert_relative_eq!(factors.axial, 1.6, max_relative = 1e-4);
        let [_, y] = roller_static_factors(angle).unwrap();
        assert_relative_eq!(y, 0.88, max_relative = 1e-4);
        let row = RollerRow { angle, ..ROW };
        let load = |axial| roller_equivalent_load(&row, 1000.0, axial).unwrap();
        assert_relative_eq!(load(2000.0), 3600.0, max_relative = 1e-4);
        assert_eq!(load(300.0), 1000.0);
    }
}
