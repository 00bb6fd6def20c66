//! Shape of a relief.
//!
//! ```text
//!   round: s = d cos(½π r/ρ) exp(−2 (r/ρ)²) within ρ = 1.2 r_0        a dent where d < 0 (Mourier et al. 2006)
//!   ridge: the same over the distance from a line
//!   waves: s = A cos(2π ξ/λ) e(ξ),   e = 10^(−10 (ξ/λ)²) before the first crest, ξ > 0, else 1        (Venner et al. 1997)
//!   map:   s of a cubic spline through the heights of points
//! ```
//! s is the height out of the surface, ξ the distance from the first crest along the direction of the waves; the gap is smaller by s.

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

use super::{Height, HeightMap};
use crate::contact::pose::turned;

/// Form of a relief; lengths in half-widths, heights in a²/R.
#[derive(Clone, Debug, PartialEq)]
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
    /// Heights of points, about their middle.
    Map {
        /// The heights over the plane.
        map: Arc<HeightMap>,
        /// Its unit of length and that of its heights.
        units: [f64; 2],
        /// Its shortest wavelength in its unit of length.
        finest: f64,
        /// Direction of its rows, against the motion, rad.
        direction: f64,
    },
    /// A repeated form.
    Repeated {
        /// The repeated form, not wider than the pitch.
        form: Box<Form>,
        /// Against the motion behind the first one; of ridges across them.
        along: Option<Repeat>,
        /// Across the motion, half of them on either side of the first one; not of ridges.
        across: Option<Repeat>,
    },
}

/// How a form is repeated in a direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Repeat {
    /// From one to the next.
    pub pitch: f64,
    /// Their number; infinitely many if `None`.
    pub count: Option<u32>,
}

impl Repeat {
    /// The place from the nearest one of those that follow each other from 0 to smaller values.
    fn behind(&self, s: f64) -> f64 {
        s + self.pitch * self.within((-s / self.pitch).round())
    }

    /// The same of those about 0.
    fn about(&self, s: f64) -> f64 {
        let Some(count) = self.count else {
            return s - self.pitch * (s / self.pitch).round();
        };
        let first = 0.5 * (f64::from(count) - 1.0);
        s - self.pitch * (self.within((s / self.pitch + first).round()) - first)
    }

    /// Limits an index to the existing repetitions.
    fn within(&self, number: f64) -> f64 {
        let last = self.count.map_or(f64::INFINITY, |n| f64::from(n) - 1.0);
        number.clamp(0.0, last)
    }
}

/// Share of r_0 to which a round or a ridge goes.
const REACH: f64 = 1.2;

/// Distance before the first crest, in wavelengths, where waves are negligible: 10^(−10·0.6²) = 2.5e-4.
const HEAD: f64 = 0.6;

/// Cosine below which a direction is that across the motion.
const ACROSS: f64 = 1e-12;

/// Distance along a direction.
fn along(direction: f64, [x, y]: [f64; 2]) -> (f64, [f64; 2]) {
    let (sin, cos) = direction.sin_cos();
    (x * cos + y * sin, [cos, sin])
}

/// Whether a direction is that across the motion.
fn is_across(direction: f64) -> bool {
    direction.cos().abs() < ACROSS
}

impl Form {
    /// Shortest length over which it rises and falls, in half-widths: a wavelength, the whole width of others.
    pub fn finest(&self) -> f64 {
        match self {
            Form::Round { radius, .. } => 2.0 * REACH * radius,
            Form::Ridge { half_width, .. } => 2.0 * REACH * half_width,
            Form::Waves { wavelength, .. } => *wavelength,
            Form::Map { finest, units, .. } => finest * units[0],
            Form::Repeated { form, .. } => form.finest(),
        }
    }

    /// Largest height or depth.
    pub fn size(&self) -> f64 {
        match self {
            Form::Round { height, .. } | Form::Ridge { height, .. } => height.abs(),
            Form::Waves { amplitude, .. } => amplitude.abs(),
            Form::Map { map, units, .. } => map.largest() * units[1],
            Form::Repeated { form, .. } => form.size(),
        }
    }

    /// The same in other units of length and of height.
    #[must_use]
    pub fn over(&self, length: f64, film: f64) -> Form {
        let repeat = |repeat: &Option<Repeat>| {
            repeat.map(|own| Repeat {
                pitch: own.pitch / length,
                ..own
            })
        };
        match self {
            Form::Round { radius, height } => Form::Round {
                radius: radius / length,
                height: height / film,
            },
            Form::Ridge {
                half_width,
                height,
                direction,
            } => Form::Ridge {
                half_width: half_width / length,
                height: height / film,
                direction: *direction,
            },
            Form::Waves {
                wavelength,
                amplitude,
                direction,
            } => Form::Waves {
                wavelength: wavelength / length,
                amplitude: amplitude / film,
                direction: *direction,
            },
            Form::Map {
                map,
                units,
                finest,
                direction,
            } => Form::Map {
                map: map.clone(),
                units: [units[0] / length, units[1] / film],
                finest: *finest,
                direction: *direction,
            },
            Form::Repeated {
                form,
                along,
                across,
            } => Form::Repeated {
                form: Box::new(form.over(length, film)),
                along: repeat(along),
                across: repeat(across),
            },
        }
    }

    /// Height and slopes at a place from its own origin.
    pub fn at(&self, place: [f64; 2]) -> Height {
        let [x, y] = place;
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
                let (s, direction) = along(*direction, place);
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
                let (s, direction) = along(*direction, place);
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
            Form::Map {
                map,
                units: [length, height],
                direction,
                ..
            } => {
                let Height { value, gradient } =
                    map.at(turned(-*direction, place).map(|x| x / length));
                return Height {
                    value: height * value,
                    gradient: turned(*direction, gradient).map(|slope| slope * height / length),
                };
            }
            Form::Repeated { form, .. } => return form.at(self.relative_to_nearest(place)),
        };
        Height {
            value,
            gradient: direction.map(|d| d * slope),
        }
    }

    /// A place relative to the nearest repetition, for repeated forms.
    fn relative_to_nearest(&self, place: [f64; 2]) -> [f64; 2] {
        let Form::Repeated {
            form,
            along: first,
            across: second,
        } = self
        else {
            return place;
        };
        let [x, y] = place;
        match (&**form, first, second) {
            (Form::Ridge { direction, .. }, Some(repeat), _) => {
                let (s, d) = along(*direction, place);
                let nearest = match is_across(*direction) {
                    true => repeat.about(s),
                    false => repeat.behind(s),
                };
                [x + (nearest - s) * d[0], y + (nearest - s) * d[1]]
            }
            (_, first, second) => [
                first.map_or(x, |repeat| repeat.behind(x)),
                second.map_or(y, |repeat| repeat.about(y)),
            ],
        }
    }

    /// Whether it lies within a distance of the contact's centre with its origin at a place.
    pub(super) fn is_within(&self, place: [f64; 2], distance: f64) -> bool {
        let [x, y] = place;
        let half = 0.5 * self.finest();
        match self {
            Form::Round { .. } => x.hypot(y) < distance + half,
            Form::Ridge { direction, .. } => along(*direction, place).0.abs() < distance + half,
            Form::Waves {
                wavelength,
                direction,
                ..
            } => along(*direction, place).0 > -distance - HEAD * wavelength,
            Form::Map {
                map,
                units,
                direction,
                ..
            } => {
                let centre = turned(-*direction, [-x, -y]);
                let [dx, dy] = [0, 1]
                    .map(|d: usize| (centre[d].abs() - 0.5 * map.sides()[d] * units[0]).max(0.0));
                dx.hypot(dy) < distance
            }
            Form::Repeated { form, .. } => {
                let nearest = self.relative_to_nearest([-x, -y]).map(|x| -x);
                form.is_within(nearest, distance)
            }
        }
    }

    /// Whether it reaches a place from its origin.
    pub(super) fn covers(&self, place: [f64; 2]) -> bool {
        let [x, y] = place;
        match self {
            Form::Round { radius, .. } => x.hypot(y) < REACH * radius,
            Form::Ridge {
                half_width,
                direction,
                ..
            } => along(*direction, place).0.abs() < REACH * half_width,
            Form::Waves {
                wavelength,
                direction,
                ..
            } => along(*direction, place).0 < HEAD * wavelength,
            Form::Map {
                map,
                units,
                direction,
                ..
            } => {
                let own = turned(-*direction, place);
                (0..2).all(|d| own[d].abs() < 0.5 * map.sides()[d] * units[0])
            }
            Form::Repeated { form, .. } => form.covers(self.relative_to_nearest(place)),
        }
    }

    /// Whether the halves y < 0 and y > 0 are alike with its origin at a place.
    pub(super) fn is_symmetric(&self, [x, y]: [f64; 2]) -> bool {
        match self {
            Form::Round { .. } => y == 0.0,
            Form::Ridge { direction, .. } => {
                *direction == 0.0 || (y == 0.0 && is_across(*direction))
            }
            Form::Waves { direction, .. } => *direction == 0.0,
            Form::Map { map, direction, .. } => map.is_profile() && *direction == 0.0,
            Form::Repeated { form, .. } => form.is_symmetric([x, y]),
        }
    }

    /// Whether it is the same all along the motion.
    pub fn is_along_motion(&self) -> bool {
        match self {
            Form::Round { .. } => false,
            Form::Ridge { direction, .. } | Form::Waves { direction, .. } => is_across(*direction),
            Form::Map { map, direction, .. } => map.is_profile() && is_across(*direction),
            Form::Repeated { form, .. } => form.is_along_motion(),
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
