//! Points without a height: a membrane through those about them.
//!
//! ```text
//!   (h_{i−1} + h_{i+1} − 2 h)/Δx² + (h_{j−1} + h_{j+1} − 2 h)/Δy² = 0        at holes; free along the rim
//! ```

use super::Topography;

/// Sweeps at most, and the change of a height, over the largest, at which they end.
const MOST_SWEEPS: usize = 2000;
const CHANGE: f64 = 1e-7;
/// Over-relaxation.
const OVER: f64 = 1.8;

impl Topography {
    /// Fills the holes; `false` where no point has a height.
    pub fn fill(&mut self) -> bool {
        let holes: Vec<usize> = (0..self.heights.len())
            .filter(|k| self.heights[*k].is_nan())
            .collect();
        if holes.len() == self.heights.len() {
            return false;
        }
        let known = self.heights.iter().filter(|h| !h.is_nan());
        let (sum, size) = known.fold((0.0, 0.0_f64), |(s, m), h| (s + h, m.max(h.abs())));
        let mean = sum / (self.heights.len() - holes.len()) as f64;
        for k in &holes {
            self.heights[*k] = mean;
        }
        let [nx, ny] = self.counts;
        let stiffness = self.spacing.map(|d| (self.spacing[0] / d).powi(2));
        for _ in 0..MOST_SWEEPS {
            let mut change = 0.0_f64;
            for &k in &holes {
                let (i, j) = (k % nx, k / nx);
                let neighbours = [
                    (i > 0).then(|| (k - 1, stiffness[0])),
                    (i + 1 < nx).then(|| (k + 1, stiffness[0])),
                    (j > 0).then(|| (k - nx, stiffness[1])),
                    (j + 1 < ny).then(|| (k + nx, stiffness[1])),
                ];
                let (mut sum, mut total) = (0.0, 0.0);
                for (k, c) in neighbours.into_iter().flatten() {
                    sum += c * self.heights[k];
                    total += c;
                }
                let step = OVER * (sum / total - self.heights[k]);
                self.heights[k] += step;
                change = change.max(step.abs());
            }
            if change <= CHANGE * size {
                break;
            }
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// A plane and x² − y² solve the equation: holes in them are filled with them.
    #[test]
    fn holes_are_filled_by_a_membrane() {
        let of = |k: usize| {
            let (x, y) = ((k % 12) as f64, 2.0 * (k / 12) as f64);
            3.0 - 0.2 * x + 0.5 * y + 0.1 * (x * x - y * y)
        };
        let mut map = Topography {
            counts: [12, 9],
            spacing: [1e-6, 2e-6],
            heights: (0..108).map(of).collect(),
        };
        let holes = [40, 41, 42, 53, 54, 30, 66];
        for k in holes {
            map.heights[k] = f64::NAN;
        }
        assert_eq!(map.n_holes(), 7);
        assert!(map.fill());
        for k in holes {
            assert_relative_eq!(map.heights[k], of(k), max_relative = 1e-4);
        }
        map.heights.fill(f64::NAN);
        assert!(!map.fill());
    }
}
