//! The gap between the bodies before they deflect.

use super::Turn;

/// A paraboloid in half-widths a, its height in a²/R: G = ½(x² + κy²), κ = R/R_y, x and y along the principal directions.
///
/// Habchi 2008, eq. 2.22; for two principal curvatures Johnson 1985, eq. 4.3.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gap {
    /// Curvature along y over that along x: 1 for a ball, 0 for a cylinder.
    pub curvature_ratio: f64,
    /// From the motion to the principal directions.
    pub turn: Turn,
}

impl Gap {
    /// G at (X, Y), X along the entrainment.
    #[inline(always)]
    pub fn value(&self, at: [f64; 2]) -> f64 {
        let [x, y] = self.turn.to_axes(at);
        0.5 * (x * x + self.curvature_ratio * (y * y))
    }

    /// ∇G at (X, Y).
    #[inline(always)]
    pub fn gradient(&self, at: [f64; 2]) -> [f64; 2] {
        let [x, y] = self.turn.to_axes(at);
        self.turn.to_motion([x, self.curvature_ratio * y])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// The gradient against differences, which are exact for a paraboloid.
    #[test]
    fn gradient_matches_differences() {
        let gap = Gap {
            curvature_ratio: 0.3,
            turn: Turn::by(0.4),
        };
        let (at, step) = ([0.7, -1.1], 1e-3);
        let value = |dx: f64, dy: f64| gap.value([at[0] + dx, at[1] + dy]);
        let [gx, gy] = gap.gradient(at);
        let along = (value(step, 0.0) - value(-step, 0.0)) / (2.0 * step);
        let across = (value(0.0, step) - value(0.0, -step)) / (2.0 * step);
        assert_relative_eq!(gx, along, max_relative = 1e-10);
        assert_relative_eq!(gy, across, max_relative = 1e-10);
        // By hand: x = 0.7 cos 0.4 + 1.1 sin 0.4, y = 0.7 sin 0.4 − 1.1 cos 0.4.
        assert_relative_eq!(gap.value(at), 0.658_042_421, max_relative = 1e-8);
    }
}
