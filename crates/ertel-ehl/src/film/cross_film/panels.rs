//! Points across a film whose stress nears or passes its limit.
//!
//! ```text
//!   ξ = |G||s − s₀|,  |t|² = ξ² + τ_⊥²       on either side of s₀, ξ from the least stress to the wall
//!   |t| < r₁τ_L    logarithm at |t| = τ_L: ξ_L − ξ = eᵛ, Gauss points in v
//!   |t| > r₁τ_L    e-folds beyond the limit, counted back from the largest stress in the film
//! ```

use ertel_rheology::shear::StressLimit;

use super::{CrossFilm, LimitScale, StressScales};

/// One side of the film, from its least stress to a wall.
struct Side {
    /// Direction of s along the growing stress.
    sign: f64,
    /// |G|.
    gradient: f64,
    /// |τ_⊥|, stress across G.
    across: f64,
    /// ξ at the least stress and at the wall.
    ends: [f64; 2],
}

impl Side {
    /// ξ where the stress has a given size, within the side.
    fn where_stress_is(&self, size: f64) -> f64 {
        let square = (size - self.across) * (size + self.across);
        square.max(0.0).sqrt().clamp(self.ends[0], self.ends[1])
    }

    fn stress(&self, xi: f64) -> f64 {
        xi.hypot(self.across)
    }
}

/// E-folds below the largest shear rate with full accuracy, and with reduced accuracy.
const UPPER_FOLDS: f64 = 12.0;
const LOWER_FOLDS: f64 = 36.0;
/// Points where the fluidity is too small to count.
const TOKEN: usize = 6;

impl CrossFilm {
    /// Lays the points for a stress near or beyond the limit.
    pub(super) fn lay_panels(
        &mut self,
        scales: &StressScales,
        limit: &LimitScale,
        mid_stress: [f64; 2],
        pressure_stress: [f64; 2],
    ) {
        let [tx, ty] = mid_stress;
        let [gx, gy] = pressure_stress;
        let gradient = gx.hypot(gy);
        let across = ((tx * gy - ty * gx) / gradient).abs();
        // ξ with its sign at mid-plane.
        let middle = (tx * gx + ty * gy) / gradient;
        let walls = [middle - 0.5 * gradient, middle + 0.5 * gradient];
        let largest = walls[0].abs().max(walls[1].abs()).hypot(across);
        self.clear();
        for (sign, wall) in [(-1.0, -walls[0]), (1.0, walls[1])] {
            if wall > 0.0 {
                let least = (wall - gradient).max(0.0);
                let side = Side {
                    sign,
                    gradient,
                    across,
                    ends: [least, wall],
                };
                self.lay_side(scales, limit, largest, &side);
            }
        }
    }

    fn lay_side(&mut self, scales: &StressScales, limit: &LimitScale, largest: f64, side: &Side) {
        let (fold, joint) = (limit.fold, limit.joint);
        let start = side.ends[0];
        // Points for what else grows exponentially.
        let growing = |from: f64, to: f64| {
            scales
                .growth
                .map_or(0.0, |g| 0.7 * (side.stress(to) - side.stress(from)) / g)
        };
        // Growth ends where the law levels off.
        let end = joint + StressLimit::MOST_FOLDS * fold;
        let largest = largest.min(end);
        let counts = largest - LOWER_FOLDS * fold;
        let xi_joint = side.where_stress_is(joint);
        if xi_joint > start {
            let token = counts > joint;
            // Half way to the limit the law's own scale is resolved, from there on the limit.
            let stress = limit.stress;
            let singular = ((stress - side.across) * (stress + side.across)).sqrt();
            let half = (0.5 * singular).clamp(start, xi_joint);
            if half > start {
                let knee = scales.knee.map(|k| k.hypot(side.across));
                let n = if token { TOKEN } else { 12 } + growing(start, half).min(1e3) as usize;
                self.crowded(side, [start, half], knee, n);
            }
            if xi_joint > half {
                let [far, near] = [half, xi_joint].map(|xi| (singular - xi).ln());
                let n = match token {
                    true => TOKEN as f64,
                    false => 10.0 + 2.0 * (far - near) + growing(half, xi_joint),
                };
                self.panel(side, n as usize, [far, near], |v| {
                    let distance = v.exp();
                    (singular - distance, -distance)
                });
            }
        }
        let upper = largest - UPPER_FOLDS * fold;
        let panels = [
            (counts, 0.0),
            (upper, 0.5),
            (end, 1.0),
            (f64::INFINITY, 0.0),
        ];
        let mut from = xi_joint;
        for (stress, accuracy) in panels {
            let to = side.where_stress_is(stress.max(side.across));
            if to > from {
                let folds = (side.stress(to) - side.stress(from)) / fold;
                let n = match accuracy > 0.0 {
                    true => 6.0 + 0.7 * accuracy * folds + growing(from, to),
                    false => TOKEN as f64,
                };
                self.panel(side, n as usize, [from, to], |xi| (xi, 1.0));
                from = to;
            }
        }
    }

    /// Points that crowd towards ξ = 0 if the law has its knee there.
    fn crowded(&mut self, side: &Side, [from, to]: [f64; 2], width: Option<f64>, n: usize) {
        let Some(width) = width.filter(|w| to > 0.2 * w) else {
            self.panel(side, n, [from, to], |xi| (xi, 1.0));
            return;
        };
        let length = to / width;
        let more = 3.4 * (1.0 + length).ln();
        if length < 50.0 {
            let [low, high] = [from, to].map(f64::sqrt);
            let n = n + (more * (1.0 - low / high)).min(1e3) as usize;
            self.panel(side, n, [low, high], |x| (x * x, 2.0 * x));
        } else {
            let [low, high] = [from, to].map(f64::cbrt);
            let n = n + (more * (1.0 - low / high)).min(1e3) as usize;
            self.panel(side, n, [low, high], |x| (x * x * x, 3.0 * x * x));
        }
    }

    /// Gauss points between two ends of a variable that maps to ξ, with the slope of the map.
    fn panel(
        &mut self,
        side: &Side,
        n: usize,
        [from, to]: [f64; 2],
        map: impl Fn(f64) -> (f64, f64),
    ) {
        let [_, wall] = side.ends;
        self.interval(n, from, to, |x| {
            let (xi, slope) = map(x);
            let s = side.sign * (0.5 - (wall - xi) / side.gradient);
            (s, slope / side.gradient)
        });
    }
}
