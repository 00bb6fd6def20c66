//! The gap between the bodies before they deflect.

use std::sync::Arc;

use super::{Roller, Turn};

/// A paraboloid in half-widths a, its height in a²/R: G = ½(x² + κy²), κ = R/R_y, x and y along the principal directions.
///
/// Habchi 2008, eq. 2.22; for two principal curvatures Johnson 1985, eq. 4.3.
#[derive(Clone, Debug, PartialEq)]
pub struct Gap {
    /// Curvature along y over that along x: 1 for a ball, 0 for a cylinder.
    pub curvature_ratio: f64,
    /// From the motion to the principal directions.
    pub turn: Turn,
    /// What a roller adds along its axis; `None` of all other bodies.
    pub along_roller: Option<RollerGap>,
}

/// Relief and tilt of a roller, z(y) − θ y, in a²/R and half-widths a; it is not turned against the motion.
#[derive(Clone, Debug, PartialEq)]
pub struct RollerGap {
    roller: Arc<Roller>,
    /// Half-width a, m.
    length: f64,
    /// a²/R, m.
    height: f64,
}

impl RollerGap {
    /// Of a roller in units of the half-width (m) and of the film scale (m).
    pub fn new(roller: Roller, half_width: f64, film: f64) -> RollerGap {
        RollerGap {
            roller: Arc::new(roller),
            length: half_width,
            height: film,
        }
    }

    /// Height and slope at Y.
    #[inline]
    pub fn at(&self, y: f64) -> [f64; 2] {
        let [z, slope] = self.roller.height(y * self.length);
        [z / self.height, slope * self.length / self.height]
    }
}

impl Gap {
    /// G at (X, Y), X along the entrainment.
    #[inline(always)]
    pub fn value(&self, at: [f64; 2]) -> f64 {
        let [x, y] = self.turn.to_axes(at);
        let paraboloid = 0.5 * (x * x + self.curvature_ratio * (y * y));
        match &self.along_roller {
            None => paraboloid,
            Some(roller) => paraboloid + roller.at(y)[0],
        }
    }

    /// ∇G at (X, Y).
    #[inline(always)]
    pub fn gradient(&self, at: [f64; 2]) -> [f64; 2] {
        let [x, y] = self.turn.to_axes(at);
        let along_y = match &self.along_roller {
            None => self.curvature_ratio * y,
            Some(roller) => self.curvature_ratio * y + roller.at(y)[1],
        };
        self.turn.to_motion([x, along_y])
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
            along_roller: None,
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

    /// A tilted roller: the height by hand, and the gradient against differences.
    #[test]
    fn rollers_add_relief_and_tilt() {
        let roller = Roller {
            length: 0.01,
            profile: crate::contact::roller::Profile::Crown { crown_radius: 10.0 },
            misalignment: 1e-4,
        };
        let (a, film) = (1e-4, 1e-6);
        let gap = Gap {
            curvature_ratio: 0.0,
            turn: Turn::NONE,
            along_roller: Some(RollerGap::new(roller, a, film)),
        };
        let at = [0.3, 12.0];
        // y = 1.2 mm: y²/(2 · 10 m) = 72 nm, θ y = 120 nm.
        assert_relative_eq!(gap.value(at), 0.045 + 0.072 - 0.12, max_relative = 1e-6);
        let step = 1e-4;
        let [_, slope] = gap.gradient(at);
        let difference = gap.value([0.3, 12.0 + step]) - gap.value([0.3, 12.0 - step]);
        assert_relative_eq!(slope, difference / (2.0 * step), max_relative = 1e-6);
    }
}
