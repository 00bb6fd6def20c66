//! Life factors: viscosity ratio, a_ISO and a_1.

use super::{Error, positive};

/// Elements of a bearing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Radial and angular contact ball bearings.
    Ball,
    /// Radial roller bearings.
    Roller,
}

/// Lubrication and cleanliness for the life modification factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lubrication {
    /// κ = ν/ν_1.
    pub viscosity_ratio: f64,
    /// Contamination factor e_C, from 0 to 1.
    pub contamination: f64,
    /// Whether effective extreme-pressure additives are in it.
    pub additives: bool,
}

const SMALLEST_RATIO: f64 = 0.1;
const LARGEST_RATIO: f64 = 4.0;
const LARGEST_FACTOR: f64 = 50.0;
/// With additives instead of viscosity.
const LARGEST_FACTOR_OF_ADDITIVES: f64 = 3.0;
const CLEAN_ENOUGH_FOR_ADDITIVES: f64 = 0.2;

/// Reference viscosity ν_1, m²/s, at a speed (rad/s) and a pitch diameter (m).
///
/// ν_1 = 45000 n^(−0.83) d_m^(−1/2) below 1000/min, else 4500 n^(−1/2) d_m^(−1/2);  mm²/s, 1/min, mm
///
/// Source: ISO 281:2007, eqs. 28 and 29.
///
/// # Errors
/// Numbers that are not positive.
pub fn reference_viscosity(speed: f64, pitch_diameter: f64) -> Result<f64, Error> {
    let n = positive("speed", speed.abs())? * 30.0 / std::f64::consts::PI;
    let pitch = positive("pitch diameter", pitch_diameter)? * 1e3;
    let of_speed = match n < 1000.0 {
        true => 45_000.0 * n.powf(-0.83),
        false => 4500.0 * n.powf(-0.5),
    };
    Ok(1e-6 * of_speed * pitch.powf(-0.5))
}

/// κ = ν/ν_1 of the oil's kinematic viscosity (m²/s) at temperature, the speed (rad/s) and the pitch diameter (m).
///
/// # Errors
/// Numbers that are not positive.
pub fn viscosity_ratio(viscosity: f64, speed: f64, pitch_diameter: f64) -> Result<f64, Error> {
    Ok(positive("viscosity", viscosity)? / reference_viscosity(speed, pitch_diameter)?)
}

/// Life factor a_ISO with the fatigue load limit C_u and the equivalent load P, both N.
///
/// ```text
///   balls:    a_ISO = 0.1 [1 − (2.5671 − c)^0.83 (e_C C_u/P)^(1/3)]^(−9.3)
///   rollers:  a_ISO = 0.1 [1 − (1.5859 − c) (e_C C_u/P)^0.4]^(−9.185)
///     0.1 ≤ κ < 0.4:  c = 2.2649, 1.3993 over κ^0.054381
///     0.4 ≤ κ < 1:    c = 1.9987, 1.2348 over κ^0.19087
///     1 ≤ κ ≤ 4:      c = 1.9987, 1.2348 over κ^0.071739
/// ```
/// 50 at the most; κ above 4 counts as 4. Additives let κ < 1 count as 1 where e_C ≥ 0.2; the factor is then 3 at the most, and no less
/// than it was. Source: ISO 281:2007, eqs. 31 to 36 and section 9.3.3.4.
///
/// # Errors
/// κ below 0.1, e_C outside of 0 to 1, loads that are not positive.
pub fn life_factor(
    kind: Kind,
    oil: Lubrication,
    fatigue_limit: f64,
    load: f64,
) -> Result<f64, Error> {
    let range = |name, value: f64, low, high| match (low..=high).contains(&value) {
        true => Ok(()),
        false => Err(Error::Range {
            name,
            value,
            low,
            high,
        }),
    };
    let kappa = oil.viscosity_ratio;
    range("κ", kappa, SMALLEST_RATIO, f64::INFINITY)?;
    range("e_C", oil.contamination, 0.0, 1.0)?;
    let limit = positive("fatigue load limit", fatigue_limit)?;
    let ratio = oil.contamination * limit / positive("equivalent load", load)?;
    let plain = of_ratio(kind, kappa.min(LARGEST_RATIO), ratio);
    let helped = oil.additives && kappa < 1.0 && oil.contamination >= CLEAN_ENOUGH_FOR_ADDITIVES;
    Ok(match helped {
        true => of_ratio(kind, 1.0, ratio)
            .min(LARGEST_FACTOR_OF_ADDITIVES)
            .max(plain),
        false => plain,
    })
}

fn of_ratio(kind: Kind, kappa: f64, ratio: f64) -> f64 {
    let power = match kappa {
        k if k < 0.4 => 0.054_381,
        k if k < 1.0 => 0.190_87,
        _ => 0.071_739,
    };
    let thin = kappa < 0.4;
    let (bracket, exponent) = match kind {
        Kind::Ball => {
            let c = if thin { 2.2649 } else { 1.9987 };
            let film: f64 = 2.5671 - c / kappa.powf(power);
            (1.0 - film.powf(0.83) * ratio.cbrt(), -9.3)
        }
        Kind::Roller => {
            let c = if thin { 1.3993 } else { 1.2348 };
            let film = 1.5859 - c / kappa.powf(power);
            (1.0 - film * ratio.powf(0.4), -9.185)
        }
    };
    match bracket > 0.0 {
        true => (0.1 * bracket.powf(exponent)).min(LARGEST_FACTOR),
        false => LARGEST_FACTOR,
    }
}

/// a_1 of the reliability in per cent: 90, 95, 96, 97, 98, 99, 99.95, between them linear.
///
/// Source: ISO 281:2007, table 12, as a public implementation quotes it.
///
/// # Errors
/// Reliabilities outside of these.
pub fn reliability_factor(per_cent: f64) -> Result<f64, Error> {
    const TABLE: [[f64; 2]; 7] = [
        [90.0, 1.0],
        [95.0, 0.64],
        [96.0, 0.55],
        [97.0, 0.47],
        [98.0, 0.37],
        [99.0, 0.25],
        [99.95, 0.077],
    ];
    super::table::interpolate("reliability in per cent", TABLE.into_iter(), per_cent)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::near::near;
    use approx::assert_relative_eq;

    fn oil(viscosity_ratio: f64, contamination: f64) -> Lubrication {
        Lubrication {
            viscosity_ratio,
            contamination,
            additives: false,
        }
    }

    /// Every row of data/a_iso.csv.
    #[test]
    fn factors_of_an_independent_program() {
        let mut rows = 0;
        for row in include_str!("data/a_iso.csv").lines() {
            let row: Vec<&str> = row.split(',').collect();
            let kind = match row[0] {
                "ball" => Kind::Ball,
                "roller" => Kind::Roller,
                _ => continue,
            };
            let [kappa, ratio, expected] = [1, 2, 3].map(|i| row[i].parse::<f64>().unwrap());
            let found = life_factor(kind, oil(kappa, 1.0), ratio * 1000.0, 1000.0).unwrap();
            assert_relative_eq!(found, expected, max_relative = 1e-8);
            rows += 1;
        }
        assert_eq!(rows, 28);
    }

    #[test]
    fn limits() {
        let at = |oil| life_factor(Kind::Ball, oil, 500.0, 1000.0).unwrap();
        assert_eq!(at(oil(4.0, 1.0)), LARGEST_FACTOR);
        assert_eq!(at(oil(9.0, 0.2)), at(oil(4.0, 0.2)));
        assert!(life_factor(Kind::Ball, oil(0.09, 0.5), 1.0, 1.0).is_err());
        assert!(life_factor(Kind::Ball, oil(1.0, 1.5), 1.0, 1.0).is_err());
        let helped = |contamination| Lubrication {
            additives: true,
            ..oil(0.4, contamination)
        };
        assert_eq!(at(helped(0.1)), at(oil(0.4, 0.1)));
        assert_eq!(at(helped(0.2)), at(oil(1.0, 0.2)).min(3.0));
        assert_eq!(at(helped(1.0)), at(oil(0.4, 1.0)).max(3.0));
    }

    /// By hand: 45000 · 500^(−0.83)/√50 = 45000/173.83/7.0711 = 36.61 mm²/s; 4500/√3000/√46 = 12.113 mm²/s, and 30 mm²/s on it κ = 2.4766.
    #[test]
    fn viscosities_by_hand() {
        let per_minute = std::f64::consts::PI / 30.0;
        let slow = reference_viscosity(500.0 * per_minute, 0.05).unwrap();
        assert_relative_eq!(slow, 36.61e-6, max_relative = 1e-3);
        let fast = reference_viscosity(3000.0 * per_minute, 0.046).unwrap();
        assert_relative_eq!(fast, 12.113e-6, max_relative = 1e-4);
        let ratio = viscosity_ratio(30e-6, 3000.0 * per_minute, 0.046).unwrap();
        assert_relative_eq!(ratio, 2.4766, max_relative = 1e-4);
    }

    #[test]
    fn reliabilities() {
        assert_eq!(reliability_factor(95.0), Ok(0.64));
        near(reliability_factor(92.5).unwrap(), 0.82, 1e-12);
        assert!(reliability_factor(99.99).is_err());
    }
}
