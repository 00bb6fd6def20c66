//! Palmgren's model of friction: a moment of the oil and one of the load.

use super::error::{Error, not_negative, positive};
use crate::bearing::catalogue::Series;

/// Oil supply of the bearing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PalmgrenOil {
    /// Grease that is run in, or oil mist.
    Grease,
    /// Oil bath to the middle of the lowest element, or circulating oil.
    Bath,
}

/// Factors of a bearing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PalmgrenFactors {
    /// f_0.
    pub oil: f64,
    /// f_1.
    pub load: f64,
}

impl Series {
    /// f_0, and f_1 = a (P_0/C_0)^b with the static equivalent load and the static rating, both N; b = 0 of rollers, which need neither.
    ///
    /// Source: Schaeffler, Rolling Bearings, catalogue HR 1, 2006, pages 57 to 59.
    ///
    /// # Errors
    /// A static rating of ball bearings that is not positive, or a negative load.
    pub fn palmgren_factors(
        self,
        oil: PalmgrenOil,
        static_load: f64,
        static_rating: f64,
    ) -> Result<PalmgrenFactors, Error> {
        let ([grease, bath], a, b) = match self {
            Series::DeepGroove60 => ([1.1, 1.7], 0.0007, 0.5),
            Series::DeepGroove62 => ([1.3, 2.0], 0.0009, 0.5),
            Series::DeepGroove63 => ([1.5, 2.3], 0.0009, 0.5),
            Series::Angular72B => ([1.3, 2.0], 0.001, 0.33),
            Series::Angular73B => ([2.0, 3.0], 0.001, 0.33),
            Series::CylindricalNu10 => ([1.3, 2.0], 0.0002, 0.0),
            Series::CylindricalNu2 => ([1.3, 2.0], 0.0003, 0.0),
            Series::CylindricalNu3 => ([1.3, 2.0], 0.000_35, 0.0),
            Series::Tapered302 | Series::Tapered303 => ([2.0, 3.0], 0.0004, 0.0),
            Series::Tapered320X | Series::Tapered322 | Series::Tapered323 => {
                ([3.0, 4.5], 0.0004, 0.0)
            }
        };
        let load = match b > 0.0 {
            true => {
                let ratio = not_negative("static equivalent load", static_load)?
                    / positive("static rating", static_rating)?;
                a * ratio.powf(b)
            }
            false => a,
        };
        Ok(PalmgrenFactors {
            oil: match oil {
                PalmgrenOil::Grease => grease,
                PalmgrenOil::Bath => bath,
            },
            load,
        })
    }
}

/// Both moments, N·m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PalmgrenMoment {
    /// M_0 of the oil.
    pub oil: f64,
    /// M_1 of the load.
    pub load: f64,
}

impl PalmgrenMoment {
    /// M_0 + M_1, N·m.
    pub fn total(&self) -> f64 {
        self.oil + self.load
    }
}

/// Decisive load P_1 of a single bearing, N; Y of tapered roller bearings, which other kinds leave aside.
///
/// ```text
///   deep groove: max(3.3 F_a − 0.1 F_r, F_r)        40-degree angular contact: max(F_a − 0.1 F_r, F_r)
///   cylindrical rollers: F_r                        tapered rollers: max(2 Y F_a, F_r)
/// ```
/// Source: Schaeffler, HR 1, 2006, page 60.
pub fn palmgren_load(series: Series, radial: f64, axial: f64, axial_factor: f64) -> f64 {
    let (radial, axial) = (radial.abs(), axial.abs());
    match series {
        Series::DeepGroove60 | Series::DeepGroove62 | Series::DeepGroove63 => {
            (3.3 * axial - 0.1 * radial).max(radial)
        }
        Series::Angular72B | Series::Angular73B => (axial - 0.1 * radial).max(radial),
        Series::CylindricalNu10 | Series::CylindricalNu2 | Series::CylindricalNu3 => radial,
        Series::Tapered302
        | Series::Tapered303
        | Series::Tapered320X
        | Series::Tapered322
        | Series::Tapered323 => (2.0 * axial_factor * axial).max(radial),
    }
}

/// Frictional moment of a bearing of the mean diameter d_m (m) at a speed (rad/s), with an oil of the kinematic viscosity (m²/s) at
/// temperature, under the decisive load P_1 (N).
///
/// ```text
///   M_0 = f_0 (ν n)^(2/3) d_m³ 10⁻⁷   where ν n ≥ 2000, else f_0 160 · 10⁻⁷ d_m³        M_1 = f_1 P_1 d_m
/// ```
/// in mm, N, 1/min, mm²/s, N·mm. Source: Palmgren; Schaeffler, HR 1, 2006, page 55.
///
/// # Errors
/// Numbers that are not positive.
pub fn palmgren_moment(
    factors: PalmgrenFactors,
    mean_diameter: f64,
    speed: f64,
    viscosity: f64,
    decisive_load: f64,
) -> Result<PalmgrenMoment, Error> {
    let pitch = positive("mean diameter", mean_diameter)? * 1e3;
    let n = not_negative("speed", speed.abs())? * 30.0 / std::f64::consts::PI;
    let product = n * positive("viscosity", viscosity)? * 1e6;
    let of_speed = match product >= 2000.0 {
        true => product.powf(2.0 / 3.0),
        false => 160.0,
    };
    let load = not_negative("decisive load", decisive_load)?;
    Ok(PalmgrenMoment {
        oil: 1e-10 * factors.oil * of_speed * pitch.powi(3),
        load: factors.load * load * mean_diameter,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    const PER_MINUTE: f64 = std::f64::consts::PI / 30.0;

    /// 6206 in an oil bath by hand: f_0 = 2, f_1 = 0.0009 √(2000/11200) = 3.80319e-4; ν n = 30 · 1000, 30000^(2/3) = 965.489; M_0 = 2 ·
    /// 965.489 · 46³ · 10⁻⁷ = 18.7953 N·mm, M_1 = 3.80319e-4 · 2000 · 46 = 34.9893 N·mm. SKF's model has 42.0 N·mm for the same bearing.
    #[test]
    fn deep_groove_by_hand() {
        let series = Series::DeepGroove62;
        let factors = series
            .palmgren_factors(PalmgrenOil::Bath, 2000.0, 11_200.0)
            .unwrap();
        assert_relative_eq!(factors.load, 3.803_19e-4, max_relative = 1e-5);
        let moment = palmgren_moment(factors, 0.046, 1000.0 * PER_MINUTE, 30e-6, 2000.0).unwrap();
        assert_relative_eq!(moment.oil, 18.795_3e-3, max_relative = 1e-5);
        assert_relative_eq!(moment.load, 34.989_3e-3, max_relative = 1e-5);
    }

    /// The moment of the oil has one value below ν n = 2000, and jumps by less than 1 % there: 2000^(2/3) = 158.74.
    #[test]
    fn slow_bearings() {
        let factors = Series::CylindricalNu2
            .palmgren_factors(PalmgrenOil::Grease, 0.0, 0.0)
            .unwrap();
        let at = |n: f64| palmgren_moment(factors, 0.046, n * PER_MINUTE, 20e-6, 0.0).unwrap();
        // 1.3 · 160 · 97336 · 10⁻⁷ N·mm
        assert_relative_eq!(at(10.0).oil, 2.024_589e-3, max_relative = 1e-6);
        assert_relative_eq!(at(100.1).oil, at(99.9).oil, max_relative = 1e-2);
    }

    /// Y = 1.6: 2 · 1.6 · 1000 N.
    #[test]
    fn decisive_loads() {
        let tapered = |axial| palmgren_load(Series::Tapered302, 1000.0, axial, 1.6);
        assert_eq!([tapered(1000.0), tapered(100.0)], [3200.0, 1000.0]);
        assert_eq!(
            palmgren_load(Series::DeepGroove62, 1000.0, 100.0, 0.0),
            1000.0
        );
        assert_eq!(
            palmgren_load(Series::DeepGroove62, 1000.0, -1000.0, 0.0),
            3200.0
        );
        assert_eq!(
            palmgren_load(Series::Angular72B, 1000.0, 3000.0, 0.0),
            2900.0
        );
        assert_eq!(
            palmgren_load(Series::CylindricalNu2, 1000.0, 3000.0, 0.0),
            1000.0
        );
    }
}
