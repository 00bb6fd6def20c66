//! Boxes around the points of sources and targets, and which of them are far enough from each other for expansions.
//!
//! A quadtree (of segments a binary tree) whose boxes of one level have one size. Boxes of one level that do not touch exchange expansions once their
//! parents touch; touching boxes of which one has no children are near. With a mirror plane y = 0 every source has an image; the plane
//! is a boundary of boxes, and the image of a box is the box on its other side.

use std::ops::Range;

/// No box.
pub const NONE: u32 = u32::MAX;
/// Levels beyond which nothing is split: points that agree to 24 bits.
const MAX_LEVEL: u32 = 24;

/// A box.
#[derive(Clone, Debug)]
pub struct Cell {
    /// Level; the side halves with each.
    pub level: u32,
    /// Number along x and y among the boxes of the level.
    pub place: [i32; 2],
    /// Its sources, in the order of the tree.
    pub sources: Range<usize>,
    /// Its targets, likewise.
    pub targets: Range<usize>,
    /// Children by quadrant (x + 2 y), [`NONE`] where there are no points.
    pub children: [u32; 4],
}

impl Cell {
    /// Whether it has no children.
    pub fn is_leaf(&self) -> bool {
        self.children == [NONE; 4]
    }
}

/// An expansion that goes from one box to another of its level.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Link {
    /// Box it comes from.
    pub from: u32,
    /// Whether from the image of that box.
    pub image: bool,
    /// Place of the source (or its image) less that of the target.
    pub offset: [i8; 2],
}

/// A box whose sources (or their images) are near a target box.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Near {
    /// The box of sources, a leaf or not.
    pub from: u32,
    /// Whether their images.
    pub image: bool,
}

/// The boxes.
#[derive(Clone, Debug)]
pub struct Tree {
    /// Level by level, parents before children.
    pub cells: Vec<Cell>,
    /// First box of each level, and the number of boxes.
    pub levels: Vec<usize>,
    /// Sources in the order of the tree.
    pub source_order: Vec<u32>,
    /// Targets in the order of the tree.
    pub target_order: Vec<u32>,
    corner: [f64; 2],
    side: f64,
    mirrored: bool,
}

impl Tree {
    /// Splits boxes that hold more than `most` sources or a tenth as many targets. With `mirrored`, all points lie at y ≤ 0.
    pub fn new(sources: &[[f64; 2]], targets: &[[f64; 2]], mirrored: bool, most: usize) -> Tree {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for p in sources.iter().chain(targets) {
            for a in 0..2 {
                low[a] = low[a].min(p[a]);
                high[a] = high[a].max(p[a]);
            }
        }
        if mirrored {
            high[1] = -low[1];
        }
        // A little more, so that rounding leaves no point outside
        let side = 1.000_001 * (high[0] - low[0]).max(high[1] - low[1]);
        let corner = [0, 1].map(|a: usize| 0.5 * (low[a] + high[a] - side));
        let mut tree = Tree {
            cells: vec![Cell {
                level: 0,
                place: [0, 0],
                sources: 0..sources.len(),
                targets: 0..targets.len(),
                children: [NONE; 4],
            }],
            levels: vec![0],
            source_order: (0..sources.len() as u32).collect(),
            target_order: (0..targets.len() as u32).collect(),
            corner,
            side,
            mirrored,
        };
        let mut first = 0;
        for level in 0..MAX_LEVEL {
            let end = tree.cells.len();
            tree.levels.push(end);
            for index in first..end {
                let cell = &tree.cells[index];
                if cell.sources.len() > most || 10 * cell.targets.len() > most {
                    tree.split(index, level, sources, targets);
                }
            }
            first = end;
            if tree.cells.len() == end {
                break;
            }
        }
        if tree.levels.last() != Some(&tree.cells.len()) {
            tree.levels.push(tree.cells.len());
        }
        tree
    }

    fn split(&mut self, index: usize, level: u32, sources: &[[f64; 2]], targets: &[[f64; 2]]) {
        let (centre, _) = self.frame(index);
        let Cell {
            place,
            sources: own_sources,
            targets: own_targets,
            ..
        } = self.cells[index].clone();
        let quadrant =
            |p: [f64; 2]| usize::from(p[0] > centre[0]) + 2 * usize::from(p[1] > centre[1]);
        let by_quadrant = |order: &mut [u32], points: &[[f64; 2]], start: usize| -> [usize; 5] {
            // Stable: points of an element stay together.
            let mut parts: [Vec<u32>; 4] = Default::default();
            for i in order.iter() {
                parts[quadrant(points[*i as usize])].push(*i);
            }
            let mut bounds = [start; 5];
            for (q, part) in parts.iter().enumerate() {
                bounds[q + 1] = bounds[q] + part.len();
                order[bounds[q] - start..bounds[q + 1] - start].copy_from_slice(part);
            }
            bounds
        };
        let s = by_quadrant(
            &mut self.source_order[own_sources.clone()],
            sources,
            own_sources.start,
        );
        let t = by_quadrant(
            &mut self.target_order[own_targets.clone()],
            targets,
            own_targets.start,
        );
        for q in 0..4 {
            if s[q] == s[q + 1] && t[q] == t[q + 1] {
                continue;
            }
            self.cells[index].children[q] = self.cells.len() as u32;
            self.cells.push(Cell {
                level: level + 1,
                place: [2 * place[0] + (q % 2) as i32, 2 * place[1] + (q / 2) as i32],
                sources: s[q]..s[q + 1],
                targets: t[q]..t[q + 1],
                children: [NONE; 4],
            });
        }
    }

    /// Half of the side of boxes of a level.
    pub fn half_side(&self, level: u32) -> f64 {
        0.5 * self.side / f64::from(1u32 << level)
    }

    /// Centre of a box and half of its side.
    pub fn frame(&self, cell: usize) -> ([f64; 2], f64) {
        let cell = &self.cells[cell];
        let half = self.half_side(cell.level);
        let centre =
            [0, 1].map(|a: usize| self.corner[a] + half * f64::from(2 * cell.place[a] + 1));
        (centre, half)
    }

    /// Place of a source box, or of its image.
    fn seen(&self, cell: &Cell, image: bool) -> [i32; 2] {
        match image {
            false => cell.place,
            true => [cell.place[0], (1 << cell.level) - 1 - cell.place[1]],
        }
    }

    /// Links and near boxes of every target box; near boxes at leaves only.
    pub fn lists(&self) -> (Vec<Vec<Link>>, Vec<Vec<Near>>) {
        let n = self.cells.len();
        let mut lists = Lists {
            links: vec![Vec::new(); n],
            near: vec![Vec::new(); n],
        };
        self.pair(0, 0, false, &mut lists);
        if self.mirrored {
            self.pair(0, 0, true, &mut lists);
        }
        (lists.links, lists.near)
    }

    fn pair(&self, target: usize, source: usize, image: bool, lists: &mut Lists) {
        let (a, b) = (&self.cells[target], &self.cells[source]);
        if a.targets.is_empty() || b.sources.is_empty() {
            return;
        }
        let seen = self.seen(b, image);
        let offset = [seen[0] - a.place[0], seen[1] - a.place[1]];
        let from = source as u32;
        if offset.iter().any(|d| d.abs() > 1) {
            lists.links[target].push(Link {
                from,
                image,
                offset: offset.map(|d| d as i8),
            });
            return;
        }
        match (a.is_leaf(), b.is_leaf()) {
            (true, _) => lists.near[target].push(Near { from, image }),
            (false, true) => {
                for child in a.children.into_iter().filter(|c| *c != NONE) {
                    self.near_below(child as usize, Near { from, image }, lists);
                }
            }
            (false, false) => {
                for child in a.children.into_iter().filter(|c| *c != NONE) {
                    for other in b.children.into_iter().filter(|c| *c != NONE) {
                        self.pair(child as usize, other as usize, image, lists);
                    }
                }
            }
        }
    }

    /// Hands a near box down to the leaves below a target box.
    fn near_below(&self, target: usize, near: Near, lists: &mut Lists) {
        let cell = &self.cells[target];
        if cell.is_leaf() {
            if !cell.targets.is_empty() {
                lists.near[target].push(near);
            }
            return;
        }
        for child in cell.children.into_iter().filter(|c| *c != NONE) {
            self.near_below(child as usize, near, lists);
        }
    }

    /// Calls `f` for every leaf with targets that meets the rectangle from `low` to `high`.
    pub fn leaves_within(&self, low: [f64; 2], high: [f64; 2], f: &mut impl FnMut(usize)) {
        let mut stack = vec![0];
        while let Some(index) = stack.pop() {
            let cell = &self.cells[index];
            let (centre, half) = self.frame(index);
            let meets = (0..2).all(|a| centre[a] - half <= high[a] && centre[a] + half >= low[a]);
            if cell.targets.is_empty() || !meets {
                continue;
            }
            if cell.is_leaf() {
                f(index);
            }
            stack.extend(
                cell.children
                    .iter()
                    .filter(|c| **c != NONE)
                    .map(|c| *c as usize),
            );
        }
    }
}

struct Lists {
    links: Vec<Vec<Link>>,
    near: Vec<Vec<Near>>,
}
