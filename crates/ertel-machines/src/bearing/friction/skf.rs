//! SKF's model of friction in deep groove ball bearings, without seals and drag.

use super::{Error, not_negative, positive};

/// Series with constants R_1, R_2, S_1 and S_2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SkfSeries {
    /// 2, 3.
    S2,
    /// 42, 43.
    S42,
    /// 60, 630.
    S60,
    /// 62, 622.
    S62,
    /// 63, 623.
    S63,
    /// 64.
    S64,
    /// 160, 161.
    S160,
    /// 618.
    S618,
    /// 619.
    S619,
}

impl SkfSeries {
    fn constants(self) -> [f64; 4] {
        match self {
            SkfSeries::S2 => [4.4e-7, 1.7, 2.00e-3, 100.0],
            SkfSeries::S42 => [5.4e-7, 0.96, 3.00e-3, 40.0],
            SkfSeries::S60 => [4.1e-7, 1.7, 3.73e-3, 14.6],
            SkfSeries::S62 => [3.9e-7, 1.7, 3.23e-3, 36.5],
            SkfSeries::S63 => [3.7e-7, 1.7, 2.84e-3, 92.8],
            SkfSeries::S64 => [3.6e-7, 1.7, 2.43e-3, 198.0],
            SkfSeries::S160 => [4.3e-7, 1.7, 4.63e-3, 4.25],
            SkfSeries::S618 => [4.7e-7, 1.7, 6.50e-3, 0.78],
            SkfSeries::S619 => [4.3e-7, 1.7, 4.75e-3, 3.6],
        }
    }
}

/// Constants of lubrication.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SkfParams {
    /// K_rs: 3e-8 of low oil baths and oil jets, 6e-8 of grease and oil-air.
    pub replenishment: f64,
    /// K_z of the bearing's type: 3.1 of deep groove ball bearings.
    pub geometry: f64,
    /// μ_bl of boundary lubrication.
    pub boundary_friction: f64,
    /// μ_EHL of a full film: 0.05 of mineral oils.
    pub film_friction: f64,
}

impl Default for SkfParams {
    /// A mineral oil in a low bath.
    fn default() -> SkfParams {
        SkfParams {
            replenishment: 3e-8,
            geometry: 3.1,
            boundary_friction: 0.12,
            film_friction: 0.05,
        }
    }
}

/// A bearing at work.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SkfState {
    /// Bore d, m.
    pub bore: f64,
    /// Outside diameter D, m.
    pub outside: f64,
    /// Speed of the rings against each other, rad/s.
    pub speed: f64,
    /// Kinematic viscosity of the oil at temperature, m²/s.
    pub viscosity: f64,
    /// F_r, N.
    pub radial: f64,
    /// F_a, N.
    pub axial: f64,
    /// C_0, N.
    pub static_rating: f64,
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
    /// φ_rs: reduction by oil that does not come back.
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
}

/// Frictional moment of a deep groove ball bearing.
///
/// ```text
///   M_rr = φ_ish φ_rs G_rr (ν n)^0.6        M_sl = G_sl [φ_bl μ_bl + (1 − φ_bl) μ_EHL]
///   radial:   G_rr = R_1 d_m^1.96 F_r^0.54                    G_sl = S_1 d_m^(−0.26) F_r^(5/3)
///   combined: G_rr = R_1 d_m^1.96 (F_r + R_2 F_a/sin α_F)^0.54   G_sl = S_1 d_m^(−0.145) (F_r⁵ + S_2 d_m^1.5 F_a⁴/sin α_F)^(1/3)
///   α_F = 24.6 (F_a/C_0)^0.24 degrees
///   φ_ish = 1/[1 + 1.84e-9 (n d_m)^1.28 ν^0.64]     φ_rs = exp{−K_rs ν n (d + D) √[K_z/(2(D − d))]}
///   φ_bl = exp[−2.6e-8 (n ν)^1.4 d_m]
/// ```
/// in mm, N, 1/min, mm²/s, N·mm. Source: SKF, Rolling Bearings (general catalogue), as a public implementation quotes it; there, loads
/// enter in kN, which these formulas do not allow.
///
/// # Errors
/// Numbers that are not positive.
pub fn skf_moment(
    series: SkfSeries,
    state: &SkfState,
    params: &SkfParams,
) -> Result<SkfMoment, Error> {
    let bore = positive("bore", state.bore)? * 1e3;
    let outside = positive("outside diameter", state.outside)? * 1e3;
    positive("outside diameter less the bore", outside - bore)?;
    let speed = state.speed.abs() * 30.0 / std::f64::consts::PI;
    let n = not_negative("speed", speed)?;
    let nu = positive("viscosity", state.viscosity)? * 1e6;
    let radial = not_negative("radial load", state.radial.abs())?;
    let axial = not_negative("axial load", state.axial.abs())?;
    let pitch = 0.5 * (bore + outside);
    let [r_1, r_2, s_1, s_2] = series.constants();
    let size = r_1 * pitch.powf(1.96);
    let (rolling_variable, sliding_variable) = match axial > 0.0 {
        false => (
            size * radial.powf(0.54),
            s_1 * pitch.powf(-0.26) * radial.powf(5.0 / 3.0),
        ),
        true => {
            let ratio = axial / positive("static rating", state.static_rating)?;
            let angle = (24.6 * ratio.powf(0.24)).to_radians();
            let sliding = radial.powi(5) + s_2 * pitch.powf(1.5) * axial.powi(4) / angle.sin();
            (
                size * (radial + r_2 * axial / angle.sin()).powf(0.54),
                s_1 * pitch.powf(-0.145) * sliding.cbrt(),
            )
        }
    };
    let inlet_heating = 1.0 / (1.0 + 1.84e-9 * (n * pitch).powf(1.28) * nu.powf(0.64));
    let width = (params.geometry / (2.0 * (outside - bore))).sqrt();
    let starvation = (-params.replenishment * nu * n * (bore + outside) * width).exp();
    let boundary = (-2.6e-8 * (n * nu).powf(1.4) * pitch).exp();
    let friction = boundary * params.boundary_friction + (1.0 - boundary) * params.film_friction;
    Ok(SkfMoment {
        rolling_variable,
        sliding_variable,
        inlet_heating,
        starvation,
        rolling: 1e-3 * inlet_heating * starvation * rolling_variable * (nu * n).powf(0.6),
        sliding: 1e-3 * sliding_variable * friction,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Every row of data/skf.csv.
    #[test]
    fn moments_of_an_independent_program() {
        let mut rows = 0;
        for row in include_str!("data/skf.csv").lines() {
            let row: Vec<&str> = row.split(',').collect();
            let (series, static_rating) = match row[0] {
                "6206" => (SkfSeries::S62, 11_200.0),
                "6309" => (SkfSeries::S63, 31_500.0),
                "6008" => (SkfSeries::S60, 11_000.0),
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

    #[test]
    fn bad_numbers() {
        let state = SkfState {
            bore: 0.03,
            outside: 0.062,
            speed: 100.0,
            viscosity: 3e-5,
            radial: 1000.0,
            axial: 100.0,
            static_rating: 0.0,
        };
        let solve = |state| skf_moment(SkfSeries::S62, &state, &SkfParams::default());
        assert!(solve(state).is_err());
        assert!(
            solve(SkfState {
                axial: 0.0,
                ..state
            })
            .is_ok()
        );
        assert!(
            solve(SkfState {
                outside: 0.03,
                ..state
            })
            .is_err()
        );
        assert!(
            solve(SkfState {
                viscosity: f64::NAN,
                ..state
            })
            .is_err()
        );
        assert_eq!(super::super::frictional_power(0.042, -100.0), 4.2);
    }
}
