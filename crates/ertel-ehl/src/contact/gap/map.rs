//! Heights of points over a plane as a surface with continuous slopes and curvatures.
//!
//! ```text
//!   s(x, y) = Σ_ij c_ij B(x/Δx − i) B(y/Δy − j),        B the cubic B-spline, s = h at the points
//! ```
//! c_ij = 0 beyond the points, so that s falls to zero within two distances of them; heights that are zero along the rim give no step
//! there. De Boor, A Practical Guide to Splines, 2001, ch. IX and XVII.

use super::Height;

/// A cubic spline through heights, about the middle of the points. One row is a profile: the same at all y.
#[derive(Clone, Debug, PartialEq)]
pub struct HeightMap {
    counts: [usize; 2],
    spacing: [f64; 2],
    /// c_ij with zeros all around, row by row.
    coefficients: Vec<f64>,
    largest: f64,
}

/// Zeros about the coefficients.
const RIM: usize = 3;

impl HeightMap {
    /// Through the heights of `counts[1]` rows of `counts[0]` points each.
    ///
    /// # Panics
    /// Unless there are as many heights, two in a row at least, and distances that are positive.
    pub fn new(counts: [usize; 2], spacing: [f64; 2], heights: &[f64]) -> HeightMap {
        let [nx, ny] = counts;
        assert!(nx > 1 && ny > 0 && heights.len() == nx * ny);
        assert!(spacing.iter().all(|d| *d > 0.0));
        let mut own = heights.to_vec();
        for row in own.chunks_exact_mut(nx) {
            coefficients(row);
        }
        let margin = if ny > 1 { RIM } else { 0 };
        let width = nx + 2 * RIM;
        let mut padded = vec![0.0; width * (ny + 2 * margin)];
        if ny > 1 {
            let mut column = vec![0.0; ny];
            for i in 0..nx {
                (column.iter_mut().enumerate()).for_each(|(j, c)| *c = own[j * nx + i]);
                coefficients(&mut column);
                (column.iter().enumerate()).for_each(|(j, c)| own[j * nx + i] = *c);
            }
        }
        for (j, row) in own.chunks_exact(nx).enumerate() {
            let start = (j + margin) * width + RIM;
            padded[start..start + nx].copy_from_slice(row);
        }
        HeightMap {
            counts,
            spacing,
            coefficients: padded,
            largest: heights.iter().fold(0.0, |m: f64, h| m.max(h.abs())),
        }
    }

    /// Whether it is the same at all y.
    pub fn is_profile(&self) -> bool {
        self.counts[1] == 1
    }

    /// Lengths of its sides; without end along a profile.
    pub fn sides(&self) -> [f64; 2] {
        let [x, y] = [0, 1].map(|d: usize| (self.counts[d] - 1) as f64 * self.spacing[d]);
        [x, if self.is_profile() { f64::INFINITY } else { y }]
    }

    /// Largest height or depth at the points.
    pub fn largest(&self) -> f64 {
        self.largest
    }

    /// Volume under all of it; under a profile, area. Each spline has that of a cell.
    pub fn integral(&self) -> f64 {
        let sum: f64 = self.coefficients.iter().sum();
        let across = if self.is_profile() {
            1.0
        } else {
            self.spacing[1]
        };
        sum * self.spacing[0] * across
    }

    /// Height and slopes at a place from the middle.
    pub fn at(&self, place: [f64; 2]) -> Height {
        let [Some((i, x, dx)), Some((j, y, dy))] = [0, 1].map(|d| self.weights(d, place[d])) else {
            return Height::default();
        };
        let width = self.counts[0] + 2 * RIM;
        let mut height = Height::default();
        for ((w, dw), row) in y.iter().zip(&dy).zip(j..) {
            if *w == 0.0 && *dw == 0.0 {
                continue;
            }
            let own = &self.coefficients[row * width + i..][..4];
            let sum =
                |weights: &[f64; 4]| -> f64 { own.iter().zip(weights).map(|(c, w)| c * w).sum() };
            let value = sum(&x);
            height.value += w * value;
            height.gradient[0] += w * sum(&dx);
            height.gradient[1] += dw * value;
        }
        height
    }

    /// The first coefficient that counts at a distance from the middle, the splines there and their slopes; `None` where none does.
    fn weights(&self, d: usize, place: f64) -> Option<(usize, [f64; 4], [f64; 4])> {
        let n = self.counts[d];
        if n == 1 {
            return Some((0, [1.0, 0.0, 0.0, 0.0], [0.0; 4]));
        }
        let u = place / self.spacing[d] + 0.5 * (n - 1) as f64;
        if !(u > -2.0 && u < n as f64 + 1.0) {
            return None;
        }
        let (first, t) = (u.floor(), u - u.floor());
        let r = 1.0 - t;
        let values = [
            r * r * r,
            (3.0 * t - 6.0) * t * t + 4.0,
            (3.0 * r - 6.0) * r * r + 4.0,
            t * t * t,
        ];
        let slopes = [-r * r, (3.0 * t - 4.0) * t, (4.0 - 3.0 * r) * r, t * t];
        let spacing = self.spacing[d];
        Some((
            (first + RIM as f64) as usize - 1,
            values.map(|w| w / 6.0),
            slopes.map(|w| 0.5 * w / spacing),
        ))
    }
}

/// From heights to coefficients: (c_{i−1} + 4 c_i + c_{i+1})/6 = h_i with none beyond the ends, by elimination.
fn coefficients(h: &mut [f64]) {
    let mut share = Vec::with_capacity(h.len());
    let mut before = (0.0, 0.0);
    for value in h.iter_mut() {
        let pivot = 4.0 - before.0;
        *value = (6.0 * *value - before.1) / pivot;
        before = (1.0 / pivot, *value);
        share.push(before.0);
    }
    for i in (1..h.len()).rev() {
        h[i - 1] -= share[i - 1] * h[i];
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Heights at the points, slopes by differences inside and beyond the rim, none far away.
    #[test]
    fn a_spline_goes_through_the_heights() {
        let counts = [7, 5];
        let heights: Vec<f64> = (0..35)
            .map(|k| (0.7 * f64::from(k)).sin() + 0.1 * f64::from(k % 5))
            .collect();
        let map = HeightMap::new(counts, [0.2, 0.3], &heights);
        assert_eq!(map.sides().map(|l| (l * 10.0).round()), [12.0, 12.0]);
        for (k, h) in heights.iter().enumerate() {
            let place = [0.2 * ((k % 7) as f64 - 3.0), 0.3 * ((k / 7) as f64 - 2.0)];
            assert_relative_eq!(
                map.at(place).value,
                *h,
                max_relative = 1e-12,
                epsilon = 1e-13
            );
        }
        for place in [[0.03, -0.11], [-0.55, 0.59], [0.71, 0.2], [-0.7, -0.8]] {
            for d in 0..2 {
                let value = |step: f64| {
                    let mut at = place;
                    at[d] += step;
                    map.at(at).value
                };
                let difference = (value(1e-6) - value(-1e-6)) / 2e-6;
                let own = map.at(place).gradient[d];
                assert_relative_eq!(own, difference, max_relative = 1e-6, epsilon = 1e-8);
            }
        }
        assert_eq!(map.at([1.01, 0.0]), Height::default());
    }

    /// The error of a cubic spline over a sine falls by 16 when the points are twice as dense; a profile is the same at all y.
    #[test]
    fn a_spline_is_of_the_fourth_order() {
        let error = |n: usize| {
            let step = 4.0 / (n - 1) as f64;
            let wave = |x: f64| (std::f64::consts::FRAC_PI_2 * x).cos().powi(2) * (-x * x).exp();
            let heights: Vec<f64> = (0..n).map(|i| wave(i as f64 * step - 2.0)).collect();
            let map = HeightMap::new([n, 1], [step, 1.0], &heights);
            assert!(map.is_profile());
            let places = (0..1000).map(|k| -0.9 + 0.0018 * f64::from(k));
            places
                .map(|x| (map.at([x, 7.0 * x]).value - wave(x)).abs())
                .fold(0.0, f64::max)
        };
        let ratio = error(41) / error(81);
        assert!((14.0..18.5).contains(&ratio), "{ratio}");
    }
}
