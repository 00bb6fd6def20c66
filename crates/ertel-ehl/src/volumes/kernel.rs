//! Influence of the pressure on the deflection of bodies that look alike from everywhere: functions of the offset, integrated over cells.
//!
//! ```text
//!   half-spaces                δ = C/π ∫∫ p dA/r                                                   (Johnson 1985, eq. 3.19)
//!   a cell of a grid           C/π ∫∫ dA/r                                                         (Love 1929; Johnson 1985, eq. 3.25)
//!   a cell of a line           −2C/π ∫ ln(|x|/d) dx                                                (Johnson 1985, eq. 2.24b)
//!   a row of a roller          C/π ∫∫ t(y) dA/r,   t: 1 on the row, falling to 0 at its neighbours
//!     ∫∫ dA/r → G_0 = x asinh(y/|x|) + y asinh(x/|y|),    ∫∫ y dA/r → G_1 = ½(x r + y² asinh(x/|y|))
//! ```
//! All else ([`super::deflection`]) takes these coefficients and knows no body. With a layer, bodies have the function of half-spaces and a smooth one of r, for which
//! quadrature is enough.

use std::f64::consts::PI;

use super::rows::Rows;
use crate::contact::Material;
use crate::elastic::{LINE_REFERENCE, compliance};

/// How bodies deflect far from their ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kernel {
    /// Half-spaces.
    HalfSpace {
        /// C = Σ(1 − ν²)/E.
        compliance: f64,
    },
}

impl Kernel {
    /// Of bodies.
    pub fn of(bodies: &[Material]) -> Kernel {
        Kernel::HalfSpace {
            compliance: compliance(bodies),
        }
    }

    /// C/π, for short waves.
    pub fn factor(self) -> f64 {
        match self {
            Kernel::HalfSpace { compliance } => compliance / PI,
        }
    }

    /// Influence coefficients of a grid: deflection at 0, 1, … cells of a size along the rows, row by row, by a unit pressure over a cell. One without end
    /// across is that of a line contact.
    pub fn cells(self, size: [f64; 2], n: [usize; 2]) -> Vec<f64> {
        match self {
            Kernel::HalfSpace { compliance } if size[1].is_infinite() => {
                strips(-2.0 * compliance / PI, size[0], n[0])
            }
            Kernel::HalfSpace { .. } => rectangles(self.factor(), size, n),
        }
    }

    /// Adds deflections by the pressure of a row, over [`Kernel::factor`], at distances along the rows, seen from y.
    pub fn add_hat(self, hat: &Hat, y: f64, samples: &Samples, sums: &mut [f64]) {
        match self {
            Kernel::HalfSpace { .. } if hat.is_far(y, samples.cell) => {
                hat.add_far(y, samples, sums);
            }
            Kernel::HalfSpace { .. } => hat.add_near(y, samples, sums),
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

/// ∫ ln(|x|/d) dx over the cells of a line.
fn strips(factor: f64, h: f64, n: usize) -> Vec<f64> {
    // From 0 to x.
    let primitive = |x: f64| x * ((x.abs() / LINE_REFERENCE).ln() - 1.0);
    (0..n)
        .map(|i| {
            let [low, high] = [-0.5, 0.5].map(|side| primitive((i as f64 + side) * h));
            factor * (high - low)
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
        Some(Hat {
            places: [before, here, behind],
            points,
        })
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

    /// ∫∫ t dA/r, by the middle of a cell, with the curvature across it.
    fn add_far(&self, y: f64, samples: &Samples, sums: &mut [f64]) {
        let dx = samples.cell;
        let share = dx * dx / 24.0;
        for [place, weight] in self.points {
            let (square, weight) = ((place - y).powi(2), weight * dx);
            for (sum, x) in sums.iter_mut().zip(&samples.x) {
                let x2 = x * x;
                let inverse = 1.0 / (x2 + square);
                *sum += weight
                    * inverse.sqrt()
                    * (1.0 + share * (2.0 * x2 - square) * inverse * inverse);
            }
        }
    }

    /// ∫∫ t dA/r, by corners.
    fn add_near(&self, y: f64, samples: &Samples, sums: &mut [f64]) {
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

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

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
