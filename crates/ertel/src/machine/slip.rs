//! Friction of a ball by differential slip and spin: ball and groove touch on a curved surface, of which only two lines roll, and turn against each other about its normal.
//!
//! ```text
//!   Δu = (u (c y² − s) − ω y, ω x),  c = 1/(2 R_d R_x)     surfaces apart from their mean u; s: slip in the middle; ω: difference of the spins
//!   τ f(τ², p) = μ(p) |Δu|/h                               law of the lubricant, f its relative fluidity; τ points along Δu
//!   ∫ τ_x dA = 0                                           the ball turns freely: for s
//!   P = ∫ τ |Δu| dA
//! ```
//! over the dry (Hertz) ellipse with its pressure p and the central film h. Film and pressure are those without this slip, which changes them little.
//! Sources: Heathcote, Proc. Inst. Automob. Eng. 15 (1921) 569-702; Harris and Kotzalas 2007, chapter 9.

use std::f64::consts::FRAC_PI_2;

/// Input of the differential slip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Slip {
    /// Semi-axes along and across the motion, m.
    pub half_widths: [f64; 2],
    /// Largest pressure of the dry contact, Pa.
    pub hertz_pressure: f64,
    /// Central film, m.
    pub film: f64,
    /// Mean speed u of both surfaces, m/s.
    pub speed: f64,
    /// c, 1/m².
    pub curvature: f64,
    /// ω, rad/s.
    pub spin: f64,
}

/// Points along each direction of a quarter of the ellipse: 32 differ from them by 1.2e-3 of the power under a limiting stress.
const POINTS: usize = 48;

/// Most steps for s, and its relative error: the power is stationary in s.
const STEPS: usize = 60;
const ROOT_TOLERANCE: f64 = 1e-9;

/// Result of the differential slip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SlipFriction {
    /// P, W.
    pub power: f64,
    /// ∫|τ| dA over the load.
    pub mean_traction: f64,
}

impl Slip {
    /// For a lubricant whose shear stress (Pa) follows from pressure (Pa) and shear rate (1/s).
    pub fn friction(&self, stress: impl Fn(f64, f64) -> f64) -> SlipFriction {
        let [a, b] = self.half_widths;
        let points = self.points();
        // Without spin both halves across are alike.
        let sides: &[f64] = if self.spin == 0.0 {
            &[1.0]
        } else {
            &[-1.0, 1.0]
        };
        let share = 1.0 / sides.len() as f64;
        let sums = |slip: f64| {
            let mut sums = [0.0; 3];
            for ([x, y], p, area) in &points {
                for side in sides {
                    let y = side * y;
                    let along = self.speed * (self.curvature * y * y - slip) - self.spin * y;
                    let speed = along.hypot(self.spin * x);
                    let pull = stress(*p, speed / self.film) * area * share;
                    sums[0] += if speed > 0.0 {
                        pull * (along / speed)
                    } else {
                        0.0
                    };
                    sums[1] += pull * speed;
                    sums[2] += pull;
                }
            }
            sums
        };
        // Spin moves the slip in the middle beyond that of the curved surface by less than its speed at the ends of the ellipse.
        let by_spin = self.spin.abs() * a.max(b) / self.speed;
        let bracket = [-by_spin, self.curvature * b * b + by_spin];
        let slip = falling_root(bracket, |s| sums(s)[0]);
        let [_, power, size] = sums(slip);
        let load = points.iter().map(|(_, p, area)| p * area).sum::<f64>();
        SlipFriction {
            power,
            mean_traction: size / load,
        }
    }

    /// Points of a quarter of the ellipse with their pressure, and the area that each of them represents.
    fn points(&self) -> Vec<([f64; 2], f64, f64)> {
        let [a, b] = self.half_widths;
        let step = FRAC_PI_2 / POINTS as f64;
        // y = b sin t, x = a cos t sin q: smooth up to the edge, p = p_h cos t cos q.
        let mut points = Vec::with_capacity(POINTS * POINTS);
        for i in 0..POINTS {
            let t = (i as f64 + 0.5) * step;
            for j in 0..POINTS {
                let q = (j as f64 + 0.5) * step;
                let area = 4.0 * a * b * t.cos().powi(2) * q.cos() * step * step;
                let at = [a * t.cos() * q.sin(), b * t.sin()];
                points.push((at, self.hertz_pressure * t.cos() * q.cos(), area));
            }
        }
        points
    }
}

/// Root of a falling function between two arguments by false position, the value of an end that stays halved (Illinois; Dowell and Jarratt, BIT 11 (1971) 168), and by
/// bisection where the bracket keeps more than half of its width.
fn falling_root([mut low, mut high]: [f64; 2], f: impl Fn(f64) -> f64) -> f64 {
    let [mut above, mut below] = [f(low), f(high)];
    let tolerance = ROOT_TOLERANCE * (high - low);
    if above <= 0.0 {
        return low;
    }
    if below >= 0.0 {
        return high;
    }
    let mut bisects = false;
    for _ in 0..STEPS {
        let width = high - low;
        let share = if bisects {
            0.5
        } else {
            above / (above - below)
        };
        let next = low + share * width;
        let value = f(next);
        if value > 0.0 {
            (low, above) = (next, value);
            below *= 0.5;
        } else if value < 0.0 {
            (high, below) = (next, value);
            above *= 0.5;
        } else {
            return next;
        }
        if high - low < tolerance {
            break;
        }
        bisects = high - low > 0.5 * width;
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use std::f64::consts::PI;

    const SLIP: Slip = Slip {
        half_widths: [0.1e-3, 1.2e-3],
        hertz_pressure: 2e9,
        film: 0.3e-6,
        speed: 3.0,
        curvature: 2.7e4,
        spin: 0.0,
    };

    /// Constant viscosity: ⟨y²⟩ = b²/4 and ⟨y⁴⟩ = b⁴/8 over an ellipse give s = c b²/4 and P = π μ u² c² a b⁵/(16 h).
    #[test]
    fn constant_viscosity() {
        let [a, b] = SLIP.half_widths;
        let (u, c, h) = (SLIP.speed, SLIP.curvature, SLIP.film);
        let power = SLIP.friction(|_, rate| 0.02 * rate).power;
        let expected = PI * 0.02 * (u * c).powi(2) * a * b.powi(5) / (16.0 * h);
        assert_relative_eq!(power, expected, max_relative = 1e-3);
    }

    /// The same stress τ everywhere: half of the area lies within |y| < η b, asin η + η√(1 − η²) = π/4, η = 0.403973, and
    /// P = τ u c ∫|y² − η²b²| dA = 4 τ u c a b³ ∫₀¹ |y² − η²| √(1 − y²) dy.
    #[test]
    fn constant_stress() {
        let [a, b] = SLIP.half_widths;
        let found = SLIP.friction(|_, _| 40e6);
        let power = found.power;
        // τ πab over ⅔ p_h πab
        assert_relative_eq!(found.mean_traction, 60e6 / 2e9, max_relative = 1e-3);
        let within = |n: usize| {
            // ∫_0^1 |y² − η²| √(1 − y²) dy by Simpson's rule in y = sin t.
            let f = |t: f64| (t.sin().powi(2) - 0.403_973_f64.powi(2)).abs() * t.cos().powi(2);
            let h = FRAC_PI_2 / n as f64;
            (0..n)
                .map(|i| {
                    let t = i as f64 * h;
                    h / 6.0 * (f(t) + 4.0 * f(t + 0.5 * h) + f(t + h))
                })
                .sum::<f64>()
        };
        let expected = 4.0 * 40e6 * SLIP.speed * SLIP.curvature * a * b.powi(3) * within(4000);
        assert_relative_eq!(power, expected, max_relative = 5e-3);
    }

    /// Spin alone, by hand: constant viscosity, ⟨x² + y²⟩ = (a² + b²)/4, P = π μ ω² a b (a² + b²)/(4 h). Both: their powers add up, as ⟨x²y⟩ and ⟨y³⟩ vanish.
    /// One stress τ on a circle: P = 2π τ ω a³/3.
    #[test]
    fn spin() {
        let [a, b] = SLIP.half_widths;
        let turning = Slip {
            spin: -200.0,
            ..SLIP
        };
        let power = |slip: &Slip| slip.friction(|_, rate| 0.02 * rate).power;
        let alone = Slip {
            curvature: 0.0,
            ..turning
        };
        let expected = PI * 0.02 * 200.0 * 200.0 * a * b * (a * a + b * b) / (4.0 * SLIP.film);
        assert_relative_eq!(power(&alone), expected, max_relative = 1e-3);
        assert_relative_eq!(
            power(&turning),
            power(&alone) + power(&SLIP),
            max_relative = 1e-6
        );
        let circle = Slip {
            half_widths: [a, a],
            ..alone
        };
        let found = circle.friction(|_, _| 40e6).power;
        assert_relative_eq!(
            found,
            2.0 * PI / 3.0 * 40e6 * 200.0 * a.powi(3),
            max_relative = 1e-3
        );
    }

    /// Coulomb friction of 0.056 by slip, by spin and by both, in W; computed outside, with midpoints of 400 × 400 parts of the whole ellipse and bisection for s.
    #[test]
    fn coulomb_friction() {
        let contact = Slip {
            half_widths: [0.15e-3, 1.39e-3],
            hertz_pressure: 2.29e9,
            speed: 1.16,
            curvature: 2.69e4,
            ..SLIP
        };
        for (curvature, spin, expected) in [
            (contact.curvature, 0.0, 0.544_040),
            (0.0, 34.86, 1.036_073),
            (contact.curvature, 34.86, 1.047_150),
        ] {
            let slip = Slip {
                curvature,
                spin,
                ..contact
            };
            let found = slip.friction(|pressure, _| 0.056 * pressure);
            assert_relative_eq!(found.power, expected, max_relative = 2e-3);
            assert_relative_eq!(found.mean_traction, 0.056, max_relative = 1e-12);
        }
    }

    /// cos x falls through π/2; a step function ends at its step; ends that are roots are returned.
    #[test]
    fn roots_of_falling_functions() {
        assert_relative_eq!(
            falling_root([0.0, 3.0], f64::cos),
            FRAC_PI_2,
            max_relative = 1e-8
        );
        let step = falling_root([0.0, 1.0], |x| if x < 0.7 { 1.0 } else { -1e-3 });
        assert_relative_eq!(step, 0.7, max_relative = 1e-8);
        assert_eq!(falling_root([0.0, 1.0], |x| -x), 0.0);
        assert_eq!(falling_root([0.0, 1.0], |x| 1.0 - x), 1.0);
    }
}
