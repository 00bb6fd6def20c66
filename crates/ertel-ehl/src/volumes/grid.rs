//! Regular grids of nodes, each in the middle of its volume.

use std::sync::Arc;

use super::rows::{RING, Rows};
use crate::contact::{HertzZone, Turn};

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
    /// Rows of a roller, at uneven distances, which `spacing` does not describe.
    pub rows: Option<Arc<Rows>>,
    /// Lengths along the second direction over those in the plane in which the zone is the unit circle.
    pub stretch: f64,
    /// Along each direction, whether the grid ends where the contact area does, before and behind the centre: there one layer of its nodes lies outside the area,
    /// so that the given pressure next to the unknown ones is that of the edge.
    pub walls: [[bool; 2]; 2],
}

/// A grid whose edges all lie within the contact area.
const NO_WALLS: [[bool; 2]; 2] = [[false; 2]; 2];

impl Grid {
    /// The grid that covers a box of the plane in which the zone is the unit circle, `[[low, high]; 2]`, with cells of these lengths there.
    pub fn covering(bounds: [[f64; 2]; 2], cell: [f64; 2], half: bool, zone: &HertzZone) -> Grid {
        let count = |d: usize, length: f64| (length / cell[d]).round() as i64;
        let first = [0, 1].map(|d: usize| count(d, bounds[d][0]));
        let last = [0, 1].map(|d: usize| count(d, bounds[d][1]));
        let last = [last[0], if half { 0 } else { last[1] }];
        Grid {
            spacing: [cell[0], cell[1] * zone.axis_ratio],
            first,
            n: [0, 1].map(|i: usize| (last[i] - first[i] + 1) as usize),
            half,
            turn: zone.turn,
            rows: None,
            stretch: zone.axis_ratio,
            walls: NO_WALLS,
        }
    }

    /// The same with edges of the contact area, and one layer of nodes outside each of them.
    #[must_use]
    pub fn with_walls(mut self, walls: [[bool; 2]; 2]) -> Grid {
        self.walls = walls;
        // The last row of a half is the centreline, and a line has one.
        self.walls[1][1] &= !self.half;
        if self.is_line() {
            self.walls[1] = [false; 2];
        }
        for (d, [before, behind]) in self.walls.into_iter().enumerate() {
            self.first[d] -= i64::from(before);
            self.n[d] += usize::from(before) + usize::from(behind);
        }
        self
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
            stretch: 1.0,
            walls: NO_WALLS,
        }
    }

    /// The grid of a line contact over these columns, counted from the middle at the distance h: one row that represents a unit of length.
    pub fn of_line(columns: [i64; 2], h: f64) -> Grid {
        Grid {
            spacing: [h, 1.0],
            first: [columns[0], 0],
            n: [(columns[1] - columns[0] + 1) as usize, 1],
            half: false,
            turn: Turn::NONE,
            rows: None,
            stretch: 1.0,
            walls: NO_WALLS,
        }
    }

    /// Whether it is the grid of a line contact: nothing varies or flows along the second direction.
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

    /// Numbers, counted from the centre, of the first and last node of the area that the grid represents, along a direction.
    pub fn ends(&self, direction: usize) -> [i64; 2] {
        let first = self.first[direction];
        let [before, behind] = self.walls[direction].map(i64::from);
        [
            first + before,
            first + self.n[direction] as i64 - 1 - behind,
        ]
    }

    /// Length of a cell along both directions in the plane in which the zone is the unit circle.
    pub fn unit_cell(&self) -> [f64; 2] {
        [self.spacing[0], self.spacing[1] / self.stretch]
    }

    /// The box that it represents, with its mirror image, in the plane in which the zone is the unit circle.
    pub fn bounds(&self) -> [[f64; 2]; 2] {
        let cell = self.unit_cell();
        [0, 1].map(|d: usize| {
            let [low, high] = self.ends(d).map(|n| n as f64 * cell[d]);
            match self.half && d == 1 {
                true => [low, -low],
                false => [low, high],
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

    /// Share of the length of its cell that a node represents along a direction: none outside the contact area, half where the grid ends. The centreline of a half
    /// counts with its mirror image.
    #[inline(always)]
    pub fn share_along(&self, direction: usize, at: usize) -> f64 {
        if direction == 1 && self.is_line() {
            return 1.0;
        }
        if let (Some(rows), 1) = (&self.rows, direction) {
            return if rows.height(at) == 0.0 { 0.0 } else { 1.0 };
        }
        let [before, behind] = self.walls[direction].map(usize::from);
        let edge = |steps: usize, beyond: usize| match steps {
            _ if steps < beyond => 0.0,
            _ if steps == beyond => 0.5,
            _ => 1.0,
        };
        match edge(at, before) {
            _ if self.half && direction == 1 => edge(at, before),
            share => f64::min(share, edge(self.n[direction] - 1 - at, behind)),
        }
    }

    /// Weight of a row of a half grid: the centreline counts half.
    #[inline(always)]
    pub fn mirrored_share(&self, j: usize) -> f64 {
        if self.half && j + 1 == self.n[1] {
            0.5
        } else {
            1.0
        }
    }

    /// Share of its cell that a node represents in sums.
    #[inline(always)]
    pub fn share(&self, i: usize, j: usize) -> f64 {
        self.share_along(0, i) * self.share_along(1, j) * self.mirrored_share(j)
    }

    /// Values at the nodes, each times the share of its cell that lies on the grid; the convolutions mirror the centreline themselves.
    pub fn within_edges(&self, values: &[f64]) -> Vec<f64> {
        let rows: Vec<f64> = (0..self.n[1]).map(|j| self.share_along(1, j)).collect();
        let columns: Vec<f64> = (0..self.n[0]).map(|i| self.share_along(0, i)).collect();
        (values.chunks_exact(self.n[0]).zip(rows))
            .flat_map(|(values, row)| {
                (values.iter().zip(&columns)).map(move |(value, column)| value * row * column)
            })
            .collect()
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

/// Slopes along both directions by differences, one-sided along the edges.
pub(super) fn slopes(grid: &Grid, values: &[f64], i: usize, j: usize) -> [f64; 2] {
    let difference = |at: usize, n: usize, mirrored: bool, of: &dyn Fn(usize) -> f64, d: usize| {
        if (mirrored && at + 1 == n) || n == 1 {
            return 0.0;
        }
        let (low, high) = (at.saturating_sub(1), (at + 1).min(n - 1));
        let distance = match d == 1 && grid.rows.is_some() {
            false => (high - low) as f64 * grid.spacing[d],
            true => grid.on_axes(i, high)[1] - grid.on_axes(i, low)[1],
        };
        (of(high) - of(low)) / distance
    };
    let [nx, ny] = grid.n;
    [
        difference(i, nx, false, &|i| values[grid.index(i, j)], 0),
        difference(j, ny, grid.half, &|j| values[grid.index(i, j)], 1),
    ]
}
