//! SKF's model of friction, without seals and drag.

use super::error::{Error, not_negative, positive};
use super::skf_series::{SkfState, Variables};
use crate::bearing::catalogue::Series;

/// Constants of lubrication.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SkfParams {
    /// K_rs: 3e-8 of low oil baths and oil jets, 6e-8 of grease and oil-air.
    pub replenishment: f64,
    /// μ_bl of boundary lubrication.
    pub boundary_friction: f64,
    /// μ_EHL of a full film: 0.05 of mineral oils. Roller bearings have their own.
    pub film_friction: f64,
}

impl Default for SkfParams {
    /// A mineral oil in a low bath.
    fn default() -> SkfParams {
        SkfParams {
            replenishment: 3e-8,
            boundary_friction: 0.12,
            film_friction: 0.05,
        }
    }
}

/// Moments and what they are made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SkfMoment {
    /// G_rr, in the model's own unit.
    pub rolling_variable: f64,
    /// G_sl, likewise.
    pub sliding_variable: f64,
    /// φ_ish: reduction by the heat of shear in the inlet.
    pub inlet_heating: f64,
    /// φ_rs: reduction by starvation (oil that does not replenish the tracks).
    pub starvation: f64,
    /// M_rr, N·m.
    pub rolling: f64,
    /// M_sl, N·m.
    pub sliding: f64,
}

impl SkfMoment {
    /// M_rr + M_sl, N·m.
    pub fn total(&self) -> f64 {
        self.rolling + self.sliding
    }

    /// Whether its rolling part rises with the viscosity of the oil. Beyond, φ_rs takes more away than a thicker oil adds, and the moment of a cold bearing falls: the
    /// model does not hold there.
    ///
    /// d ln M_rr/d ln ν = 0.6 + ln φ_rs − 0.64 (1 − φ_ish)
    pub fn rises_with_viscosity(&self) -> bool {
        0.6 + self.starvation.ln() - 0.64 * (1.0 - self.inlet_heating) > 0.0
    }
}

/// Frictional moment of a bearing.
///
/// ```text
///   M_rr = φ_ish φ_rs G_rr (ν n)^0.6        M_sl = G_sl [φ_bl μ_bl + (1 − φ_bl) μ_EHL]
///   φ_ish = 1/[1 + 1.84e-9 (n d_m)^1.28 ν^0.64]     φ_rs = exp{−K_rs ν n (d + D) √[K_z/(2(D − d))]}
///   φ_bl = exp[−2.6e-8 (n ν)^1.4 d_m]
/// ```
/// in mm, N, 1/min, mm²/s, N·mm; G_rr and G_sl by the series of the bearing. Source: SKF, Rolling Bearings (general catalogue).
///
/// # Errors
/// Numbers that are not positive.
pub fn skf_moment(
    series: Series,
    state: &SkfState,
    params: &SkfParams,
) -> Result<SkfMoment, Error> {
    let bore = positive("bore", state.bore)? * 1e3;
    let outside = positive("outside diameter", state.outside)? * 1e3;
    positive("outside diameter less the bore", outside - bore)?;
    let speed = state.speed.abs() * 30.0 / std::f64::consts::PI;
    let n = not_negative("speed", speed)?;
    let nu = positive("viscosity", state.viscosity)? * 1e6;
    let pitch = 0.5 * (bore + outside);
    let Variables { rolling, sliding } = series.skf_variables(pitch, n, state)?;
    let inlet_heating = 1.0 / (1.0 + 1.84e-9 * (n * pitch).powf(1.28) * nu.powf(0.64));
    let width = (series.skf_geometry_constant() / (2.0 * (outside - bore))).sqrt();
    let starvation = (-params.replenishment * nu * n * (bore + outside) * width).exp();
    let boundary = (-2.6e-8 * (n * nu).powf(1.4) * pitch).exp();
    let film = series.skf_film_friction().unwrap_or(params.film_friction);
    let friction = boundary * params.boundary_friction + (1.0 - boundary) * film;
    Ok(SkfMoment {
        rolling_variable: rolling,
        sliding_variable: sliding,
        inlet_heating,
        starvation,
        rolling: 1e-3 * inlet_heating * starvation * rolling * (nu * n).powf(0.6),
        sliding: 1e-3 * sliding * friction,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// A 6206 under 1000 N at 1000/min.
    const STATE: SkfState = SkfState {
        bore: 0.03,
        outside: 0.062,
        speed: 1000.0 * std::f64::consts::PI / 30.0,
        viscosity: 3e-5,
        radial: 1000.0,
        axial: 0.0,
        static_rating: 0.0,
        axial_factor: 0.0,
    };

    /// Every row of data/skf.csv.
    #[test]
    fn moments_of_an_independent_program() {
        let mut rows = 0;
        for row in include_str!("data/skf.csv").lines() {
            let row: Vec<&str> = row.split(',').collect();
            let (series, static_rating) = match row[0] {
                "6206" => (Series::DeepGroove62, 11_200.0),
                "6309" => (Series::DeepGroove63, 31_500.0),
                "6008" => (Series::DeepGroove60, 11_000.0),
                _ => continue,
            };
            let v = |i: usize| row[i].parse::<f64>().unwrap();
            let state = SkfState {
                bore: v(1) * 1e-3,
                outside: v(2) * 1e-3,
                speed: v(3) * std::f64::consts::PI / 30.0,
                viscosity: v(4) * 1e-6,
                radial: v(5) * 1e3,
                axial: v(6) * 1e3,
                static_rating,
                ..STATE
            };
            let found = skf_moment(series, &state, &SkfParams::default()).unwrap();
            let numbers = [
                found.rolling_variable,
                found.sliding_variable,
                found.inlet_heating,
                found.starvation,
                found.rolling * 1e3,
                found.sliding * 1e3,
                found.total() * 1e3,
            ];
            for (k, number) in numbers.iter().enumerate() {
                assert_relative_eq!(*number, v(7 + k), max_relative = 1e-8);
            }
            rows += 1;
        }
        assert_eq!(rows, 6);
    }

    /// 30206 by hand at 1000/min, 30 mm²/s, F_r = 2000 N and F_a = 1000 N with Y = 1.6: 1.76e-6 · 46^2.38 = 0.0159534, (2000 + 10.9 · 1600)^0.31 =
    /// 19440^0.31 = 21.3499, G_rr = 0.340604, (ν n)^0.6 = 30000^0.6 = 485.593; φ_ish = 1/(1 + 1.84e-9 · 46000^1.28 · 30^0.64) = 0.985156,
    /// φ_rs = exp(−3e-8 · 30000 · 92 √(6/64)) = 0.974967: M_rr = 158.86 N mm; G_sl = 0.017 · 46^0.82 · 5200 = 2041.39, φ_bl = exp(−2.6e-8 · 30000^1.4 ·
    /// 46) = 0.109050, μ_sl = 0.013086 + 0.001782 = 0.0148679: M_sl = 30.351 N mm.
    #[test]
    fn tapered_rollers_by_hand() {
        let state = SkfState {
            radial: 2000.0,
            axial: 1000.0,
            axial_factor: 1.6,
            ..STATE
        };
        let found = skf_moment(Series::Tapered302, &state, &SkfParams::default()).unwrap();
        assert_relative_eq!(found.rolling, 158.86e-3, max_relative = 1e-3);
        assert_relative_eq!(found.sliding, 30.351e-3, max_relative = 1e-3);
    }

    /// A 6205 at 1500/min: the slope of the formula is that of differences, and the moment no longer rises between 400 and 800 mm²/s: K_rs ν n (d + D) √(3.1/54) = 0.6 − 0.64 (1 −
    /// φ_ish) there.
    #[test]
    fn thick_oils_are_beyond_the_model() {
        let at = |viscosity: f64| {
            let state = SkfState {
                bore: 0.025,
                outside: 0.052,
                speed: 1500.0 * std::f64::consts::PI / 30.0,
                viscosity: viscosity * 1e-6,
                radial: 500.0,
                static_rating: 7850.0,
                ..STATE
            };
            skf_moment(Series::DeepGroove62, &state, &SkfParams::default()).unwrap()
        };
        for viscosity in [10.0, 100.0, 400.0, 800.0, 1e4] {
            let rises = at(1.001 * viscosity).rolling > at(viscosity).rolling;
            assert_eq!(at(viscosity).rises_with_viscosity(), rises, "{viscosity}");
            assert_eq!(rises, viscosity < 500.0, "{viscosity}");
        }
    }

    #[test]
    fn bad_numbers() {
        let solve = |state| skf_moment(Series::DeepGroove62, &state, &SkfParams::default());
        assert!(solve(STATE).is_ok());
        let (axial, outside, viscosity) = (100.0, 0.03, f64::NAN);
        for state in [
            SkfState { axial, ..STATE },
            SkfState { outside, ..STATE },
            SkfState { viscosity, ..STATE },
        ] {
            assert!(solve(state).is_err(), "{state:?}");
        }
    }
}
