//! Rolling resistance after Biboulet and Houpert.
//!
//! ```text
//!   line:     T/(E'R) = (2U)^¾ 1.4√M/[1 + (1.4√M/1.45)^10]^0.1                                        M 0.2 to 200
//!   ellipse:  T/(E'R²) = (2b/R)(2U)^¾ [(0.77 β^(−1/3) κ^0.12 (2U)^(−1/12) − 1.8 β^(−1/4))/(1 + M/6.6) + 1.8 β^(−1/4)]
//!             β = 4E(1 − κ²)/[π(1 + R/R_s)],  κ = a/b ≤ 1,  M = β^¼ κ W (2U)^(−3/4)                    M 0.2 to 800, κ from 1/60
//! ```
//! T is the force of the rolling film on each surface, ½∫h ∂p/∂x, per length of a line. Under heavy loads it depends neither on the load nor
//! on the pressure-viscosity coefficient. R and a are along the motion, R_s and b across it, E is the complete elliptic integral of the
//! parameter 1 − κ². β goes from 1 (circle) to 4/π (long ellipse across the motion).
//!
//! Source: Proc. IMechE J 224 (2010): of lines Biboulet and Houpert 2010, part 1, eq. 42; of ellipses Biboulet and Houpert 2010, part 2, eqs. 14, 32 and 41.
//! Constants read in stored texts of both. They treat ellipses as wide as a circle or wider, with the motion along the short axis.

use std::f64::consts::PI;

use ellip::ellipe;

use crate::contact::{Contact, Family, Groups, Hertz};

/// Where the formulas come from.
pub const SOURCE: &str =
    "Biboulet and Houpert 2010, Proc. IMechE J 224, parts 1 (eq. 42) and 2 (eq. 32)";

/// Loads of the formulas, M.
const LINE: std::ops::RangeInclusive<f64> = 0.2..=200.0;
const ELLIPSE: std::ops::RangeInclusive<f64> = 0.2..=800.0;

/// Smallest ratio of the axes, along the motion over across it.
const NARROWEST: f64 = 1.0 / 60.0;

/// Angle between the motion and an axis, rad, that is none.
const ALONG: f64 = 1e-6;

/// Rolling resistance T of each surface, N (N/m of a line), for the reduced modulus E' in Pa; `None` beyond the reach of the formulas.
pub fn rolling_resistance(
    contact: &Contact,
    hertz: &Hertz,
    groups: &Groups,
    reduced_modulus: f64,
) -> Option<f64> {
    let [radius, across] = contact.radii_along_and_across();
    let speed = 2.0 * groups.speed;
    match contact.kind.family() {
        Family::Cylinder if contact.kind.is_line() && LINE.contains(&groups.moes_load) => {
            let rigid = 1.4 * groups.moes_load.sqrt();
            let law = rigid / (1.0 + (rigid / 1.45).powi(10)).powf(0.1);
            Some(law * speed.powf(0.75) * reduced_modulus * radius)
        }
        Family::Point => {
            let axes = [
                hertz.half_width,
                hertz.half_width_y.unwrap_or(hertz.half_width),
            ];
            let [a, b] = match contact.entrainment_angle.rem_euclid(PI) {
                t if t.min(PI - t) < ALONG => axes,
                t if (t - 0.5 * PI).abs() < ALONG => [axes[1], axes[0]],
                _ => return None,
            };
            // Equal radii, up to rounding, are a circle.
            let kappa = if a > b * (1.0 + 1e-9) {
                return None;
            } else {
                (a / b).min(1.0)
            };
            let integral = ellipe(1.0 - kappa * kappa).ok()?;
            let beta = 4.0 * integral / (PI * (1.0 + radius / across));
            let m = beta.powf(0.25) * kappa * groups.moes_load;
            if !(ELLIPSE.contains(&m) && kappa >= NARROWEST) {
                return None;
            }
            let elastic = 1.8 * beta.powf(-0.25);
            let rigid = 0.77 * beta.powf(-1.0 / 3.0) * kappa.powf(0.12) * speed.powf(-1.0 / 12.0);
            let law = (rigid - elastic) / (1.0 + m / 6.6) + elastic;
            Some(law * 2.0 * b / radius * speed.powf(0.75) * reduced_modulus * radius * radius)
        }
        Family::Cylinder => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn of(contact: &Contact, speed: f64) -> (Option<f64>, Groups) {
        let modulus = 230.769_230_769e9;
        let groups = Groups::new(contact, modulus, 0.04, speed, 22e-9);
        let hertz = Hertz::new(contact, modulus);
        (
            rolling_resistance(contact, &hertz, &groups, modulus),
            groups,
        )
    }

    /// Evaluated in Python from the formulas of the papers, written by U = 2μu/(E'R), M and T* = T/(E'R) W^(−3/2) there.
    #[test]
    fn values() {
        let (line, groups) = of(&Contact::line(0.01, 1e5), 2.0);
        assert_relative_eq!(groups.moes_load, 5.204_165, max_relative = 1e-6);
        assert_relative_eq!(line.unwrap(), 80.396_346, max_relative = 1e-5);
        let (light, _) = of(&Contact::line(0.01, 6e3), 2.0);
        assert_relative_eq!(light.unwrap(), 43.368_359, max_relative = 1e-5);
        let (circle, groups) = of(&Contact::circular(0.016, 100.0), 0.8);
        assert_relative_eq!(groups.moes_load, 199.3, max_relative = 1e-3);
        assert_relative_eq!(circle.unwrap(), 0.026_522_453, max_relative = 1e-5);
        // With E, F and κ of eqs. 41 to 43: κ 0.255982, β 1.216739, M 96.9737.
        let (ellipse, _) = of(&Contact::elliptical([0.01, 0.08], 200.0, 0.0), 2.0);
        assert_relative_eq!(ellipse.unwrap(), 0.129_726_720, max_relative = 1e-6);
    }

    /// Beyond their reach there are none, nor for slender ellipses and skewed motions.
    #[test]
    fn reach() {
        assert_eq!(of(&Contact::circular(0.016, 1e5), 0.8).0, None);
        let ellipse = |radii, degrees: f64| {
            of(&Contact::elliptical(radii, 50.0, degrees.to_radians()), 0.8).0
        };
        assert!(ellipse([0.01, 0.02], 0.0).is_some());
        assert_eq!(ellipse([0.01, 0.02], 10.0), None);
        assert_eq!(ellipse([0.02, 0.01], 0.0), None);
        assert_eq!(ellipse([0.001, 10.0], 0.0), None);
        assert_relative_eq!(
            ellipse([0.01, 0.02], 0.0).unwrap(),
            ellipse([0.02, 0.01], 90.0).unwrap(),
            max_relative = 1e-9
        );
        assert_relative_eq!(
            ellipse([0.016, 0.016], 0.0).unwrap(),
            of(&Contact::circular(0.016, 50.0), 0.8).0.unwrap(),
            max_relative = 1e-9
        );
    }
}
