//! Quadrature across the film for functions of the shear stress.
//!
//! ```text
//!   t(s) = τ + sG,   −½ ≤ s ≤ ½          stress across the film, linear in s
//!   |t|² = |G|²[(s − s₀)² + s_⊥²],        s₀ = −τ·G/|G|²,  s_⊥ = |τ × G|/|G|²
//! ```
//! A shear-thinning fluidity, as a function of s, has its singularities at |t|² = −κ², κ the stress of
//! its knee: s = s₀ ± iw, w² = s_⊥² + κ²/|G|², and powers of |t| also have a corner at s₀. Gauss points
//! spread evenly over the film would miss both where w is small. The substitution s − s₀ ∝ x², or x³
//! where w is very small, crowds the points there, without a transcendental function.
//!
//! Where the stress nears its limit the film is laid in panels along ξ = |G||s − s₀|, |t|² = ξ² + τ_⊥², from
//! s₀ to each wall (`panels`): the fluidity has a logarithm at the limit, and beyond it grows e-fold
//! over 0.1 % of the limit.
//!
//! Theory: Integration points across the film.

use std::sync::OnceLock;

use ertel_fem::quadrature::Quadrature;

use super::fluidity::Fluidity;
use super::lanes::{Lanes, WIDTH};
use super::stress_scales::{LimitScale, StressScales};

mod panels;

/// Points s and weights; the weights sum to one.
#[derive(Clone, Debug)]
pub struct CrossFilm {
    points: [[f64; 2]; CAPACITY],
    n: usize,
    /// s₀ and w of the points laid, if they were laid around a knee.
    around: Option<[f64; 2]>,
    /// Number of points, if they were laid evenly.
    even: Option<usize>,
    /// The law at each point, and the number of points where it is known.
    factors: [f64; CAPACITY],
    n_factors: usize,
}

/// Most points of one Gauss rule.
const LONGEST: usize = 40;
/// Most points of a rule: five panels on each side of s₀ at most, of which two are long.
const CAPACITY: usize = 6 * LONGEST;

impl Default for CrossFilm {
    fn default() -> CrossFilm {
        CrossFilm {
            points: [[0.0; 2]; CAPACITY],
            n: 0,
            around: None,
            even: None,
            factors: [1.0; CAPACITY],
            n_factors: 0,
        }
    }
}

const _: () = assert!(CAPACITY.is_multiple_of(WIDTH));

/// Shift of s₀, in w, and change of w, relative, up to which points may stay where they are.
const STALE: f64 = 0.1;

/// Distance of the wall stress to the limit, over the pressure stress, below which panels are used.
const NEAR_LIMIT: f64 = 0.25;
/// Stress difference across the film, over the stress of an e-fold beyond the limit, that any rule resolves.
const NEGLIGIBLE: f64 = 1e-2;

impl CrossFilm {
    /// (s, weight) of each point.
    pub fn points(&self) -> &[[f64; 2]] {
        &self.points[..self.n]
    }

    /// Lays the points for mid-plane stress τ and pressure stress G.
    #[inline(always)]
    pub fn lay(&mut self, scales: &StressScales, mid_stress: [f64; 2], pressure_stress: [f64; 2]) {
        self.clear();
        self.place(scales, mid_stress, pressure_stress);
    }

    /// No points.
    fn clear(&mut self) {
        self.n = 0;
        self.n_factors = 0;
        self.around = None;
        self.even = None;
    }

    /// Factors of a law at the points, unless the last ones are still valid.
    #[inline(always)]
    pub(super) fn fill_in(&mut self, law: &impl Fluidity) {
        if self.n_factors == self.n {
            return;
        }
        let points = self.points[..self.n].chunks(WIDTH);
        for (values, points) in self.factors.chunks_mut(WIDTH).zip(points) {
            let mut s = Lanes::default();
            for (s, [point, _]) in s.0.iter_mut().zip(points) {
                *s = *point;
            }
            values.copy_from_slice(&law.factors(s).0);
        }
        self.n_factors = self.n;
    }

    /// The factors last filled in.
    pub fn factors(&self) -> &[f64] {
        &self.factors[..self.n_factors]
    }

    /// The same for another mid-plane stress: points that still serve stay.
    #[inline(always)]
    pub fn move_to(
        &mut self,
        scales: &StressScales,
        mid_stress: [f64; 2],
        pressure_stress: [f64; 2],
    ) {
        self.place(scales, mid_stress, pressure_stress);
    }

    #[inline(always)]
    fn place(&mut self, scales: &StressScales, mid_stress: [f64; 2], pressure_stress: [f64; 2]) {
        let [tx, ty] = mid_stress;
        let [gx, gy] = pressure_stress;
        let square = |x: f64, y: f64| x * x + y * y;
        let (gg, tt) = (square(gx, gy), square(tx, ty));
        let mut extra = 0;
        if let Some(variation) = scales.variation {
            // a power series across the film, and its exponential
            extra += 6 + variation.min(1e3) as usize;
        }
        if let Some(growth) = scales.growth {
            // e^{ks} on an interval of length 1
            extra += (0.7 * gg.sqrt() / growth).min(1e3) as usize;
        }
        if let Some(limit) = scales.limit {
            // The limit lies at a distance of (τ_L − |t|)/|G| beyond the walls.
            let g = gg.sqrt();
            let room = limit.joint - tt.sqrt() - 0.5 * g;
            if room < NEAR_LIMIT * g && g > NEGLIGIBLE * limit.fold {
                self.lay_panels(scales, &limit, mid_stress, pressure_stress);
                return;
            }
            extra += (6.0 / (room / g.max(1e-30)).max(NEAR_LIMIT).sqrt()) as usize;
        }
        let matters = |k: &f64| gg > 0.04 * (k * k + tt) || (tt < 0.25 * gg && gg > 1e-6 * k * k);
        let Some(knee) = scales.knee.filter(matters) else {
            let n = 6 + extra;
            if self.even != Some(n) {
                self.clear();
                self.even = Some(n);
                self.interval(n, -0.5, 0.5, |s| (s, 1.0));
            }
            return;
        };
        let centre = -(tx * gx + ty * gy) / gg;
        let across = (tx * gy - ty * gx) / gg;
        let width = (across * across + knee * knee / gg).sqrt();
        let serves =
            |[c, w]: [f64; 2]| (centre - c).abs() < STALE * w && (width - w).abs() < STALE * w;
        if self.around.is_some_and(serves) {
            return;
        }
        self.clear();
        self.around = Some([centre, width]);
        let ends = [-0.5 - centre, 0.5 - centre];
        if ends[0] < 0.0 && ends[1] > 0.0 {
            for end in ends {
                self.fan(centre, end, 0.0, width, extra);
            }
        } else {
            let (near, far) = if ends[0] >= 0.0 {
                (ends[0], ends[1])
            } else {
                (ends[1], ends[0])
            };
            self.fan(centre, far, near / far, width, extra);
        }
    }

    /// Points from s₀ + `share`·`end` to s₀ + `end`, crowding towards s₀.
    #[inline(always)]
    fn fan(&mut self, centre: f64, end: f64, share: f64, width: f64, extra: usize) {
        // Numbers of points for 1e-10, measured on laws with exponents 0.3 to 1.
        let length = end.abs() / width;
        let full = 3.4 * (1.0 + length).ln();
        if length < 50.0 {
            let from = share.sqrt();
            let n = 10 + (full * (1.0 - from)) as usize + extra;
            self.interval(n, from, 1.0, |x| {
                (centre + end * x * x, 2.0 * end.abs() * x)
            });
        } else {
            let from = share.cbrt();
            let n = 10 + (full * (1.0 - from)) as usize + extra;
            self.interval(n, from, 1.0, |x| {
                (centre + end * x * x * x, 3.0 * end.abs() * x * x)
            });
        }
    }

    /// Gauss points between two ends, mapped to s with the slope of the map.
    #[inline(always)]
    fn interval(&mut self, n: usize, from: f64, to: f64, map: impl Fn(f64) -> (f64, f64)) {
        for [x, w] in gauss(n.clamp(1, LONGEST)) {
            let (s, slope) = map(from + (to - from) * x);
            self.points[self.n] = [s, w * (to - from) * slope];
            self.n += 1;
        }
    }
}

/// Gauss rule of `n` points on [0, 1].
fn gauss(n: usize) -> &'static [[f64; 2]] {
    static RULES: OnceLock<Vec<Vec<[f64; 2]>>> = OnceLock::new();
    &RULES.get_or_init(|| {
        (1..=LONGEST)
            .map(|n| {
                let rule = Quadrature::simplex(1, 2 * n - 1);
                let points = rule.points.iter().zip(&rule.weights);
                points.map(|(x, w)| [x[0], *w]).collect()
            })
            .collect()
    })[n - 1]
}

#[cfg(test)]
mod tests;
