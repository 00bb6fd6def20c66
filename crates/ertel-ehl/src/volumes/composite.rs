//! Triangles over all patches together, without gaps: cells of two triangles, and of three where the next grid has a node in the middle of an edge. Segments in
//! line contacts.

use super::film::share;
use super::level::Level;

/// A node: its level and its numbers along both directions.
pub type NodeOf = (usize, [usize; 2]);

/// Nodes and triangles.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Composite {
    /// The nodes, each of the finest grid that has it.
    pub nodes: Vec<NodeOf>,
    /// Corners of the triangles, all of one orientation; of segments in the first two entries.
    pub cells: Vec<[u32; 3]>,
}

const NONE: u32 = u32::MAX;

impl Composite {
    /// Of all levels.
    pub fn new(levels: &[Level]) -> Composite {
        let mut mesh = Composite::default();
        // Numbers of the nodes of the next finer grid.
        let mut finer: Vec<u32> = Vec::new();
        for l in (0..levels.len()).rev() {
            finer = mesh.add(levels, l, &finer);
        }
        mesh
    }

    /// Adds the part of a level outside the next one, whose nodes have these numbers; returns the numbers of the nodes of this level.
    fn add(&mut self, levels: &[Level], l: usize, finer: &[u32]) -> Vec<u32> {
        let grid = &levels[l].system.grid;
        let next = (l + 1 < levels.len()).then(|| &levels[l + 1].system.grid);
        let patch = levels[l].patch.filter(|_| next.is_some());
        // The number of the finer node at twice the distance from the corner of the patch, plus an offset; nodes outside the contact area come before it.
        let on_patch = |i: usize, j: usize, offset: [usize; 2]| -> Option<u32> {
            let ([[x0, x1], [y0, y1]], next) = patch.zip(next)?;
            let inside = (x0..=x1).contains(&i) && (y0..=y1).contains(&j);
            let [x, y] = next.walls.map(|[before, _]| usize::from(before));
            inside.then(|| {
                finer[next.index(2 * (i - x0) + x + offset[0], 2 * (j - y0) + y + offset[1])]
            })
        };
        let mut numbers = vec![NONE; grid.n_nodes()];
        for [i, j] in grid.nodes() {
            let number = match on_patch(i, j, [0; 2]) {
                Some(number) => number,
                None if share(levels, l, i, j) > 0.0 => {
                    self.nodes.push((l, [i, j]));
                    self.nodes.len() as u32 - 1
                }
                None => NONE,
            };
            numbers[grid.index(i, j)] = number;
        }
        if grid.is_line() {
            let is_inside = |i: usize| on_patch(i, 0, [0; 2]).is_some();
            let own = (1..grid.n[0]).filter(|i| !(is_inside(i - 1) && is_inside(*i)));
            let segments = own.map(|i| [numbers[i - 1], numbers[i], 0]);
            (self.cells).extend(segments.filter(|ends| !ends.contains(&NONE)));
            return numbers;
        }
        for [i, j] in grid.nodes() {
            if i + 1 == grid.n[0] || j + 1 == grid.n[1] {
                continue;
            }
            let corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
            let within = |[i, j]: [usize; 2]| on_patch(i, j, [0; 2]).is_some();
            if corners.iter().all(|corner| within(*corner)) {
                continue;
            }
            let mut around = Vec::with_capacity(5);
            let mut middle = None;
            for (a, b) in (0..4).map(|c| (corners[c], corners[(c + 1) % 4])) {
                around.push(numbers[grid.index(a[0], a[1])]);
                if within(a) && within(b) {
                    let low = [a[0].min(b[0]), a[1].min(b[1])];
                    let offset = if a[1] == b[1] { [1, 0] } else { [0, 1] };
                    middle = Some(around.len());
                    around.extend(on_patch(low[0], low[1], offset));
                }
            }
            // Outside the contact area, and beyond the end of a roller, there is nothing.
            if around.contains(&NONE) {
                continue;
            }
            // A fan from the node in the middle of an edge, or from a corner.
            around.rotate_left(middle.unwrap_or(0));
            for pair in around[1..].windows(2) {
                self.cells.push([around[0], pair[0], pair[1]]);
            }
        }
        numbers
    }
}
