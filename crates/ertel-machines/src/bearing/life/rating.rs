//! Basic load ratings of ball bearings from the internal geometry.

use super::table::interpolate;
use super::{Error, fatigue_limit_of_contact};
use crate::bearing::Material;
use crate::bearing::geometry::{BallGeometry, Ring};

/// b_m of radial and angular contact ball bearings of today's steels (ISO 281:2007, table 1).
const B_M_BALL: f64 = 1.3;
/// Ball diameter from which the exponent changes, mm.
const LARGE_BALL: f64 = 25.4;

/// f_c of ISO 281:2007, table 2, at γ = 0.01, 0.02, … 0.40: single-row radial and angular contact ball bearings.
const F_C: [f64; 40] = [
    29.1, 35.8, 40.3, 43.8, 46.7, 49.1, 51.1, 52.8, 54.3, 55.5, 56.6, 57.5, 58.2, 58.8, 59.3, 59.6,
    59.8, 59.9, 60.0, 59.9, 59.8, 59.6, 59.3, 59.0, 58.6, 58.2, 57.7, 57.1, 56.6, 56.0, 55.3, 54.6,
    53.9, 53.2, 52.4, 51.7, 50.9, 50.0, 49.2, 48.4,
];

/// f_0 of ISO 76 at γ = 0, 0.01, … 0.40: radial and angular contact ball bearings. From a public implementation, whose seventh entry, 15.7
/// like the sixth, is taken for a misprint of 15.9: all other steps of that part are 0.2.
const F_0: [f64; 41] = [
    14.7, 14.9, 15.1, 15.3, 15.5, 15.7, 15.9, 16.1, 16.3, 16.5, 16.4, 16.1, 15.9, 15.6, 15.4, 15.2,
    14.9, 14.7, 14.4, 14.2, 14.0, 13.7, 13.5, 13.2, 13.0, 12.8, 12.5, 12.3, 12.1, 11.8, 11.6, 11.4,
    11.2, 10.9, 10.7, 10.5, 10.3, 10.0, 9.8, 9.6, 9.4,
];

/// Widest grooves, radius over ball diameter, of the inner and outer ring, for which the tables of f_c and f_0 hold (ISO 281:2007, ISO 76).
const WIDEST: [f64; 2] = [0.52, 0.53];

/// The bearing with grooves of [`WIDEST`], and with its own where they are wider; `None` where none is.
fn wide_grooves(geometry: &BallGeometry) -> Option<[BallGeometry; 2]> {
    let own = [0, 1].map(|k| geometry.groove[k].max(WIDEST[k]));
    (own != WIDEST).then(|| {
        [WIDEST, own].map(|groove| BallGeometry {
            groove,
            ..*geometry
        })
    })
}

/// Whether a groove is wider than those for which the standards' tables hold.
pub fn has_wide_grooves(geometry: &BallGeometry) -> bool {
    wide_grooves(geometry).is_some()
}

/// f_c by the grooves, without the factors that do not depend on them.
///
/// (2f_i/(2f_i − 1))^0.41 {1 + [1.04 ((1 − γ)/(1 + γ))^1.72 (f_i (2f_o − 1)/(f_o (2f_i − 1)))^0.41]^(10/3)}^(−3/10)
///
/// Source: Lundberg and Palmgren 1947; Harris and Kotzalas 2007, Essential Concepts, chapter 11.
fn of_grooves(gamma: f64, [inner, outer]: [f64; 2]) -> f64 {
    let of = |f: f64| 2.0 * f / (2.0 * f - 1.0);
    let rings = ((1.0 - gamma) / (1.0 + gamma)).powf(1.72) * (of(inner) / of(outer)).powf(0.41);
    of(inner).powf(0.41) * (1.0 + (1.04 * rings).powf(10.0 / 3.0)).powf(-0.3)
}

/// f_c of ball bearings, γ = D cos α/d_m at the nominal contact angle.
///
/// # Errors
/// γ outside of 0.01 to 0.40.
pub fn ball_rating_factor(gamma: f64) -> Result<f64, Error> {
    let points = F_C.iter().enumerate();
    interpolate("γ", points.map(|(k, f)| [0.01 * (k + 1) as f64, *f]), gamma)
}

/// Basic dynamic radial load rating C_r of a single-row ball bearing, N, at the nominal contact angle α (rad).
///
/// ```text
///   C_r = b_m f_c (cos α)^0.7 Z^(2/3) D^1.8          D in mm up to 25.4 mm
///   C_r = 3.647 b_m f_c (cos α)^0.7 Z^(2/3) D^1.4    above
/// ```
/// Source: ISO 281:2007, eqs. 1 and 2, whose f_c holds for groove radii up to 0.52 D inside and 0.53 D outside. Wider grooves reduce it as they do in the formula of
/// Lundberg and Palmgren.
///
/// # Errors
/// γ outside of the table.
pub fn ball_rating(geometry: &BallGeometry, nominal_angle: f64) -> Result<f64, Error> {
    let diameter = geometry.ball_diameter * 1e3;
    let gamma = geometry.gamma(nominal_angle);
    let reduction = wide_grooves(geometry).map_or(1.0, |[table, own]| {
        of_grooves(gamma, own.groove) / of_grooves(gamma, table.groove)
    });
    let f_c = reduction * ball_rating_factor(gamma)?;
    let size = match diameter <= LARGE_BALL {
        true => diameter.powf(1.8),
        false => 3.647 * diameter.powf(1.4),
    };
    let number = (geometry.number as f64).powf(2.0 / 3.0);
    Ok(B_M_BALL * f_c * nominal_angle.cos().powf(0.7) * number * size)
}

/// Basic static radial load rating C_0r of a single-row ball bearing, N, at the nominal contact angle α (rad).
///
/// C_0r = f_0 Z D² cos α,  D in mm
///
/// Source: ISO 76. Grooves wider than its f_0 holds for reduce it by the load under the same Hertz pressure at the ring that bears less.
///
/// # Errors
/// γ outside of 0 to 0.40.
pub fn deep_groove_static_rating(
    geometry: &BallGeometry,
    nominal_angle: f64,
) -> Result<f64, Error> {
    let gamma = geometry.gamma(nominal_angle);
    let points = F_0.iter().enumerate();
    let f_0 = interpolate("γ", points.map(|(k, f)| [0.01 * k as f64, *f]), gamma)?;
    let reduction = wide_grooves(geometry).map_or(1.0, |grooves| {
        let [table, own] = grooves.map(|geometry| {
            let loads = Ring::BOTH.map(|ring| {
                fatigue_limit_of_contact(&geometry, Material::STEEL, ring, nominal_angle)
            });
            loads[0].min(loads[1])
        });
        own / table
    });
    let diameter = geometry.ball_diameter * 1e3;
    Ok(reduction * f_0 * geometry.number as f64 * diameter * diameter * nominal_angle.cos())
}

/// Exponent of the life of ball bearings, L10 = (C/P)³.
pub const BALL_EXPONENT: f64 = 3.0;

/// Exponent of the life of roller bearings, L10 = (C/P)^(10/3).
pub const ROLLER_EXPONENT: f64 = 10.0 / 3.0;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bearing::geometry::Play;
    use crate::near::near;
    use approx::assert_relative_eq;

    fn of(ball: f64, pitch: f64, number: usize) -> BallGeometry {
        BallGeometry {
            ball_diameter: ball,
            pitch_diameter: pitch,
            number,
            groove: [0.52, 0.52],
            play: Play::Clearance(0.0),
        }
    }

    /// 6206 by hand: γ = 0.207065, f_c = 59.82935, 1.3 · 59.82935 · 9^(2/3) · 9.525^1.8 = 77.7782 · 4.326749 · 57.8035 = 19452.5 N. C_0 =
    /// 13.788 · 9 · 90.7256 = 11258 N.
    #[test]
    fn deep_groove_by_hand() {
        let bearing = of(9.525e-3, 46e-3, 9);
        near(ball_rating(&bearing, 0.0).unwrap(), 19_452.5, 1e-5);
        let still = deep_groove_static_rating(&bearing, 0.0).unwrap();
        // f_0 = 14.0 − 0.7065 · 0.3 = 13.788
        assert_relative_eq!(still, 13.788 * 9.0 * 90.725_6, max_relative = 1e-4);
        assert!(ball_rating(&of(10e-3, 22e-3, 4), 0.0).is_err());
    }

    /// Grooves of 0.56 at γ = 0.207 by hand: (1.12/0.12)^0.41 = 2.4987 against (1.04/0.04)^0.41 = 3.8031; rings 1.04 · 0.48541 = 0.50483, and 1.17167 times that at 0.52
    /// and 0.53, 0.59150; (1 + 0.50483^(10/3))^(−0.3) = 0.97116 against (1 + 0.59150^(10/3))^(−0.3) = 0.95309: 0.6695, C = 13.02 kN. Tighter grooves change nothing.
    #[test]
    fn wide_grooves_carry_less() {
        let of = |groove| BallGeometry {
            groove,
            ..of(9.525e-3, 46e-3, 9)
        };
        let dynamic = |groove| ball_rating(&of(groove), 0.0).unwrap();
        near(dynamic([0.56, 0.56]) / dynamic([0.52, 0.53]), 0.6695, 1e-3);
        assert_eq!(dynamic([0.51, 0.51]), dynamic([0.52, 0.53]));
        let fixed = |groove| deep_groove_static_rating(&of(groove), 0.0).unwrap();
        assert_eq!(fixed([0.51, 0.51]), fixed([0.52, 0.53]));
        // Q ~ (a b)³ at one pressure falls with the radius across, but less than it: 0.163 m against 0.044 m.
        let ratio = fixed([0.56, 0.56]) / fixed([0.52, 0.53]);
        assert!((0.3..0.7).contains(&ratio), "{ratio}");
        assert!(dynamic([0.525, 0.53]) < dynamic([0.52, 0.53]));
        // Inside, ball and raceway are less conformal: Σρ = (2.522 + 0.077)/D against (1.657 + 0.148)/D outside. A wider groove outside changes nothing.
        assert_eq!(fixed([0.52, 0.54]), fixed([0.52, 0.53]));
        assert!(fixed([0.53, 0.53]) < fixed([0.52, 0.53]));
    }

    /// Both formulas meet at 25.4 mm: 25.4^0.4 = 3.647.
    #[test]
    fn large_balls() {
        let [small, large] = [25.4e-3, 25.4001e-3].map(|d| ball_rating(&of(d, 120e-3, 9), 0.0));
        assert_relative_eq!(small.unwrap(), large.unwrap(), max_relative = 1e-4);
    }
}
