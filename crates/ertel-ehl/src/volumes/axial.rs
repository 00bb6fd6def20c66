//! Heat along the axis of a roller: shapes over the rows of its grid that keep their form while heat spreads in a body.
//!
//! ```text
//!   −d²v_n/dy² = κ_n² v_n,   dv_n/dy = 0 at both ends          Σ_j h_j v_m v_n = δ_mn,  h_j what row j stands for
//!   q(x, y_j) = Σ_n q_n(x) v_n(y_j),   q_n = Σ_j h_j v_n(y_j) q(x, y_j)
//! ```
//! On even rows v_n would be cosines. Fluxes between rows are differences of second order. No heat passes the ends: a roller ends there, and below a raceway what spreads
//! beyond them in a passage is little.
//!
//! Theory: Heat by finite volumes.

use nalgebra::{DMatrix, SymmetricEigen};
use realfft::num_complex::Complex64;

use super::rows::{RING, Rows};

/// Shapes along the axis.
#[derive(Debug)]
pub struct AxialShapes {
    /// Rows of the grid, the first and the last one of the roller.
    n_rows: usize,
    ends: [usize; 2],
    /// κ², over half-widths squared.
    squares: Vec<f64>,
    /// v at the rows of the roller, shape by shape.
    shapes: Vec<f64>,
    /// Length that each row of the roller represents.
    heights: Vec<f64>,
}

impl AxialShapes {
    /// Over rows; the last one may be the centreline, beyond which all is mirrored.
    pub fn new(rows: &Rows, half: bool) -> AxialShapes {
        let last = rows.n() - 1 - if half { 0 } else { RING };
        let n = last + 1 - RING;
        let heights: Vec<f64> = (RING..=last)
            .map(|j| match half && j == last {
                true => 0.5 * rows.height(j),
                false => rows.height(j),
            })
            .collect();
        // h^−½ K h^−½ is symmetric.
        let mut spread = DMatrix::<f64>::zeros(n, n);
        for j in 0..n - 1 {
            let passes = 1.0 / rows.step(RING + j);
            spread[(j, j)] += passes / heights[j];
            spread[(j + 1, j + 1)] += passes / heights[j + 1];
            let between = passes / (heights[j] * heights[j + 1]).sqrt();
            spread[(j, j + 1)] -= between;
            spread[(j + 1, j)] -= between;
        }
        let found = SymmetricEigen::new(spread);
        let shapes = (0..n).flat_map(|m| {
            let vector = found.eigenvectors.column(m);
            (0..n)
                .map(|j| vector[j] / heights[j].sqrt())
                .collect::<Vec<f64>>()
        });
        AxialShapes {
            n_rows: rows.n(),
            ends: [RING, last],
            squares: found.eigenvalues.iter().map(|k: &f64| k.max(0.0)).collect(),
            shapes: shapes.collect(),
            heights,
        }
    }

    /// Their number.
    pub fn n(&self) -> usize {
        self.squares.len()
    }

    /// κ² of each, over half-widths squared.
    pub fn squares(&self) -> &[f64] {
        &self.squares
    }

    /// Parts of a line of values, one for each row of the grid.
    pub fn parts(&self, line: &[Complex64], parts: &mut [Complex64]) {
        let own = &line[self.ends[0]..];
        for (part, shape) in parts.iter_mut().zip(self.shapes.chunks_exact(self.n())) {
            let each = shape.iter().zip(&self.heights).zip(own);
            *part = each.map(|((v, h), value)| *value * (v * h)).sum();
        }
    }

    /// A line of values by its parts; mirrored beyond the ends.
    pub fn line(&self, parts: &[Complex64], line: &mut [Complex64]) {
        line.fill(Complex64::default());
        let [first, last] = self.ends;
        let own = &mut line[first..=last];
        for (part, shape) in parts.iter().zip(self.shapes.chunks_exact(self.n())) {
            for (value, v) in own.iter_mut().zip(shape) {
                *value += *part * *v;
            }
        }
        for beyond in 1..=RING {
            line[first - beyond] = line[first + beyond];
            if last + beyond < self.n_rows {
                line[last + beyond] = line[last - beyond];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use std::f64::consts::PI;

    fn uneven(n: usize, half: bool) -> Rows {
        // Dense at both ends of −1 < y < 1, two rows beyond them.
        let inner = (0..=n).map(|k| -(PI * k as f64 / n as f64).cos());
        let mut places: Vec<f64> = inner.filter(|y| !half || *y < 1e-9).collect();
        let step = places[1] - places[0];
        let last = places.len() - 1;
        let far = places[last] + (places[last] - places[last - 1]);
        places.insert(0, -1.0 - step);
        places.insert(0, -1.0 - 2.0 * step);
        if !half {
            places.extend([far, 2.0 * far - 1.0]);
        }
        Rows::at(places, half)
    }

    /// Between insulated ends at −1 and 1 shapes are cosines with κ = nπ/2 (Carslaw and Jaeger 1959, section 3.3); on a half those that are even. Errors fall with the
    /// square of the distance of the rows.
    #[test]
    fn cosines() {
        for half in [false, true] {
            let errors = [40, 80].map(|n| {
                let shapes = AxialShapes::new(&uneven(n, half), half);
                let mut squares = shapes.squares().to_vec();
                squares.sort_by(f64::total_cmp);
                let step = if half { PI } else { 0.5 * PI };
                assert!(squares[0].abs() < 1e-9);
                (1..4)
                    .map(|m| (squares[m].sqrt() / (m as f64 * step) - 1.0).abs())
                    .fold(0.0, f64::max)
            });
            assert!(errors[0] < 0.02, "{errors:?}");
            assert_relative_eq!(errors[0] / errors[1], 4.0, max_relative = 0.15);
        }
    }

    /// Values come back from their parts, and heat spreads to no other place than the rows.
    #[test]
    fn there_and_back() {
        for half in [false, true] {
            let rows = uneven(16, half);
            let shapes = AxialShapes::new(&rows, half);
            let line: Vec<Complex64> = (0..rows.n())
                .map(|j| Complex64::new((1.3 * j as f64).sin(), (j as f64).cos()))
                .collect();
            let mut parts = vec![Complex64::default(); shapes.n()];
            let mut back = vec![Complex64::default(); rows.n()];
            shapes.parts(&line, &mut parts);
            shapes.line(&parts, &mut back);
            let last = rows.n() - 1 - if half { 0 } else { RING };
            for j in RING..=last {
                assert_relative_eq!(back[j].re, line[j].re, epsilon = 1e-12);
                assert_relative_eq!(back[j].im, line[j].im, epsilon = 1e-12);
            }
            assert_eq!(back[RING - 1], back[RING + 1]);
        }
    }
}
