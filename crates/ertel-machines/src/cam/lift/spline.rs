//! A periodic spline of the fifth degree through a table.

use nalgebra::{DMatrix, DVector};

use super::super::CamError;
use super::super::error::in_range;

/// Degree: the curve has four continuous derivatives, so s'' is smooth and not made of straight lines.
pub(super) const DEGREE: usize = 5;
/// Fewest and most rows.
pub const ROWS: [usize; 2] = [DEGREE + 3, 2000];

/// A periodic function through given places, a spline of the fifth degree with its knots there.
#[derive(Clone, Debug, PartialEq)]
pub struct PeriodicSpline {
    places: Vec<f64>,
    coefficients: Vec<f64>,
    period: f64,
}

impl PeriodicSpline {
    /// A spline through ascending places within one period and the values there.
    ///
    /// Coefficients of the B-splines B_j follow from Σ_j c_j B_j(t_i) = y_i. Source: de Boor, A Practical Guide to Splines, 1978, chapters IX to XIII.
    ///
    /// # Errors
    ///
    /// Places out of order, numbers that are not finite, and tables of unfit size.
    pub fn new(places: &[f64], values: &[f64], period: f64) -> Result<PeriodicSpline, CamError> {
        let mut spline = PeriodicSpline::unset(places, values, period)?;
        let rows = places.len();
        let mut matrix = DMatrix::zeros(rows, rows);
        for row in 0..rows {
            for (k, value) in spline.basis(row, places[row]).into_iter().enumerate() {
                matrix[(row, spline.column(row, k))] += value;
            }
        }
        let solution = matrix.lu().solve(&DVector::from_column_slice(values));
        let Some(coefficients) = solution.filter(|c| c.iter().all(|value| value.is_finite()))
        else {
            return Err(CamError::Spline);
        };
        spline.coefficients = coefficients.as_slice().to_vec();
        Ok(spline)
    }

    /// A spline with its knots at the places and without coefficients yet.
    pub(super) fn unset(
        places: &[f64],
        values: &[f64],
        period: f64,
    ) -> Result<PeriodicSpline, CamError> {
        let rows = places.len().min(values.len());
        if rows < ROWS[0] || rows > ROWS[1] || places.len() != values.len() {
            return Err(CamError::TableSize {
                rows,
                least: ROWS[0],
                most: ROWS[1],
            });
        }
        for row in 0..rows {
            in_range("angle of a table", places[row], true, "a finite number")?;
            in_range("lift of a table", values[row], true, "a finite number")?;
            let ascends = row == 0 || places[row] > places[row - 1];
            if !ascends || places[row] - places[0] >= period * (1.0 - 1e-9) {
                return Err(CamError::TableOrder {
                    row: row + 1,
                    angle: places[row],
                });
            }
        }
        Ok(PeriodicSpline {
            places: places.to_vec(),
            coefficients: vec![0.0; rows],
            period,
        })
    }

    /// The same with other coefficients.
    pub(super) fn with(self, coefficients: Vec<f64>) -> PeriodicSpline {
        PeriodicSpline {
            coefficients,
            ..self
        }
    }

    /// The value and its first two derivatives.
    pub fn at(&self, place: f64) -> [f64; 3] {
        let x = self.within(place);
        let interval = self.interval(place);
        let local = std::array::from_fn(|k| self.coefficients[self.column(interval, k)]);
        let [value, first, second, _] = self.derivatives(interval, local, x);
        [value, first, second]
    }

    /// A place of the period from the first knot on.
    fn within(&self, place: f64) -> f64 {
        let first = self.places[0];
        first + (place - first).rem_euclid(self.period)
    }

    /// The interval, by its first knot, in which a place is.
    pub(super) fn interval(&self, place: f64) -> usize {
        let x = self.within(place);
        self.places.partition_point(|t| *t <= x).max(1) - 1
    }

    /// The period.
    pub(super) fn period(&self) -> f64 {
        self.period
    }

    /// The value and three derivatives from the coefficients of an interval.
    pub(super) fn derivatives(
        &self,
        interval: usize,
        local: [f64; DEGREE + 1],
        x: f64,
    ) -> [f64; 4] {
        let mut local = local.to_vec();
        let mut values = [0.0; 4];
        for (derivative, value) in values.iter_mut().enumerate() {
            let degree = DEGREE - derivative;
            *value = self.de_boor(interval, degree, &local, x);
            // Coefficients of the derivative: p (c_j − c_{j−1})/(t_{j+p} − t_j).
            local = (1..=degree)
                .map(|k| {
                    let j = interval as isize - degree as isize + k as isize;
                    let width = self.knot(j + degree as isize) - self.knot(j);
                    degree as f64 * (local[k] - local[k - 1]) / width
                })
                .collect();
        }
        values
    }

    /// Knots of all turns: t_{j+n} = t_j + period.
    pub(super) fn knot(&self, j: isize) -> f64 {
        let n = self.places.len() as isize;
        self.places[j.rem_euclid(n) as usize] + self.period * j.div_euclid(n) as f64
    }

    /// Which coefficient the k-th B-spline of an interval has.
    pub(super) fn column(&self, interval: usize, k: usize) -> usize {
        let n = self.places.len();
        (interval + n + k - DEGREE) % n
    }

    /// De Boor's algorithm on the coefficients of an interval.
    fn de_boor(&self, interval: usize, degree: usize, local: &[f64], x: f64) -> f64 {
        let mut d = local.to_vec();
        for r in 1..=degree {
            for k in (r..=degree).rev() {
                let j = interval as isize - degree as isize + k as isize;
                let (from, to) = (self.knot(j), self.knot(j + (degree + 1 - r) as isize));
                let alpha = (x - from) / (to - from);
                d[k] = (1.0 - alpha) * d[k - 1] + alpha * d[k];
            }
        }
        d[degree]
    }

    /// The B-splines of an interval at a place: de Boor's algorithm on unit coefficients.
    pub(super) fn basis(&self, interval: usize, x: f64) -> [f64; DEGREE + 1] {
        std::array::from_fn(|k| {
            let mut unit = [0.0; DEGREE + 1];
            unit[k] = 1.0;
            self.de_boor(interval, DEGREE, &unit, x)
        })
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use approx::assert_relative_eq;

    use super::*;

    /// A sum of two waves at uneven places: the error falls as h⁶, that of s'' as h⁴.
    #[test]
    fn waves() {
        let exact = |x: f64| {
            [
                x.sin() + 0.3 * (2.0 * x).cos(),
                x.cos() - 0.6 * (2.0 * x).sin(),
                -x.sin() - 1.2 * (2.0 * x).cos(),
            ]
        };
        let errors = [24, 48].map(|n| {
            let places: Vec<f64> = (0..n)
                .map(|i| TAU * f64::from(i) / f64::from(n))
                .map(|x| x + 0.1 * x.sin())
                .collect();
            let values: Vec<f64> = places.iter().map(|x| exact(*x)[0]).collect();
            let spline = PeriodicSpline::new(&places, &values, TAU).expect("a spline");
            let mut worst = [0.0_f64; 3];
            for i in 0..500 {
                let x = TAU * f64::from(i) / 499.0 - 1.0;
                let (found, right) = (spline.at(x), exact(x));
                for d in 0..3 {
                    worst[d] = worst[d].max((found[d] - right[d]).abs());
                }
            }
            worst
        });
        for d in 0..3 {
            let order = (errors[0][d] / errors[1][d]).log2();
            assert!(order > [5.5, 4.5, 3.5][d], "{d}: {order}");
        }
        assert!(errors[1][2] < 1e-4, "{errors:?}");
    }

    #[test]
    fn passes_through_the_table() {
        let places: Vec<f64> = (0..10).map(|i| 0.6 * f64::from(i)).collect();
        let values: Vec<f64> = (0..10).map(|i| f64::from((i * 7) % 10)).collect();
        let spline = PeriodicSpline::new(&places, &values, TAU).expect("a spline");
        for (place, value) in places.iter().zip(&values) {
            assert_relative_eq!(spline.at(*place)[0], value, epsilon = 1e-10);
            assert_relative_eq!(spline.at(place + TAU)[0], value, epsilon = 1e-10);
        }
    }

    #[test]
    fn refusals() {
        let line = |n: i32| -> Vec<f64> { (0..n).map(f64::from).collect() };
        let new = |places: &[f64], period| PeriodicSpline::new(places, places, period);
        assert!(matches!(
            new(&line(4), TAU),
            Err(CamError::TableSize { .. })
        ));
        assert!(matches!(
            new(&line(9), 8.0),
            Err(CamError::TableOrder { row: 9, .. })
        ));
        let mut back = line(9);
        back[3] = 1.5;
        assert!(matches!(
            new(&back, 20.0),
            Err(CamError::TableOrder { row: 4, .. })
        ));
        back[3] = f64::NAN;
        assert!(matches!(new(&back, 20.0), Err(CamError::Value { .. })));
    }
}
