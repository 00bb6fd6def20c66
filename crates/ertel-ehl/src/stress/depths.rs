//! Depths at which stresses are sampled: dense near the surface, and functions of them.

use crate::layers::Plane;

/// Depths z = D sinh(β t/n)/sinh β, t = 0 … n; layers and the substrate have their own steps of t, from interface to interface with both sides of each.
#[derive(Clone, Debug, PartialEq)]
pub struct Depths {
    /// The largest, D.
    pub largest: f64,
    /// Number of planes below the surface of a body without layers, n.
    pub planes: usize,
    /// The parts of the body down to the largest depth.
    parts: Vec<Part>,
}

/// Planes of a layer or of the substrate.
#[derive(Clone, Debug, PartialEq)]
struct Part {
    /// t at its upper and at its lower side.
    ends: [f64; 2],
    /// Number of steps between them.
    steps: usize,
    /// Index of the first plane.
    first: usize,
}

impl Part {
    fn planes(&self) -> std::ops::RangeInclusive<usize> {
        self.first..=self.first + self.steps
    }

    /// Change of t over that of the index.
    fn step(&self) -> f64 {
        (self.ends[1] - self.ends[0]) / self.steps as f64
    }
}

/// β: the first plane lies at 0.0024 D of 60.
const DENSER: f64 = 4.0;
/// Steps of the integral between two planes; even.
const STEPS: usize = 8;
/// Least steps of a part.
const LEAST: usize = 8;
/// Share of the largest depth that is no part: an interface there is the end.
const NO_PART: f64 = 1e-9;

impl Depths {
    /// Of a body without layers.
    pub fn new(largest: f64, planes: usize) -> Depths {
        Depths::with_interfaces(largest, planes, &[])
    }

    /// Of a body with interfaces at ascending depths.
    pub fn with_interfaces(largest: f64, planes: usize, interfaces: &[f64]) -> Depths {
        let mut depths = Depths {
            largest,
            planes,
            parts: Vec::new(),
        };
        let above = |z: &&f64| **z < (1.0 - NO_PART) * largest;
        let mut ends = vec![0.0];
        ends.extend(interfaces.iter().take_while(above).map(|z| depths.t(*z)));
        ends.push(planes as f64);
        let mut first = 0;
        for pair in ends.windows(2) {
            let steps = ((pair[1] - pair[0]).ceil() as usize).max(LEAST);
            depths.parts.push(Part {
                ends: [pair[0], pair[1]],
                steps,
                first,
            });
            first += steps + 1;
        }
        depths
    }

    fn z(&self, t: f64) -> f64 {
        self.largest * (DENSER * t / self.planes as f64).sinh() / DENSER.sinh()
    }

    fn t(&self, z: f64) -> f64 {
        self.planes as f64 / DENSER * (z / self.largest * DENSER.sinh()).asinh()
    }

    /// The part of an index of planes, and whether the plane is its lower side (`true`), its upper side (`false`) or neither.
    pub fn part(&self, index: f64) -> (usize, Option<bool>) {
        let above = |p: &Part| index > (p.first + p.steps) as f64;
        let found = self.parts.partition_point(above).min(self.parts.len() - 1);
        let nearest = index.round() as usize;
        let side = match &self.parts[found] {
            part if nearest == part.first + part.steps => Some(true),
            part if nearest == part.first => Some(false),
            _ => None,
        };
        (found, side)
    }

    /// Depth at an index of planes, which need not be whole within a part.
    pub fn at(&self, index: f64) -> f64 {
        let part = &self.parts[self.part(index).0];
        self.z(part.ends[0] + (index - part.first as f64) * part.step())
    }

    /// The planes from the surface on.
    pub fn all(&self) -> Vec<Plane> {
        let planes = self.parts.iter().enumerate().flat_map(|(i, part)| {
            part.planes().map(move |index| Plane {
                depth: self.at(index as f64),
                part: i,
            })
        });
        planes.collect()
    }

    /// Their depths.
    pub fn values(&self) -> Vec<f64> {
        self.all().into_iter().map(|plane| plane.depth).collect()
    }

    /// Number of parts: of the layers that begin above the largest depth, and the substrate.
    pub fn n_parts(&self) -> usize {
        self.parts.len()
    }

    /// The index of the lowest plane of a part.
    pub fn last_of(&self, part: usize) -> usize {
        *self.parts[part].planes().end()
    }

    /// Half as many planes to the same depth.
    #[must_use]
    pub fn coarser(&self) -> Depths {
        let mut first = 0;
        let halved = |part: &Part| {
            let steps = part.steps.div_ceil(2);
            let own = Part {
                steps,
                first,
                ..part.clone()
            };
            first += steps + 1;
            own
        };
        Depths {
            parts: self.parts.iter().map(halved).collect(),
            ..*self
        }
    }

    /// The largest value of the planes from a depth on and its index, by parabolas within each part.
    pub fn largest(&self, from: f64, value: impl Fn(usize) -> f64) -> (f64, f64) {
        let mut found = (f64::NEG_INFINITY, 0.0);
        for part in &self.parts {
            let own = self.largest_of(part, from, &value);
            if own.0 > found.0 {
                found = own;
            }
        }
        found
    }

    /// The largest value of the planes down to a depth, and its index.
    pub fn largest_above(&self, to: f64, value: impl Fn(usize) -> f64) -> (f64, f64) {
        let planes = self.values().into_iter().enumerate();
        let near = planes.filter(|(_, depth)| *depth <= to);
        let found = near.map(|(i, _)| (value(i), i as f64));
        found.fold(
            (f64::NEG_INFINITY, 0.0),
            |m, v| if v.0 > m.0 { v } else { m },
        )
    }

    /// The largest value of the planes of a part and its index, by a parabola.
    pub fn largest_in(&self, part: usize, value: impl Fn(usize) -> f64) -> (f64, f64) {
        self.largest_of(&self.parts[part], 0.0, &value)
    }

    fn largest_of(&self, part: &Part, from: f64, value: impl Fn(usize) -> f64) -> (f64, f64) {
        let skipped = ((self.t(from) - part.ends[0]) / part.step()).ceil();
        let skipped = skipped.max(0.0) as usize;
        // The last plane of all is always there.
        let skipped = match part.ends[1] < self.planes as f64 {
            true if skipped > part.steps => return (f64::NEG_INFINITY, 0.0),
            _ => skipped.min(part.steps),
        };
        let first = part.first + skipped;
        let (value, t) = crest(part.steps - skipped + 1, |i| value(first + i));
        (value, first as f64 + t)
    }

    /// The value at a depth of a function with these values at the planes.
    pub(super) fn value(&self, depth: f64, v: &[f64]) -> f64 {
        let t = self.t(depth);
        let within = |part: &&Part| t <= part.ends[1];
        let part = self.parts.iter().find(within);
        let part = part.unwrap_or(&self.parts[self.parts.len() - 1]);
        between(&v[part.planes()], (t - part.ends[0]) / part.step())
    }

    /// ∫ f(z, v) dz from a depth on, with the values `v` at the planes interpolated, by Simpson's rule.
    pub(super) fn integral(&self, from: f64, v: &[f64], f: impl Fn(f64, f64) -> f64) -> f64 {
        let of_part = |part: &Part| {
            let start = ((self.t(from) - part.ends[0]) / part.step()).max(0.0);
            let end = part.steps as f64;
            if start >= end {
                return 0.0;
            }
            let steps = STEPS * (end - start).ceil() as usize;
            let step = (end - start) / steps as f64;
            let slope = |t: f64| {
                let scale = DENSER / self.planes as f64;
                self.largest * scale * part.step() * (scale * t).cosh() / DENSER.sinh()
            };
            let weight = |i: usize| match i {
                0 => 1.0,
                i if i == steps => 1.0,
                i => 2.0 + 2.0 * (i % 2) as f64,
            };
            let own = &v[part.planes()];
            let sum: f64 = (0..=steps)
                .map(|i| {
                    let index = start + i as f64 * step;
                    let t = part.ends[0] + index * part.step();
                    weight(i) * slope(t) * f(self.z(t), between(own, index))
                })
                .sum();
            sum * step / 3.0
        };
        self.parts.iter().map(of_part).sum()
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
