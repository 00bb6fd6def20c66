//! Rolling resistance after Biboulet and Houpert.
//!
//! ```text
//!   line:    T/(E'R) = (2U)^¾ 1.4√M/[1 + (1.4√M/1.45)^10]^0.1                             M 0.2 to 200
//!   circle:  T/(E'R²) = (2a/R)(2U)^¾ [(0.77 (2U)^(−1/12) − 1.8)/(1 + M/6.6) + 1.8]        M 0.2 to 800
//! ```
//! T is the force of the rolling film on each surface, ½∫h ∂p/∂x, per length of a line. Under heavy loads it depends neither on the load nor
//! on the pressure-viscosity coefficient.
//!
//! Source: Biboulet and Houpert, Proc. IMechE J 224 (2010), part 1 (line, eq. 42) and part 2 (elliptical, eq. 32, here with κ = β = 1).
//! Constants read in stored texts of both. The wide ellipses of part 2 are left out: how its β goes from 1 to 4/π was not seen.

use crate::contact::{Contact, ContactKind, Groups, Hertz};

/// Where the formulas come from.
pub const SOURCE: &str =
    "Biboulet and Houpert 2010, Proc. IMechE J 224, parts 1 (eq. 42) and 2 (eq. 32)";

/// Loads of the formulas, M.
const LINE: std::ops::RangeInclusive<f64> = 0.2..=200.0;
const CIRCULAR: std::ops::RangeInclusive<f64> = 0.2..=800.0;

/// Rolling resistance T of each surface, N (N/m of a line), for the reduced modulus E' in Pa; `None` beyond the reach of the formulas.
pub fn rolling_resistance(
    contact: &Contact,
    hertz: &Hertz,
    groups: &Groups,
    reduced_modulus: f64,
) -> Option<f64> {
    let (m, radius) = (groups.moes_load, contact.radius);
    let speed = (2.0 * groups.speed).powf(0.75);
    match contact.kind {
        ContactKind::Line if LINE.contains(&m) => {
            let rigid = 1.4 * m.sqrt();
            let law = rigid / (1.0 + (rigid / 1.45).powi(10)).powf(0.1);
            Some(law * speed * reduced_modulus * radius)
        }
        ContactKind::Circular if CIRCULAR.contains(&m) => {
            let rigid = 0.77 * (2.0 * groups.speed).powf(-1.0 / 12.0);
            let law = (rigid - 1.8) / (1.0 + m / 6.6) + 1.8;
            let width = 2.0 * hertz.half_width / radius;
            Some(law * width * speed * reduced_modulus * radius * radius)
        }
        ContactKind::Line
        | ContactKind::Circular
        | ContactKind::Elliptical
        | ContactKind::Roller => None,
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
    }

    /// Beyond their reach there are none.
    #[test]
    fn reach() {
        assert_eq!(of(&Contact::circular(0.016, 1e5), 0.8).0, None);
        assert_eq!(
            of(&Contact::elliptical([0.01, 0.02], 50.0, 0.0), 0.8).0,
            None
        );
    }
}
