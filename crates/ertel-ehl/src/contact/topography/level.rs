//! The form of a surface by least squares over its points.
//!
//! ```text
//!   h → h − Σ c_k b_k,   Σ (h − Σ c_k b_k)² least,   b = 1;  1, x, y;  1, x, y, x², xy, y²
//! ```
//! Points without a height are ignored.

use nalgebra::{DMatrix, DVector};

use super::Topography;

/// The form that levelling subtracts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Levelling {
    /// The mean height.
    Mean,
    /// The least-squares plane, of a profile a line.
    Plane,
    /// The least-squares polynomial of degree two.
    Quadratic,
}

impl Levelling {
    fn basis(self, [x, y]: [f64; 2], is_profile: bool) -> Vec<f64> {
        let all: &[f64] = match self {
            Levelling::Mean => &[1.0],
            Levelling::Plane if is_profile => &[1.0, x],
            Levelling::Plane => &[1.0, x, y],
            Levelling::Quadratic if is_profile => &[1.0, x, x * x - 1.0 / 3.0],
            Levelling::Quadratic => &[1.0, x, y, x * x - 1.0 / 3.0, x * y, y * y - 1.0 / 3.0],
        };
        all.to_vec()
    }
}

impl Topography {
    /// Subtracts a form. Returns `false`, and subtracts nothing, if too few points have heights to determine it.
    pub fn level(&mut self, form: Levelling) -> bool {
        let [nx, ny] = self.counts;
        let place = |k: usize| {
            let of = |i: usize, n: usize| match n {
                1 => 0.0,
                n => 2.0 * i as f64 / (n - 1) as f64 - 1.0,
            };
            [of(k % nx, nx), of(k / nx, ny)]
        };
        let is_profile = self.is_profile();
        let n = form.basis([0.0; 2], is_profile).len();
        let mut matrix = DMatrix::<f64>::zeros(n, n);
        let mut right = DVector::<f64>::zeros(n);
        for (k, h) in self.heights.iter().enumerate().filter(|(_, h)| !h.is_nan()) {
            let b = form.basis(place(k), is_profile);
            for i in 0..n {
                right[i] += b[i] * h;
                for j in 0..n {
                    matrix[(i, j)] += b[i] * b[j];
                }
            }
        }
        let points = matrix[(0, 0)];
        let Some(factors) = (matrix / points.max(1.0)).cholesky() else {
            return false;
        };
        let c = factors.solve(&(right / points));
        for (k, h) in self.heights.iter_mut().enumerate() {
            let b = form.basis(place(k), is_profile);
            *h -= b.iter().zip(c.iter()).map(|(b, c)| b * c).sum::<f64>();
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An added form is removed again, with holes, too; the same surface with two different forms gives the same result.
    #[test]
    fn forms_come_off() {
        for counts in [[30, 20], [40, 1]] {
            let points = || (0..counts[0] * counts[1]).map(move |k| (k % counts[0], k / counts[0]));
            let mut bare = Topography {
                counts,
                spacing: [1e-6; 2],
                heights: points()
                    .map(|(i, j)| ((i * i + 3 * j) as f64).sin())
                    .collect(),
            };
            bare.heights[17] = f64::NAN;
            let mut full = bare.clone();
            for ((i, j), h) in points().zip(&mut full.heights) {
                let (x, y) = (i as f64, j as f64);
                *h += 5.0 - 0.3 * x + 0.02 * x * x + 0.1 * y - 0.01 * x * y + 0.03 * y * y;
            }
            for map in [&mut bare, &mut full] {
                assert!(map.level(Levelling::Quadratic));
            }
            let far = (bare.heights.iter().zip(&full.heights))
                .filter(|(a, _)| !a.is_nan())
                .map(|(a, b)| (a - b).abs())
                .fold(0.0, f64::max);
            assert!(far < 1e-10, "{far}");
            let kept = full.clone();
            assert!(full.level(Levelling::Plane) && full.level(Levelling::Mean));
            let moved = (kept.heights.iter().zip(&full.heights))
                .filter(|(a, _)| !a.is_nan())
                .map(|(a, b)| (a - b).abs())
                .fold(0.0, f64::max);
            assert!(moved < 1e-12, "{moved}");
            assert_eq!(full.n_holes(), 1);
        }
    }
}
