//! Quintic Hermite interpolation: a function by its values and two derivatives at the ends of cells.

/// Coefficients of one cell in t from 0 to 1.
#[derive(Clone, Copy, Debug)]
pub struct Quintic([f64; 6]);

impl Quintic {
    /// Through values and derivatives by t, first and second, at both ends.
    pub fn new([y0, d0, s0]: [f64; 3], [y1, d1, s1]: [f64; 3]) -> Quintic {
        let rise = y1 - y0;
        Quintic([
            y0,
            d0,
            0.5 * s0,
            10.0 * rise - 6.0 * d0 - 4.0 * d1 - 1.5 * s0 + 0.5 * s1,
            -15.0 * rise + 8.0 * d0 + 7.0 * d1 + 1.5 * s0 - s1,
            6.0 * rise - 3.0 * (d0 + d1) - 0.5 * (s0 - s1),
        ])
    }

    /// Value and derivatives by t at t.
    #[inline(always)]
    pub fn at(&self, t: f64) -> [f64; 3] {
        let [c0, c1, c2, c3, c4, c5] = self.0;
        [
            ((((c5 * t + c4) * t + c3) * t + c2) * t + c1) * t + c0,
            (((5.0 * c5 * t + 4.0 * c4) * t + 3.0 * c3) * t + 2.0 * c2) * t + c1,
            ((20.0 * c5 * t + 12.0 * c4) * t + 6.0 * c3) * t + 2.0 * c2,
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// A polynomial of order five is its own interpolant: 2 − t + 3t² − t³ + 4t⁴ − 2t⁵.
    #[test]
    fn reproduces_quintics() {
        let exact = |t: f64| {
            [
                2.0 - t + 3.0 * t * t - t.powi(3) + 4.0 * t.powi(4) - 2.0 * t.powi(5),
                -1.0 + 6.0 * t - 3.0 * t * t + 16.0 * t.powi(3) - 10.0 * t.powi(4),
                6.0 - 6.0 * t + 48.0 * t * t - 40.0 * t.powi(3),
            ]
        };
        let cell = Quintic::new(exact(0.0), exact(1.0));
        for t in [0.0, 0.3, 0.8, 1.0] {
            for (ours, theirs) in cell.at(t).into_iter().zip(exact(t)) {
                assert_relative_eq!(ours, theirs, max_relative = 1e-13, epsilon = 1e-13);
            }
        }
    }
}
