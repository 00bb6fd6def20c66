//! Kinds of bearings in SKF's model of friction.

use super::error::{Error, not_negative, positive};
use crate::bearing::catalogue::Series;

/// G_rr and G_sl, in the model's own units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Variables {
    pub rolling: f64,
    pub sliding: f64,
}

/// Constants of a series.
enum Constants {
    /// R_1, R_2, S_1, S_2.
    DeepGroove([f64; 4]),
    /// R_1, R_2, R_3, S_1, S_2, S_3.
    AngularContact([f64; 6]),
    /// R_1, S_1, S_2.
    Cylindrical([f64; 3]),
    /// R_1, R_2, S_1, S_2.
    Tapered([f64; 4]),
}

impl Series {
    /// Source: SKF, Rolling Bearings (general catalogue), tables 3 to 3d.
    fn skf_constants(self) -> Constants {
        use Constants::{AngularContact, Cylindrical, DeepGroove, Tapered};
        match self {
            Series::DeepGroove60 => DeepGroove([4.1e-7, 1.7, 3.73e-3, 14.6]),
            Series::DeepGroove62 => DeepGroove([3.9e-7, 1.7, 3.23e-3, 36.5]),
            Series::DeepGroove63 => DeepGroove([3.7e-7, 1.7, 2.84e-3, 92.8]),
            Series::Angular72B | Series::Angular73B => {
                AngularContact([5.03e-7, 1.97, 1.90e-12, 1.30e-2, 0.68, 1.91e-12])
            }
            Series::CylindricalNu10 => Cylindrical([1.12e-6, 0.17, 0.0015]),
            Series::CylindricalNu2 | Series::CylindricalNu3 => Cylindrical([1.09e-6, 0.16, 0.0015]),
            Series::Tapered302 => Tapered([1.76e-6, 10.9, 0.017, 2.0]),
            Series::Tapered303 => Tapered([1.69e-6, 10.9, 0.017, 2.0]),
            Series::Tapered320X => Tapered([2.38e-6, 10.9, 0.014, 2.0]),
            Series::Tapered322 => Tapered([2.27e-6, 10.9, 0.018, 2.0]),
            Series::Tapered323 => Tapered([2.38e-6, 10.9, 0.019, 2.0]),
        }
    }

    /// K_z of the reduction by starvation (table 5).
    pub(super) fn skf_geometry_constant(self) -> f64 {
        match self.skf_constants() {
            Constants::DeepGroove(_) => 3.1,
            Constants::AngularContact(_) => 4.4,
            Constants::Cylindrical(_) => 5.1,
            Constants::Tapered(_) => 6.0,
        }
    }

    /// μ_EHL of a full film where the kind of bearing has one: cylindrical 0.02 and tapered roller bearings 0.002.
    pub(super) fn skf_film_friction(self) -> Option<f64> {
        match self.skf_constants() {
            Constants::Cylindrical(_) => Some(0.02),
            Constants::Tapered(_) => Some(0.002),
            Constants::DeepGroove(_) | Constants::AngularContact(_) => None,
        }
    }

    /// G_rr and G_sl at the mean diameter d_m (mm) and the speed n (1/min).
    ///
    /// ```text
    ///   deep groove, F_a = 0:  G_rr = R_1 d_m^1.96 F_r^0.54                       G_sl = S_1 d_m^(−0.26) F_r^(5/3)
    ///   deep groove, F_a > 0:  G_rr = R_1 d_m^1.96 (F_r + R_2 F_a/sin α_F)^0.54   G_sl = S_1 d_m^(−0.145) (F_r⁵ + S_2 d_m^1.5 F_a⁴/sin α_F)^(1/3)
    ///   angular contact:       G_rr = R_1 d_m^1.97 (F_r + F_g + R_2 F_a)^0.54     G_sl = S_1 d_m^0.26 [(F_r + F_g)^(4/3) + S_2 F_a^(4/3)]
    ///   cylindrical rollers:   G_rr = R_1 d_m^2.41 F_r^0.31                       G_sl = S_1 d_m^0.9 F_a + S_2 d_m F_r
    ///   tapered rollers:       G_rr = R_1 d_m^2.38 (F_r + R_2 Y F_a)^0.31         G_sl = S_1 d_m^0.82 (F_r + S_2 Y F_a)
    ///   α_F = 24.6 (F_a/C_0)^0.24 degrees;   F_g = R_3 d_m⁴ n² in G_rr, S_3 d_m⁴ n² in G_sl
    /// ```
    /// Source: SKF, Rolling Bearings (general catalogue), table 2a.
    pub(super) fn skf_variables(
        self,
        pitch: f64,
        n: f64,
        state: &SkfState,
    ) -> Result<Variables, Error> {
        let radial = not_negative("radial load", state.radial.abs())?;
        let axial = not_negative("axial load", state.axial.abs())?;
        let [rolling, sliding] = match self.skf_constants() {
            Constants::DeepGroove([r_1, r_2, s_1, s_2]) => {
                let size = r_1 * pitch.powf(1.96);
                match axial > 0.0 {
                    false => [
                        size * radial.powf(0.54),
                        s_1 * pitch.powf(-0.26) * radial.powf(5.0 / 3.0),
                    ],
                    true => {
                        let ratio = axial / positive("static rating", state.static_rating)?;
                        let angle = (24.6 * ratio.powf(0.24)).to_radians();
                        let sliding =
                            radial.powi(5) + s_2 * pitch.powf(1.5) * axial.powi(4) / angle.sin();
                        [
                            size * (radial + r_2 * axial / angle.sin()).powf(0.54),
                            s_1 * pitch.powf(-0.145) * sliding.cbrt(),
                        ]
                    }
                }
            }
            Constants::AngularContact([r_1, r_2, r_3, s_1, s_2, s_3]) => {
                let inertia = |constant: f64| constant * pitch.powi(4) * n * n;
                let power = 4.0 / 3.0;
                let load = radial + inertia(r_3) + r_2 * axial;
                let sliding = (radial + inertia(s_3)).powf(power) + s_2 * axial.powf(power);
                [
                    r_1 * pitch.powf(1.97) * load.powf(0.54),
                    s_1 * pitch.powf(0.26) * sliding,
                ]
            }
            Constants::Cylindrical([r_1, s_1, s_2]) => [
                r_1 * pitch.powf(2.41) * radial.powf(0.31),
                s_1 * pitch.powf(0.9) * axial + s_2 * pitch * radial,
            ],
            Constants::Tapered([r_1, r_2, s_1, s_2]) => {
                let thrust = not_negative("axial factor Y", state.axial_factor)? * axial;
                [
                    r_1 * pitch.powf(2.38) * (radial + r_2 * thrust).powf(0.31),
                    s_1 * pitch.powf(0.82) * (radial + s_2 * thrust),
                ]
            }
        };
        Ok(Variables { rolling, sliding })
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
    /// C_0, N: of deep groove ball bearings.
    pub static_rating: f64,
    /// Y: of tapered roller bearings.
    pub axial_factor: f64,
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// By hand at d_m = 50 mm and 1000/min, F_r = 1000 N and F_a = 500 N. Angular contact: F_g = 1.9e-12 · 6.25e6 · 1e6 = 11.875 N, 11.9375 N; G_rr =
    /// 5.03e-7 · 50^1.97 · 1996.875^0.54 = 5.03e-7 · 2223.18 · 60.5535 = 0.0677146, G_sl = 0.013 · 50^0.26 · (1011.9375^(4/3) + 0.68 · 500^(4/3)) =
    /// 0.013 · 2.765281 · (10159.6 + 2698.58) = 462.234. Cylindrical: 1.09e-6 · 50^2.41 · 1000^0.31 = 1.09e-6 · 12434.3 · 8.51138 = 0.115358; 0.16 · 50^0.9
    /// · 500 + 0.0015 · 50 · 1000 = 2704.98 + 75.
    #[test]
    fn variables_by_hand() {
        let state = SkfState {
            bore: 0.035,
            outside: 0.065,
            speed: 104.72,
            viscosity: 3e-5,
            radial: 1000.0,
            axial: 500.0,
            static_rating: 0.0,
            axial_factor: 0.0,
        };
        let of = |series: Series| series.skf_variables(50.0, 1000.0, &state).unwrap();
        let ball = of(Series::Angular72B);
        assert_relative_eq!(ball.rolling, 0.067_714_6, max_relative = 1e-3);
        assert_relative_eq!(ball.sliding, 462.234, max_relative = 1e-3);
        let roller = of(Series::CylindricalNu2);
        assert_relative_eq!(roller.rolling, 0.115_358, max_relative = 1e-3);
        assert_relative_eq!(roller.sliding, 2779.98, max_relative = 1e-3);
    }
}
