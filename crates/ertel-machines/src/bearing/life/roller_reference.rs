//! Reference rating life of roller bearings from the loads of all slices of all rollers.

use super::reference::ReferenceLife;
use super::roller_rating::{RollerRow, UNEVEN, rings};
use super::{Error, ROLLER_EXPONENT, positive};
use crate::bearing::geometry::Ring;

/// Exponents of the equivalent load of a slice: on the ring that turns against the load, and on the other one.
const TURNING: f64 = 4.0;
const RESTING: f64 = 4.5;

/// Factor on the load of slice k of n for the pressure that rises at the ends of the contact, k from 0.
///
/// f = 1 − 0.01/ln(1.985 |2k + 1 − n|/(2n − 2));  1 in the middle
///
/// It applies to rollers with the reference profile under medium loads whose rings tilt by less than 4 minutes of arc. Source: ISO/TS 16281:2008,
/// eq. 60.
pub fn stress_riser(k: usize, n: usize) -> f64 {
    let place = (2.0 * k as f64 + 1.0 - n as f64).abs() / (2.0 * n as f64 - 2.0);
    match place > 0.0 {
        true => 1.0 - 0.01 / (1.985 * place).ln(),
        false => 1.0,
    }
}

/// Basic reference rating life of a single-row roller bearing with the rating C_r (N) under the loads of all slices (N) of all rollers on inner and
/// outer ring; `turning` says of each ring whether it turns against the load.
///
/// ```text
///   Q_ci = C_r/(0.378 λν Z cos α) {1 + [1.038 ((1 − γ)/(1 + γ))^(143/108)]^(9/2)}^(2/9),   λν = 0.83
///   Q_ce = C_r/(0.364 λν Z cos α) {1 + [1.038 ((1 − γ)/(1 + γ))^(143/108)]^(−9/2)}^(2/9)
///   q_c = Q_c n^(−7/9),   q_e,k = (1/Z Σ_j (f_k q_jk)^p)^(1/p),   p = 4 of the ring that turns against the load, 9/2 of the other one
///   L_10r = {Σ_k [(q_ci/q_ei)^(−9/2) + (q_ce/q_ee)^(−9/2)]}^(−8/9)   million revolutions,   P_ref = C_r/L_10r^(3/10)
/// ```
/// In the result, loads of a roller are those of all its slices as (Σ_k q_k^(9/2) n^(7/2))^(2/9). Source: ISO/TS 16281:2008, sections 5.3.1 to 5.3.5, as
/// public implementations quote it.
///
/// # Errors
/// No loads, or a rating that is not positive.
pub fn roller_reference_life(
    row: &RollerRow,
    dynamic_rating: f64,
    loads: [&[Vec<f64>]; 2],
    turning: [bool; 2],
) -> Result<ReferenceLife, Error> {
    let rating = positive("rating", dynamic_rating)?;
    let base = 1.038 * rings(row.gamma());
    let each = rating / (UNEVEN * row.number as f64 * row.angle.cos());
    let both = |sign: f64| (1.0 + base.powf(sign * RESTING)).powf(2.0 / 9.0);
    let rating_of = [each / 0.378 * both(1.0), each / 0.364 * both(-1.0)];
    let equivalent = Ring::BOTH.map(|ring| {
        let p = if turning[ring.index()] {
            TURNING
        } else {
            RESTING
        };
        of_slices(loads[ring.index()], p)
    });
    positive(
        "equivalent load of a roller",
        equivalent[0].max(equivalent[1]),
    )?;
    let sum: f64 = [0, 1]
        .map(|k| (equivalent[k] / rating_of[k]).powf(RESTING))
        .iter()
        .sum();
    let life = sum.powf(-8.0 / 9.0);
    Ok(ReferenceLife {
        rating: rating_of,
        equivalent,
        life: 1e6 * life,
        equivalent_load: rating / life.powf(ROLLER_EXPONENT.recip()),
    })
}

/// The equivalent load of all slices of all rollers, N: q_c,k = Q_c n^(−7/9) turns Σ_k (q_c/q_e,k)^(−9/2) into (Q_c/Q_e)^(−9/2).
fn of_slices(rollers: &[Vec<f64>], p: f64) -> f64 {
    let n = rollers.first().map_or(0, Vec::len);
    let sum: f64 = (0..n)
        .map(|k| {
            let f = stress_riser(k, n);
            let powers = rollers.iter().map(|slices| (f * slices[k]).powf(p));
            (powers.sum::<f64>() / rollers.len() as f64).powf(RESTING / p)
        })
        .sum();
    (sum * (n as f64).powf(3.5)).powf(RESTING.recip())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bearing::geometry::{RollerGeometry, RollerProfile};
    use crate::bearing::kinematics::Speeds;
    use crate::bearing::life::roller_rating;
    use crate::bearing::load::{Given, Loads, Params};
    use crate::bearing::{Bearing, Geometry};
    use crate::near::near;
    use approx::assert_relative_eq;

    const ROW: RollerRow = RollerRow {
        diameter: 10e-3,
        length: 10e-3,
        pitch_diameter: 50e-3,
        number: 3,
        angle: 0.0,
    };

    /// Ends carry 2.33 times as much by −0.01/ln 0.9925 = 1.3283; a quarter of the length from the middle 1 + 0.01/0.7006 = 1.01427.
    #[test]
    fn ends_of_a_roller() {
        assert_relative_eq!(stress_riser(0, 41), 2.3283, max_relative = 1e-4);
        assert_relative_eq!(stress_riser(40, 41), 2.3283, max_relative = 1e-4);
        assert_relative_eq!(stress_riser(30, 41), 1.014_27, max_relative = 1e-4);
        assert_eq!(stress_riser(20, 41), 1.0);
    }

    /// One slice of every roller in the middle bears all, 1000 N of 41 slices: q_e = 1000 N on both rings, so that with q_c = Q_c 41^(−7/9) by hand, γ =
    /// 0.2, base 1.038 · 0.58457 = 0.60678: Q_ci = 50 kN/(0.378 · 0.83 · 3) · 1.10558^(2/9) = 53122 · 1.02256 = 54321 N, Q_ce = 50 kN/(0.364 · 0.83 · 3) ·
    /// (1 + 9.4714)^(2/9) = 55166 · 1.68519 = 92965 N; 41^(−7/9) = 0.055681: q_ci = 3024.6 N, q_ce = 5176.4 N; L = (3.0246^(−4.5) + 5.1764^(−4.5))^(−8/9) =
    /// (0.0068704 + 0.00061219)^(−8/9) = 77.66.
    #[test]
    fn one_slice_by_hand() {
        let mut slices = vec![0.0; 41];
        slices[20] = 1000.0;
        let rollers = vec![slices; 3];
        let found = roller_reference_life(&ROW, 50e3, [&rollers, &rollers], [true, false]).unwrap();
        assert_relative_eq!(found.rating[0], 54_321.0, max_relative = 1e-3);
        assert_relative_eq!(found.rating[1], 92_965.0, max_relative = 1e-3);
        assert_relative_eq!(found.life * 1e-6, 77.66, max_relative = 3e-3);
        near(found.equivalent_load, 50e3 / 77.66_f64.powf(0.3), 1e-3);
        let none = vec![vec![0.0; 41]; 3];
        assert!(roller_reference_life(&ROW, 50e3, [&none, &none], [true, false]).is_err());
    }

    /// Rollers with the reference profile without clearance and tilt live about as long as the rating says, which is what λν and the factor at the ends are
    /// for: 10⁶ (C_r/F_r)⁴ with the exponent 4 of line contacts, which the slices have, while ISO 281 takes 10/3. Tilted ones, and ones that bear on one
    /// end, live shorter.
    #[test]
    fn reference_life_against_the_basic_life() {
        let geometry = RollerGeometry {
            roller_diameter: 9e-3,
            length: 10e-3,
            pitch_diameter: 46.5e-3,
            number: 13,
            clearance: 0.0,
            profile: RollerProfile::Logarithmic,
        };
        let row = RollerRow::from(&geometry);
        let rating = roller_rating(&row).unwrap();
        let life = |tilt: f64| {
            let loads = Loads {
                tilt: [Given::Shift(0.0), Given::Shift(tilt)],
                ..Loads::forces(0.12 * rating, 0.0)
            };
            let found = Bearing::steel(Geometry::CylindricalRoller(geometry))
                .solve(&loads, Speeds::default(), &Params::default())
                .unwrap();
            let [inner, outer] = Ring::BOTH.map(|ring| found.slice_loads(ring));
            let found = roller_reference_life(&row, rating, [&inner, &outer], [true, false]);
            found.unwrap()
        };
        let straight = life(0.0);
        let ratio = (straight.life * 1e-6).powf(-0.25) / 0.12;
        assert!((0.9..1.15).contains(&ratio), "{ratio}");
        assert!(life(1e-3).life < 0.95 * straight.life);
        assert!(life(3e-3).life < 0.5 * straight.life);
    }
}
