//! Fatigue load limits.

use ertel_ehl::contact::Ellipse;

use super::Error;
use crate::bearing::Material;
use crate::bearing::geometry::{BallGeometry, Ring};

/// Contact pressure up to which bearing steel of good quality does not tire, Pa (ISO 281:2007, annex B).
const PRESSURE: f64 = 1.5e9;
/// Pitch diameter from which the limit is reduced, m.
const LARGE: f64 = 0.1;

/// Load Q_u of a ball at the fatigue limit of its contact with a ring, N, at the contact angle (rad).
///
/// Q_u = σ_Hu³ (32πχ/3) [(1 − ν²)/E · E(χ)/Σρ]²: the load whose Hertz pressure is σ_Hu = 1500 MPa. Source: ISO 281:2007, annex B, eq. B.1.
pub fn fatigue_limit_of_contact(
    geometry: &BallGeometry,
    material: Material,
    ring: Ring,
    angle: f64,
) -> f64 {
    let ellipse = Ellipse::of_radii(geometry.radii(ring, angle));
    let [a, b] = ellipse.semi_axes(1.0, material.reduced_modulus);
    let unit = 1.5 / (std::f64::consts::PI * a * b);
    (PRESSURE / unit).powi(3)
}

fn reduction(kind: super::Kind, pitch_diameter: f64) -> f64 {
    let exponent = match kind {
        super::Kind::Ball => 0.5,
        super::Kind::Roller => 0.3,
    };
    (LARGE / pitch_diameter.max(LARGE)).powf(exponent)
}

/// Fatigue load limit C_u of a single-row ball bearing, N, at the nominal contact angle (rad).
///
/// C_u = 0.2288 Z Q_u cos α, times √(100 mm/d_m) of larger pitch diameters; Q_u the smaller one of both rings
///
/// Source: ISO 281:2007, annex B, eqs. B.9 to B.11.
pub fn fatigue_limit(geometry: &BallGeometry, material: Material, nominal_angle: f64) -> f64 {
    let [inner, outer] =
        Ring::BOTH.map(|ring| fatigue_limit_of_contact(geometry, material, ring, nominal_angle));
    let all = 0.2288 * geometry.number as f64 * inner.min(outer) * nominal_angle.cos();
    all * reduction(super::Kind::Ball, geometry.pitch_diameter)
}

/// The same by the simple method from the static rating C_0 (N): C_0/22 of balls, C_0/8.2 of rollers, those times (100 mm/d_m)^0.3 of larger pitch diameters; pitch
/// diameter in m.
///
/// Source: ISO 281:2007, annex B, eqs. B.18 to B.20.
///
/// # Errors
/// Numbers that are not positive.
pub fn simple_fatigue_limit(
    kind: super::Kind,
    static_rating: f64,
    pitch_diameter: f64,
) -> Result<f64, Error> {
    let divisor = match kind {
        super::Kind::Ball => 22.0,
        super::Kind::Roller => 8.2,
    };
    let rating = super::positive("static rating", static_rating)?;
    Ok(rating / divisor * reduction(kind, super::positive("pitch diameter", pitch_diameter)?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// By hand: 11 kN/22 = 500 N; at 400 mm half of it; rollers 8.2 kN/8.2 = 1 kN, at 400 mm 0.25^0.3 = 0.659754 of it.
    #[test]
    fn simple_by_hand() {
        let of = |kind, rating, pitch| simple_fatigue_limit(kind, rating, pitch).unwrap();
        assert_relative_eq!(of(super::super::Kind::Ball, 11e3, 0.05), 500.0);
        assert_relative_eq!(of(super::super::Kind::Ball, 11e3, 0.4), 250.0);
        assert_relative_eq!(of(super::super::Kind::Roller, 8.2e3, 0.05), 1000.0);
        let large = of(super::super::Kind::Roller, 8.2e3, 0.4);
        assert_relative_eq!(large, 659.754, max_relative = 1e-6);
    }

    /// Large cylindrical roller bearings of a catalogue: d and D, mm, C_0 and P_u, kN (SKF, General catalogue, 2006: NU 1030 ML, NU 1040 MA, NU 1052 MA, NU 2340
    /// ECMA).
    #[test]
    fn large_rollers_of_a_catalogue() {
        for [bore, outside, rating, limit] in [
            [150.0, 225.0, 275.0, 30.0],
            [200.0, 310.0, 570.0, 58.5],
            [260.0, 400.0, 965.0, 96.5],
            [200.0, 420.0, 2800.0, 255.0],
        ] {
            let pitch = 0.5e-3 * (bore + outside);
            let found = simple_fatigue_limit(super::super::Kind::Roller, rating, pitch).unwrap();
            assert_relative_eq!(found, limit, max_relative = 0.16);
        }
    }
}
