//! Residual stress over depth, as of shot peening, case hardening or a coating.
//!
//! It depends on the depth alone: equilibrium leaves σ_xx and σ_yy, which add to those of the contact at all times.

use super::Stress;
use super::hardness::between;

/// Residual stress over depth, linear between the given depths and constant outside.
#[derive(Clone, Debug, PartialEq)]
pub struct Residual {
    /// Depths, m, ascending, and the stress there along and across the motion, Pa; a depth that is given twice is a jump.
    points: Vec<[f64; 3]>,
}

/// Share of a depth that is rounding.
const ROUNDING: f64 = 1e-9;

impl Residual {
    /// From a table: depth, m, and stresses along and across the motion, Pa, tension positive.
    ///
    /// # Errors
    /// Which rule is broken: there are two points or more, all finite, and depths ascend from zero or more, each at most twice.
    pub fn of_table(points: Vec<[f64; 3]>) -> Result<Residual, &'static str> {
        if points.len() < 2 {
            return Err("a table of residual stress needs at least two depths");
        }
        if !points.iter().flatten().all(|v| v.is_finite()) {
            return Err("residual stresses and their depths must be finite");
        }
        let falls = points.windows(2).any(|pair| pair[1][0] < pair[0][0]);
        let thrice = points.windows(3).any(|three| three[2][0] <= three[0][0]);
        if points[0][0] < 0.0 || falls || thrice {
            return Err(
                "the depths of a table of residual stress must ascend, from zero or more; a jump has its depth twice",
            );
        }
        Ok(Residual { points })
    }

    /// At a depth; `below`: below a jump that lies there.
    pub fn at(&self, depth: f64, below: bool) -> Stress {
        let side = if below { ROUNDING } else { -ROUNDING };
        let at = |i: usize| between(&self.points, i, depth * (1.0 + side));
        Stress([at(1), at(2), 0.0, 0.0, 0.0, 0.0])
    }
}
