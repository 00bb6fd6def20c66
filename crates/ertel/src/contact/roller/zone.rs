//! Where the dry contact of a roller carries pressure, and how a mesh is drawn out along it.

use super::Slices;
use super::slices::NARROWEST;
use crate::contact::hertz;

/// How long a cell may be along the axis that would be as long as wide, at the ends of the contact and where the profile has a kink,
const FINEST: f64 = 2.0;
/// how fast that grows with the distance from there,
const GROWTH: f64 = 1.5;
/// and how far.
const LONGEST: f64 = 50.0;
/// Knots of the map.
const KNOTS: usize = 400;
/// Distance, in half-widths, of places outside of all that is loaded.
const OUTSIDE: f64 = 1e3;

/// The zone of a roller in half-widths b of the line contact under the mean load per length.
#[derive(Clone, Debug, PartialEq)]
pub struct RollerZone {
    slices: Slices,
    half_length: f64,
    /// Axial places y and what they become in the plane where the mesh is made, rising.
    y: Vec<f64>,
    v: Vec<f64>,
    /// Half-width at each knot.
    widths: Vec<f64>,
}

impl RollerZone {
    /// Of a roller of half the length k with its dry contact; `kinks` are places along the axis that the mesh looks at.
    pub fn new(half_length: f64, slices: Slices, kinks: &[f64]) -> RollerZone {
        let [first, last] = slices.loaded();
        let mut features = vec![first, last];
        features.extend(kinks.iter().filter(|y| (first..last).contains(*y)));
        let stretch = |y: f64| {
            let nearest = (features.iter().map(|f| (y - f).abs())).fold(f64::INFINITY, f64::min);
            (FINEST + GROWTH * nearest).min(LONGEST)
        };
        let y: Vec<f64> = (0..=KNOTS)
            .map(|i| half_length * (i as f64 - 0.5 * KNOTS as f64) / (0.5 * KNOTS as f64))
            .collect();
        let mut v = vec![0.0];
        for pair in y.windows(2) {
            // Simpson's rule on 1/stretch
            let ends = 1.0 / stretch(pair[0]) + 1.0 / stretch(pair[1]);
            let middle = 4.0 / stretch(0.5 * (pair[0] + pair[1]));
            v.push(v[v.len() - 1] + (pair[1] - pair[0]) / 6.0 * (ends + middle));
        }
        // Half the length in halves: bisection meshes that well.
        let half = 0.5 * v[KNOTS];
        let side = (2.0 * half).ceil() / 2.0;
        for v in &mut v {
            *v = (*v - half) * side / half;
        }
        let widths = y.iter().map(|y| slices.load(*y).sqrt()).collect();
        let mut zone = RollerZone {
            slices,
            half_length,
            y,
            v,
            widths,
        };
        zone.level_out();
        zone
    }

    /// The same, with the same map along the axis, for other loads per length; only their proportions count.
    pub fn with_loads(&self, load: impl Fn(f64) -> f64) -> RollerZone {
        let slices = self.slices.with_loads(load);
        RollerZone {
            widths: self.y.iter().map(|y| slices.load(*y).sqrt()).collect(),
            slices,
            ..self.clone()
        }
    }

    /// Makes a map that differs from its mirror image by rounding alone equal to it.
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

    /// Half the length of the roller.
    pub fn half_length(&self) -> f64 {
        self.half_length
    }

    /// What the end of the roller becomes.
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

    /// Largest pressure at y, in p_h of the line.
    pub fn peak(&self, y: f64) -> f64 {
        self.slices.load(y).sqrt()
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
        self.peak(at[1]) * hertz::pressure_profile(self.radius(at))
    }

    /// Area of the zone.
    pub fn area(&self) -> f64 {
        let widths = self.slices.all().map(|[_, q]| 2.0 * q.sqrt());
        widths.sum::<f64>() * self.slices.width()
    }

    /// Half the extent of the zone along and across the motion.
    pub fn half_extents(&self) -> [f64; 2] {
        let [first, last] = self.slices.loaded();
        let widest = self.widths.iter().fold(0.0_f64, |m, w| m.max(*w));
        [widest, last.max(-first).min(self.half_length)]
    }

    /// Where the dry contact carries most.
    pub fn heaviest(&self) -> f64 {
        let most = self.slices.all().max_by(|a, b| a[1].total_cmp(&b[1]));
        most.map_or(0.0, |[y, _]| y)
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
        let mut least = f64::INFINITY;
        let points = || self.v.iter().zip(&self.widths);
        // Every other knot will do.
        for (a, b) in points().step_by(2).zip(points().step_by(2).skip(1)) {
            if *a.1 == 0.0 && *b.1 == 0.0 {
                continue;
            }
            least = least.min(to_segment([u.abs(), v], [*a.1, *a.0], [*b.1, *b.0]));
        }
        // A contact that the end of the roller cuts off is closed by it.
        for end in [0, self.v.len() - 1] {
            let [width, at] = [self.widths[end], self.v[end]];
            if width > 0.0 {
                least = least.min(to_segment([u.abs(), v], [0.0, at], [width, at]));
            }
        }
        let inside = u.abs() < linear(&self.v, &self.widths, v);
        (least, inside)
    }
}

/// Distance of a point from a segment.
fn to_segment(p: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    let (d, r) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let square = d[0] * d[0] + d[1] * d[1];
    let t = ((r[0] * d[0] + r[1] * d[1]) / square.max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
    (r[0] - t * d[0]).hypot(r[1] - t * d[1])
}

/// Which piece of rising knots holds x; the first and the last go on beyond.
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
    use approx::assert_relative_eq;

    fn zone() -> RollerZone {
        let slices = Slices::new(50.0, |y| 0.5 * y * y / 2000.0);
        RollerZone::new(50.0, slices, &[])
    }

    /// The map and its inverse, symmetric to the last bit; cells are short at the ends of the contact and long in the middle.
    #[test]
    fn the_map_is_invertible() {
        let zone = zone();
        for i in 0..=100 {
            let y = f64::from(i) - 50.0;
            assert_relative_eq!(zone.place(zone.unit(y)), y, epsilon = 1e-12);
            assert_eq!(zone.unit(-y), -zone.unit(y));
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
