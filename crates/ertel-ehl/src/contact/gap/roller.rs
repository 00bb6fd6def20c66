//! The gap of a roller along its axis.

use std::sync::Arc;

use super::Height;
use crate::contact::Roller;

/// Relief and tilt of a roller, z(y) − θ y, in a²/R and half-widths a; its axis is y.
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

    /// Height and slopes at (x, y).
    #[inline]
    pub fn at(&self, [_, y]: [f64; 2]) -> Height {
        let [z, slope] = self.roller.height(y * self.length);
        Height {
            value: z / self.height,
            gradient: [0.0, slope * self.length / self.height],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::roller::Profile;
    use approx::assert_relative_eq;

    /// A crowned and tilted roller: the height by hand, and the slope against differences.
    #[test]
    fn relief_and_tilt() {
        let roller = Roller {
            length: 0.01,
            profile: Profile::Crown { crown_radius: 10.0 },
            misalignment: 1e-4,
        };
        let (a, film) = (1e-4, 1e-6);
        let gap = RollerGap::new(roller, a, film);
        let value = |y: f64| gap.at([0.3, y]).value;
        // y = 1.2 mm: y²/(2 · 10 m) = 72 nm, θ y = 120 nm.
        assert_relative_eq!(value(12.0), 0.072 - 0.12, max_relative = 1e-6);
        let step = 1e-4;
        let difference = (value(12.0 + step) - value(12.0 - step)) / (2.0 * step);
        let [along, across] = gap.at([0.3, 12.0]).gradient;
        assert_relative_eq!(across, difference, max_relative = 1e-6);
        assert_eq!(along, 0.0);
    }
}
