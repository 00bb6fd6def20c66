//! Splines near tables with errors.

use std::f64::consts::TAU;

use super::super::CamError;
use super::super::error::in_range;
use super::spline::{DEGREE, PeriodicSpline};

/// Halvings of the logarithm of the weight.
const HALVINGS: usize = 60;

/// The spline with the smallest ∫ s'''² of those whose values differ from a table by the root mean square of a tolerance.
///
/// Its coefficients minimise Σ_i (s(t_i) − y_i)² + λ ∫ s'''² dt, with the weight λ at which the difference is the tolerance: it grows with λ, from 0 to that of the mean.
/// Source: Reinsch, Numerische Mathematik 10, 1967, 177–183 (of s''; here s''', as forces follow s'').
pub(super) fn smooth(
    places: &[f64],
    values: &[f64],
    period: f64,
    tolerance: f64,
) -> Result<PeriodicSpline, CamError> {
    let fit = Fit::new(places, values, period)?;
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
    let spread = (squares / values.len() as f64).sqrt();
    let requirement = "below the spread of the lifts";
    in_range(
        "tolerance of the lifts",
        tolerance,
        tolerance < spread,
        requirement,
    )?;
    // From far below the weight that damps waves of two rows to far above that which damps waves of a period, (period/2π)⁶/step.
    let step = period / values.len() as f64;
    let (mut low, mut high) = (1e-6 * step.powi(5), 1e3 * (period / TAU).powi(6) / step);
    let mut best = fit.coefficients(low)?;
    for _ in 0..HALVINGS {
        let weight = (low * high).sqrt();
        match fit.coefficients(weight) {
            Ok(found) if fit.difference(&found) <= tolerance => (low, best) = (weight, found),
            // Weights at which the penalty drowns the table in rounding are too large as well.
            _ => high = weight,
        }
    }
    Ok(fit.spline.with(best))
}

/// A table and the quadratic form of its fit.
struct Fit<'a> {
    spline: PeriodicSpline,
    values: &'a [f64],
    /// B-splines at each row.
    rows: Vec<[f64; DEGREE + 1]>,
    /// ∫ B_j''' B_l''' dt over each interval.
    penalties: Vec<[[f64; DEGREE + 1]; DEGREE + 1]>,
}

impl<'a> Fit<'a> {
    fn new(places: &[f64], values: &'a [f64], period: f64) -> Result<Fit<'a>, CamError> {
        let spline = PeriodicSpline::unset(places, values, period)?;
        let rows = (0..places.len())
            .map(|row| spline.basis(row, places[row]))
            .collect();
        let penalties = (0..places.len())
            .map(|interval| interval_penalty(&spline, interval))
            .collect();
        Ok(Fit {
            spline,
            values,
            rows,
            penalties,
        })
    }

    /// Coefficients of the weight λ: (Bᵀ B + λ P) c = Bᵀ y.
    fn coefficients(&self, weight: f64) -> Result<Vec<f64>, CamError> {
        let n = self.values.len();
        let mut matrix = Skyline::cyclic(n, DEGREE);
        let mut right = vec![0.0; n];
        for interval in 0..n {
            let (row, penalty) = (&self.rows[interval], &self.penalties[interval]);
            for k in 0..=DEGREE {
                let j = self.spline.column(interval, k);
                right[j] += row[k] * self.values[interval];
                for l in 0..=DEGREE {
                    let column = self.spline.column(interval, l);
                    matrix.add(j, column, row[k] * row[l] + weight * penalty[k][l]);
                }
            }
        }
        matrix.solve(right).ok_or(CamError::Spline)
    }

    /// Root mean square of the difference to the table.
    fn difference(&self, coefficients: &[f64]) -> f64 {
        let n = self.values.len();
        let sum: f64 = (0..n)
            .map(|row| {
                let terms = self.rows[row].iter().enumerate();
                let value: f64 = terms
                    .map(|(k, basis)| basis * coefficients[self.spline.column(row, k)])
                    .sum();
                (value - self.values[row]).powi(2)
            })
            .sum();
        (sum / n as f64).sqrt()
    }
}

/// ∫ B_j''' B_l''' dt over an interval: third derivatives are parabolas, of whose products three Gauss points have the exact integral.
fn interval_penalty(spline: &PeriodicSpline, interval: usize) -> [[f64; DEGREE + 1]; DEGREE + 1] {
    let (from, to) = (
        spline.knot(interval as isize),
        spline.knot(interval as isize + 1),
    );
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    let mut penalty = [[0.0; DEGREE + 1]; DEGREE + 1];
    let far = 0.6_f64.sqrt();
    for (place, weight) in [(-far, 5.0 / 9.0), (0.0, 8.0 / 9.0), (far, 5.0 / 9.0)] {
        let jerks: [f64; DEGREE + 1] = std::array::from_fn(|k| {
            let mut unit = [0.0; DEGREE + 1];
            unit[k] = 1.0;
            spline.derivatives(interval, unit, middle + place * half)[3]
        });
        for k in 0..=DEGREE {
            for l in 0..=DEGREE {
                penalty[k][l] += half * weight * jerks[k] * jerks[l];
            }
        }
    }
    penalty
}

/// A symmetric matrix whose rows have no entries before their first one: of a cyclic band all but the last rows are short.
struct Skyline {
    first: Vec<usize>,
    rows: Vec<Vec<f64>>,
}

impl Skyline {
    /// A zero matrix of n rows, coupled with their neighbours up to a distance around the cycle.
    fn cyclic(n: usize, distance: usize) -> Skyline {
        let first: Vec<usize> = (0..n)
            .map(|i| {
                if i + distance >= n {
                    0
                } else {
                    i.saturating_sub(distance)
                }
            })
            .collect();
        let rows = first
            .iter()
            .enumerate()
            .map(|(i, first)| vec![0.0; i + 1 - first])
            .collect();
        Skyline { first, rows }
    }

    /// Adds to an entry; those above the diagonal are those below.
    fn add(&mut self, row: usize, column: usize, value: f64) {
        if column <= row {
            self.rows[row][column - self.first[row]] += value;
        }
    }

    /// The solution by Cholesky's method, which stays inside the skyline; `None` of matrices that are not positive definite.
    fn solve(mut self, mut x: Vec<f64>) -> Option<Vec<f64>> {
        let n = x.len();
        for i in 0..n {
            let (before, rest) = self.rows.split_at_mut(i);
            let row = &mut rest[0];
            let first = self.first[i];
            for j in first..=i {
                let start = first.max(self.first[j]);
                let mut value = row[j - first];
                for k in start..j {
                    let other = if j == i {
                        row[k - first]
                    } else {
                        before[j][k - self.first[j]]
                    };
                    value -= row[k - first] * other;
                }
                row[j - first] = if j < i {
                    value / before[j][j - self.first[j]]
                } else if value > 0.0 {
                    value.sqrt()
                } else {
                    return None;
                };
            }
            let sum: f64 = (first..i).map(|k| row[k - first] * x[k]).sum();
            x[i] = (x[i] - sum) / row[i - first];
        }
        for i in (0..n).rev() {
            let (row, first) = (&self.rows[i], self.first[i]);
            x[i] /= row[i - first];
            for k in first..i {
                x[k] -= row[k - first] * x[i];
            }
        }
        Some(x)
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    fn even(n: u32) -> Vec<f64> {
        (0..n).map(|i| TAU * f64::from(i) / f64::from(n)).collect()
    }

    /// On even places cos kt keeps the part 1/(1 + 2π λ k⁶/n) of its amplitude: Σ cos² = n/2 and ∫ (k³ sin kt)² dt = π k⁶.
    #[test]
    fn waves_are_damped() {
        let places = even(96);
        let values: Vec<f64> = places
            .iter()
            .map(|t| t.cos() + 0.1 * (5.0 * t).sin())
            .collect();
        let fit = Fit::new(&places, &values, TAU).expect("a fit");
        for weight in [1e-4, 1e-2, 1.0] {
            let coefficients = fit.coefficients(weight).expect("a solution");
            let spline = fit.spline.clone().with(coefficients);
            let kept = |k: i32| 1.0 / (1.0 + TAU * weight * f64::from(k.pow(6)) / 96.0);
            for t in [0.1_f64, 1.3, 4.0] {
                let right = kept(1) * t.cos() + 0.1 * kept(5) * (5.0 * t).sin();
                assert_relative_eq!(spline.at(t)[0], right, max_relative = 1e-6);
            }
        }
    }

    /// A lift of 8 mm rounded to 1 µm at each degree: through all of it s'' is off by mm, smoothed by 0.29 µm, the root mean square of rounding, by 1/100 of that.
    #[test]
    fn rounded_lifts() {
        let places = even(360);
        let exact = |t: f64| 4e-3 * (1.0 - t.cos()).powi(2) / 2.0;
        let second = |t: f64| 4e-3 * (t.cos() - (2.0 * t).cos());
        let values: Vec<f64> = places
            .iter()
            .map(|t| 1e-6 * (1e6 * exact(*t)).round())
            .collect();
        let worst = |spline: &PeriodicSpline| {
            let errors = places.iter().map(|t| (spline.at(*t)[2] - second(*t)).abs());
            errors.fold(0.0, f64::max)
        };
        let through = PeriodicSpline::new(&places, &values, TAU).expect("a spline");
        let near = smooth(&places, &values, TAU, 0.29e-6).expect("a spline");
        assert!(worst(&through) > 3e-3, "{}", worst(&through));
        assert!(worst(&near) < 3e-5, "{}", worst(&near));
        let sum: f64 = places
            .iter()
            .zip(&values)
            .map(|(t, value)| (near.at(*t)[0] - value).powi(2))
            .sum();
        assert_relative_eq!((sum / 360.0).sqrt(), 0.29e-6, max_relative = 1e-6);
        // No law has more than the whole lift of difference.
        assert!(matches!(
            smooth(&places, &values, TAU, 1.0),
            Err(CamError::Value { .. })
        ));
    }
}
