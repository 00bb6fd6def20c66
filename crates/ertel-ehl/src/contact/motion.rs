//! The motion of both surfaces: translation along and across the entrainment, and spin about the contact normal.
//!
//! ```text
//!   ū(x, y) = u_m e_x + ω̄ e_z × r          mean velocity, ω̄ = (ω_1 + ω_2)/2,   e_z × r = (−y, x)
//!   Δu(x, y) = u_2 − u_1 = u_m (S e_x + S_⊥ e_y) + (ω_2 − ω_1) e_z × r          sliding, S the slide-to-roll ratio
//!   u_1 = ū − Δu/2,   u_2 = ū + Δu/2        body 1 is the plane, body 2 the ball
//! ```
//! x lies along the mean velocity at the centre. Both fields are free of divergence. For spin in ball bearings: Harris and
//! Kotzalas, Advanced Concepts of Bearing Technology (2006), chapter 2.

use serde::Serialize;

/// Motion of the two surfaces.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Motion {
    /// Entrainment speed u_m, the mean of both surfaces at the centre, m/s.
    pub entrainment_speed: f64,
    /// Slide-to-roll ratio (u_2 − u_1)/u_m along the entrainment.
    pub slide_to_roll_ratio: f64,
    /// The same across the entrainment, (v_2 − v_1)/u_m.
    #[serde(skip_serializing_if = "is_zero")]
    pub slide_to_roll_ratio_across: f64,
    /// Angular velocities of body 1 and body 2 about the contact normal, from x towards y, rad/s.
    #[serde(skip_serializing_if = "are_zero")]
    pub spin: [f64; 2],
}

fn is_zero(value: &f64) -> bool {
    *value == 0.0
}

fn are_zero(values: &[f64; 2]) -> bool {
    *values == [0.0; 2]
}

/// Slide-to-roll ratio, and angle in rad, that count as zero: a million times the rounding error, a thousandth of a relevant value.
pub const ROUNDING: f64 = 1e-12;

impl Motion {
    /// Both surfaces along the entrainment, at its speed (m/s) with a slide-to-roll ratio.
    pub fn straight(entrainment_speed: f64, slide_to_roll_ratio: f64) -> Motion {
        Motion {
            entrainment_speed,
            slide_to_roll_ratio,
            slide_to_roll_ratio_across: 0.0,
            spin: [0.0; 2],
        }
    }

    /// Speed of the surface of body 2 along the entrainment at the centre, m/s.
    pub fn body_2_speed(&self) -> f64 {
        self.entrainment_speed * (1.0 + 0.5 * self.slide_to_roll_ratio)
    }

    /// Speed of the surface of body 1 along the entrainment at the centre, m/s.
    pub fn body_1_speed(&self) -> f64 {
        self.entrainment_speed * (1.0 - 0.5 * self.slide_to_roll_ratio)
    }

    /// The same with sliding and spin set to zero where they are only rounding errors, as at the pitch point of gears: pure rolling
    /// is solved and reported as such.
    pub fn without_rounding(self) -> Motion {
        let ratio = |s: f64| if s.abs() < ROUNDING { 0.0 } else { s };
        // A spin is judged by its sliding one millimetre from the centre.
        let spin = |w: f64| match (1e-3 * w).abs() < ROUNDING * self.entrainment_speed.abs() {
            true => 0.0,
            false => w,
        };
        Motion {
            slide_to_roll_ratio: ratio(self.slide_to_roll_ratio),
            slide_to_roll_ratio_across: ratio(self.slide_to_roll_ratio_across),
            spin: self.spin.map(spin),
            ..self
        }
    }

    /// Whether the surfaces move along the entrainment alone, everywhere.
    pub fn is_straight(&self) -> bool {
        self.slide_to_roll_ratio_across == 0.0 && self.spin == [0.0; 2]
    }

    /// Whether the surfaces slide anywhere.
    pub fn slides(&self) -> bool {
        self.sliding_at_centre() != 0.0 || self.spin[0] != self.spin[1]
    }

    /// Size of the sliding velocity at the centre over the entrainment speed.
    pub fn sliding_at_centre(&self) -> f64 {
        if self.slide_to_roll_ratio_across == 0.0 {
            return self.slide_to_roll_ratio.abs();
        }
        self.slide_to_roll_ratio
            .hypot(self.slide_to_roll_ratio_across)
    }

    /// Mean velocity of both surfaces over the entrainment speed, at places in units of a length (m).
    pub fn entrainment(&self, length: f64) -> Planar {
        let [first, second] = self.spin;
        Planar {
            centre: [1.0, 0.0],
            spin: 0.5 * (first + second) * length / self.entrainment_speed,
        }
    }

    /// Velocity of body 2 less that of body 1, likewise.
    pub fn sliding(&self, length: f64) -> Planar {
        let [first, second] = self.spin;
        Planar {
            centre: [self.slide_to_roll_ratio, self.slide_to_roll_ratio_across],
            spin: (second - first) * length / self.entrainment_speed,
        }
    }

    /// Velocities of body 1 and body 2, m/s, at places in units of a length (m).
    pub fn surfaces(&self, length: f64) -> [Planar; 2] {
        let across = 0.5 * self.entrainment_speed * self.slide_to_roll_ratio_across;
        let [first, second] = self.spin.map(|w| w * length);
        [
            Planar {
                centre: [self.body_1_speed(), -across],
                spin: first,
            },
            Planar {
                centre: [self.body_2_speed(), across],
                spin: second,
            },
        ]
    }
}

/// A rigid motion in the plane: v(X, Y) = v_0 + ω(−Y, X), in the units of its creator.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Planar {
    /// Velocity at the centre.
    pub centre: [f64; 2],
    /// Angular velocity, from X towards Y.
    pub spin: f64,
}

impl Planar {
    /// Along x everywhere.
    pub const fn along_x(velocity: f64) -> Planar {
        Planar {
            centre: [velocity, 0.0],
            spin: 0.0,
        }
    }

    /// Velocity at a point.
    #[inline(always)]
    pub fn at(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        if self.spin == 0.0 {
            return self.centre;
        }
        [
            self.centre[0] - self.spin * y,
            self.centre[1] + self.spin * x,
        ]
    }

    /// A factor on all of it.
    #[must_use]
    pub fn map(&self, f: impl Fn(f64) -> f64) -> Planar {
        Planar {
            centre: self.centre.map(&f),
            spin: f(self.spin),
        }
    }

    /// Times a factor.
    #[must_use]
    pub fn times(&self, factor: f64) -> Planar {
        self.map(|v| factor * v)
    }

    /// The sum of two.
    #[must_use]
    pub fn plus(&self, other: &Planar) -> Planar {
        Planar {
            centre: [0, 1].map(|i: usize| self.centre[i] + other.centre[i]),
            spin: self.spin + other.spin,
        }
    }

    /// Whether nothing moves anywhere.
    pub fn is_zero(&self) -> bool {
        *self == Planar::default()
    }

    /// Whether it moves along x alone, everywhere.
    pub fn is_along_x(&self) -> bool {
        self.centre[1] == 0.0 && self.spin == 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// A rolling ball that spins: velocities at a point by hand.
    #[test]
    fn bodies_move_by_translation_and_spin() {
        let motion = Motion {
            entrainment_speed: 2.0,
            slide_to_roll_ratio: 0.1,
            slide_to_roll_ratio_across: -0.04,
            spin: [100.0, 300.0],
        };
        let [first, second] = motion.surfaces(1e-3);
        // At x = 0.5 mm, y = 2 mm: ω × r = ω(−2 mm, 0.5 mm); u_m(1 ∓ 0.05) along, ±0.04 m/s across.
        let at = [0.5, 2.0];
        let expected = [
            [1.9 - 100.0 * 2e-3, 0.04 + 100.0 * 0.5e-3],
            [2.1 - 300.0 * 2e-3, -0.04 + 300.0 * 0.5e-3],
        ];
        for (body, expected) in [first, second].iter().zip(expected) {
            let velocity = body.at(at);
            assert_relative_eq!(velocity[0], expected[0], max_relative = 1e-14);
            assert_relative_eq!(velocity[1], expected[1], max_relative = 1e-14);
        }
        let [mean, sliding] = [motion.entrainment(1e-3), motion.sliding(1e-3)].map(|v| v.at(at));
        for i in 0..2 {
            let [one, two] = [0, 1].map(|b: usize| 0.5 * expected[b][i]);
            assert_relative_eq!(mean[i], 0.5 * (one + two), max_relative = 1e-14);
            assert_relative_eq!(sliding[i], two - one, max_relative = 1e-13);
        }
    }
}
