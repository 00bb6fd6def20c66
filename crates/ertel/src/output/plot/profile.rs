//! Fields along the centreline y = 0, by their polynomials.

use ertel_fem::element::Lagrange;

use super::super::surface::near_centreline;
use super::sampling::{CORNERS, value};
use crate::solution::{ElementFields, Polynomials, Solution};

/// A field along y = 0, times a factor, over x/a.
pub(crate) fn profile(solution: &Solution, field: &Polynomials, factor: f64) -> Vec<[f64; 2]> {
    (along_centreline(&solution.elements, field).into_iter())
        .map(|[x, v]| [x / solution.hertz.half_width, factor * v])
        .collect()
}

/// Samples per element edge.
const PER_EDGE: usize = 32;

/// A field along y = 0, by its polynomials: x, m, rising, and value, SI.
fn along_centreline(elements: &ElementFields, field: &Polynomials) -> Vec<[f64; 2]> {
    let lagrange = match field.values.is_empty() {
        true => return Vec::new(),
        false => Lagrange::new(elements.dim, field.order),
    };
    let on_centreline = near_centreline(&elements.vertices);
    let mut edges: Vec<([f64; 2], usize, [[f64; 3]; 2])> = Vec::new();
    for (element, cell) in elements.cells.iter().enumerate() {
        for (i, j) in [(0, 1), (1, 2), (2, 0)] {
            if i.max(j) > elements.dim {
                continue;
            }
            let [a, b] = [cell[i], cell[j]].map(|n| elements.vertices[n as usize]);
            if !(on_centreline(a[1]) && on_centreline(b[1])) {
                continue;
            }
            edges.push(match a[0] < b[0] {
                true => ([a[0], b[0]], element, [CORNERS[i], CORNERS[j]]),
                false => ([b[0], a[0]], element, [CORNERS[j], CORNERS[i]]),
            });
        }
    }
    edges.sort_by(|a, b| a.0[0].total_cmp(&b.0[0]));
    let sample = |([x0, x1], element, [from, to]): &([f64; 2], usize, [[f64; 3]; 2]), k: usize| {
        let t = k as f64 / PER_EDGE as f64;
        let xi = [0, 1, 2].map(|i: usize| from[i] + t * (to[i] - from[i]));
        [x0 + t * (x1 - x0), value(&lagrange, field, *element, xi)]
    };
    let mut line: Vec<[f64; 2]> = (edges.iter())
        .flat_map(|edge| (0..PER_EDGE).map(move |k| (edge, k)))
        .map(|(edge, k)| sample(edge, k))
        .collect();
    line.extend(edges.last().map(|edge| sample(edge, PER_EDGE)));
    line
}

#[cfg(test)]
mod tests {
    use super::*;

    /// T₅(x) on two segments of order 5, written from right to left: rising x, the maximum of 1 at cos(2π/5) found
    /// between nodes at which T₅ is 0.85 and −0.08 at the most.
    #[test]
    fn profile_shows_what_lies_between_nodes() {
        let bump = |x: f64| 16.0 * x.powi(5) - 20.0 * x.powi(3) + 5.0 * x;
        let lagrange = Lagrange::new(1, 5);
        let corners = [1.0, -1.0, -3.0];
        let values = (0..2).flat_map(|e: usize| {
            let [from, to] = [corners[e], corners[e + 1]];
            (lagrange.points()).map(move |xi| bump(from + xi[0] * (to - from)))
        });
        let field = Polynomials {
            order: 5,
            values: values.collect(),
        };
        let elements = ElementFields {
            dim: 1,
            vertices: corners.map(|x| [x, 0.0]).to_vec(),
            cells: vec![[0, 1, 0], [1, 2, 0]],
            ..ElementFields::default()
        };
        let line = along_centreline(&elements, &field);
        assert_eq!(line.len(), 2 * PER_EDGE + 1);
        assert!(line.is_sorted_by(|a, b| a[0] < b[0]));
        for [x, v] in &line {
            assert!((v - bump(*x)).abs() < 1e-9 * bump(3.0).abs(), "{x} {v}");
        }
        let top = (line.iter()).filter(|p| (0.0..0.8).contains(&p[0]));
        let top = top.map(|p| p[1]).fold(0.0, f64::max);
        assert!(top > 0.99, "{top}");
        assert!(along_centreline(&elements, &Polynomials::default()).is_empty());
    }
}
