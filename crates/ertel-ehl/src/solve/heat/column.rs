//! The column of temperatures over a point of the contact area: plane, film, ball.
//!
//! ```text
//!   plane: bottom … wall | film: wall … wall | ball: wall … bottom        walls are shared
//! ```

use ertel_fem::quadrature::Quadrature;

use crate::film::{FilmNodes, MOST_NODES, Nodal};
use crate::forms::energy::{Heat, Heights};

/// Order of the elements over the depth of a body.
const SOLID_ORDER: usize = 3;

/// One element of a body over its depth.
#[derive(Clone, Debug)]
pub struct Layer {
    /// Unknowns of the column, in order of depth from the wall.
    pub nodes: Vec<usize>,
    /// At each quadrature point: weight in half-widths, shape functions, first and second derivatives by depth.
    pub points: Vec<LayerPoint>,
}

/// A quadrature point of a layer.
#[derive(Clone, Debug)]
pub struct LayerPoint {
    /// Weight, half-widths.
    pub weight: f64,
    /// Shape functions.
    pub shapes: Nodal,
    /// ∂/∂Z and ∂²/∂Z².
    pub slopes: [Nodal; 2],
}

/// The layers over a point.
#[derive(Clone, Debug)]
pub struct Column {
    /// Nodes across the film.
    pub film: FilmNodes,
    /// Heights at which it is heated.
    pub heights: Heights,
    /// Plane and ball.
    pub bodies: [Vec<Layer>; 2],
    /// Depth of each unknown below its wall, half-widths; zero in the film.
    pub depths: Vec<f64>,
    /// Unknown of the film's first node, the wall of body 1.
    pub first: usize,
}

impl Column {
    /// Layers for a film of some order and bodies of `n_elements` each, down to `depth` half-widths, the first as
    /// thick as `penetration_depths` says (plane, ball).
    pub fn new(
        film_order: usize,
        n_elements: usize,
        depth: f64,
        penetration_depths: [f64; 2],
    ) -> Column {
        let film = FilmNodes::new(film_order);
        let per_body = SOLID_ORDER * n_elements;
        let n = 2 * per_body + film.n();
        let mut depths = vec![0.0; n];
        let wall = [per_body, per_body + film.n() - 1];
        let shape = FilmNodes::new(SOLID_ORDER);
        let rule = Quadrature::simplex(1, 2 * SOLID_ORDER);
        let bodies = [0, 1].map(|b: usize| {
            let ends = graded(n_elements, depth, penetration_depths[b]);
            let node = |k: usize| match b {
                0 => wall[0] - k,
                _ => wall[1] + k,
            };
            let layer = |e: usize| {
                let (from, size) = (ends[e], ends[e + 1] - ends[e]);
                let nodes: Vec<usize> = (0..=SOLID_ORDER)
                    .map(|k| node(SOLID_ORDER * e + k))
                    .collect();
                for (unknown, s) in nodes.iter().zip(shape.points()) {
                    depths[*unknown] = from + (s + 0.5) * size;
                }
                let point = |(x, w): (&[f64; 3], &f64)| {
                    let s = x[0] - 0.5;
                    let [first, second] = shape.slopes_at(s);
                    LayerPoint {
                        weight: w * size,
                        shapes: shape.shapes_at(s),
                        slopes: [first.map(|v| v / size), second.map(|v| v / (size * size))],
                    }
                };
                Layer {
                    nodes,
                    points: rule.points.iter().zip(&rule.weights).map(point).collect(),
                }
            };
            (0..n_elements).map(layer).collect()
        });
        Column {
            heights: Heights::new(&film),
            film,
            bodies,
            depths,
            first: wall[0],
        }
    }

    /// Number of unknowns.
    pub fn n(&self) -> usize {
        self.depths.len()
    }

    /// The film's nodes among them.
    pub fn film_range(&self) -> std::ops::Range<usize> {
        self.first..self.first + self.film.n()
    }

    /// Deepest unknown of a body.
    pub fn bottom(&self, body: usize) -> usize {
        if body == 0 { 0 } else { self.n() - 1 }
    }

    /// Unknowns of a body, its wall included.
    pub fn body_range(&self, body: usize) -> std::ops::Range<usize> {
        match body {
            0 => 0..self.first + 1,
            _ => self.first + self.film.n() - 1..self.n(),
        }
    }

    /// Inflow temperatures of lubricant and bodies.
    pub fn unheated(&self, heat: &Heat) -> Vec<f64> {
        let mut temperatures = vec![heat.inlet_temperature; self.n()];
        for (body, law) in heat.bodies.iter().enumerate() {
            temperatures[self.body_range(body)].fill(law.bulk_temperature);
        }
        let film = temperatures[self.film_range()].iter_mut();
        for (t, s) in film.zip(self.film.points()) {
            *t = heat.entering(*s, self.film.n() - 1);
        }
        temperatures
    }

    /// Temperatures of the film out of a column.
    pub fn film_of(&self, column: &[f64]) -> Nodal {
        let mut film = [0.0; MOST_NODES];
        film[..self.film.n()].copy_from_slice(&column[self.film_range()]);
        film
    }
}

/// Ends of `n` elements from 0 to `depth`, the first of size `first` at the most, each larger than the one
/// before by the same ratio.
fn graded(n: usize, depth: f64, first: f64) -> Vec<f64> {
    if n == 1 {
        // No ratio makes one element longer.
        return vec![0.0, depth];
    }
    let first = first.min(depth / n as f64);
    let sum = |ratio: f64| (0..n).map(|k| first * ratio.powi(k as i32)).sum::<f64>();
    let (mut low, mut high) = (1.0, 2.0);
    while sum(high) < depth {
        high *= 2.0;
    }
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if sum(middle) < depth {
            low = middle
        } else {
            high = middle
        }
    }
    let mut ends = vec![0.0];
    for k in 0..n {
        ends.push(ends[k] + first * high.powi(k as i32));
    }
    ends[n] = depth;
    ends
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Elements fill the depth, the first no longer than requested, each longer than the one before; one alone is as long as the depth.
    #[test]
    fn elements_fill_the_depth() {
        assert_eq!(graded(1, 3.15, 0.02), [0.0, 3.15]);
        for n in [2, 4, 64] {
            let ends = graded(n, 3.15, 0.02);
            assert_eq!((ends.len(), ends[n]), (n + 1, 3.15));
            assert!(ends[1] <= 0.02 + 1e-12);
            let sizes: Vec<f64> = ends.windows(2).map(|pair| pair[1] - pair[0]).collect();
            assert!(sizes.windows(2).all(|pair| pair[1] > 0.999 * pair[0]));
        }
    }

    /// Each layer integrates and differentiates Z³ exactly, and walls are shared.
    #[test]
    fn layers_carry_cubics() {
        let column = Column::new(6, 4, 3.15, [0.02, 0.3]);
        assert_eq!(column.n(), 2 * 12 + 7);
        for (b, layers) in column.bodies.iter().enumerate() {
            assert_eq!(layers[0].nodes[0], column.film_range().start + b * 6);
            let (mut integral, mut slope) = (0.0, 0.0);
            for layer in layers {
                for point in &layer.points {
                    for (m, node) in layer.nodes.iter().enumerate() {
                        let z = column.depths[*node];
                        integral += point.weight * point.shapes[m] * z.powi(3);
                        slope += point.weight * point.slopes[1][m] * z.powi(3);
                    }
                }
            }
            // ∫Z³ and ∫6Z
            assert_relative_eq!(integral, 3.15_f64.powi(4) / 4.0, max_relative = 1e-12);
            assert_relative_eq!(slope, 3.0 * 3.15_f64.powi(2), max_relative = 1e-9);
            assert_relative_eq!(column.depths[column.bottom(b)], 3.15, max_relative = 1e-14);
        }
        assert_relative_eq!(column.depths[column.first - 3], 0.02, max_relative = 1e-12);
    }
}
