//! The pressure of rigid parabolas far from where they are closest, with its rupture.
//!
//! ```text
//!   P = λ f(φ)/ρ³,  H = ½ρ²,  ρ² = x² + κy², φ the angle of (x, √κ y)
//!   (s² + κc²) f')' − ((6 + 3κ)c² + (6κ + 3)s²) f = 8(ū_x c + √κ ū_y s),  f ≥ 0        c = cos φ, s = sin φ
//! ```
//! Reynolds' equation for this P, with Reynolds' condition where the film breaks. Before that f is nearly −4 c·X/ρ of [`far_field`](crate::engine::far_field);
//! behind the line c·X = 0, where that ends, there is pressure for another 18° around a sphere: tan ψ = −3 tanh 3ψ, ψ = 108.4° from the inlet.

use std::f64::consts::PI;

use crate::contact::Gap;

/// Angles at which f is known: 0.25° apart, by which the load is exact to 1e-5.
const ANGLES: usize = 1440;

/// f around a gap.
#[derive(Clone, Debug, PartialEq)]
pub struct FarPressure {
    gap: Gap,
    f: Vec<f64>,
}

/// A pressure over λ and its slopes along and across the motion.
#[derive(Clone, Copy, Debug)]
pub struct PressureThere {
    /// P/λ.
    pub value: f64,
    /// Its slopes.
    pub gradient: [f64; 2],
}

/// The angles before and after one.
fn neighbours(n: usize) -> (usize, usize) {
    ((n + ANGLES - 1) % ANGLES, (n + 1) % ANGLES)
}

/// f where there is pressure, by elimination from an angle without pressure on; `own` holds the factor of f and the drag.
fn pressures(own: &[[f64; 2]], side: &[f64], full: &[bool], f: &mut [f64]) {
    let start = full.iter().position(|full| !full).unwrap_or(0);
    let around = |n: usize| (start + n) % ANGLES;
    // f_n = value + factor f_(n+1).
    let mut rows = vec![[0.0; 2]; ANGLES];
    for n in (0..ANGLES).map(around).filter(|n| full[*n]) {
        let (before, _) = neighbours(n);
        let ([mass, drag], (low, high)) = (own[n], (side[before], side[n]));
        let pivot = mass + low + high - low * rows[before][1];
        rows[n] = [(drag + low * rows[before][0]) / pivot, high / pivot];
    }
    for n in (0..ANGLES).rev().map(around) {
        let (_, after) = neighbours(n);
        f[n] = match full[n] {
            true => rows[n][0] + rows[n][1] * f[after],
            false => 0.0,
        };
    }
}

impl FarPressure {
    /// Around a gap whose surfaces entrain along the motion. Pressure is solved for where the gap closes, then also wherever what flows in would
    /// raise it above zero: f grows from one set to the next, and ends at the only solution.
    pub fn new(gap: &Gap) -> FarPressure {
        let step = 2.0 * PI / ANGLES as f64;
        let kappa = gap.curvature_ratio;
        let [along, across] = gap.turn.to_axes([1.0, 0.0]);
        let angle = |n: f64| (n * step).sin_cos();
        let side: Vec<f64> = (0..ANGLES)
            .map(|n| {
                let (s, c) = angle(n as f64 + 0.5);
                (s * s + kappa * c * c) / (step * step)
            })
            .collect();
        let own: Vec<[f64; 2]> = (0..ANGLES)
            .map(|n| {
                let (s, c) = angle(n as f64);
                [
                    (6.0 + 3.0 * kappa) * c * c + (6.0 * kappa + 3.0) * s * s,
                    -8.0 * (along * c + kappa.sqrt() * across * s),
                ]
            })
            .collect();
        let mut full: Vec<bool> = own.iter().map(|[_, drag]| *drag > 0.0).collect();
        let mut f = vec![0.0_f64; ANGLES];
        loop {
            pressures(&own, &side, &full, &mut f);
            let fills = |n: usize| {
                let (before, after) = neighbours(n);
                own[n][1] + side[before] * f[before] + side[n] * f[after] > 0.0
            };
            let more: Vec<usize> = (0..ANGLES).filter(|n| !full[*n] && fills(*n)).collect();
            if more.is_empty() {
                break;
            }
            more.into_iter().for_each(|n| full[n] = true);
        }
        FarPressure {
            gap: gap.clone(),
            f,
        }
    }

    /// Between parabolas of the height `film` with these slopes at a place: λfρ/4H².
    pub fn at(&self, place: [f64; 2], film: f64, slopes: [f64; 2]) -> PressureThere {
        let root = self.gap.curvature_ratio.sqrt();
        let [x, y] = self.gap.turn.to_axes(place);
        let y = root * y;
        let rho = x.hypot(y);
        let (c, s) = (x / rho, y / rho);
        let step = 2.0 * PI / ANGLES as f64;
        let at = y.atan2(x).rem_euclid(2.0 * PI) / step;
        let n = at as usize % ANGLES;
        let [a, b] = [self.f[n], self.f[(n + 1) % ANGLES]];
        let (f, by_angle) = (a + (at - at.floor()) * (b - a), (b - a) / step);
        let squared = film * film;
        let value = 0.25 * f * rho / squared;
        let driven =
            (self.gap.turn).to_motion([f * c - by_angle * s, root * (f * s + by_angle * c)]);
        PressureThere {
            value,
            gradient: [0, 1]
                .map(|i: usize| 0.25 * driven[i] / squared - 2.0 * value * slopes[i] / film),
        }
    }
}

/// The contact area between the edges of a grid and its own.
#[derive(Clone, Debug, PartialEq)]
pub struct Beyond {
    pub(super) lambda: f64,
    pub(super) far: FarPressure,
    /// Boxes of the grid and of the contact area, in the plane in which the zone is the unit circle.
    pub(super) boxes: [[[f64; 2]; 2]; 2],
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::Turn;
    use approx::assert_relative_eq;

    /// Around a sphere f = −0.8 cos φ + b cosh 3ψ, ψ = π − φ, up to tan ψ = −3 tanh 3ψ by hand: ψ = 1.89253, where f = f' = 0.
    #[test]
    fn sphere_by_hand() {
        let psi = 1.892_53_f64;
        assert_relative_eq!(psi.tan(), -3.0 * (3.0 * psi).tanh(), max_relative = 1e-4);
        let b = -0.8 * psi.cos() / (3.0 * psi).cosh();
        let far = FarPressure::new(&Gap::paraboloid(1.0));
        for angle in [0.0, 0.5, 1.2, 1.6, 1.8, 1.88] {
            let hand = 0.8 * f64::cos(angle) + b * f64::cosh(3.0 * angle);
            let (s, c) = f64::sin_cos(PI - angle);
            let found = far.at([10.0 * c, 10.0 * s], 50.0, [0.0; 2]).value * 1000.0;
            assert_relative_eq!(found, hand, epsilon = 1e-4);
        }
        for angle in [1.91, 2.5, PI] {
            let (s, c) = f64::sin_cos(PI - angle);
            assert_eq!(far.at([10.0 * c, 10.0 * s], 50.0, [0.0; 2]).value, 0.0);
        }
    }

    /// Reynolds' equation at an angle to the axes of an ellipse, by differences, at places with pressure.
    #[test]
    fn ellipse_satisfies_the_equation() {
        let gap = Gap {
            turn: Turn::by(0.6),
            ..Gap::paraboloid(0.2)
        };
        let far = FarPressure::new(&gap);
        let at = |place: [f64; 2]| far.at(place, gap.value(place), gap.at(place).gradient);
        // H³∇P as P falls with the cube of the distance.
        let flow = |place: [f64; 2], i: usize| gap.value(place).powi(3) * at(place).gradient[i];
        let e = 0.5;
        for place in [[-20.0, 5.0], [-15.0, -30.0], [-15.0, 20.0]] {
            assert!(at(place).value > 0.0, "{place:?}");
            let mut divergence = 0.0;
            for i in 0..2 {
                let moved = |sign: f64| {
                    let mut place = place;
                    place[i] += sign * e;
                    flow(place, i)
                };
                divergence += (moved(1.0) - moved(-1.0)) / (2.0 * e);
            }
            let drag = gap.at(place).gradient[0];
            assert_relative_eq!(divergence, drag, epsilon = 0.02 * place[0].hypot(place[1]));
        }
    }
}
