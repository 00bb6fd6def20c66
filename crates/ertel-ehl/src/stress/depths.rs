//! Depths at which stresses are sampled: dense near the surface, and functions of them.

/// Depths z = D sinh(β t/n)/sinh β, t = 0 … n.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Depths {
    /// The largest, D.
    pub largest: f64,
    /// Number of planes below the surface, n.
    pub planes: usize,
}

/// β: the first plane lies at 0.0024 D of 60.
const DENSER: f64 = 4.0;
/// Steps of the integral between two planes; even.
const STEPS: usize = 8;

impl Depths {
    /// Depth at an index, which need not be whole.
    pub fn at(&self, t: f64) -> f64 {
        self.largest * (DENSER * t / self.planes as f64).sinh() / DENSER.sinh()
    }

    /// The index of a depth.
    pub fn index(&self, z: f64) -> f64 {
        self.planes as f64 / DENSER * (z / self.largest * DENSER.sinh()).asinh()
    }

    /// All depths from the surface on.
    pub fn all(&self) -> Vec<f64> {
        (0..=self.planes).map(|t| self.at(t as f64)).collect()
    }

    /// Half as many planes to the same depth.
    #[must_use]
    pub fn coarser(&self) -> Depths {
        Depths {
            planes: self.planes.div_ceil(2),
            ..*self
        }
    }

    /// ∫ f(z, v) dz from a depth on, with the values `v` at the planes interpolated, by Simpson's rule.
    pub(super) fn integral(&self, from: f64, v: &[f64], f: impl Fn(f64, f64) -> f64) -> f64 {
        let (start, end) = (self.index(from), self.planes as f64);
        if start >= end {
            return 0.0;
        }
        let steps = STEPS * (end - start).ceil() as usize;
        let step = (end - start) / steps as f64;
        let slope = |t: f64| {
            let scale = DENSER / self.planes as f64;
            self.largest * scale * (scale * t).cosh() / DENSER.sinh()
        };
        let weight = |i: usize| match i {
            0 => 1.0,
            i if i == steps => 1.0,
            i => 2.0 + 2.0 * (i % 2) as f64,
        };
        let sum: f64 = (0..=steps)
            .map(|i| {
                let t = start + i as f64 * step;
                weight(i) * slope(t) * f(self.at(t), between(v, t))
            })
            .sum();
        sum * step / 3.0
    }
}

/// Cubic interpolation at an index between values.
pub(super) fn between(v: &[f64], t: f64) -> f64 {
    let n = v.len();
    if n < 4 {
        let i = (t.max(0.0) as usize).min(n.saturating_sub(2));
        return v[i] + (t - i as f64) * (v[i + 1] - v[i]);
    }
    let first = ((t.floor() as i64) - 1).clamp(0, n as i64 - 4) as usize;
    let u = t - first as f64;
    let [a, b, c, d] = [u, u - 1.0, u - 2.0, u - 3.0];
    -b * c * d / 6.0 * v[first] + a * c * d / 2.0 * v[first + 1] - a * b * d / 2.0 * v[first + 2]
        + a * b * c / 6.0 * v[first + 3]
}

/// The largest of equally spaced values and its index, by the parabola through it and its neighbours.
pub(super) fn crest(n: usize, value: impl Fn(usize) -> f64) -> (f64, f64) {
    let largest = (0..n).max_by(|a, b| value(*a).total_cmp(&value(*b)));
    let top = largest.unwrap_or(0);
    let here = value(top);
    if top == 0 || top + 1 >= n {
        return (here, top as f64);
    }
    let (left, right) = (value(top - 1), value(top + 1));
    let bend = left - 2.0 * here + right;
    if bend >= 0.0 {
        return (here, top as f64);
    }
    let shift = (0.5 * (left - right) / bend).clamp(-0.5, 0.5);
    (here - 0.25 * (left - right) * shift, top as f64 + shift)
}

/// The value of sorted places at an index between them.
pub(super) fn place(places: &[f64], t: f64) -> f64 {
    let last = places.len() - 1;
    let i = (t as usize).min(last.saturating_sub(1));
    match last {
        0 => places[0],
        _ => places[i] + (t - i as f64) * (places[i + 1] - places[i]),
    }
}
