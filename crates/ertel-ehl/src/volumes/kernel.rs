//! Influence of the pressure on the deflection of bodies that look alike from everywhere: functions of the offset, integrated over cells.
//!
//! ```text
//!   half-spaces                δ = C/π ∫∫ p dA/r                                                   (Johnson 1985, eq. 3.19)
//!   a cell of a grid           C/π ∫∫ dA/r                                                         (Love 1929; Johnson 1985, eq. 3.25)
//!   a cell of a line           −2C/π ∫ ln(|x|/d) dx                                                (Johnson 1985, eq. 2.24b)
//!   a row of a roller          C/π ∫∫ t(y) dA/r,   t: 1 on the row, falling to 0 at its neighbours
//!     ∫∫ dA/r → G_0 = x asinh(y/|x|) + y asinh(x/|y|),    ∫∫ y dA/r → G_1 = ½(x r + y² asinh(x/|y|))
//!   layers                     Σ c_m/π ∫∫ p dA/ρ more, ρ² = r² + z_m²: images at depths z_m             ([`crate::layers`])
//!     ∫∫ dA/ρ → G_0 = x asinh(y/√(x² + z²)) + y asinh(x/√(y² + z²)) − z arctan(xy/(zρ)),   −c_m/π ∫ ln((x² + z²)/d²) dx of a line
//!     ∫∫ y dA/ρ → G_1 = ½(x ρ + (y² + z²) asinh(x/√(y² + z²)))
//! ```
//! All else ([`super::deflection`]) takes these coefficients and knows no body.

use std::f64::consts::PI;

use std::sync::Arc;

use super::rows::Rows;
use crate::elastic::{Elasticity, LINE_REFERENCE, compliance};
use crate::layers::{Image, Images};

/// How bodies deflect far from their ends.
#[derive(Clone, Debug, PartialEq)]
pub enum Kernel {
    /// Half-spaces.
    HalfSpace {
        /// C = Σ(1 − ν²)/E.
        compliance: f64,
    },
    /// Half-spaces with layers.
    Layered(Arc<Images>),
}

impl Kernel {
    /// Of bodies.
    pub fn of(elasticity: &Elasticity) -> Kernel {
        let coated = elasticity.coated();
        if coated.iter().all(|body| body.layers.is_empty()) {
            return Kernel::HalfSpace {
                compliance: compliance(&elasticity.bodies),
            };
        }
        Kernel::Layered(Arc::new(Images::of(&coated)))
    }

    /// C/π, for short waves.
    pub fn factor(&self) -> f64 {
        match self {
            Kernel::HalfSpace { compliance } => compliance / PI,
            Kernel::Layered(images) => images.of_short_waves / PI,
        }
    }

    /// Depths and C/π of the half-space and of the images.
    fn parts(&self) -> impl Iterator<Item = [f64; 2]> + '_ {
        let images: &[Image] = match self {
            Kernel::HalfSpace { .. } => &[],
            Kernel::Layered(images) => &images.images,
        };
        let images = images.iter().map(|i| [i.depth, i.compliance / PI]);
        std::iter::once([0.0, self.factor()]).chain(images)
    }

    /// Influence coefficients of a grid: deflection at 0, 1, … cells of a size along the rows, row by row, by a unit pressure over a cell. One without end
    /// across is that of a line contact.
    pub fn cells(&self, size: [f64; 2], n: [usize; 2]) -> Vec<f64> {
        if size[1].is_infinite() {
            let mut sum = vec![0.0; n[0]];
            for [depth, factor] in self.parts() {
                let own = strips(factor, size[0], n[0], depth);
                sum.iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
            }
            return sum;
        }
        let mut cells = rectangles(self.factor(), size, n);
        let images: Vec<[f64; 2]> = self.parts().skip(1).collect();
        for (k, cell) in cells.iter_mut().enumerate() {
            let middle = [(k % n[0]) as f64 * size[0], (k / n[0]) as f64 * size[1]];
            let of = |[depth, factor]: &[f64; 2]| factor * deep_rectangle(middle, size, *depth);
            *cell += images.iter().map(of).sum::<f64>();
        }
        cells
    }

    /// Adds deflections by the pressure of a row, over [`Kernel::factor`], at distances along the rows, seen from y.
    pub fn add_hat(&self, hat: &Hat, y: f64, samples: &Samples, sums: &mut [f64]) {
        let is_far = hat.is_far(y, samples.cell);
        let add = |depth: f64, sums: &mut [f64]| match is_far {
            true => hat.add_far(y, depth, samples, sums),
            false if depth == 0.0 => hat.add_near(y, samples, sums, corner),
            false => hat.add_near(y, samples, sums, |x, y| deep_corner(x, y, depth)),
        };
        add(0.0, sums);
        let mut own = vec![0.0; sums.len()];
        for [depth, factor] in self.parts().skip(1) {
            own.fill(0.0);
            add(depth, &mut own);
            let share = factor / self.factor();
            for (sum, own) in sums.iter_mut().zip(&own) {
                *sum += share * own;
            }
        }
    }
}

/// ∫∫ dA/r over rectangles, by corners between nodes and their differences.
fn rectangles(factor: f64, [dx, dy]: [f64; 2], [nx, rows]: [usize; 2]) -> Vec<f64> {
    // From the origin to (x, y), with the sign of xy.
    let corner = |x: f64, y: f64| x * (y / x.abs()).asinh() + y * (x / y.abs()).asinh();
    let corners: Vec<f64> = (0..=rows)
        .flat_map(|j| (0..=nx).map(move |i| (i, j)))
        .map(|(i, j)| corner((i as f64 - 0.5) * dx, (j as f64 - 0.5) * dy))
        .collect();
    let at = |i: usize, j: usize| corners[j * (nx + 1) + i];
    (0..rows)
        .flat_map(|j| (0..nx).map(move |i| (i, j)))
        .map(|(i, j)| factor * (at(i + 1, j + 1) - at(i, j + 1) - at(i + 1, j) + at(i, j)))
        .collect()
}

/// Distance in lengths of a cell from which its middle and the curvature there give ∫∫ dA/ρ to 1e-7.
const SMOOTH: f64 = 45.0;

/// ∫∫ dA/ρ over a rectangle about (x, y), of a depth.
fn deep_rectangle([x, y]: [f64; 2], [dx, dy]: [f64; 2], depth: f64) -> f64 {
    let (x2, y2) = (x * x, y * y);
    let square = x2 + y2 + depth * depth;
    if square > (SMOOTH * dx.max(dy)).powi(2) {
        let bend = (3.0 * x2 / square - 1.0) * dx * dx + (3.0 * y2 / square - 1.0) * dy * dy;
        return dx * dy / square.sqrt() * (1.0 + bend / (24.0 * square));
    }
    let corner = |x: f64, y: f64| {
        let distance = (x * x + y * y + depth * depth).sqrt();
        x * (y / x.hypot(depth)).asinh() + y * (x / y.hypot(depth)).asinh()
            - depth * (x * y / (depth * distance)).atan()
    };
    let ([left, right], [low, high]) = (
        [-0.5, 0.5].map(|side| x + side * dx),
        [-0.5, 0.5].map(|side| y + side * dy),
    );
    corner(right, high) - corner(left, high) - corner(right, low) + corner(left, low)
}

/// −2 ∫ ln(ρ/d) dx over the cells of a line; of a depth.
fn strips(factor: f64, h: f64, n: usize, depth: f64) -> Vec<f64> {
    // From 0 to x.
    let primitive = |x: f64| {
        let flat = x * ((x.hypot(depth) / LINE_REFERENCE).ln() - 1.0);
        match depth == 0.0 {
            true => flat,
            false => flat + depth * (x / depth).atan(),
        }
    };
    (0..n)
        .map(|i| {
            let [low, high] = [-0.5, 0.5].map(|side| primitive((i as f64 + side) * h));
            -2.0 * factor * (high - low)
        })
        .collect()
}

/// Middles of cells along the rows.
pub struct Samples {
    /// Length of a cell.
    pub cell: f64,
    /// Distances of the middles.
    pub x: Vec<f64>,
    /// How many of the first ones belong to adjacent cells.
    pub adjacent: usize,
}

/// t of a row, with a quadrature of it for places far away: of degree 5.
pub struct Hat {
    /// Rows before, here and behind.
    places: [f64; 3],
    points: [[f64; 2]; QUADRATURE],
}

/// Points of a quadrature: three on either side.
const QUADRATURE: usize = 6;

/// Distance of a row in lengths of its hat, and in cells, from which a quadrature gives its kernel to 1e-7.
const FAR: f64 = 4.0;
const FAR_CELLS: f64 = 8.0;

impl Hat {
    /// Of a row; none of one that stands for nothing.
    pub fn new(rows: &Rows, n: usize) -> Option<Hat> {
        if rows.height(n) == 0.0 {
            return None;
        }
        let places = rows.places();
        let here = places[n];
        let before = here - rows.step(n - 1);
        let behind = match places.get(n + 1) {
            Some(place) => *place,
            None => here + rows.step(n - 1),
        };
        Some(Hat::of([before, here, behind]))
    }

    /// Of its place between those of its neighbours.
    fn of([before, here, behind]: [f64; 3]) -> Hat {
        let gauss = [(-0.6_f64.sqrt(), 5.0), (0.0, 8.0), (0.6_f64.sqrt(), 5.0)];
        let mut points = [[0.0; 2]; QUADRATURE];
        for (k, point) in points.iter_mut().enumerate() {
            let (at, weight) = gauss[k % 3];
            let height = 0.5 + 0.5 * at;
            let foot = if k < 3 { before } else { behind };
            let length = (here - foot).abs();
            *point = [
                foot + height * (here - foot),
                height * weight / 18.0 * length,
            ];
        }
        Hat {
            places: [before, here, behind],
            points,
        }
    }

    /// How far its foot is from y, negative within.
    pub fn distance(&self, y: f64) -> f64 {
        (self.places[0] - y).max(y - self.places[2])
    }

    /// Whether the quadrature is enough.
    fn is_far(&self, y: f64, cell: f64) -> bool {
        let [a, b, c] = self.places.map(|place| place - y);
        let length = (b - a).max(c - b);
        self.distance(y) > (FAR * length).max(FAR_CELLS * cell)
    }

    /// ∫∫ t dA/ρ, by the middle of a cell, with the curvature across it; of a depth.
    fn add_far(&self, y: f64, depth: f64, samples: &Samples, sums: &mut [f64]) {
        let dx = samples.cell;
        let share = dx * dx / 24.0;
        for [place, weight] in self.points {
            let (square, weight) = ((place - y).powi(2) + depth * depth, weight * dx);
            for (sum, x) in sums.iter_mut().zip(&samples.x) {
                let x2 = x * x;
                let inverse = 1.0 / (x2 + square);
                *sum += weight
                    * inverse.sqrt()
                    * (1.0 + share * (2.0 * x2 - square) * inverse * inverse);
            }
        }
    }

    /// ∫∫ t dA/r, by G_0 and G_1 at corners.
    #[inline(always)]
    fn add_near(
        &self,
        y: f64,
        samples: &Samples,
        sums: &mut [f64],
        corner: impl Fn(f64, f64) -> [f64; 2],
    ) {
        let dx = samples.cell;
        let [a, b, c] = self.places.map(|place| place - y);
        let at = |x: f64| [a, b, c].map(|y| corner(x, y));
        let mut before = at(0.5 * dx).map(|corner| corner.map(|g| -g));
        for (m, (sum, x)) in sums.iter_mut().zip(&samples.x).enumerate() {
            if m > 0 && m >= samples.adjacent {
                before = at(x - 0.5 * dx);
            }
            let next = at(x + 0.5 * dx);
            let [low, here, high] = [0, 1, 2].map(|n: usize| {
                let [from, to] = [before[n], next[n]];
                [to[0] - from[0], to[1] - from[1]]
            });
            let [first, first_moment] = [here[0] - low[0], here[1] - low[1]];
            let [second, second_moment] = [high[0] - here[0], high[1] - here[1]];
            *sum += (first_moment - a * first) / (b - a) + (c * second - second_moment) / (c - b);
            before = next;
        }
    }
}

/// G_0 and G_1 at a corner with x > 0.
#[inline(always)]
fn corner(x: f64, y: f64) -> [f64; 2] {
    let r = (x * x + y * y).sqrt();
    let distance = y.abs();
    // asinh(x/|y|), times y.
    let along = if y == 0.0 {
        0.0
    } else {
        y * ((x + r) / distance).ln()
    };
    let across = x * ((distance + r) / x).ln().copysign(y);
    [along + across, 0.5 * (x * r + y * along)]
}

/// The same of a depth.
fn deep_corner(x: f64, y: f64, depth: f64) -> [f64; 2] {
    let z2 = depth * depth;
    let distance = (x * x + y * y + z2).sqrt();
    let along = (x / (y * y + z2).sqrt()).asinh();
    let across = x * (y / (x * x + z2).sqrt()).asinh();
    let angle = depth * (x * y / (depth * distance)).atan();
    [
        y * along + across - angle,
        0.5 * (x * distance + (y * y + z2) * along),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::Material;
    use crate::layers::{Coated, Layer};
    use approx::assert_relative_eq;

    /// A layer of the thickness 1 with E₁/E₂ and ν₁ on a half-space with ν₂ = 0.3.
    fn coated(modulus: f64, poissons_ratio: f64) -> Kernel {
        let layer = Layer {
            thickness: 1.0,
            material: Material {
                youngs_modulus: modulus,
                poissons_ratio,
            },
        };
        let body = Coated {
            layers: vec![layer],
            substrate: Material {
                youngs_modulus: 1.0,
                poissons_ratio: 0.3,
            },
        };
        Kernel::Layered(Arc::new(Images::of(&[body])))
    }

    /// E₁/E₂, ν₁, side of a square cell, offset in cells, and the deflection over (1 − ν₂²) p d/E₂: half-space of the layer in closed form and a
    /// Hankel integral of the rest, to 8 digits.
    const INFLUENCE: &[(f64, f64, f64, [usize; 2], f64)] = &[
        (1.0, 0.3, 0.05, [0, 0], 1.1221997),
        (1.0, 0.3, 0.2, [8, 5], 0.033756624),
        (2.0, 0.25, 0.05, [0, 0], 0.587074696),
        (2.0, 0.25, 0.05, [3, 0], 0.0638547564),
        (2.0, 0.25, 0.2, [1, 1], 0.153866178),
        (2.0, 0.25, 0.2, [8, 5], 0.0345200327),
        (2.0, 0.25, 1.0, [0, 0], 0.748915396),
        (2.0, 0.25, 1.0, [1, 1], 0.227534396),
        (2.0, 0.25, 1.0, [3, 0], 0.108271238),
        (0.25, 0.4, 0.05, [0, 0], 4.07878246),
        (0.25, 0.4, 0.05, [8, 5], 0.0660851872),
        (0.25, 0.4, 0.2, [1, 0], 0.966607475),
    ];

    #[test]
    fn cells_on_a_layer() {
        for (modulus, poisson, side, [i, j], known) in INFLUENCE {
            let n = [9, 6];
            let found = coated(*modulus, *poisson).cells([*side; 2], n);
            let own = found[j * n[0] + i] / (0.91 * side);
            assert_relative_eq!(own, *known, max_relative = 3e-7);
        }
    }

    /// Images in closed form against a sum over small squares, of cells and of the strips of a line, as far as the potential of a line load goes.
    #[test]
    fn depths_by_quadrature() {
        let depth = 0.3;
        let cell = |i: usize, j: usize| {
            let middle = [0.25 * i as f64, 0.75 * j as f64];
            deep_rectangle(middle, [0.25, 0.75], depth)
        };
        let line = strips(1.0, 0.25, 4, depth);
        let n = 60;
        for [di, dj] in [[0, 0], [1, 0], [2, 1], [3, 2]] {
            let (mut sum, mut along) = (0.0, 0.0);
            for a in 0..n {
                let x = 0.25 * (di as f64 - (f64::from(a) + 0.5) / f64::from(n) + 0.5);
                let square = (x * x + depth * depth) / (LINE_REFERENCE * LINE_REFERENCE);
                along -= 0.25 / f64::from(n) * square.ln();
                for b in 0..n {
                    let y = 0.75 * (dj as f64 - (f64::from(b) + 0.5) / f64::from(n) + 0.5);
                    sum += 0.25 * 0.75 / f64::from(n * n) / (x * x + y * y + depth * depth).sqrt();
                }
            }
            assert_relative_eq!(cell(di, dj), sum, max_relative = 2e-4);
            assert_relative_eq!(line[di], along, max_relative = 1e-4);
        }
    }

    /// Where cells are smooth their middle does as well as their corners.
    #[test]
    fn smooth_cells_of_a_depth() {
        let (size, depth) = ([0.1, 0.2], 1.0);
        let near = |x: f64| deep_rectangle([x, 0.5], size, depth);
        let edge = (SMOOTH * SMOOTH * 0.04 - 1.25_f64).sqrt();
        assert_relative_eq!(
            near(edge * (1.0 - 1e-12)),
            near(edge * (1.0 + 1e-12)),
            max_relative = 1e-7
        );
    }

    /// Rows that are linear between their neighbours, near and far, over a layer: a sum over small squares.
    #[test]
    fn hats_on_a_layer() {
        let (kernel, depth) = (coated(0.25, 0.4), 1.0);
        let hat = Hat::of([-0.5, 0.0, 0.25]);
        let samples = Samples {
            cell: 0.5 * depth,
            x: vec![0.0, 0.5, 1.0],
            adjacent: 2,
        };
        let n = 600;
        for y in [0.1, 1.0, 9.0] {
            let mut sums = vec![0.0; 3];
            kernel.add_hat(&hat, y, &samples, &mut sums);
            for (own, x) in sums.iter().zip(&samples.x) {
                let mut known = 0.0;
                for a in 0..n {
                    let at = x + 0.5 * ((f64::from(a) + 0.5) / f64::from(n) - 0.5);
                    for b in 0..n {
                        let place = -0.5 + 0.75 * (f64::from(b) + 0.5) / f64::from(n);
                        let height = match place < 0.0 {
                            true => 1.0 + 2.0 * place,
                            false => 1.0 - 4.0 * place,
                        };
                        let squared = at * at + (place - y).powi(2);
                        let all = kernel
                            .parts()
                            .map(|[z, factor]| factor / kernel.factor() / (squared + z * z).sqrt());
                        let area = 0.5 * 0.75 / f64::from(n * n);
                        known += area * height * all.sum::<f64>();
                    }
                }
                assert_relative_eq!(*own, known, max_relative = 3e-3);
            }
        }
    }

    /// Coefficients against a sum over small squares, of cells three times as long as wide.
    #[test]
    fn kernel_by_quadrature() {
        let nx = 4;
        let found = Kernel::HalfSpace { compliance: PI }.cells([0.25, 0.75], [nx, 3]);
        let n = 200;
        for (di, dj) in [(1, 0), (0, 1), (2, 1), (3, 2)] {
            let at = [0.25 * f64::from(di), 0.75 * f64::from(dj)];
            let mut sum = 0.0;
            for a in 0..n {
                for b in 0..n {
                    let x = ((f64::from(a) + 0.5) / f64::from(n) - 0.5) * 0.25;
                    let y = ((f64::from(b) + 0.5) / f64::from(n) - 0.5) * 0.75;
                    sum += 0.25 * 0.75 / f64::from(n * n) / (at[0] - x).hypot(at[1] - y);
                }
            }
            let own = found[di as usize + nx * dj as usize];
            assert_relative_eq!(own, sum, max_relative = 1e-4);
        }
    }
}
