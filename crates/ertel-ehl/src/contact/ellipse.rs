//! The Hertz ellipse of bodies with two radii of curvature.

use std::f64::consts::PI;

use ellip::{ellipe, elliprd};

/// Shape of the contact ellipse, which depends on the radii alone.
///
/// ```text
///   R_l/R_s = [κ²E(m) − K(m)]/[K(m) − E(m)] = B(m)/[(1 − m) D(m)],   κ = a_l/a_s,  m = 1 − 1/κ²
///   a_l³ = 6κ²E(m) F R/(πE'),   1/R = 1/R_x + 1/R_y,   p_h = 3F/(2π a_l a_s),   δ = 3F K(m)/(π a_l E')
/// ```
/// l and s: along the larger and the smaller radius. D = (K − E)/m and B = K − D lose no digits near circles.
///
/// Source: Johnson 1985, eqs. 4.25 to 4.28; D = R_D(0, 1 − m, 1)/3: DLMF 19.25.1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipse {
    radii: [f64; 2],
    /// κ ≥ 1.
    axis_ratio: f64,
}

/// B(m) and D(m) with 1 − m given.
fn integrals(one_less_m: f64) -> [f64; 2] {
    // R_D is homogeneous of degree −3/2 and finite for 1 − m > 0.
    let d = elliprd(0.0, one_less_m, 1.0).expect("a parameter between 0 and 1") / 3.0;
    // E = K − mD and K = E + mD: B = E − (1 − m) D.
    let e = ellipe(1.0 - one_less_m).expect("a parameter between 0 and 1");
    [e - one_less_m * d, d]
}

/// Largest ln κ: no radii in double precision give more.
const LARGEST: f64 = 20.0;

impl Ellipse {
    /// Of reduced radii along x and y, both positive.
    pub fn of_radii(radii: [f64; 2]) -> Ellipse {
        let ratio = (radii[0] / radii[1]).max(radii[1] / radii[0]);
        let of_axes = |t: f64| {
            let one_less_m = (-2.0 * t).exp();
            let [b, d] = integrals(one_less_m);
            b / (one_less_m * d)
        };
        let (mut low, mut high) = (0.0, LARGEST);
        // The ratio of the radii rises with that of the axes.
        while ratio > 1.0 && high - low > 1e-15 * high {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            match of_axes(middle) < ratio {
                true => low = middle,
                false => high = middle,
            }
        }
        Ellipse {
            radii,
            axis_ratio: if ratio > 1.0 { low.exp() } else { 1.0 },
        }
    }

    /// Semi-axes along x and y, m, under a load (N) for the reduced modulus E' (Pa).
    pub fn semi_axes(&self, load: f64, reduced_modulus: f64) -> [f64; 2] {
        let [x, y] = self.radii;
        let kappa = self.axis_ratio;
        let e = ellipe(1.0 - 1.0 / (kappa * kappa)).expect("a parameter between 0 and 1");
        let radius = 1.0 / (1.0 / x + 1.0 / y);
        let long = (6.0 * kappa * kappa * e * load * radius / (PI * reduced_modulus)).cbrt();
        match x > y {
            true => [long, long / kappa],
            false => [long / kappa, long],
        }
    }

    /// Approach of the bodies under a load (N) for the reduced modulus E' (Pa), δ, m.
    pub fn approach(&self, load: f64, reduced_modulus: f64) -> f64 {
        let [x, y] = self.semi_axes(load, reduced_modulus);
        let one_less_m = self.axis_ratio.powi(-2);
        let [b, d] = integrals(one_less_m);
        3.0 * load * (b + d) / (PI * x.max(y) * reduced_modulus)
    }
}

/// Dimensionless Hertz pressure P(r) = √(1 − r²) inside r < 1, zero outside; r in half-widths.
pub fn pressure_profile(r: f64) -> f64 {
    (1.0 - r * r).max(0.0).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::near::near;
    use approx::assert_relative_eq;

    /// Ratios of radii and axes, and E, by arithmetic-geometric means and bisection in 40-digit arithmetic.
    #[test]
    fn axis_ratios() {
        for (radii, axes, e) in [
            (1.25, 1.160_357_497_699_02, 1.464_271_786_857_42),
            (2.0, 1.585_802_119_702_55, 1.297_152_156_388_73),
            (10.0, 4.499_447_303_155_42, 1.059_884_343_939_35),
            (1000.0, 67.872_474_777_969_3, 1.000_554_010_797_11),
        ] {
            for pair in [[1.0, radii], [radii, 1.0]] {
                let found = Ellipse::of_radii(pair).axis_ratio;
                assert_relative_eq!(found, axes, max_relative = 1e-12);
            }
            near(ellipe(1.0 - 1.0 / (axes * axes)).unwrap(), e, 1e-12);
        }
    }

    /// Equal radii give the circle, nearly equal ones nearly so: d ln κ/d ln ratio = 2/3 there (B/D = 1 − m/4,
    /// and 1/(1 − m) = 1 + m, where m = 2 ln κ to first order).
    #[test]
    fn circles_are_ellipses() {
        let (r, f, e) = (0.016, 100.0, 230.769e9);
        let [a, b] = Ellipse::of_radii([r, r]).semi_axes(f, e);
        assert_relative_eq!(a, (1.5 * f * r / e).cbrt(), max_relative = 1e-14);
        assert_relative_eq!(a, b, max_relative = 1e-15);
        let kappa = Ellipse::of_radii([1.0, 1.0 + 1e-6]).axis_ratio;
        assert_relative_eq!(kappa - 1.0, 2.0 / 3.0 * 1e-6, max_relative = 1e-4);
    }

    /// Of circles δ = a²/R, and δ grows with F^(2/3).
    #[test]
    fn approach() {
        let (r, f, e) = (0.016, 100.0, 230.769e9);
        let circle = Ellipse::of_radii([r, r]);
        let [a, _] = circle.semi_axes(f, e);
        assert_relative_eq!(circle.approach(f, e), a * a / r, max_relative = 1e-12);
        let twenty_one = Ellipse::of_radii([r, 21.0 * r]);
        // δ ∝ F^(2/3)
        assert_relative_eq!(
            twenty_one.approach(8.0 * f, e),
            4.0 * twenty_one.approach(f, e),
            max_relative = 1e-12
        );
    }

    /// Axes of twenty ellipses from long to wide, against data/hertz_ellipse.csv.
    #[test]
    fn ellipses_of_the_closed_form() {
        let (load, modulus) = (100.0, 230.769e9);
        let rows = include_str!("data/hertz_ellipse.csv").lines();
        let rows: Vec<[f64; 4]> = rows
            .filter(|row| !row.starts_with(['#', 'r']))
            .map(|row| {
                let numbers: Vec<f64> = row.split(',').map(|v| v.parse().unwrap()).collect();
                numbers.try_into().unwrap()
            })
            .collect();
        assert_eq!(rows.len(), 20);
        for [radii, axes, e, k] in rows {
            let ratio = axes * axes;
            let small = 0.016;
            let radius = small * radii / (1.0 + radii);
            let long = (6.0 * ratio * e * load * radius / (PI * modulus)).cbrt();
            let found = Ellipse::of_radii([small, small * radii]).semi_axes(load, modulus);
            assert_relative_eq!(found[0], long / axes, max_relative = 1e-6);
            assert_relative_eq!(found[1], long, max_relative = 1e-6);
            let wide = Ellipse::of_radii([small * radii, small]).semi_axes(load, modulus);
            assert_relative_eq!(wide[0], long, max_relative = 1e-6);
            assert_relative_eq!(wide[1], long / axes, max_relative = 1e-6);
            // B and D of the row itself: E = B + (1 − m) D, K = B + D.
            let [b, d] = integrals(1.0 / ratio);
            assert_relative_eq!(b + d / ratio, e, max_relative = 1e-6);
            assert_relative_eq!(b + d, k, max_relative = 1e-6);
            let approach = 3.0 * load * k / (PI * long * modulus);
            let found = Ellipse::of_radii([small, small * radii]).approach(load, modulus);
            assert_relative_eq!(found, approach, max_relative = 2e-6);
        }
    }
}
