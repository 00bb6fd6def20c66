//! The dry contact of a roller, slice by slice: the start of the film and of the mesh.
//!
//! Theory: Dry contact.

use nalgebra::{DMatrix, DVector};

/// Length of a slice, in half-widths: slices shorter than the contact width do not improve the pressure, and the equation is less accurate for them.
const SLICE: f64 = 0.5;
const FEWEST: f64 = 21.0;
const MOST: f64 = 151.0;
/// Rounds of half-widths, and of slices that lift off.
const ROUNDS: usize = 15;
const LIFTS: usize = 40;
/// Half-width, in that of the line, below which none counts.
pub(super) const NARROWEST: f64 = 0.05;

/// Load per length along a roller, in the mean one w = F/l; y in half-widths b of the line contact under w.
///
/// Each slice carries the Hertz pressure of its load per length q, with the half-width β = √q and the largest pressure √q, in
/// those of the line; heights in b²/R:
///
/// ```text
///   g(y_i) + ¼ Σ_j q_j [asinh((y_i − y_j + ½Δ)/ρ_j) − asinh((y_i − y_j − ½Δ)/ρ_j)] = d  where q_i > 0
///   Σ_j q_j Δ = 2k,   ρ = ½e^(−½) β
/// ```
/// The kernel is the potential of a strip whose mean of ln|x| is that of the Hertz pressure, ln(β/2) − ½; the equation is that of
/// half-spaces on the middle line x = 0 alone.
#[derive(Clone, Debug, PartialEq)]
pub struct Slices {
    half_length: f64,
    width: f64,
    load: Vec<f64>,
}

impl Slices {
    /// Of a roller of half the length k (half-widths) with the height g(y) over the raceway.
    pub fn new(half_length: f64, height: impl Fn(f64) -> f64) -> Slices {
        let n = (2.0 * half_length / SLICE).clamp(FEWEST, MOST) as usize | 1;
        let width = 2.0 * half_length / n as f64;
        let y = |i: usize| (i as f64 + 0.5) * width - half_length;
        let heights: Vec<f64> = (0..n).map(|i| height(y(i))).collect();
        let mut load = vec![1.0; n];
        for _ in 0..ROUNDS {
            let next = balanced(&heights, width, &load);
            // Half-widths are proportional to the root: the mean converges quickly.
            for (old, new) in load.iter_mut().zip(next) {
                *old = 0.5 * (*old + new);
            }
        }
        let load = balanced(&heights, width, &load);
        Slices {
            half_length,
            width,
            load,
        }
    }

    /// Load per length at y, in the mean one.
    pub fn load(&self, y: f64) -> f64 {
        let place = (y + self.half_length) / self.width - 0.5;
        // A load that the end of the roller cuts off continues to there.
        let at = |i: f64| self.load[(i.max(0.0) as usize).min(self.load.len() - 1)];
        let below = place.floor();
        let share = place - below;
        (1.0 - share) * at(below) + share * at(below + 1.0)
    }

    /// Middle and value of each slice.
    pub fn all(&self) -> impl Iterator<Item = [f64; 2]> {
        let first = 0.5 * self.width - self.half_length;
        (self.load.iter().enumerate()).map(move |(i, q)| [first + i as f64 * self.width, *q])
    }
}

/// Loads of slices whose half-widths are those of the loads `before`.
fn balanced(heights: &[f64], width: f64, before: &[f64]) -> Vec<f64> {
    let n = heights.len();
    let kernel = DMatrix::from_fn(n, n, |i, j| {
        let rho = 0.5 * (-0.5_f64).exp() * before[j].max(0.0).sqrt().max(NARROWEST);
        let distance = (i as f64 - j as f64) * width;
        let half = 0.5 * width;
        0.25 * (((distance + half) / rho).asinh() - ((distance - half) / rho).asinh())
    });
    let mut active: Vec<usize> = (0..n).collect();
    let mut load = vec![0.0; n];
    for _ in 0..LIFTS {
        let m = active.len();
        let system = DMatrix::from_fn(m + 1, m + 1, |i, j| match (i < m, j < m) {
            (true, true) => kernel[(active[i], active[j])],
            (true, false) => -1.0,
            (false, true) => width,
            (false, false) => 0.0,
        });
        let right = DVector::from_fn(m + 1, |i, _| match i < m {
            true => -heights[active[i]],
            false => width * n as f64,
        });
        let Some(found) = system.lu().solve(&right) else {
            break;
        };
        load.fill(0.0);
        for (k, i) in active.iter().enumerate() {
            load[*i] = found[k];
        }
        let approach = found[m];
        let depth = |i: usize| {
            let deflection: f64 = (0..n).map(|j| kernel[(i, j)] * load[j].max(0.0)).sum();
            approach - heights[i] - deflection
        };
        let next: Vec<usize> = (0..n)
            .filter(|i| load[*i] > 0.0 || (load[*i] == 0.0 && depth(*i) > 0.0))
            .collect();
        if next.is_empty() || next == active {
            break;
        }
        active = next;
    }
    load.iter().map(|q| q.max(0.0)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::near::near;
    use approx::assert_relative_eq;

    fn sum(slices: &Slices) -> f64 {
        slices.all().map(|[_, q]| q * slices.width).sum()
    }

    /// Lundberg's profile makes the load uniform: ¼ ln{1/[1 − (1 − e^(−½)/(2k))(y/k)²]} in b²/R, away from the ends within 2 %.
    #[test]
    fn lundberg_is_uniform() {
        let k: f64 = 60.0;
        let share = 1.0 - (-0.5_f64).exp() / (2.0 * k);
        let slices = Slices::new(k, |y| -0.25 * (1.0 - share * (y / k).powi(2)).ln());
        assert_relative_eq!(sum(&slices), 2.0 * k, max_relative = 1e-9);
        for [y, q] in slices.all().filter(|[y, _]| y.abs() < 0.9 * k) {
            assert!((q - 1.0).abs() < 0.02, "{y}: {q}");
        }
    }

    /// A slender crown makes a Hertz ellipse, whose load per length falls off like 1 − (y/c)²: its half-length c and the load in the
    /// middle, by the ellipse itself, within 3 %.
    #[test]
    fn a_crown_makes_an_ellipse() {
        use crate::contact::{Contact, Hertz};
        let (radius, modulus) = (0.01, 2.3e11);
        let ellipse = Contact::elliptical([radius, 4000.0 * radius], 5000.0, 0.0);
        let hertz = Hertz::new(&ellipse, modulus);
        let [a, c] = [hertz.half_width, hertz.half_width_y.unwrap()];
        let length = 3.0 * c;
        let line = Hertz::new(&Contact::line(radius, 5000.0 / length), modulus);
        let b = line.half_width;
        // y²/(2R_y) in b²/R
        let slices = Slices::new(0.5 * length / b, |y| 0.5 * y * y / 4000.0);
        let loaded = slices.all().filter(|[_, q]| *q > 0.0);
        let last = loaded.last().unwrap()[0] + 0.5 * slices.width;
        let first = slices.all().find(|[_, q]| *q > 0.0).unwrap()[0] - 0.5 * slices.width;
        assert_relative_eq!(last, c / b, max_relative = 0.03);
        assert_relative_eq!(first, -last, max_relative = 1e-9);
        assert_relative_eq!(slices.load(0.0), (a / b).powi(2), max_relative = 0.03);
        near(slices.load(0.5 * c / b), 0.75 * (a / b).powi(2), 0.03);
    }

    /// A tilt shifts the load towards the end that it presses in, and its mirror image to the other.
    #[test]
    fn a_tilt_shifts_the_load() {
        let k = 40.0_f64;
        let moment = |tilt: f64| {
            let slices = Slices::new(k, |y| 0.5 * y * y / 2000.0 - tilt * y);
            slices.all().map(|[y, q]| y * q * slices.width).sum::<f64>() / sum(&slices)
        };
        assert!(moment(0.005) > 1.0);
        assert_relative_eq!(moment(0.005), -moment(-0.005), max_relative = 1e-6);
        assert!(moment(0.0).abs() < 1e-9);
    }
}
