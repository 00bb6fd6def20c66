//! Pressure zone of the dry contact of a roller, and grading of the mesh along it.

use super::ends::{End, LEAST, ends};
use super::slices::NARROWEST;
use crate::contact::pressure_profile;

/// Largest aspect ratio of a cell along the axis where the profile has a kink,
const FINEST: f64 = 2.0;
/// how fast that grows with the distance from there,
const GROWTH: f64 = 1.5;
/// and how far.
const LONGEST: f64 = 50.0;
/// Distance of knots in such lengths, and the fewest pieces of half the roller.
const KNOT_DISTANCE: f64 = 0.08;
const FEWEST_PIECES: f64 = 80.0;
/// Distance, in half-widths, of places outside all loaded slices.
const OUTSIDE: f64 = 1e3;

/// The zone of a roller in half-widths b of the line contact under the mean load per length.
///
/// Each place along the axis has the half-width √q and the largest pressure √q, with q the load per length there over the mean one.
#[derive(Clone, Debug, PartialEq)]
pub struct RollerZone {
    half_length: f64,
    /// Places along the axis that the mesh resolves.
    kinks: Vec<f64>,
    ends: [End; 2],
    /// Axial places y and their images in the plane of the mesh, rising.
    y: Vec<f64>,
    v: Vec<f64>,
    /// Load per length at each knot, over the mean one, and half-width.
    loads: Vec<f64>,
    widths: Vec<f64>,
}

impl RollerZone {
    /// Of a roller of half the length k with the loads per length of its dry contact, whose proportions count; `kinks` are places along the
    /// axis that the mesh resolves.
    pub fn new(half_length: f64, load: impl Fn(f64) -> f64, kinks: &[f64]) -> RollerZone {
        let ends = ends(half_length, &load);
        RollerZone::between(ends, half_length, load, kinks)
    }

    /// The same with rows and meshes drawn around the ends of other loads per length.
    pub fn graded_around(&self, load: impl Fn(f64) -> f64) -> RollerZone {
        let ends = ends(self.half_length, &load);
        RollerZone::between(ends, self.half_length, |y| self.load(y), &self.kinks)
    }

    fn between(
        ends: [End; 2],
        half_length: f64,
        load: impl Fn(f64) -> f64,
        kinks: &[f64],
    ) -> RollerZone {
        let within = |k: &&f64| (ends[0].y..ends[1].y).contains(*k);
        let features: Vec<(f64, f64)> = (ends.iter().map(|end| (end.y, end.longest_cell())))
            .chain(kinks.iter().filter(within).map(|k| (*k, FINEST)))
            .collect();
        let stretch = |y: f64| {
            let at = |(feature, finest): &(f64, f64)| finest + GROWTH * (y - feature).abs();
            features.iter().map(at).fold(LONGEST, f64::min)
        };
        let y = knots(half_length, &stretch);
        let mut v = vec![0.0];
        for pair in y.windows(2) {
            // Simpson's rule on 1/stretch
            let ends = 1.0 / stretch(pair[0]) + 1.0 / stretch(pair[1]);
            let middle = 4.0 / stretch(0.5 * (pair[0] + pair[1]));
            v.push(v[v.len() - 1] + (pair[1] - pair[0]) / 6.0 * (ends + middle));
        }
        // Half the length in halves: bisection meshes that well.
        let half = 0.5 * v[v.len() - 1];
        let side = (2.0 * half).ceil() / 2.0;
        for v in &mut v {
            *v = (*v - half) * side / half;
        }
        let mut loads: Vec<f64> = y.iter().map(|y| load(*y).max(0.0)).collect();
        let total: f64 = (y.windows(2).zip(loads.windows(2)))
            .map(|(y, q)| 0.5 * (q[0] + q[1]) * (y[1] - y[0]))
            .sum();
        let mean = total / (2.0 * half_length);
        loads.iter_mut().for_each(|q| *q /= mean);
        let widths = loads.iter().map(|q| q.sqrt()).collect();
        let mut zone = RollerZone {
            half_length,
            kinks: kinks.to_vec(),
            ends,
            y,
            v,
            loads,
            widths,
        };
        zone.level_out();
        zone
    }

    /// Makes a map symmetric that differs from its mirror image only by rounding.
    fn level_out(&mut self) {
        let n = self.v.len();
        let alike = (0..n).all(|i| (self.v[i] + self.v[n - 1 - i]).abs() < 1e-9);
        for i in (0..n / 2).filter(|_| alike) {
            self.v[i] = -self.v[n - 1 - i];
            self.y[i] = -self.y[n - 1 - i];
        }
        if alike {
            self.v[n / 2] = 0.0;
        }
    }

    /// Whether y lies at an end of the roller whose edge indents the raceway.
    pub fn is_at_edge(&self, y: f64) -> bool {
        self.ends.iter().any(|end| end.presses_in_at(y))
    }

    /// Half the length of the roller.
    pub fn half_length(&self) -> f64 {
        self.half_length
    }

    /// The end of the roller on the map.
    pub fn side(&self) -> f64 {
        self.v[self.v.len() - 1]
    }

    /// Where y lies in the plane of the mesh.
    pub fn unit(&self, y: f64) -> f64 {
        linear(&self.y, &self.v, y)
    }

    /// The inverse.
    pub fn place(&self, v: f64) -> f64 {
        linear(&self.v, &self.y, v)
    }

    /// dy/dv at y.
    pub fn stretch(&self, y: f64) -> f64 {
        let i = piece(&self.y, y);
        (self.y[i + 1] - self.y[i]) / (self.v[i + 1] - self.v[i])
    }

    /// Load per length at y, over the mean one.
    pub fn load(&self, y: f64) -> f64 {
        linear(&self.y, &self.loads, y).max(0.0)
    }

    /// Largest pressure at y, in p_h of the line.
    pub fn peak(&self, y: f64) -> f64 {
        self.load(y).sqrt()
    }

    /// Distance from the axis over the half-width there.
    pub fn radius(&self, [x, y]: [f64; 2]) -> f64 {
        match self.peak(y) {
            width if width < NARROWEST => OUTSIDE,
            width => x.abs() / width,
        }
    }

    /// Pressure of the dry contact, in p_h of the line.
    pub fn pressure(&self, at: [f64; 2]) -> f64 {
        self.peak(at[1]) * pressure_profile(self.radius(at))
    }

    /// Area of the zone.
    pub fn area(&self) -> f64 {
        let pieces = self.y.windows(2).zip(self.widths.windows(2));
        pieces.map(|(y, w)| (w[0] + w[1]) * (y[1] - y[0])).sum()
    }

    /// Half the extent of the zone along and across the motion.
    pub fn half_extents(&self) -> [f64; 2] {
        let widest = self.widths.iter().fold(0.0_f64, |m, w| m.max(*w));
        let loaded = self.y.iter().zip(&self.loads).filter(|(_, q)| **q > LEAST);
        let farthest = loaded.fold(0.0_f64, |m, (y, _)| m.max(y.abs()));
        [widest, farthest]
    }

    /// Place of the largest pressure of the dry contact.
    pub fn heaviest(&self) -> f64 {
        let most = self.y.iter().zip(&self.loads);
        let most = most.max_by(|a, b| a.1.total_cmp(b.1));
        most.map_or(0.0, |(y, _)| *y)
    }

    /// The rim, a closed line.
    pub fn rim(&self) -> Vec<[f64; 2]> {
        let loaded = || (self.y.iter().zip(&self.widths)).filter(|(_, w)| **w > 0.0);
        let right = loaded().map(|(y, w)| [*w, *y]);
        let left = loaded().rev().map(|(y, w)| [-*w, *y]);
        let mut line: Vec<[f64; 2]> = right.chain(left).collect();
        line.extend(line.first().copied());
        line
    }

    /// Distance from the rim in the plane of the mesh, and whether the point (u, v) lies inside.
    pub fn rim_distance(&self, [u, v]: [f64; 2]) -> (f64, bool) {
        let from = [u.abs(), v];
        let mut nearest = [f64::INFINITY; 2];
        let mut look_at = |a: [f64; 2], b: [f64; 2]| {
            let offset = to_segment(from, a, b);
            if square(offset) < square(nearest) {
                nearest = offset;
            }
            square(nearest)
        };
        // A contact that the end of the roller cuts off is closed by it.
        let mut least = f64::INFINITY;
        for end in [0, self.v.len() - 1] {
            let [width, at] = [self.widths[end], self.v[end]];
            if width > 0.0 {
                least = look_at([0.0, at], [width, at]);
            }
        }
        // Every other knot is enough. Search outwards from the pieces next to the point while one may be nearer than those before:
        // long rollers have thousands.
        let n_pieces = (self.v.len() - 1) / 2;
        let middle = (piece(&self.v, v) / 2).min(n_pieces.saturating_sub(1));
        let mut is_done = |i: usize, knot: usize| {
            let beyond = self.v[knot] - v;
            if (knot == 2 * i) == (beyond > 0.0) && beyond * beyond > least {
                return true;
            }
            let [a, b] = [2 * i, 2 * i + 2].map(|i| [self.widths[i], self.v[i]]);
            if a[0] > 0.0 || b[0] > 0.0 {
                least = look_at(a, b);
            }
            false
        };
        let _ = (middle..n_pieces).any(|i| is_done(i, 2 * i));
        let _ = (0..middle).rev().any(|i| is_done(i, 2 * i + 2));
        let inside = u.abs() < linear(&self.v, &self.widths, v);
        (nearest[0].hypot(nearest[1]), inside)
    }
}

/// Places from one end of a roller to the other, from both ends to the middle, as close as the stretch of the mesh there requires.
fn knots(half_length: f64, stretch: &impl Fn(f64) -> f64) -> Vec<f64> {
    let longest = half_length / FEWEST_PIECES;
    let from = |side: f64| {
        let mut places = vec![side * half_length];
        loop {
            let at = places[places.len() - 1];
            let step = (KNOT_DISTANCE * stretch(at)).min(longest);
            if at.abs() < 1.5 * step {
                return places;
            }
            places.push(at - side * step);
        }
    };
    let (left, right) = (from(-1.0), from(1.0));
    left.into_iter()
        .chain([0.0])
        .chain(right.into_iter().rev())
        .collect()
}

/// From the nearest point of a segment to p.
fn to_segment(p: [f64; 2], a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    let (d, r) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let t = ((r[0] * d[0] + r[1] * d[1]) / square(d).max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
    [r[0] - t * d[0], r[1] - t * d[1]]
}

fn square(d: [f64; 2]) -> f64 {
    d[0] * d[0] + d[1] * d[1]
}

/// The piece of rising knots that contains x; the first and the last extend to infinity.
fn piece(knots: &[f64], x: f64) -> usize {
    let after = knots.partition_point(|k| *k <= x);
    after.clamp(1, knots.len() - 1) - 1
}

fn linear(knots: &[f64], values: &[f64], x: f64) -> f64 {
    let i = piece(knots, x);
    let t = (x - knots[i]) / (knots[i + 1] - knots[i]);
    values[i] + t * (values[i + 1] - values[i])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::roller::Slices;
    use approx::assert_relative_eq;

    fn zone() -> RollerZone {
        let slices = Slices::new(50.0, |y| 0.5 * y * y / 2000.0);
        RollerZone::new(50.0, |y| slices.load(y), &[])
    }

    /// The map and its inverse, symmetric; cells are short at the ends of the contact and long in the middle.
    #[test]
    fn the_map_is_invertible() {
        let zone = zone();
        for i in 0..=100 {
            let y = f64::from(i) - 50.0;
            assert_relative_eq!(zone.place(zone.unit(y)), y, epsilon = 1e-12);
            assert_relative_eq!(zone.unit(-y), -zone.unit(y), epsilon = 1e-13);
        }
        assert_eq!(zone.unit(0.0), 0.0);
        assert_relative_eq!(zone.unit(50.0), zone.side(), max_relative = 1e-14);
        assert_eq!((2.0 * zone.side()).fract(), 0.0);
        let [width, end] = zone.half_extents();
        assert!(zone.peak(0.0) <= width);
        assert!(zone.stretch(0.0) > 10.0 * zone.stretch(end));
    }

    /// The pressure of the zone carries the load, ∫p = πk, and the area is that of the strip of each slice.
    #[test]
    fn the_pressure_carries_the_load() {
        let zone = zone();
        let n = 1500;
        let [dx, dy] = [5.0 / f64::from(n), 100.0 / f64::from(n)];
        let (mut load, mut area) = (0.0, 0.0);
        for i in 0..n {
            for j in 0..n {
                let at = [
                    (f64::from(i) + 0.5) * dx - 2.5,
                    (f64::from(j) + 0.5) * dy - 50.0,
                ];
                load += zone.pressure(at) * dx * dy;
                area += f64::from(u8::from(zone.radius(at) < 1.0)) * dx * dy;
            }
        }
        assert_relative_eq!(load, std::f64::consts::PI * 50.0, max_relative = 2e-3);
        assert_relative_eq!(area, zone.area(), max_relative = 1e-2);
    }

    /// The nearest piece is found without looking at all of them: the same distance as by all, far off the roller and beyond its ends, too.
    #[test]
    fn the_nearest_piece_is_found() {
        let tilted = Slices::new(900.0, |y| 1e-4 * y * y - 0.05 * y);
        for zone in [zone(), RollerZone::new(900.0, |y| tilted.load(y), &[])] {
            let n = zone.v.len();
            let place = |i: usize| [zone.widths[i], zone.v[i]];
            let pieces = (0..n - 2).step_by(2).map(|i| [place(i), place(i + 2)]);
            let pieces = pieces.filter(|[a, b]| a[0] > 0.0 || b[0] > 0.0);
            let ends = [0, n - 1].map(|i| [[0.0, zone.v[i]], place(i)]);
            let ends = ends.into_iter().filter(|[_, b]| b[0] > 0.0);
            let all: Vec<_> = pieces.chain(ends).collect();
            for i in 0..=40 {
                for j in 0..=60 {
                    let v = (f64::from(j) / 25.0 - 1.2) * zone.side();
                    let u = f64::from(i) * 0.15 - 3.0;
                    let distance = |[a, b]: &[[f64; 2]; 2]| {
                        let [x, y] = to_segment([u.abs(), v], *a, *b);
                        x.hypot(y)
                    };
                    let least = all.iter().map(distance).fold(f64::INFINITY, f64::min);
                    let (found, _) = zone.rim_distance([u, v]);
                    assert_relative_eq!(found, least, max_relative = 1e-15);
                }
            }
        }
    }

    /// Distances from the rim: at the middle line half the width, none on the rim.
    #[test]
    fn distances_from_the_rim() {
        let zone = zone();
        let width = zone.peak(0.0);
        let (distance, inside) = zone.rim_distance([0.0, 0.0]);
        assert!(inside);
        assert_relative_eq!(distance, width, max_relative = 0.05);
        let (distance, inside) = zone.rim_distance([-width, 0.0]);
        assert!(!inside && distance < 1e-3);
        let (distance, _) = zone.rim_distance([3.0, 0.0]);
        assert_relative_eq!(distance, 3.0 - width, max_relative = 1e-2);
    }
}
