//! Fields along the centreline y = 0 and across the contact, from their polynomials.

use ertel_fem::element::Lagrange;

use super::sampling::{CORNERS, value};
use crate::solution::near_zero;
use crate::solution::{ElementFields, Polynomials, Solution};

/// A field along y = 0, times a factor, over x/a.
pub fn profile(solution: &Solution, field: &Polynomials, factor: f64) -> Vec<[f64; 2]> {
    (along(&solution.elements, field, X).into_iter())
        .map(|[x, v]| [x / solution.hertz.half_width, factor * v])
        .collect()
}

/// A field along x = 0 of a circular contact, times a factor, over y/a from the side edge to the centreline.
pub fn profile_across(solution: &Solution, field: &Polynomials, factor: f64) -> Vec<[f64; 2]> {
    (along(&solution.elements, field, Y).into_iter())
        .map(|[y, v]| [y / solution.hertz.half_width, factor * v])
        .collect()
}

/// Samples per element edge.
const PER_EDGE: usize = 32;

/// Coordinate axes.
const X: usize = 0;
const Y: usize = 1;

/// A field along an axis, from its polynomials: x or y, m, rising, and value, SI.
fn along(elements: &ElementFields, field: &Polynomials, axis: usize) -> Vec<[f64; 2]> {
    let lagrange = match field.values.is_empty() {
        true => return Vec::new(),
        false => Lagrange::new(elements.dim, field.order),
    };
    // Along the axis, and across it.
    let turned = |v: u32| [axis, 1 - axis].map(|k| elements.vertices[v as usize][k]);
    let across = elements.vertices.iter().map(|v| v[1 - axis]);
    let on_axis = near_zero(across);
    let mut edges: Vec<Piece> = Vec::new();
    for (element, cell) in elements.cells.iter().enumerate() {
        for (i, j) in [(0, 1), (1, 2), (2, 0)] {
            if i.max(j) > elements.dim {
                continue;
            }
            let [a, b] = [cell[i], cell[j]].map(turned);
            if !(on_axis(a[1]) && on_axis(b[1])) {
                continue;
            }
            edges.push(rising([a[0], b[0]], element, [CORNERS[i], CORNERS[j]]));
        }
        if elements.dim == 2 {
            edges.extend(chord(cell.map(turned), element, &on_axis));
        }
    }
    edges.sort_by(|a, b| a.0[0].total_cmp(&b.0[0]));
    // An edge between two elements counts once.
    edges.dedup_by(|b, a| {
        let [from, to] = [0, 1].map(|k: usize| (a.0[k] - b.0[k]).abs());
        from + to <= 1e-9 * (a.0[1] - a.0[0])
    });
    let sample = |([x0, x1], element, [from, to]): &Piece, k: usize| {
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

/// A piece of the axis: its ends, the element, and the ends in the element's coordinates.
type Piece = ([f64; 2], usize, [[f64; 3]; 2]);

fn rising([a, b]: [f64; 2], element: usize, [from, to]: [[f64; 3]; 2]) -> Piece {
    match a < b {
        true => ([a, b], element, [from, to]),
        false => ([b, a], element, [to, from]),
    }
}

/// The piece of the axis inside a triangle; the corners are given by their coordinates along and across it.
fn chord(corners: [[f64; 2]; 3], element: usize, on_axis: &impl Fn(f64) -> bool) -> Option<Piece> {
    let side = corners.map(|c| if on_axis(c[1]) { 0.0 } else { c[1].signum() });
    if !(side.contains(&1.0) && side.contains(&-1.0)) {
        return None;
    }
    let through = (0..3)
        .filter(|i| side[*i] == 0.0)
        .map(|i| (corners[i][0], CORNERS[i]));
    let crossed = [(0, 1), (1, 2), (2, 0)]
        .into_iter()
        .filter(|(i, j)| side[*i] * side[*j] < 0.0);
    let crossings = crossed.map(|(i, j)| {
        let t = corners[i][1] / (corners[i][1] - corners[j][1]);
        let between = |a: f64, b: f64| a + t * (b - a);
        let xi = [0, 1, 2].map(|k: usize| between(CORNERS[i][k], CORNERS[j][k]));
        (between(corners[i][0], corners[j][0]), xi)
    });
    let ends: Vec<(f64, [f64; 3])> = through.chain(crossings).collect();
    match ends[..] {
        [(a, from), (b, to)] => Some(rising([a, b], element, [from, to])),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A line through two triangles and along no edge, f = 3x − 2y: exact, from boundary to boundary.
    #[test]
    fn a_centreline_cuts_triangles() {
        let vertices = vec![[-1.0, -0.5], [2.0, -1.0], [0.5, 1.0], [3.0, 2.0]];
        let elements = ElementFields {
            dim: 2,
            cells: vec![[0, 1, 2], [2, 1, 3]],
            vertices: vertices.clone(),
            ..ElementFields::default()
        };
        let value = |[x, y]: [f64; 2]| 3.0 * x - 2.0 * y;
        let field = Polynomials {
            order: 1,
            values: (elements.cells.iter().flatten())
                .map(|n| value(vertices[*n as usize]))
                .collect(),
        };
        let line = along(&elements, &field, X);
        // By hand: y = 0 meets the sides at x = −1/2, 5/4 and 7/3.
        assert!((line[0][0] + 0.5).abs() < 1e-12);
        assert!((line[line.len() - 1][0] - 7.0 / 3.0).abs() < 1e-12);
        assert!(line.is_sorted_by(|a, b| a[0] < b[0]));
        assert!(line.iter().all(|[x, v]| (v - 3.0 * x).abs() < 1e-12));
    }

    /// Triangles on both sides of an edge on the line: each piece occurs once, in rising order.
    #[test]
    fn an_edge_between_two_triangles_counts_once() {
        let vertices = vec![[-1.0, 0.0], [1.0, 0.0], [0.0, -1.0], [0.0, 1.0], [3.0, 0.0]];
        let elements = ElementFields {
            dim: 2,
            cells: vec![[0, 1, 2], [1, 0, 3], [1, 4, 3]],
            vertices: vertices.clone(),
            ..ElementFields::default()
        };
        let field = Polynomials {
            order: 1,
            values: (elements.cells.iter().flatten())
                .map(|n| vertices[*n as usize][0])
                .collect(),
        };
        let line = along(&elements, &field, X);
        assert_eq!(line.len(), 2 * PER_EDGE + 1);
        assert!(line.is_sorted_by(|a, b| a[0] < b[0]));
        assert!(line.iter().all(|[x, v]| (v - x).abs() < 1e-12));
    }

    /// y² + x on two triangles of order 2, one on each side of the line, and a third one to the left.
    #[test]
    fn the_line_across_is_found_in_triangles() {
        let lagrange = Lagrange::new(2, 2);
        let vertices = [
            [-1.0, 0.0],
            [1.0, 0.0],
            [0.5, -2.0],
            [-1.0, -2.0],
            [-3.0, -1.0],
        ];
        let cells = [[0, 1, 2], [0, 2, 3], [0, 3, 4]];
        let mut values = Vec::new();
        for cell in cells {
            let [a, b, c] = cell.map(|n: u32| vertices[n as usize]);
            for xi in lagrange.points() {
                let at = |k: usize| a[k] + xi[0] * (b[k] - a[k]) + xi[1] * (c[k] - a[k]);
                values.push(at(1) * at(1) + at(0));
            }
        }
        let elements = ElementFields {
            dim: 2,
            vertices: vertices.to_vec(),
            cells: cells.to_vec(),
            ..ElementFields::default()
        };
        let line = along(&elements, &Polynomials { order: 2, values }, Y);
        assert_eq!(line.len(), 2 * PER_EDGE + 1);
        assert_eq!((line[0][0], line[line.len() - 1][0]), (-2.0, 0.0));
        for [y, v] in line {
            assert!((v - y * y).abs() < 1e-12, "{y} {v}");
        }
    }

    /// T₅(x) on two segments of order 5, written from right to left: rising x, the maximum of 1 at cos(2π/5) found
    /// between nodes at which T₅ is 0.85 and −0.08 at the most.
    #[test]
    fn profiles_resolve_extrema_between_nodes() {
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
        let line = along(&elements, &field, X);
        assert_eq!(line.len(), 2 * PER_EDGE + 1);
        assert!(line.is_sorted_by(|a, b| a[0] < b[0]));
        for [x, v] in &line {
            assert!((v - bump(*x)).abs() < 1e-9 * bump(3.0).abs(), "{x} {v}");
        }
        let top = (line.iter()).filter(|p| (0.0..0.8).contains(&p[0]));
        let top = top.map(|p| p[1]).fold(0.0, f64::max);
        assert!(top > 0.99, "{top}");
        assert!(along(&elements, &Polynomials::default(), X).is_empty());
    }
}
