//! Adaptive samples of fields that are polynomials on elements, for pictures.
//!
//! Elements are divided into triangles on which the field is nearly linear: no contour is displaced by more than a
//! tenth of a pixel. In each round, triangles request edges to be halved; a triangle is divided according to the edges
//! that it or a neighbour requests, which leaves no gaps between fine and coarse triangles.

use ertel_fem::element::Lagrange;
use rayon::prelude::*;
use rustc_hash::FxHashMap;

use crate::solution::mirror;
use crate::solution::{ElementFields, Polynomials};

/// Maximum length of edges within the picture, px,
const LONGEST: f64 = 3.0;
/// and minimum length of edges halved for the sake of contours, px.
const FINE_ENOUGH: f64 = 0.7;
/// Tolerated displacement of a contour, px.
const OUT_OF_PLACE: f64 = 0.1;
/// Approximate maximum number of triangles of a sampling before mirroring.
const MOST: usize = 75_000;
/// Barycentric coordinates at which a polynomial is compared with the linear field: thirds of the edges, which reveal odd
/// and even deviations.
const PROBES: [[f64; 3]; 4] = {
    const A: f64 = 1.0 / 3.0;
    const B: f64 = 2.0 / 3.0;
    [[A, A, A], [A, B, 0.0], [0.0, A, B], [B, 0.0, A]]
};

/// Reference coordinates of an element's corners.
pub(super) const CORNERS: [[f64; 3]; 3] = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

/// The view of a field in a picture.
pub(super) struct View<'a> {
    /// Unit of length of the picture axes, m.
    pub unit: f64,
    /// Lower and upper limit of both axes, in that unit.
    pub window: [[f64; 2]; 2],
    /// Size of a pixel, in that unit.
    pub pixel: f64,
    /// Factor applied to the SI field.
    pub factor: f64,
    /// Contours, rising.
    pub levels: &'a [f64],
}

/// A field that is nearly linear on triangles.
#[derive(Default)]
pub(super) struct Sampling {
    /// Points, in the unit of the view.
    pub points: Vec<[f64; 2]>,
    /// Triangles.
    pub triangles: Vec<[u32; 3]>,
    /// Values at the points, times the factor of the view.
    pub values: Vec<f64>,
}

impl Sampling {
    /// Samples a field on triangles.
    pub fn new(elements: &ElementFields, field: &Polynomials, view: &View) -> Sampling {
        let mut sampler = Sampler::new(elements, field, view);
        while sampler.refine() {}
        Sampling {
            points: sampler.points,
            triangles: (sampler.pieces.iter())
                .map(|p| p.corners.map(|c| c.node))
                .collect(),
            values: sampler.values,
        }
    }

    /// The half y ≤ 0 with its mirror image.
    pub fn mirrored(&self) -> Sampling {
        let whole = mirror(&self.points, &self.triangles);
        Sampling {
            points: whole.points,
            triangles: whole.cells,
            values: whole.sources.iter().map(|i| self.values[*i]).collect(),
        }
    }
}

/// Corner of a piece: its point, and its position in the element.
#[derive(Clone, Copy)]
struct Corner {
    node: u32,
    xi: [f64; 3],
}

/// Triangle within an element.
#[derive(Clone, Copy)]
struct Piece {
    element: usize,
    corners: [Corner; 3],
    /// Whether no edge is to be halved.
    content: bool,
}

impl Piece {
    /// Key of the edge from corner `i` to the next one, independent of the side.
    fn edge(&self, i: usize) -> [u32; 2] {
        let (a, b) = (self.corners[i].node, self.corners[(i + 1) % 3].node);
        [a.min(b), a.max(b)]
    }
}

struct Sampler<'a> {
    view: &'a View<'a>,
    lagrange: Lagrange,
    field: &'a Polynomials,
    points: Vec<[f64; 2]>,
    values: Vec<f64>,
    pieces: Vec<Piece>,
}

impl<'a> Sampler<'a> {
    /// The elements that overlap the window, undivided.
    fn new(elements: &ElementFields, field: &'a Polynomials, view: &'a View) -> Sampler<'a> {
        let mut sampler = Sampler {
            view,
            lagrange: Lagrange::new(2, field.order),
            field,
            points: (elements.vertices.iter())
                .map(|v| v.map(|x| x / view.unit))
                .collect(),
            values: vec![0.0; elements.vertices.len()],
            pieces: Vec::new(),
        };
        for (element, cell) in elements.cells.iter().enumerate() {
            let corner = |i: usize| Corner {
                node: cell[i],
                xi: CORNERS[i],
            };
            let piece = Piece {
                element,
                corners: [0, 1, 2].map(corner),
                content: field.order == 1,
            };
            if sampler.visible(&piece) {
                for corner in piece.corners {
                    sampler.values[corner.node as usize] = sampler.value(element, corner.xi);
                }
                sampler.pieces.push(piece);
            }
        }
        sampler
    }

    fn value(&self, element: usize, xi: [f64; 3]) -> f64 {
        self.view.factor * value(&self.lagrange, self.field, element, xi)
    }

    fn visible(&self, piece: &Piece) -> bool {
        [0, 1].into_iter().all(|axis| {
            let [low, high] = self.view.window[axis];
            let at = piece.corners.map(|c| self.points[c.node as usize][axis]);
            at.iter().any(|v| *v >= low) && at.iter().any(|v| *v <= high)
        })
    }

    /// Edge lengths of a piece, px.
    fn lengths(&self, piece: &Piece) -> [f64; 3] {
        [0, 1, 2].map(|i| {
            let [a, b] = piece.edge(i).map(|n| self.points[n as usize]);
            (b[0] - a[0]).hypot(b[1] - a[1]) / self.view.pixel
        })
    }

    /// Halves the edges requested by the pieces; returns whether there were any.
    fn refine(&mut self) -> bool {
        let wants: Vec<[bool; 3]> = self.pieces.par_iter().map(|p| self.wants(p)).collect();
        let mut halved: FxHashMap<[u32; 2], Option<u32>> = FxHashMap::default();
        for (piece, wants) in self.pieces.iter_mut().zip(wants) {
            piece.content = wants == [false; 3];
            for (edge, _) in (0..3).zip(wants).filter(|(_, wanted)| *wanted) {
                halved.insert(piece.edge(edge), None);
            }
        }
        // Each halved edge divides two triangles
        if halved.is_empty() || self.pieces.len() + 2 * halved.len() > MOST {
            return false;
        }
        for piece in std::mem::take(&mut self.pieces) {
            let middles = [0, 1, 2].map(|i| {
                let middle = halved.get_mut(&piece.edge(i))?;
                Some(self.middle(&piece, i, middle))
            });
            cut(&piece, middles, &mut self.pieces);
        }
        true
    }

    /// The midpoint of an edge, created on first use.
    fn middle(&mut self, piece: &Piece, edge: usize, known: &mut Option<u32>) -> Corner {
        let (a, b) = (piece.corners[edge], piece.corners[(edge + 1) % 3]);
        let half = |i: usize| 0.5 * (a.xi[i] + b.xi[i]);
        let xi = [half(0), half(1), 0.0];
        let node = *known.get_or_insert_with(|| {
            let [p, q] = [a, b].map(|c| self.points[c.node as usize]);
            self.points.push([0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])]);
            self.values.push(self.value(piece.element, xi));
            (self.points.len() - 1) as u32
        });
        Corner { node, xi }
    }

    /// Edges that a piece requests to be halved: long ones, and those where a contour would be displaced.
    fn wants(&self, piece: &Piece) -> [bool; 3] {
        if piece.content {
            return [false; 3];
        }
        let lengths = self.lengths(piece);
        let longest = lengths.into_iter().fold(0.0, f64::max);
        if longest <= FINE_ENOUGH || !self.visible(piece) {
            return [false; 3];
        }
        if longest > LONGEST {
            return lengths.map(|l| l > LONGEST);
        }
        match self.is_bent(piece) {
            true => lengths.map(|l| l > FINE_ENOUGH.max(0.5 * longest)),
            false => [false; 3],
        }
    }

    /// Whether contours cross a piece and would be displaced if the field were linear on it.
    fn is_bent(&self, piece: &Piece) -> bool {
        let at_corners = piece.corners.map(|c| self.values[c.node as usize]);
        let mut deviation = 0.0_f64;
        let mut range = [f64::INFINITY, f64::NEG_INFINITY];
        let mut reach = |v: f64| range = [range[0].min(v), range[1].max(v)];
        at_corners.into_iter().for_each(&mut reach);
        for probe in PROBES {
            let at = |i: usize| (0..3).map(|k| probe[k] * piece.corners[k].xi[i]).sum();
            let value = self.value(piece.element, [at(0), at(1), 0.0]);
            let linear: f64 = (0..3).map(|k| probe[k] * at_corners[k]).sum();
            deviation = deviation.max((value - linear).abs());
            reach(value);
        }
        let [low, high] = range;
        let levels = self.view.levels;
        let next = levels.partition_point(|l| *l < low - deviation);
        let crossed = levels.get(next).is_some_and(|l| *l <= high + deviation);
        let slope = self.slope(piece, at_corners) * self.view.pixel;
        crossed && deviation > OUT_OF_PLACE * slope
    }

    /// Gradient of the linear field through the corners of a piece.
    fn slope(&self, piece: &Piece, values: [f64; 3]) -> f64 {
        let [a, b, c] = piece.corners.map(|c| self.points[c.node as usize]);
        let (u, v) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
        let (du, dv) = (values[1] - values[0], values[2] - values[0]);
        let x = du * v[1] - dv * u[1];
        let y = dv * u[0] - du * v[0];
        x.hypot(y) / (u[0] * v[1] - u[1] * v[0]).abs()
    }
}

/// Divides a piece at the midpoints of its edges, each given from a corner to the next one.
fn cut(piece: &Piece, middles: [Option<Corner>; 3], pieces: &mut Vec<Piece>) {
    let mut push = |corners: [Corner; 3]| {
        pieces.push(Piece {
            corners,
            content: false,
            ..*piece
        });
    };
    let n = middles.iter().flatten().count();
    // Rotated to make the first edge a halved one and, of two, the second
    let turn = (0..3).find(|t| (0..n).all(|i| middles[(t + i) % 3].is_some()));
    let turn = turn.unwrap_or(0);
    let [a, b, c] = [0, 1, 2].map(|i| piece.corners[(turn + i) % 3]);
    match [0, 1, 2].map(|i| middles[(turn + i) % 3]) {
        [Some(ab), None, None] => {
            push([a, ab, c]);
            push([ab, b, c]);
        }
        [Some(ab), Some(bc), None] => {
            push([ab, b, bc]);
            push([a, ab, bc]);
            push([a, bc, c]);
        }
        [Some(ab), Some(bc), Some(ca)] => {
            push([a, ab, ca]);
            push([ab, b, bc]);
            push([ca, bc, c]);
            push([ab, bc, ca]);
        }
        _ => pieces.push(*piece),
    }
}

/// A field at reference coordinates of an element.
pub(super) fn value(lagrange: &Lagrange, field: &Polynomials, element: usize, xi: [f64; 3]) -> f64 {
    let nodes = &field.values[element * lagrange.n_nodes()..];
    lagrange.values(xi).zip(nodes).map(|(n, v)| n * v).sum()
}

#[cfg(test)]
mod tests;
