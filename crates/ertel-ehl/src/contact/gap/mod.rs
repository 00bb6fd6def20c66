//! The gap between the bodies before they deflect: a paraboloid, and terms that are added to it.
//!
//! ```text
//!   G = ½(x² + κy²) + Σ g_k(x, y)        κ = R/R_y
//! ```
//! Lengths in half-widths a, heights in a²/R; x and y along the principal directions of the bodies. Paraboloid: Habchi 2008, eq. 2.22; for
//! two principal curvatures Johnson 1985, eq. 4.3.
//!
//! Each term is one file here and one variant of [`GapTerm`]; nothing else changes for a new one.

mod curvature;
mod form;
mod height;
mod map;
mod relief;
mod roller;

pub use curvature::Curvature;
pub use form::{Form, Repeat};
pub use height::{Body, Height};
pub use map::HeightMap;
pub use relief::Relief;
pub use roller::RollerGap;

use super::Turn;

/// The undeformed gap.
#[derive(Clone, Debug, PartialEq)]
pub struct Gap {
    /// κ, curvature along y over that along x: 1 for a ball, 0 for a cylinder.
    pub curvature_ratio: f64,
    /// From the motion to the principal directions.
    pub turn: Turn,
    /// Terms added to the paraboloid.
    pub terms: Vec<GapTerm>,
}

/// A term of the gap.
#[derive(Clone, Debug, PartialEq)]
pub enum GapTerm {
    /// Relief and tilt of a roller.
    Roller(RollerGap),
    /// A dent, a ridge, waves on one of the surfaces.
    Relief(Relief),
    /// Change of the paraboloid by a changed radius.
    Curvature(Curvature),
}

impl GapTerm {
    /// Height and slopes at (x, y).
    #[inline]
    pub fn at(&self, place: [f64; 2]) -> Height {
        match self {
            GapTerm::Roller(roller) => roller.at(place),
            GapTerm::Relief(relief) => relief.at(place),
            GapTerm::Curvature(curvature) => curvature.at(place),
        }
    }

    /// The body whose surface has this shape, with which it moves.
    pub fn body(&self) -> Body {
        match self {
            // A roller is body 2, on a plane.
            GapTerm::Roller(_) => Body::Second,
            GapTerm::Relief(relief) => relief.body,
            // On a plane, as the paraboloid.
            GapTerm::Curvature(_) => Body::Second,
        }
    }
}

impl Gap {
    /// A paraboloid alone, its first principal direction along the motion.
    pub const fn paraboloid(curvature_ratio: f64) -> Gap {
        Gap {
            curvature_ratio,
            turn: Turn::NONE,
            terms: Vec::new(),
        }
    }

    /// Whether the surfaces have reliefs.
    pub fn has_reliefs(&self) -> bool {
        (self.terms.iter()).any(|term| matches!(term, GapTerm::Relief(_)))
    }

    /// G and ∇G at (X, Y), X along the entrainment.
    #[inline(always)]
    pub fn at(&self, place: [f64; 2]) -> Height {
        let [x, y] = self.turn.to_axes(place);
        let mut sum = Height {
            value: 0.5 * (x * x + self.curvature_ratio * (y * y)),
            gradient: [x, self.curvature_ratio * y],
        };
        for term in &self.terms {
            let more = term.at([x, y]);
            sum.value += more.value;
            for (total, slope) in sum.gradient.iter_mut().zip(more.gradient) {
                *total += slope;
            }
        }
        Height {
            value: sum.value,
            gradient: self.turn.to_motion(sum.gradient),
        }
    }

    /// Time since a place that moves with a velocity passed the lowest gap of the paraboloid (distance over velocity); negative before.
    pub fn since_closest(&self, place: [f64; 2], velocity: [f64; 2]) -> f64 {
        let [x, y] = self.turn.to_axes(place);
        let [u, v] = self.turn.to_axes(velocity);
        let curvature = u * u + self.curvature_ratio * v * v;
        match curvature > 0.0 {
            true => (x * u + self.curvature_ratio * y * v) / curvature,
            false => 0.0,
        }
    }

    /// G at (X, Y).
    #[inline(always)]
    pub fn value(&self, place: [f64; 2]) -> f64 {
        self.at(place).value
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::Roller;
    use crate::contact::roller::Profile;
    use approx::assert_relative_eq;

    /// ∇G against central differences of G.
    fn gradient_by_differences(gap: &Gap, at: [f64; 2], step: f64) -> [f64; 2] {
        let value = |dx: f64, dy: f64| gap.value([at[0] + dx, at[1] + dy]);
        [
            (value(step, 0.0) - value(-step, 0.0)) / (2.0 * step),
            (value(0.0, step) - value(0.0, -step)) / (2.0 * step),
        ]
    }

    /// The gradient against differences, which are exact for a paraboloid.
    #[test]
    fn gradient_matches_differences() {
        let gap = Gap {
            turn: Turn::by(0.4),
            ..Gap::paraboloid(0.3)
        };
        let at = [0.7, -1.1];
        let differences = gradient_by_differences(&gap, at, 1e-3);
        for (own, difference) in gap.at(at).gradient.into_iter().zip(differences) {
            assert_relative_eq!(own, difference, max_relative = 1e-10);
        }
        // By hand: x = 0.7 cos 0.4 + 1.1 sin 0.4, y = 0.7 sin 0.4 − 1.1 cos 0.4.
        assert_relative_eq!(gap.value(at), 0.658_042_421, max_relative = 1e-8);
    }

    /// Two terms on a turned paraboloid: each adds its closed form along the axes of the bodies, crown y²/(2R) and tilt −θy, and the
    /// gradient is that of differences.
    #[test]
    fn terms_add_up() {
        let (a, film) = (1e-4, 1e-6);
        let term = |crown_radius: f64, misalignment: f64| {
            let roller = Roller {
                length: 0.01,
                profile: Profile::Crown { crown_radius },
                misalignment,
            };
            GapTerm::Roller(RollerGap::new(roller, a, film))
        };
        let (crowns, tilts) = ([10.0, 25.0], [1e-4, -3e-4]);
        let gap = Gap {
            turn: Turn::by(0.25),
            terms: vec![term(crowns[0], tilts[0]), term(crowns[1], tilts[1])],
            ..Gap::paraboloid(0.1)
        };
        let at = [0.3, 12.0];
        let [x, y] = gap.turn.to_axes(at);
        let metres = a * y;
        let mut expected = 0.5 * (x * x + 0.1 * y * y);
        for (crown, tilt) in crowns.into_iter().zip(tilts) {
            expected += (metres * metres / (2.0 * crown) - tilt * metres) / film;
        }
        // A circle is a parabola up to (y/R)²/4.
        assert_relative_eq!(gap.value(at), expected, max_relative = 1e-7);
        let differences = gradient_by_differences(&gap, at, 1e-4);
        for (own, difference) in gap.at(at).gradient.into_iter().zip(differences) {
            assert_relative_eq!(own, difference, max_relative = 1e-6);
        }
        assert!(gap.terms.iter().all(|term| term.body() == Body::Second));
    }
}
