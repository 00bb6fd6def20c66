//! Quadrature across the film for functions of the shear stress.
//!
//! ```text
//!   t(s) = τ + sG,   −½ ≤ s ≤ ½          stress across the film, linear in s
//!   |t|² = |G|²[(s − s₀)² + s_⊥²],        s₀ = −τ·G/|G|²,  s_⊥ = |τ × G|/|G|²
//! ```
//! A shear-thinning fluidity, as a function of s, has its singularities at |t|² = −κ², κ the stress of
//! its knee: s = s₀ ± iw, w² = s_⊥² + κ²/|G|². Where w is small against the film, Gauss points would miss
//! the knee. The substitution s = s₀ + w sinh u moves the singularities to u = ± iπ/2, whatever the
//! state, and Gauss's rule in u converges at a rate that depends on the length of the interval alone.

use std::sync::OnceLock;

use ertel_fem::quadrature::Quadrature;

/// Stresses, in one unit with τ and G, that the quadrature must resolve.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StressScales {
    /// κ, beyond which the fluid thins by a power law.
    pub knee: Option<f64>,
    /// Stress by which the fluidity grows exponentially.
    pub growth: Option<f64>,
    /// Stress that the fluid cannot pass.
    pub limit: Option<f64>,
}

/// Points s and weights; the weights sum to one.
#[derive(Clone, Debug)]
pub struct CrossFilm {
    points: [[f64; 2]; CAPACITY],
    n: usize,
    /// s₀ and w of the points laid, if they were laid around a knee.
    around: Option<[f64; 2]>,
}

/// Most points of one Gauss rule.
const LONGEST: usize = 40;
/// Most points of a rule: two intervals.
const CAPACITY: usize = 2 * LONGEST;

impl Default for CrossFilm {
    fn default() -> CrossFilm {
        CrossFilm {
            points: [[0.0; 2]; CAPACITY],
            n: 0,
            around: None,
        }
    }
}

/// Shift of s₀, in w, and change of w, relative, up to which points may stay where they are.
const STALE: f64 = 0.1;

impl CrossFilm {
    /// (s, weight) of each point.
    pub fn points(&self) -> &[[f64; 2]] {
        &self.points[..self.n]
    }

    /// Lays the points for mid-plane stress τ and pressure stress G.
    pub fn lay(&mut self, scales: &StressScales, mid_stress: [f64; 2], pressure_stress: [f64; 2]) {
        self.around = None;
        self.place(scales, mid_stress, pressure_stress);
    }

    /// The same for another mid-plane stress: points that still serve stay.
    pub fn move_to(
        &mut self,
        scales: &StressScales,
        mid_stress: [f64; 2],
        pressure_stress: [f64; 2],
    ) {
        self.place(scales, mid_stress, pressure_stress);
    }

    fn place(&mut self, scales: &StressScales, mid_stress: [f64; 2], pressure_stress: [f64; 2]) {
        let [tx, ty] = mid_stress;
        let [gx, gy] = pressure_stress;
        let g = gx.hypot(gy);
        let t = tx.hypot(ty);
        let mut n = 6;
        if let Some(growth) = scales.growth {
            // e^{ks} on an interval of length 1
            n += (0.7 * g / growth).min(1e3) as usize;
        }
        if let Some(limit) = scales.limit {
            // The limit lies at a distance of (τ_L − |t|)/|G| beyond the walls.
            let room = ((limit - t - 0.5 * g) / g.max(1e-30)).max(0.02);
            n += (6.0 / room.sqrt()).min(1e3) as usize;
        }
        let n = n.min(LONGEST);
        let matters = |k: &f64| g > 0.2 * k.hypot(t) || (t < 0.5 * g && g > 1e-3 * k);
        let Some(knee) = scales.knee.filter(matters) else {
            self.n = 0;
            self.around = None;
            self.interval(n, -0.5, 0.5, |s| (s, 1.0));
            return;
        };
        let centre = -(tx * gx + ty * gy) / (g * g);
        let width = ((tx * gy - ty * gx) / (g * g)).hypot(knee / g);
        let serves =
            |[c, w]: [f64; 2]| (centre - c).abs() < STALE * w && (width - w).abs() < STALE * w;
        if self.around.is_some_and(serves) {
            return;
        }
        self.n = 0;
        self.around = Some([centre, width]);
        let ends = [-0.5, 0.5].map(|s: f64| ((s - centre) / width).asinh());
        // sinh and cosh: absolute errors, not relative ones, matter here
        let map = |u: f64| {
            let grown = 0.5 * u.exp();
            let shrunk = 0.25 / grown;
            (centre + width * (grown - shrunk), width * (grown + shrunk))
        };
        let points = |n: usize, length: f64| (n + (3.2 * length) as usize).min(LONGEST);
        if ends[0] < 0.0 && ends[1] > 0.0 {
            // Powers of |t| have a corner where the stress passes zero: points crowd there, u = Uv².
            for end in ends {
                self.interval(points(n + 4, end.abs()), 0.0, 1.0, |v| {
                    let (s, slope) = map(end * v * v);
                    (s, slope * 2.0 * end.abs() * v)
                });
            }
        } else {
            let length = ends[1] - ends[0];
            self.interval(points(n, length), ends[0], ends[1], map);
        }
    }

    /// Gauss points between two ends, mapped to s with the slope of the map.
    fn interval(&mut self, n: usize, from: f64, to: f64, map: impl Fn(f64) -> (f64, f64)) {
        for [x, w] in gauss(n) {
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
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// ∫ ds/(|t|² + κ²) along the x axis is [atan(t/κ)]/(κG): knees a thousand times thinner than the
    /// film, in its middle, off it, beyond a wall.
    #[test]
    fn resolves_a_knee_wherever_it_lies() {
        let mut rule = CrossFilm::default();
        for g in [1e-6, 0.1, 1.0, 3.0, 100.0, 2000.0] {
            for tau in [0.0, 0.3, 0.49 * g, 0.6 * g, 50.0] {
                for knee in [0.1, 1.0] {
                    let scales = StressScales {
                        knee: Some(knee),
                        ..StressScales::default()
                    };
                    rule.lay(&scales, [tau, 0.0], [g, 0.0]);
                    let sum: f64 = (rule.points().iter())
                        .map(|[s, w]| w / ((tau + s * g).powi(2) + knee * knee))
                        .sum();
                    let (low, high) = ((tau - 0.5 * g) / knee, (tau + 0.5 * g) / knee);
                    // atan(b) − atan(a), without cancellation
                    let angle = (g / knee).atan2(1.0 + high * low);
                    assert_relative_eq!(sum, angle / (knee * g), max_relative = 1e-10);
                }
            }
        }
    }

    /// ∫ e^{kt} ds = sinh(kG/2)/(kG/2) for a stress that grows exponentially.
    #[test]
    fn resolves_exponential_growth() {
        let mut rule = CrossFilm::default();
        for g in [0.01, 1.0, 10.0, 40.0] {
            let scales = StressScales {
                growth: Some(1.0),
                ..StressScales::default()
            };
            rule.lay(&scales, [0.0; 2], [g, 0.0]);
            let sum: f64 = rule.points().iter().map(|[s, w]| w * (s * g).exp()).sum();
            assert_relative_eq!(sum, (0.5 * g).sinh() / (0.5 * g), max_relative = 1e-10);
        }
    }
}
