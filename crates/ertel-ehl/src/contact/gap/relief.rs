//! What stands out of a surface or is missing from it, and moves with its body.
//!
//! ```text
//!   round: s = d cos(½π r/ρ) exp(−2 (r/ρ)²) within ρ = 1.2 r_0        a dent where d < 0 (Mourier et al. 2006)
//!   ridge: the same over the distance from a line
//!   waves: s = A cos(2π ξ/λ) e(ξ),   e = 10^(−10 (ξ/λ)²) before the first crest, ξ > 0, else 1        (Venner et al. 1997)
//! ```
//! s is the height out of the surface, ξ the distance from the first crest along the direction of the waves; the gap is smaller by s.

use std::f64::consts::{FRAC_PI_2, PI};

use super::{Body, Height};
use crate::contact::Turn;

/// Form of a relief; lengths in half-widths, heights in a²/R.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Form {
    /// A bump or a dent.
    Round {
        /// r_0.
        radius: f64,
        /// d, negative for a dent.
        height: f64,
    },
    /// A ridge or a groove.
    Ridge {
        /// r_0, half of its width.
        half_width: f64,
        /// d, negative for a groove.
        height: f64,
        /// Direction across it, against the motion, rad: 0 where it lies across the motion.
        direction: f64,
    },
    /// Waves behind a first crest.
    Waves {
        /// λ.
        wavelength: f64,
        /// A.
        amplitude: f64,
        /// Direction in which they follow each other, against the motion, rad.
        direction: f64,
    },
}

/// A relief of one of the bodies, along and across the motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Relief {
    /// What it looks like.
    pub form: Form,
    /// Whose surface.
    pub body: Body,
    /// Where its middle, or first crest, lies at the start.
    pub place: [f64; 2],
    /// How far the body has moved since.
    pub moved: f64,
    /// From the motion to the principal directions.
    pub turn: Turn,
}

/// Share of r_0 to which a round or a ridge goes.
const REACH: f64 = 1.2;

/// Half-widths of a first crest before which waves are as good as gone: 10^(−10·0.6²) = 2.5e-4.
const HEAD: f64 = 0.6;

impl Form {
    /// Shortest length over which it rises and falls, in half-widths: a wavelength, the whole width of others.
    pub fn finest(&self) -> f64 {
        match self {
            Form::Round { radius, .. } => 2.0 * REACH * radius,
            Form::Ridge { half_width, .. } => 2.0 * REACH * half_width,
            Form::Waves { wavelength, .. } => *wavelength,
        }
    }

    /// Largest height or depth.
    pub fn size(&self) -> f64 {
        match self {
            Form::Round { height, .. } | Form::Ridge { height, .. } => height.abs(),
            Form::Waves { amplitude, .. } => amplitude.abs(),
        }
    }

    /// Height and slopes at a place from its own origin.
    pub fn at(&self, [x, y]: [f64; 2]) -> Height {
        let along = |direction: f64| {
            let (sin, cos) = direction.sin_cos();
            (x * cos + y * sin, [cos, sin])
        };
        let (value, slope, direction) = match self {
            Form::Round { radius, height } => {
                let r = x.hypot(y);
                let (value, slope) = hill(r / (REACH * radius));
                let direction = if r > 0.0 { [x / r, y / r] } else { [0.0; 2] };
                (height * value, height * slope / (REACH * radius), direction)
            }
            Form::Ridge {
                half_width,
                height,
                direction,
            } => {
                let (s, direction) = along(*direction);
                let (value, slope) = hill(s.abs() / (REACH * half_width));
                let slope = slope.copysign(-s);
                (
                    height * value,
                    height * slope / (REACH * half_width),
                    direction,
                )
            }
            Form::Waves {
                wavelength,
                amplitude,
                direction,
            } => {
                let (s, direction) = along(*direction);
                let s = s / wavelength;
                let (sin, cos) = (2.0 * PI * s).sin_cos();
                let ahead = s.max(0.0);
                let head = 10.0_f64.powf(-10.0 * ahead * ahead);
                let by_head = -20.0 * std::f64::consts::LN_10 * ahead * head;
                (
                    amplitude * cos * head,
                    amplitude * (cos * by_head - 2.0 * PI * sin * head) / wavelength,
                    direction,
                )
            }
        };
        Height {
            value,
            gradient: direction.map(|d| d * slope),
        }
    }
}

/// cos(½π t) exp(−2 t²) and its slope for t from 0 to 1.
fn hill(t: f64) -> (f64, f64) {
    if t >= 1.0 {
        return (0.0, 0.0);
    }
    let (sin, cos) = (FRAC_PI_2 * t).sin_cos();
    let exp = (-2.0 * t * t).exp();
    (cos * exp, -(FRAC_PI_2 * sin + 4.0 * t * cos) * exp)
}

impl Relief {
    /// What it adds to the gap at a place along the principal directions.
    pub fn at(&self, place: [f64; 2]) -> Height {
        let [x, y] = self.turn.to_motion(place);
        let from = [x - self.place[0] - self.moved, y - self.place[1]];
        let Height { value, gradient } = self.form.at(from);
        Height {
            value: -value,
            gradient: self.turn.to_axes(gradient.map(|slope| -slope)),
        }
    }

    /// Whether it lies within a distance from the centre.
    pub fn is_within(&self, distance: f64) -> bool {
        let x = self.place[0] + self.moved;
        let half = 0.5 * self.form.finest();
        match self.form {
            Form::Round { .. } => x.hypot(self.place[1]) < distance + half,
            Form::Ridge { direction, .. } => {
                let (sin, cos) = direction.sin_cos();
                (x * cos + self.place[1] * sin).abs() < distance + half
            }
            Form::Waves {
                wavelength,
                direction,
                ..
            } => {
                let (sin, cos) = direction.sin_cos();
                x * cos + self.place[1] * sin > -distance - HEAD * wavelength
            }
        }
    }

    /// Whether it reaches a place along and across the motion.
    pub fn covers(&self, [x, y]: [f64; 2]) -> bool {
        let [x, y] = [x - self.place[0] - self.moved, y - self.place[1]];
        let along = |direction: f64| x * direction.cos() + y * direction.sin();
        match self.form {
            Form::Round { radius, .. } => x.hypot(y) < REACH * radius,
            Form::Ridge {
                half_width,
                direction,
                ..
            } => along(direction).abs() < REACH * half_width,
            Form::Waves {
                wavelength,
                direction,
                ..
            } => along(direction) < HEAD * wavelength,
        }
    }

    /// Whether the halves y < 0 and y > 0 are alike.
    pub fn is_symmetric(&self) -> bool {
        match self.form {
            Form::Round { .. } => self.place[1] == 0.0,
            Form::Ridge { direction, .. } => {
                direction == 0.0 || (self.place[1] == 0.0 && direction.cos().abs() < 1e-12)
            }
            Form::Waves { direction, .. } => direction == 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Depth in the middle and at r_0 by hand, cos(75°) e^(−2/1.44); slopes by differences, moved and turned, of all forms.
    #[test]
    fn reliefs_by_hand_and_differences() {
        let dent = Form::Round {
            radius: 0.1,
            height: -0.4,
        };
        assert_relative_eq!(dent.at([0.0, 0.0]).value, -0.4);
        assert_relative_eq!(
            dent.at([0.06, -0.08]).value,
            -0.4 * 0.258_819_045 * 0.249_352_209,
            max_relative = 1e-8
        );
        assert_eq!(dent.at([0.13, 0.0]), Height::default());
        let waves = Form::Waves {
            wavelength: 0.5,
            amplitude: 0.02,
            direction: 0.0,
        };
        assert_relative_eq!(waves.at([-0.75, 0.3]).value, -0.02, max_relative = 1e-12);
        assert!(waves.at([0.5, 0.0]).value < 1e-11);
        let ridge = Form::Ridge {
            half_width: 0.3,
            height: 0.2,
            direction: 0.7,
        };
        for (form, offset) in [
            (dent, [0.05, -0.02]),
            (waves, [-0.3, 0.2]),
            (waves, [0.07, 0.2]),
            (ridge, [-0.1, 0.05]),
            (ridge, [0.15, 0.05]),
        ] {
            let relief = Relief {
                form,
                body: Body::First,
                place: [-1.0, 0.25],
                moved: 0.4,
                turn: Turn::by(0.3),
            };
            let axes = relief.turn.to_axes([-0.6 + offset[0], 0.25 + offset[1]]);
            let own = relief.at(axes);
            assert_relative_eq!(own.value, -form.at(offset).value, max_relative = 1e-9);
            for d in 0..2 {
                let value = |step: f64| {
                    let mut at = axes;
                    at[d] += step;
                    relief.at(at).value
                };
                let difference = (value(1e-6) - value(-1e-6)) / 2e-6;
                assert_relative_eq!(
                    own.gradient[d],
                    difference,
                    max_relative = 1e-5,
                    epsilon = 1e-8
                );
            }
        }
    }

    /// A dent on its way enters and leaves; waves stay once they have come.
    #[test]
    fn arrivals() {
        let at = |form, x: f64| Relief {
            form,
            body: Body::Second,
            place: [x, 0.0],
            moved: 0.0,
            turn: Turn::NONE,
        };
        let dent = Form::Round {
            radius: 0.1,
            height: -1.0,
        };
        let inside = [-1.2, -1.1, 0.0, 1.1, 1.2].map(|x| at(dent, x).is_within(1.0));
        assert_eq!(inside, [false, true, true, true, false]);
        let waves = Form::Waves {
            wavelength: 0.5,
            amplitude: 1.0,
            direction: 0.0,
        };
        let inside = [-1.4, -1.2, 0.0, 9.0].map(|x| at(waves, x).is_within(1.0));
        assert_eq!(inside, [false, true, true, true]);
    }
}
