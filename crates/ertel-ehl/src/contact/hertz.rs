//! Hertz theory of the dry contact.

use std::f64::consts::PI;

use serde::Serialize;

use super::ellipse::Ellipse;
use super::{Contact, ContactKind, Family};

/// Dry contact after Hertz (1881).
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Hertz {
    /// Radius of the contact circle, half-width of the line contact, or semi-axis of the ellipse along x, a, m.
    pub half_width: f64,
    /// Semi-axis of the ellipse along y, m.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub half_width_y: Option<f64>,
    /// Largest pressure p_h, Pa.
    pub pressure: f64,
}

impl Hertz {
    /// Hertz contact for the reduced modulus E' in Pa (2/E' = Σ (1−ν²)/E).
    ///
    /// Circular: a³ = 3FR/(2E'), p_h = 3F/(2πa²) (Habchi 2008, eqs. 2.25, 2.26, corrected).
    /// Line: a² = 8wR/(πE'), p_h = 2w/(πa) (Johnson 1985, eqs. 4.43, 4.45).
    /// Roller: the line contact under the mean load per length w = F/l.
    /// Elliptical: a_l³ = 6κ²E(m)FR/(πE'), p_h = 3F/(2π a_l a_s) (Johnson 1985, eqs. 4.25 to 4.28).
    pub fn new(contact: &Contact, reduced_modulus: f64) -> Hertz {
        let (radius, load) = (contact.radius, contact.line_load());
        match contact.kind {
            ContactKind::Circular => {
                let half_width = (1.5 * load * radius / reduced_modulus).cbrt();
                Hertz {
                    half_width,
                    half_width_y: None,
                    pressure: 1.5 * load / (PI * half_width * half_width),
                }
            }
            ContactKind::Line | ContactKind::Roller => {
                let half_width = (8.0 * load * radius / (PI * reduced_modulus)).sqrt();
                Hertz {
                    half_width,
                    half_width_y: None,
                    pressure: 2.0 * load / (PI * half_width),
                }
            }
            ContactKind::Elliptical => {
                let [half_width, along_y] =
                    Ellipse::of_radii([radius, contact.radius_y]).semi_axes(load, reduced_modulus);
                Hertz {
                    half_width,
                    half_width_y: Some(along_y),
                    pressure: 1.5 * load / (PI * half_width * along_y),
                }
            }
        }
    }

    /// Area of the dry contact: m², of line contacts per length, m.
    pub fn area(&self, contact: &Contact) -> f64 {
        let a = self.half_width;
        match contact.kind.family() {
            Family::Point => PI * a * self.half_width_y.unwrap_or(a),
            Family::Cylinder => 2.0 * a * contact.roller.as_ref().map_or(1.0, |r| r.length),
        }
    }

    /// Load under which a contact has the given Hertz pressure (Pa), of rollers that of the line contact: N, or N/m for a line. The load of `contact` is not used.
    pub fn load_for_pressure(contact: &Contact, reduced_modulus: f64, pressure: f64) -> f64 {
        let radius = contact.radius;
        match contact.kind {
            // p_h = E' a/(π R)
            ContactKind::Circular => {
                let a = PI * radius * pressure / reduced_modulus;
                2.0 / 3.0 * PI * a * a * pressure
            }
            // p_h = E' a/(4 R)
            ContactKind::Line | ContactKind::Roller => {
                let a = 4.0 * radius * pressure / reduced_modulus;
                0.5 * PI * a * pressure * contact.roller.as_ref().map_or(1.0, |r| r.length)
            }
            // p_h grows with the cube root of the load.
            ContactKind::Elliptical => {
                let unit = Contact {
                    load: 1.0,
                    ..contact.clone()
                };
                (pressure / Hertz::new(&unit, reduced_modulus).pressure).powi(3)
            }
        }
    }
}

/// Dimensionless integral of P over the whole contact: 2π/3 (circular; elliptical in units of both semi-axes), π/2 (line;
/// rollers per length).
pub fn load_integral(family: Family) -> f64 {
    match family {
        Family::Point => 2.0 * PI / 3.0,
        Family::Cylinder => 0.5 * PI,
    }
}

/// Dimensionless deflection δR/a² of both bodies under the Hertz pressure at radius r (in a).
///
/// Circular (Johnson 1985, eqs. 3.41a, 3.42a): δ = 1 − r²/2 inside,
/// δ = [(2 − r²) asin(1/r) + √(r² − 1)]/π outside; zero at infinity.
///
/// Line: relative to the centre, since the plane displacement has no far-field limit:
/// δ = −r²/2 inside, δ = −r²/2 + [r√(r²−1) − ln(r + √(r²−1))]/2 outside.
///
/// Elliptical: that of the circle, which it resembles; rollers: that of the line.
pub fn deflection_profile(family: Family, r: f64) -> f64 {
    let r = r.abs();
    match family {
        Family::Point if r <= 1.0 => 1.0 - 0.5 * r * r,
        Family::Point => ((2.0 - r * r) * (1.0 / r).asin() + (r * r - 1.0).sqrt()) / PI,
        Family::Cylinder if r <= 1.0 => -0.5 * r * r,
        Family::Cylinder => {
            let s = (r * r - 1.0).sqrt();
            -0.5 * r * r + 0.5 * (r * s - (r + s).ln())
        }
    }
}

/// Gap of a dry contact, in a²/R, at the distance `r` > 1 in half-widths.
pub fn dry_gap(family: Family, r: f64) -> f64 {
    0.5 * r * r + deflection_profile(family, r) - deflection_profile(family, 1.0) - 0.5
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Main case: F = 100 N, R = 16 mm, steel on steel; figures of `formula_vectors` computed
    /// by an independent script: a = 218.279 µm, p_h = 1.00212 GPa, E' = 230.769 GPa.
    #[test]
    fn circular_steel_contact() {
        let contact = Contact::circular(0.016, 100.0);
        let hertz = Hertz::new(&contact, 230.769e9);
        assert_relative_eq!(hertz.half_width, 218.279e-6, max_relative = 1e-5);
        assert_relative_eq!(hertz.pressure, 1.00212e9, max_relative = 1e-5);
    }

    #[test]
    fn load_for_pressure_inverts_hertz() {
        for mut contact in [Contact::line(0.01, 1.0), Contact::circular(0.01, 1.0)] {
            contact.load = Hertz::load_for_pressure(&contact, 2.2e11, 7e8);
            let hertz = Hertz::new(&contact, 2.2e11);
            assert_relative_eq!(hertz.pressure, 7e8, max_relative = 1e-12);
        }
    }

    /// Line contact, Johnson 1985, eqs. 4.43 to 4.45, with E* = E'/2: p_h² = w E*/(π R).
    #[test]
    fn line_contact_pressure() {
        let contact = Contact::line(0.015, 2.0e5);
        let hertz = Hertz::new(&contact, 2.3e11);
        assert_relative_eq!(
            hertz.pressure.powi(2),
            2.0e5 * 1.15e11 / (PI * 0.015),
            max_relative = 1e-12
        );
    }

    /// The gap of a dry contact closes at r = 1 with continuous deflection and slope.
    #[test]
    fn deflection_is_smooth_at_the_edge_and_decays() {
        for kind in [Family::Cylinder, Family::Point] {
            let (i, o) = (
                deflection_profile(kind, 1.0 - 1e-9),
                deflection_profile(kind, 1.0 + 1e-9),
            );
            assert_relative_eq!(i, o, epsilon = 1e-7);
        }
        // A point load's field far away: δ → F/(πE*r), dimensionless 2/(3 r)·(2/π)
        let far = deflection_profile(Family::Point, 1e3);
        assert_relative_eq!(far, 4.0 / (3.0 * PI * 1e3), max_relative = 1e-5);
    }
}
