//! Regular grids of nodes, each in the middle of its volume.

use std::sync::Arc;

use super::rows::Rows;
use crate::contact::{HertzZone, Turn};

/// Layers of nodes along an edge whose pressure is given: what the third-order upwind fluxes reach for.
pub const RING: usize = 2;

/// Nodes of a patch, lines along the principal directions of the bodies; one node is the centre of the contact.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    /// Distance of the nodes along the first and the second principal direction, in half-widths.
    pub spacing: [f64; 2],
    /// Number of the first node along each direction, counted from the centre.
    pub first: [i64; 2],
    /// Nodes along each direction.
    pub n: [usize; 2],
    /// Whether the last row is the centreline, beyond which all is mirrored.
    pub half: bool,
    /// From the motion to the principal directions.
    pub turn: Turn,
    /// Rows of a roller, at uneven distances; `spacing` tells nothing of them.
    pub rows: Option<Arc<Rows>>,
}

impl Grid {
    /// The grid that covers a box of the plane in which the zone is the unit circle, `[[low, high]; 2]`, with cells of the size h there.
    pub fn covering(bounds: [[f64; 2]; 2], h: f64, half: bool, zone: &HertzZone) -> Grid {
        let first = bounds.map(|[low, _]| (low / h).round() as i64);
        let last = bounds.map(|[_, high]| (high / h).round() as i64);
        let last = [last[0], if half { 0 } else { last[1] }];
        Grid {
            spacing: [h, h * zone.axis_ratio],
            first,
            n: [0, 1].map(|i: usize| (last[i] - first[i] + 1) as usize),
            half,
            turn: zone.turn,
            rows: None,
        }
    }

    /// The grid over these columns, counted from the middle at the distance h, and the rows of a roller, of which this many come before the middle.
    pub fn of_roller(columns: [i64; 2], h: f64, rows: Rows, before: usize, half: bool) -> Grid {
        Grid {
            spacing: [h, f64::NAN],
            first: [columns[0], -(before as i64)],
            n: [(columns[1] - columns[0] + 1) as usize, rows.n()],
            half,
            turn: Turn::NONE,
            rows: Some(Arc::new(rows)),
        }
    }

    /// The grid of a line contact over these columns, counted from the middle at the distance h: one row that stands for a unit of length.
    pub fn of_line(columns: [i64; 2], h: f64) -> Grid {
        Grid {
            spacing: [h, 1.0],
            first: [columns[0], 0],
            n: [(columns[1] - columns[0] + 1) as usize, 1],
            half: false,
            turn: Turn::NONE,
            rows: None,
        }
    }

    /// Whether all is the same along the second direction, and nothing flows there.
    #[inline(always)]
    pub fn is_line(&self) -> bool {
        self.n[1] == 1
    }

    /// Size of a cell, m, where a half-width is `length`; one of a line has no end across, nor have those of a roller, whose rows are uneven.
    pub fn cell_size(&self, length: f64) -> [f64; 2] {
        let [along, across] = self.spacing.map(|h| h * length);
        match self.is_line() || self.rows.is_some() {
            true => [along, f64::INFINITY],
            false => [along, across],
        }
    }

    /// Rows whose pressures are unknown between the edges.
    #[inline(always)]
    pub fn inner_rows(&self) -> std::ops::Range<usize> {
        let ny = self.n[1];
        match (self.is_line(), self.half) {
            (true, _) => 0..1,
            (false, true) => RING..ny,
            (false, false) => RING..ny - RING,
        }
    }

    /// The box that it covers, with its mirror image, in the plane in which the zone is the unit circle.
    pub fn bounds(&self) -> [[f64; 2]; 2] {
        [0, 1].map(|d: usize| {
            let h = self.spacing[0];
            let low = self.first[d] as f64 * h;
            match self.half && d == 1 {
                true => [low, -low],
                false => [low, low + (self.n[d] - 1) as f64 * h],
            }
        })
    }

    /// Number of nodes.
    pub fn n_nodes(&self) -> usize {
        self.n[0] * self.n[1]
    }

    /// Position of a node in arrays.
    #[inline(always)]
    pub fn index(&self, i: usize, j: usize) -> usize {
        j * self.n[0] + i
    }

    /// Place of a node along the principal directions.
    #[inline(always)]
    pub fn on_axes(&self, i: usize, j: usize) -> [f64; 2] {
        [
            (self.first[0] + i as i64) as f64 * self.spacing[0],
            match &self.rows {
                None => (self.first[1] + j as i64) as f64 * self.spacing[1],
                Some(rows) => rows.places()[j],
            },
        ]
    }

    /// Distance from a node of a row to the next one along a direction.
    #[inline(always)]
    pub fn step(&self, direction: usize, j: usize) -> f64 {
        match &self.rows {
            Some(rows) if direction == 1 => rows.step(j),
            _ => self.spacing[direction],
        }
    }

    /// Length of the cell of a node of a row along a direction.
    #[inline(always)]
    pub fn length(&self, direction: usize, j: usize) -> f64 {
        match &self.rows {
            Some(rows) if direction == 1 => rows.height(j),
            _ => self.spacing[direction],
        }
    }

    /// Whether a row lies where a roller ends, or beyond: there is no pressure.
    #[inline(always)]
    pub fn is_end(&self, j: usize) -> bool {
        self.rows.as_ref().is_some_and(|rows| rows.is_end(j))
    }

    /// Place of a node along and across the motion.
    pub fn place(&self, i: usize, j: usize) -> [f64; 2] {
        self.turn.to_motion(self.on_axes(i, j))
    }

    /// The node at the centre.
    pub fn centre(&self) -> [usize; 2] {
        self.first.map(|first| (-first) as usize)
    }

    /// Whether the pressure of a node is unknown; that of the nodes along the edge is given.
    #[inline(always)]
    pub fn is_unknown(&self, i: usize, j: usize) -> bool {
        (RING..self.n[0] - RING).contains(&i) && self.inner_rows().contains(&j)
    }

    /// Share of its cell that a node stands for in sums: half of it along the edges and on the centreline of a half.
    #[inline(always)]
    pub fn share(&self, i: usize, j: usize) -> f64 {
        let [nx, ny] = self.n;
        let x = if i == 0 || i + 1 == nx { 0.5 } else { 1.0 };
        let y = match &self.rows {
            Some(rows) if rows.height(j) == 0.0 => 0.0,
            Some(_) if !(self.half && j + 1 == ny) => 1.0,
            None if self.is_line() => 1.0,
            None if j > 0 && j + 1 < ny => 1.0,
            _ => 0.5,
        };
        x * y
    }

    /// Area of the cell of a node of a row.
    pub fn cell(&self, j: usize) -> f64 {
        self.spacing[0] * self.length(1, j)
    }

    /// All nodes, row by row.
    pub fn nodes(&self) -> impl Iterator<Item = [usize; 2]> {
        let [nx, ny] = self.n;
        (0..ny).flat_map(move |j| (0..nx).map(move |i| [i, j]))
    }
}
