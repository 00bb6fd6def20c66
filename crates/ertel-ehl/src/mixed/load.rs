//! Asperity pressure integrated over a film map.

use ertel_fem::element::Lagrange;
use ertel_fem::quadrature::Quadrature;
use rayon::prelude::*;

use super::NOTHING_FROM;
use crate::contact::{Planar, Symmetry};
use crate::solution::ElementFields;

/// Degree of the rule on each piece of an element.
const DEGREE: usize = 7;

/// Share of the whole load by which that of an element may change when it is cut: the integral is accurate to about 1e-6.
pub const TOLERANCE: f64 = 1e-8;
/// Most cuts of an element.
const MOST_CUTS: usize = 8;

/// Normal and tangential forces of asperities: N, in line contacts N/m.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AsperityForces {
    /// ∫ p_a dA.
    pub load: f64,
    /// ∫ p_a e dA, e the direction in which body 2 slides over body 1; zero where nothing slides.
    pub directed: [f64; 2],
}

impl AsperityForces {
    fn sum(self, other: AsperityForces) -> AsperityForces {
        let [x, y] = self.directed;
        AsperityForces {
            load: self.load + other.load,
            directed: [x + other.directed[0], y + other.directed[1]],
        }
    }

    fn times(self, factor: f64) -> AsperityForces {
        AsperityForces {
            load: factor * self.load,
            directed: self.directed.map(|f| factor * f),
        }
    }

    /// The largest difference of a component.
    fn distance(self, other: AsperityForces) -> f64 {
        let differences = [
            self.load - other.load,
            self.directed[0] - other.directed[0],
            self.directed[1] - other.directed[1],
        ];
        differences.into_iter().fold(0.0, |m, d| m.max(d.abs()))
    }
}

/// Integrates an asperity pressure p_a(h/σ), Pa, over the film of a solution; each element is cut until its load changes by no more than
/// `tolerance` of the whole load.
///
/// `rms_height` is σ in m, `sliding` the velocity of body 2 less that of body 1 at places in m, `symmetry` states whether the map is half of the
/// contact. The film is multiplied by `film_factor` first, to show the effect of its error.
pub fn asperity_forces(
    elements: &ElementFields,
    symmetry: Symmetry,
    sliding: &Planar,
    rms_height: f64,
    film_factor: f64,
    pressure: impl Fn(f64) -> f64 + Sync,
    tolerance: f64,
) -> AsperityForces {
    let film = &elements.film_thickness;
    let lagrange = Lagrange::new(elements.dim, film.order);
    let scale = film_factor / rms_height;
    let of_height = |h: f64| pressure(scale * h);
    let map = Map {
        elements,
        n_nodes: lagrange.n_nodes(),
        lagrange,
        rule: Quadrature::simplex(elements.dim, DEGREE),
        sliding,
        pressure: &of_height,
    };
    // A polynomial may undershoot its nodes, but not by half in a film that thick.
    let is_near = |cell: &usize| {
        let mut heights = map.film_of(*cell).iter();
        heights.any(|h| scale * h < 2.0 * NOTHING_FROM)
    };
    let near: Vec<usize> = (0..elements.cells.len()).filter(is_near).collect();
    let whole = map.whole();
    let coarse: Vec<AsperityForces> = (near.par_iter())
        .map(|cell| map.piece(*cell, &whole))
        .collect();
    let total: f64 = coarse.iter().map(|forces| forces.load).sum();
    let fine: Vec<AsperityForces> = (near.par_iter().zip(&coarse))
        .map(|(cell, coarse)| map.refined(*cell, &whole, *coarse, tolerance * total, MOST_CUTS))
        .collect();
    let sum = (fine.into_iter()).fold(AsperityForces::default(), AsperityForces::sum);
    let mut forces = sum.times(symmetry.multiplicity());
    if symmetry == Symmetry::Half {
        forces.directed[1] = 0.0;
    }
    forces
}

/// Corners of a piece in reference coordinates of its element.
type Piece = Vec<[f64; 3]>;

struct Map<'a> {
    elements: &'a ElementFields,
    lagrange: Lagrange,
    n_nodes: usize,
    rule: Quadrature,
    sliding: &'a Planar,
    pressure: &'a (dyn Fn(f64) -> f64 + Sync),
}

impl Map<'_> {
    fn film_of(&self, cell: usize) -> &[f64] {
        &self.elements.film_thickness.values[cell * self.n_nodes..][..self.n_nodes]
    }

    /// The whole of an element.
    fn whole(&self) -> Piece {
        let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        corners[..=self.elements.dim].to_vec()
    }

    /// Halves of a segment, quarters of a triangle.
    fn cut(&self, piece: &[[f64; 3]]) -> Vec<Piece> {
        let middle = |a: [f64; 3], b: [f64; 3]| std::array::from_fn(|i| 0.5 * (a[i] + b[i]));
        match *piece {
            [a, b] => vec![vec![a, middle(a, b)], vec![middle(a, b), b]],
            [a, b, c] => {
                let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
                [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
                    .map(|p| p.to_vec())
                    .into()
            }
            _ => Vec::new(),
        }
    }

    /// Integrates a piece, refined as needed.
    fn refined(
        &self,
        cell: usize,
        piece: &[[f64; 3]],
        coarse: AsperityForces,
        tolerance: f64,
        cuts_left: usize,
    ) -> AsperityForces {
        let parts = self.cut(piece);
        let loads: Vec<AsperityForces> = parts.iter().map(|p| self.piece(cell, p)).collect();
        let fine = (loads.iter().copied()).fold(AsperityForces::default(), AsperityForces::sum);
        if cuts_left == 0 || fine.distance(coarse) <= tolerance {
            return fine;
        }
        let parts = parts.iter().zip(loads);
        parts
            .map(|(p, load)| self.refined(cell, p, load, tolerance, cuts_left - 1))
            .fold(AsperityForces::default(), AsperityForces::sum)
    }

    /// Forces of a piece by the rule.
    fn piece(&self, cell: usize, piece: &[[f64; 3]]) -> AsperityForces {
        let place = |xi: [f64; 3]| {
            let [a, b, c] = self.elements.cells[cell].map(|v| self.elements.vertices[v as usize]);
            let edge = |i: usize| xi[0] * (b[i] - a[i]) + xi[1] * (c[i] - a[i]);
            [a[0] + edge(0), a[1] + edge(1)]
        };
        let corners: Vec<[f64; 2]> = piece.iter().map(|xi| place(*xi)).collect();
        let measure = match *corners.as_slice() {
            [a, b] => (b[0] - a[0]).hypot(b[1] - a[1]),
            [a, b, c] => {
                let (u, v) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
                (u[0] * v[1] - u[1] * v[0]).abs()
            }
            _ => 0.0,
        };
        let mut forces = AsperityForces::default();
        for (point, weight) in self.rule.points.iter().zip(&self.rule.weights) {
            let xi: [f64; 3] = std::array::from_fn(|i| {
                let along = |k: usize| point[k] * (piece[k + 1][i] - piece[0][i]);
                piece[0][i] + (0..self.elements.dim).map(along).sum::<f64>()
            });
            let shapes = self.lagrange.values(xi).zip(self.film_of(cell));
            let film: f64 = shapes.map(|(shape, h)| shape * h).sum();
            let load = (self.pressure)(film) * weight * measure;
            let [x, y] = self.sliding.at(place(xi));
            let speed = x.hypot(y);
            let directed = match speed > 0.0 {
                true => [load * x / speed, load * y / speed],
                false => [0.0; 2],
            };
            forces = forces.sum(AsperityForces { load, directed });
        }
        forces
    }
}

#[cfg(test)]
mod tests {
    use super::super::Asperities;
    use super::*;
    use crate::solution::Polynomials;
    use approx::assert_relative_eq;
    use std::f64::consts::PI;

    const ASPERITIES: Asperities = Asperities {
        asperity_group: 0.05,
        rms_height_to_asperity_radius: 1e-3,
        boundary_friction_coefficient: None,
    };
    const MODULUS: f64 = 230e9;
    const SIGMA: f64 = 0.2e-6;

    /// A square -a..a on n × n × 2 triangles, or its half y ≤ 0, with a film of order 2.
    fn square(n: usize, a: f64, half: bool, film: impl Fn([f64; 2]) -> f64) -> ElementFields {
        let (nx, ny) = (n, if half { n / 2 } else { n });
        let step = 2.0 * a / n as f64;
        let vertices: Vec<[f64; 2]> = (0..=ny)
            .flat_map(|j| (0..=nx).map(move |i| [i as f64 * step - a, j as f64 * step - a]))
            .collect();
        let cells: Vec<[u32; 3]> = (0..ny)
            .flat_map(|j| {
                (0..nx).flat_map(move |i| {
                    let k = (j * (nx + 1) + i) as u32;
                    let up = k + nx as u32 + 1;
                    [[k, k + 1, up], [k + 1, up + 1, up]]
                })
            })
            .collect();
        let nodes = Lagrange::new(2, 2);
        let values = (cells.iter())
            .flat_map(|cell| {
                let [o, b, c] = cell.map(|v| vertices[v as usize]);
                let film = &film;
                nodes.points().map(move |xi| {
                    let at = |i: usize| o[i] + xi[0] * (b[i] - o[i]) + xi[1] * (c[i] - o[i]);
                    film([at(0), at(1)])
                })
            })
            .collect();
        ElementFields {
            dim: 2,
            vertices,
            cells,
            film_thickness: Polynomials { order: 2, values },
            ..ElementFields::default()
        }
    }

    fn forces(map: &ElementFields, symmetry: Symmetry, sliding: &Planar) -> AsperityForces {
        let pressure = |u| ASPERITIES.pressure(u, MODULUS);
        asperity_forces(map, symmetry, sliding, SIGMA, 1.0, pressure, TOLERANCE)
    }

    /// A constant film: pressure times area, whichever part is solved, along the sliding.
    #[test]
    fn constant_film_carries_pressure_times_area() {
        let a = 1e-4;
        let sliding = Planar {
            centre: [-3.0, 4.0],
            spin: 0.0,
        };
        let pressure = ASPERITIES.pressure(1.5, MODULUS);
        for (half, symmetry) in [(false, Symmetry::Full), (true, Symmetry::Half)] {
            let map = square(6, a, half, |_| 1.5 * SIGMA);
            let found = forces(&map, symmetry, &sliding);
            let load = pressure * 4.0 * a * a;
            assert_relative_eq!(found.load, load, max_relative = 1e-12);
            let across = if half { 0.0 } else { 0.8 };
            assert_relative_eq!(found.directed[0], -0.6 * load, max_relative = 1e-12);
            assert_relative_eq!(found.directed[1], across * load, max_relative = 1e-12);
        }
    }

    /// A thick film carries nothing.
    #[test]
    fn thick_film_carries_nothing() {
        let map = square(4, 1e-4, false, |_| 50.0 * SIGMA);
        let found = forces(&map, Symmetry::Full, &Planar::along_x(1.0));
        assert_eq!(found, AsperityForces::default());
    }

    /// A paraboloid h = h₀ + r²/2R: the integral over rings by substitution is 2πRσ(F_{7/2} of u₀)·2/7 of the factor, since
    /// ∫_{u₀}^∞ F_{5/2} du = 2/7 F_{7/2}(u₀). F_{7/2}(0.5) by mpmath; one spin, no force along any direction.
    #[test]
    fn paraboloid_against_closed_form() {
        let (a, radius): (f64, f64) = (1e-4, 1e-3);
        let map = square(24, a, false, |[x, y]| {
            0.5 * SIGMA + (x * x + y * y) / (2.0 * radius)
        });
        let spin = Planar {
            centre: [0.0; 2],
            spin: 5.0,
        };
        let found = forces(&map, Symmetry::Full, &spin);
        const F_7_2: f64 = 0.3678082240224405;
        let factor = ASPERITIES.pressure(0.0, MODULUS) / super::super::five_halves_integral(0.0);
        let expected = factor * 2.0 * PI * radius * SIGMA * 2.0 / 7.0 * F_7_2;
        assert_relative_eq!(found.load, expected, max_relative = 1e-6);
        for force in found.directed {
            assert!(force.abs() < 1e-6 * expected, "{force}");
        }
    }

    /// The same in two dimensions: a line contact per length, h = h₀ + x²/2R with a trapezoidal sum.
    #[test]
    fn line_against_a_sum() {
        let (a, radius): (f64, f64) = (1e-4, 1e-3);
        let film = |x: f64| 0.5 * SIGMA + x * x / (2.0 * radius);
        let n = 10;
        let vertices: Vec<[f64; 2]> = (0..=n)
            .map(|i| [2.0 * a * f64::from(i) / f64::from(n) - a, 0.0])
            .collect();
        let cells: Vec<[u32; 3]> = (0..n as u32).map(|i| [i, i + 1, 0]).collect();
        let nodes = Lagrange::new(1, 2);
        let values = (cells.iter())
            .flat_map(|cell| {
                let [l, r, _] = cell.map(|v| vertices[v as usize][0]);
                nodes.points().map(move |xi| film(l + xi[0] * (r - l)))
            })
            .collect();
        let map = ElementFields {
            dim: 1,
            vertices,
            cells,
            film_thickness: Polynomials { order: 2, values },
            ..ElementFields::default()
        };
        let found = forces(&map, Symmetry::Full, &Planar::along_x(-0.5));
        let m = 4000;
        let step = 2.0 * a / f64::from(m);
        let sum: f64 = (0..m)
            .map(|i| ASPERITIES.pressure(film((f64::from(i) + 0.5) * step - a) / SIGMA, MODULUS))
            .sum();
        assert_relative_eq!(found.load, sum * step, max_relative = 1e-6);
        assert_relative_eq!(found.directed[0], -found.load, max_relative = 1e-12);
    }
}
