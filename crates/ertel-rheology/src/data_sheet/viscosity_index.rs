//! The viscosity index.
//!
//! Theory: Viscosity index.

use super::index_table::{L_AND_H, row};

/// Viscosity index (ASTM D2270) from the kinematic viscosities `nu_40` and `nu_100` (m²/s) at 40 and 100 degC; `None`
/// below 2 mm²/s at 100 degC, where it is not defined.
///
/// ```text
/// VI = 100 (L - U)/(L - H)                                  up to 100
/// VI = 100 + (10^N - 1)/0.00715,   N = lg(H/U)/lg Y         above
/// ```
///
/// `U` and `Y` are the viscosities at 40 and 100 degC in mm²/s, `L` and `H` those at 40 degC of oils of index 0 and 100
/// with the same `Y`: by linear interpolation in the table of the standard, above 70 mm²/s by its equations
/// `L = 0.8353 Y² + 14.67 Y - 216` and `H = 0.1684 Y² + 11.85 Y - 97`.
pub fn viscosity_index(nu_40: f64, nu_100: f64) -> Option<f64> {
    let (u, y) = (nu_40 * 1e6, nu_100 * 1e6);
    let (l, h) = reference_oils(y)?;
    let index = 100.0 * (l - u) / (l - h);
    if index <= 100.0 {
        return Some(index);
    }
    let n = (h / u).log10() / y.log10();
    Some(100.0 + (10_f64.powf(n) - 1.0) / 0.007_15)
}

/// Kinematic viscosity (m²/s) at 100 degC of an oil with `nu_40` (m²/s) at 40 degC and the viscosity index `index`;
/// `None` if there is none between 2 mm²/s and `nu_40`.
pub fn viscosity_at_100(nu_40: f64, index: f64) -> Option<f64> {
    let (mut low, mut high) = (2e-6, nu_40);
    let reaches = |nu_100: f64| viscosity_index(nu_40, nu_100).is_some_and(|found| found >= index);
    if low >= high || reaches(low) || !reaches(high) {
        return None;
    }
    while high - low > 1e-12 * high {
        let middle = 0.5 * (low + high);
        if reaches(middle) {
            high = middle;
        } else {
            low = middle;
        }
        if middle == low && middle == high {
            break;
        }
    }
    Some(0.5 * (low + high))
}

/// Kinematic viscosity (m²/s) at 40 degC of an oil with `nu_100` (m²/s) at 100 degC and the viscosity index `index`, the equations of
/// [`viscosity_index`] solved for `U`; `None` below 2 mm²/s at 100 degC.
///
/// ```text
/// U = L - (L - H) VI/100                                       up to 100
/// U = H/Y^N,   N = lg[1 + 0.00715 (VI - 100)]                  above
/// ```
pub fn viscosity_at_40(nu_100: f64, index: f64) -> Option<f64> {
    let y = nu_100 * 1e6;
    let (l, h) = reference_oils(y)?;
    let u = if index <= 100.0 {
        l - (l - h) * index / 100.0
    } else {
        h / y.powf((1.0 + 0.007_15 * (index - 100.0)).log10())
    };
    (u > 0.0).then_some(1e-6 * u)
}

/// `L` and `H` (mm²/s) for `y` mm²/s at 100 degC.
fn reference_oils(y: f64) -> Option<(f64, f64)> {
    // Two degrees of rounding: 2 mm²/s may have come from m²/s.
    if y.is_nan() || y < 2.0 - 1e-9 {
        return None;
    }
    let [l, h] = &*L_AND_H;
    let last = l.len() - 1;
    if y > row(last) {
        return Some((
            (0.8353 * y + 14.67) * y - 216.0,
            (0.1684 * y + 11.85) * y - 97.0,
        ));
    }
    let i = (0..last).rfind(|i| row(*i) <= y).unwrap_or(0);
    let share = (y - row(i)) / (row(i + 1) - row(i));
    let between = |column: &[f64]| column[i] + share * (column[i + 1] - column[i]);
    Some((between(l), between(h)))
}

#[cfg(test)]
mod tests {
    use crate::near::near;
    use approx::assert_relative_eq;

    use super::*;

    /// The worked examples of the standard, with the reference oils it prints.
    #[test]
    fn examples_of_the_standard() {
        let (l, h) = reference_oils(8.86).unwrap();
        assert_eq!(
            (format!("{l:.2}"), format!("{h:.2}")),
            ("119.94".into(), "69.48".into())
        );
        let index = viscosity_index(73.30e-6, 8.86e-6).unwrap();
        assert_eq!(format!("{index:.2}"), "92.43");
        let (_, h) = reference_oils(5.05).unwrap();
        assert!((h - 28.97).abs() < 0.006, "{h}"); // 28.975, which the standard cuts
        let index = viscosity_index(22.83e-6, 5.05e-6).unwrap();
        // The standard rounds H and N first and prints 156.37.
        assert_relative_eq!(index, 156.37, max_relative = 5e-4);
    }

    #[test]
    fn the_table_meets_the_equations() {
        let [of_l, of_h] = &*L_AND_H;
        let last = of_l.len() - 1;
        assert_eq!(
            (row(0), row(180), row(230), row(last)),
            (2.0, 20.0, 30.0, 70.0)
        );
        let (l, h) = reference_oils(70.000001).unwrap();
        assert_relative_eq!(l, of_l[last], max_relative = 1e-3);
        assert_relative_eq!(h, of_h[last], max_relative = 1e-3);
        // Both columns grow, and smoothly: no entry is off its neighbours' line by more than 1 %.
        for column in [of_l, of_h] {
            for i in 1..last {
                let share = (row(i) - row(i - 1)) / (row(i + 1) - row(i - 1));
                let line = column[i - 1] + share * (column[i + 1] - column[i - 1]);
                assert!(column[i] > column[i - 1]);
                assert_relative_eq!(column[i], line, max_relative = 1e-2);
            }
        }
    }

    /// PAO 4 of 4 mm²/s and an index of 125: H = 19.56 mm²/s in the table, 1.17875^(lg 4) = 1.10409, 17.716 mm²/s by hand.
    #[test]
    fn an_oil_by_its_viscosity_at_100_and_its_index() {
        let nu_40 = viscosity_at_40(4e-6, 125.0).unwrap();
        assert_relative_eq!(nu_40, 17.716e-6, max_relative = 1e-4);
        for (nu_100, index) in [
            (8.86e-6, 92.43),
            (5.05e-6, 156.4),
            (20e-6, -50.0),
            (80e-6, 180.0),
        ] {
            let nu_40 = viscosity_at_40(nu_100, index).unwrap();
            near(viscosity_index(nu_40, nu_100).unwrap(), index, 1e-9);
        }
        assert_eq!(viscosity_at_40(1.5e-6, 100.0), None);
    }

    #[test]
    fn the_index_can_be_inverted() {
        for (nu_40, index) in [
            (46e-6, 95.0),
            (46e-6, 150.0),
            (460e-6, 30.0),
            (1000e-6, 240.0),
        ] {
            let nu_100 = viscosity_at_100(nu_40, index).unwrap();
            near(viscosity_index(nu_40, nu_100).unwrap(), index, 1e-6);
        }
        assert_eq!(viscosity_at_100(4e-6, 95.0), None);
        assert_eq!(viscosity_index(3.7e-6, 1.3e-6), None);
    }
}
