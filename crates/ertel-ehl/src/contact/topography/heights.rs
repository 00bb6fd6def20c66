//! Heights of a surface at the points of a grid.

/// Heights, m, at points at equal distances, not a number where there is none.
#[derive(Clone, Debug, PartialEq)]
pub struct Topography {
    /// Points in a row, and rows; one row is a profile.
    pub counts: [usize; 2],
    /// Distances of points in a row, and of rows, m.
    pub spacing: [f64; 2],
    /// Row by row.
    pub heights: Vec<f64>,
}

impl Topography {
    /// Whether it is a profile.
    pub fn is_profile(&self) -> bool {
        self.counts[1] == 1
    }

    /// Lengths of its sides, m; 0 across a profile.
    pub fn sides(&self) -> [f64; 2] {
        [0, 1].map(|d: usize| (self.counts[d] - 1) as f64 * self.spacing[d])
    }

    /// Points without a height.
    pub fn n_holes(&self) -> usize {
        self.heights.iter().filter(|h| h.is_nan()).count()
    }

    /// Heights multiplied by a cosine that falls from 1 to 0 over a width, m, along the rim:
    /// `½(1 − cos(π d/w))` at the distance d < w from it, in each direction (Tukey's window).
    pub fn taper(&mut self, width: f64) {
        let window = |d: usize, i: usize| {
            let n = self.counts[d];
            if n == 1 {
                return 1.0;
            }
            let distance = i.min(n - 1 - i) as f64 * self.spacing[d];
            match distance < width {
                true => 0.5 * (1.0 - (std::f64::consts::PI * distance / width).cos()),
                false => 1.0,
            }
        };
        let along: Vec<f64> = (0..self.counts[0]).map(|i| window(0, i)).collect();
        let across: Vec<f64> = (0..self.counts[1]).map(|j| window(1, j)).collect();
        for (row, w) in self.heights.chunks_exact_mut(self.counts[0]).zip(&across) {
            for (h, v) in row.iter_mut().zip(&along) {
                *h *= v * w;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Nothing at the rim, half of the heights half a width from it, all inside.
    #[test]
    fn a_taper_is_a_cosine() {
        let mut map = Topography {
            counts: [21, 11],
            spacing: [0.1, 0.2],
            heights: vec![3.0; 231],
        };
        map.taper(0.4);
        let at = |i: usize, j: usize| map.heights[21 * j + i];
        assert_eq!([at(0, 5), at(7, 0), at(20, 10)], [0.0; 3]);
        assert_relative_eq!(at(2, 5), 1.5, max_relative = 1e-12);
        assert_relative_eq!(at(2, 1), 0.75, max_relative = 1e-12);
        assert_eq!([at(4, 2), at(10, 5)], [3.0; 2]);
    }
}
