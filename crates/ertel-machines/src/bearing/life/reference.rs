//! Reference rating life from the loads of all balls.

use super::{Error, positive};
use crate::bearing::geometry::{BallGeometry, Ring};

/// Which ring turns against the load.
const TURNING: f64 = 3.0;
const RESTING: f64 = 10.0 / 3.0;

/// Reference life and what it is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReferenceLife {
    /// Q_ci and Q_ce: loads of an element for a life of each ring of a million revolutions, N.
    pub rating: [f64; 2],
    /// Q_ei and Q_ee: equivalent loads of an element on each ring, N.
    pub equivalent: [f64; 2],
    /// L_10r, revolutions.
    pub life: f64,
    /// P_ref = C_r/(L_10r/10⁶)^(1/p), N; p = 3 of balls, 10/3 of rollers.
    pub equivalent_load: f64,
}

/// Power mean of the loads of all elements, those without load included, N.
///
/// Q_e = (1/Z Σ Q_j^p)^(1/p),  p = 3 of the ring that turns against the load, 10/3 of the other one
pub fn equivalent_element_load(loads: &[f64], turns: bool) -> f64 {
    let p = if turns { TURNING } else { RESTING };
    let sum: f64 = loads.iter().map(|q| q.max(0.0).powf(p)).sum();
    (sum / loads.len().max(1) as f64).powf(p.recip())
}

/// Basic reference rating life of a single-row ball bearing with the rating C_r (N) at the nominal contact angle (rad), under the loads of
/// all balls on inner and outer ring (N); `turning` says of each ring whether it turns against the load.
///
/// ```text
///   T = 1.044 ((1 − γ)/(1 + γ))^1.72 [(r_i/r_e)(2r_e − D)/(2r_i − D)]^0.41
///   Q_ci = C_r/(0.407 Z cos α) (1 + T^(10/3))^(3/10)     Q_ce = C_r/(0.389 Z cos α) (1 + T^(−10/3))^(3/10)
///   L_10r = [(Q_ci/Q_ei)^(−10/3) + (Q_ce/Q_ee)^(−10/3)]^(−9/10)   million revolutions
/// ```
/// Source: ISO/TS 16281, sections on ball bearings.
///
/// # Errors
/// No loads, or a rating that is not positive.
pub fn reference_life(
    geometry: &BallGeometry,
    nominal_angle: f64,
    dynamic_rating: f64,
    loads: [&[f64]; 2],
    turning: [bool; 2],
) -> Result<ReferenceLife, Error> {
    let rating = positive("rating", dynamic_rating)?;
    let gamma = geometry.gamma(nominal_angle);
    let [inner, outer] = geometry.groove;
    let grooves = inner / outer * (2.0 * outer - 1.0) / (2.0 * inner - 1.0);
    let t = 1.044 * ((1.0 - gamma) / (1.0 + gamma)).powf(1.72) * grooves.powf(0.41);
    let each = rating / (geometry.number as f64 * nominal_angle.cos());
    let both = |sign: f64| (1.0 + t.powf(sign * 10.0 / 3.0)).powf(0.3);
    let rating_of = [each / 0.407 * both(1.0), each / 0.389 * both(-1.0)];
    let equivalent =
        Ring::BOTH.map(|ring| equivalent_element_load(loads[ring.index()], turning[ring.index()]));
    positive(
        "equivalent load of a ball",
        equivalent[0].max(equivalent[1]),
    )?;
    let sum: f64 = [0, 1]
        .map(|k| (equivalent[k] / rating_of[k]).powf(10.0 / 3.0))
        .iter()
        .sum();
    let life = sum.powf(-0.9);
    Ok(ReferenceLife {
        rating: rating_of,
        equivalent,
        life: 1e6 * life,
        equivalent_load: rating / life.cbrt(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bearing::geometry::Play;
    use crate::bearing::kinematics::Speeds;
    use crate::bearing::life::{
        ball_rating, ball_rating_factor, fatigue_limit, fatigue_limit_of_contact,
    };
    use crate::bearing::load::{CurvatureAngle, Loads, Params};
    use crate::bearing::test_data::rows;
    use crate::bearing::{Bearing, Geometry, Material};
    use crate::near::near;
    use approx::assert_relative_eq;

    /// Every row of data/ball_life.csv, with the loads of this crate's own solution.
    #[test]
    fn lives_of_an_independent_program() {
        let rows = rows(include_str!("data/ball_life.csv"));
        assert_eq!(rows.len(), 9);
        for row in rows {
            let v = |i: usize| row[i].parse::<f64>().unwrap();
            let (ball_diameter, pitch_diameter, number, groove) = match row[0] {
                "6206-like" => (9.525e-3, 46e-3, 9, [0.515, 0.525]),
                "6309-like" => (17.462e-3, 72.5e-3, 8, [0.515, 0.525]),
                _ => (12.7e-3, 70e-3, 14, [0.52, 0.53]),
            };
            let geometry = BallGeometry {
                ball_diameter,
                pitch_diameter,
                number,
                groove,
                play: Play::Clearance(v(1) * 1e-6),
            };
            let nominal = match row[0] {
                "7210-like" => geometry.free_angle(),
                _ => 0.0,
            };
            let params = Params {
                curvature_angle: CurvatureAngle::Free,
                ..Params::default()
            };
            let solved = Bearing::steel(Geometry::Ball(geometry))
                .solve(&Loads::forces(v(2), v(3)), Speeds::default(), &params)
                .unwrap();
            let [inner, outer] = Ring::BOTH.map(|ring| solved.loads(ring));
            let rating = ball_rating(&geometry, nominal).unwrap();
            let life = reference_life(&geometry, nominal, rating, [&inner, &outer], [true, false])
                .unwrap();
            let gamma = geometry.gamma(nominal);
            let limits = Ring::BOTH
                .map(|ring| fatigue_limit_of_contact(&geometry, Material::STEEL, ring, nominal));
            let found = [
                gamma,
                ball_rating_factor(gamma).unwrap(),
                rating,
                life.rating[0],
                life.rating[1],
                life.equivalent[0],
                life.equivalent[1],
                life.life * 1e-6,
                life.equivalent_load,
                limits[0],
                limits[1],
                fatigue_limit(&geometry, Material::STEEL, nominal),
            ];
            for (k, number) in found.iter().enumerate() {
                // Loads there are in balance to 1e-6 of the radial load, and lives are proportional to their inverse cube.
                let accuracy = if k == 7 { 3e-5 } else { 1e-5 };
                assert_relative_eq!(*number, v(4 + k), max_relative = accuracy);
            }
        }
    }

    #[test]
    fn no_load_no_life() {
        let geometry = crate::bearing::geometry::BallGeometry {
            ball_diameter: 9.525e-3,
            pitch_diameter: 46e-3,
            number: 9,
            groove: [0.52, 0.52],
            play: Play::Clearance(0.0),
        };
        let none = [0.0; 9];
        assert!(reference_life(&geometry, 0.0, 2e4, [&none, &none], [true, false]).is_err());
        near(equivalent_element_load(&[500.0; 9], true), 500.0, 1e-12);
    }
}
