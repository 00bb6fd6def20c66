//! Splines near tables with errors.

use std::f64::consts::TAU;

use super::super::CamError;
use super::super::error::in_range;
use super::spline::{DEGREE, PeriodicSpline};

/// Halvings of the logarithm of the weight.
const HALVINGS: usize = 60;

/// A spline near a table, and what the errors of the table leave open of it.
#[derive(Clone, Debug, PartialEq)]
pub struct TableLift {
    /// Lifts over the angle, m.
    spline: PeriodicSpline,
    /// Root mean square of the difference to the table, m; 0 through all of it.
    pub tolerance: f64,
    /// Bars of s'' behind each row, m.
    bars: Vec<f64>,
}

impl TableLift {
    /// The spline near a table whose lifts have errors of the root mean square `error` (m): with the smallest ∫ s'''² of those that differ from the
    /// table by as much, or interpolating all of it where s'' is then accurate to [`EXACT_TABLE`]. An error that `is_given` is smoothed by in any case, unless it is 0.
    pub(super) fn new(
        places: &[f64],
        values: &[f64],
        period: f64,
        error: f64,
        is_given: bool,
    ) -> Result<TableLift, CamError> {
        let through = PeriodicSpline::new(places, values, period)?;
        let none = TableLift {
            bars: vec![0.0; places.len()],
            tolerance: 0.0,
            spline: through,
        };
        if error == 0.0 {
            return Ok(none);
        }
        let fit = Fit::new(places, values, period)?;
        if !is_given {
            let bars = fit.bars(&none.spline, 0.0, error)?;
            let seconds = places.iter().map(|t| none.spline.at(*t)[2].abs());
            let largest = seconds.fold(0.0, f64::max);
            if bars.iter().all(|bar| *bar <= EXACT_TABLE * largest) {
                return Ok(TableLift { bars, ..none });
            }
        }
        let (spline, weight) = smooth(&fit, error)?;
        Ok(TableLift {
            bars: fit.bars(&spline, weight, error)?,
            tolerance: error,
            spline,
        })
    }

    /// s, s' and s'' at a place.
    pub(super) fn at(&self, place: f64) -> [f64; 3] {
        self.spline.at(place)
    }

    /// By how much s'' may be off there, m.
    pub(super) fn bar(&self, place: f64) -> f64 {
        self.bars[self.spline.interval(place)]
    }
}

/// Bar of s'' over the largest |s''| of a turn below which a spline interpolates all of the table: the digits do not limit accuracy then.
const EXACT_TABLE: f64 = 1e-3;
/// Standard deviations of rounding that a bar of s'' has.
const DEVIATIONS: f64 = 3.0;
/// How often a bar has the smoothing's own error as estimated: at a corner of s'', as of cycloidal moves, smoothing that is repeated sees an eighth of it or more.
const SMOOTHING: f64 = 8.0;
/// Rows to either side whose largest bar counts: the errors of neighbours go together.
const NEIGHBOURS: usize = 2;

/// The spline with the smallest ∫ s'''² of those whose values differ from a table by the root mean square of a tolerance, and its weight.
///
/// Its coefficients minimise Σ_i (s(t_i) − y_i)² + λ ∫ s'''² dt, with the weight λ at which the difference is the tolerance: it grows with λ, from 0 to that of the mean.
/// Source: Reinsch, Numerische Mathematik 10, 1967, 177–183 (of s''; here s''', as forces follow s'').
fn smooth(fit: &Fit<'_>, tolerance: f64) -> Result<(PeriodicSpline, f64), CamError> {
    let values = fit.values;
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
    let period = fit.spline.period();
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
    Ok((fit.spline.clone().with(best), low))
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
        Ok(self.factor(weight)?.solve(self.projected(self.values)))
    }

    /// Bᵀ y of values at the rows.
    fn projected(&self, values: &[f64]) -> Vec<f64> {
        let mut right = vec![0.0; values.len()];
        for (row, (basis, value)) in self.rows.iter().zip(values).enumerate() {
            for (k, basis) in basis.iter().enumerate() {
                right[self.spline.column(row, k)] += basis * value;
            }
        }
        right
    }

    /// B c at the rows.
    fn at_rows(&self, coefficients: &[f64]) -> Vec<f64> {
        let value = |(row, basis): (usize, &[f64; DEGREE + 1])| {
            let terms = basis.iter().enumerate();
            terms
                .map(|(k, basis)| basis * coefficients[self.spline.column(row, k)])
                .sum()
        };
        self.rows.iter().enumerate().map(value).collect()
    }

    /// Bars of s'' behind each row, of errors of the root mean square `error` (m) that do not depend on one another.
    ///
    /// s''(t_i) = Σ_j w_ij y_j varies by `error` √(Σ_j w_ij²), w_i = B M⁻¹ b''(t_i), M = Bᵀ B + λ P. The error of the smoothing is the change of s'' when
    /// the smoothed lifts are smoothed again.
    fn bars(&self, spline: &PeriodicSpline, weight: f64, error: f64) -> Result<Vec<f64>, CamError> {
        let n = self.values.len();
        let matrix = self.factor(weight)?;
        let knot = |row: usize| self.spline.knot(row as isize);
        let own: Vec<f64> = (0..n).map(|row| spline.at(knot(row))[0]).collect();
        let again = self.spline.clone().with(matrix.solve(self.projected(&own)));
        let at = |interval: usize, place: f64| {
            let mut right = vec![0.0; n];
            for k in 0..=DEGREE {
                let mut unit = [0.0; DEGREE + 1];
                unit[k] = 1.0;
                let second = self.spline.derivatives(interval, unit, place)[2];
                right[self.spline.column(interval, k)] += second;
            }
            let weights = self.at_rows(&matrix.solve(right));
            let spread = weights.iter().map(|w| w * w).sum::<f64>().sqrt();
            let smoothed = (spline.at(place)[2] - again.at(place)[2]).abs();
            DEVIATIONS * error * spread + SMOOTHING * smoothed
        };
        let interval = |row: usize| {
            let middle = 0.5 * (knot(row) + knot(row + 1));
            at(row, knot(row)).max(at(row, middle))
        };
        let own: Vec<f64> = (0..n).map(interval).collect();
        let around =
            |row: usize| (0..=2 * NEIGHBOURS).map(move |by| (row + n + by - NEIGHBOURS) % n);
        Ok((0..n)
            .map(|row| around(row).map(|other| own[other]).fold(0.0, f64::max))
            .collect())
    }

    /// M = Bᵀ B + λ P, factored.
    fn factor(&self, weight: f64) -> Result<Skyline, CamError> {
        let n = self.values.len();
        let mut matrix = Skyline::cyclic(n, DEGREE);
        for interval in 0..n {
            let (row, penalty) = (&self.rows[interval], &self.penalties[interval]);
            for k in 0..=DEGREE {
                let j = self.spline.column(interval, k);
                for l in 0..=DEGREE {
                    let column = self.spline.column(interval, l);
                    matrix.add(j, column, row[k] * row[l] + weight * penalty[k][l]);
                }
            }
        }
        matrix.factored().ok_or(CamError::Spline)
    }

    /// Root mean square of the difference to the table.
    fn difference(&self, coefficients: &[f64]) -> f64 {
        let own = self.at_rows(coefficients);
        let squares = own
            .iter()
            .zip(self.values)
            .map(|(own, y)| (own - y).powi(2));
        (squares.sum::<f64>() / self.values.len() as f64).sqrt()
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

    /// The factor of Cholesky's method, which stays inside the skyline; `None` of matrices that are not positive definite.
    fn factored(mut self) -> Option<Skyline> {
        for i in 0..self.rows.len() {
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
        }
        Some(self)
    }

    /// The solution, of a factor.
    fn solve(&self, mut x: Vec<f64>) -> Vec<f64> {
        let n = x.len();
        for i in 0..n {
            let (row, first) = (&self.rows[i], self.first[i]);
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
        x
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
        let near = |error| TableLift::new(&places, &values, TAU, error, true);
        let near_by = near(0.29e-6).expect("a spline").spline;
        assert!(worst(&through) > 3e-3, "{}", worst(&through));
        assert!(worst(&near_by) < 3e-5, "{}", worst(&near_by));
        let sum: f64 = places
            .iter()
            .zip(&values)
            .map(|(t, value)| (near_by.at(*t)[0] - value).powi(2))
            .sum();
        assert_relative_eq!((sum / 360.0).sqrt(), 0.29e-6, max_relative = 1e-6);
        // No law has more than the whole lift of difference.
        assert!(matches!(near(1.0), Err(CamError::Value { .. })));
    }
}
