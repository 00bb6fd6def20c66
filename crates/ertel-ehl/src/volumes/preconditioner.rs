//! An approximation of the linearised film equation that can be factorised.
//!
//! ```text
//!   δP = S w,   S ≈ K⁻¹ by nine points        (A S + B) w = r,   A: fluxes by the pressures, B: by the films, upwind of first order
//! ```
//! The compliance is long-range, its inverse is not.

use std::sync::Arc;

use ertel_fem::assembly::NodeGraph;
use ertel_fem::linear::frontal_lu::{FrontalLu, FrontalPattern};
use ertel_fem::linear::fronts::Blocks;
use ertel_fem::linear::ordering::OrderingError;

use super::grid::{Grid, RING};
use super::system::Linearised;

/// What all preconditioners of a grid share.
pub struct Pattern {
    grid: Grid,
    /// Unknown nodes along each direction: a rectangle within the given ones.
    n: [usize; 2],
    frontal: Arc<FrontalPattern>,
    /// S at the centre, along both directions and on the diagonals.
    inverse: [f64; 4],
}

/// Nodes along each side of the blocks that are eliminated together: the stencil of A S reaches neighbouring blocks alone.
const BLOCK: usize = 2;

/// Reach of that stencil along each direction; its corners are empty.
const REACH: i64 = 2;

impl Pattern {
    /// For a grid, with the stencil S.
    ///
    /// # Errors
    /// When no order of elimination is found.
    pub fn new(grid: &Grid, inverse: [f64; 4]) -> Result<Pattern, OrderingError> {
        let [nx, ny] = grid.n;
        let n = [nx - 2 * RING, ny - if grid.half { RING } else { 2 * RING }];
        let blocks = n.map(|n| n.div_ceil(BLOCK));
        let members = |block: [usize; 2]| -> Vec<u32> {
            let along = |d: usize| block[d] * BLOCK..((block[d] + 1) * BLOCK).min(n[d]);
            let rows = along(1);
            rows.flat_map(|j| along(0).map(move |i| (j * n[0] + i) as u32))
                .collect()
        };
        let all = (0..blocks[1]).flat_map(|j| (0..blocks[0]).map(move |i| [i, j]));
        let near = |at: usize, n: usize| at.saturating_sub(1)..(at + 2).min(n);
        let mut graph = NodeGraph {
            offsets: vec![0],
            neighbours: Vec::new(),
        };
        for [i, j] in all.clone() {
            for row in near(j, blocks[1]) {
                let others = near(i, blocks[0]).map(|column| (row * blocks[0] + column) as u32);
                graph.neighbours.extend(others);
            }
            graph.offsets.push(graph.neighbours.len());
        }
        let blocks = Blocks {
            graph: &graph,
            n_inner: blocks[0] * blocks[1],
            carriers: None,
            unknowns: all.map(members).collect(),
        };
        let entries: Vec<(u32, u32)> = (0..n[0] * n[1])
            .flat_map(|row| neighbours(n, row).map(move |(_, column)| (row as u32, column)))
            .collect();
        Ok(Pattern {
            frontal: Arc::new(FrontalPattern::new(&blocks, &entries)?),
            grid: grid.clone(),
            n,
            inverse,
        })
    }

    /// The node of an unknown.
    fn node(&self, unknown: usize) -> usize {
        let [i, j] = [unknown % self.n[0], unknown / self.n[0]];
        self.grid.index(i + RING, j + RING)
    }

    /// Number of unknowns.
    fn len(&self) -> usize {
        self.n[0] * self.n[1]
    }

    /// The stencil of A S + B at a node.
    fn square(&self, node: usize, cross: &Cross) -> [f64; (SIDE * SIDE) as usize] {
        let [nx, ny] = self.grid.n;
        let row = (node / nx) as i64;
        let mut square = [0.0; (SIDE * SIDE) as usize];
        let mut put = |[i, j]: [i64; 2], value: f64| {
            // Beyond the centreline of a half all is mirrored.
            let beyond = row + j - (ny as i64 - 1);
            let j = match self.grid.half && beyond > 0 {
                true => j - 2 * beyond,
                false => j,
            };
            square[at_square([i, j])] += value;
        };
        for (place, (by_pressure, by_film)) in CROSS
            .into_iter()
            .zip(cross.by_pressure.into_iter().zip(cross.by_film))
        {
            put(place, by_film);
            for dj in -1..=1_i64 {
                for di in -1..=1_i64 {
                    let weight = self.inverse[(di.abs() + 2 * dj.abs()) as usize];
                    put([place[0] + di, place[1] + dj], by_pressure * weight);
                }
            }
        }
        square
    }
}

/// Unknowns that the stencil of one reaches, with their places beside it.
fn neighbours(n: [usize; 2], unknown: usize) -> impl Iterator<Item = ([i64; 2], u32)> {
    let at = [unknown % n[0], unknown / n[0]].map(|i| i as i64);
    let places = (-REACH..=REACH).flat_map(|j| (-REACH..=REACH).map(move |i| [i, j]));
    places
        .filter(|[i, j]| i.abs() + j.abs() < 2 * REACH)
        .filter_map(move |place| {
            let [i, j] = [at[0] + place[0], at[1] + place[1]];
            let is_unknown = (0..n[0] as i64).contains(&i) && (0..n[1] as i64).contains(&j);
            is_unknown.then(|| (place, (j * n[0] as i64 + i) as u32))
        })
}

/// What a row of the equation has at its node and the four beside it: centre, west, east, south, north.
#[derive(Clone, Copy, Debug, Default)]
struct Cross {
    by_pressure: [f64; 5],
    by_film: [f64; 5],
}

/// Places of the entries of a [`Cross`].
const CROSS: [[i64; 2]; 5] = [[0, 0], [-1, 0], [1, 0], [0, -1], [0, 1]];

impl Cross {
    /// Of a node where the film has broken: the equation P = 0.
    fn broken() -> Cross {
        let mut cross = Cross::default();
        cross.by_pressure[0] = 1.0;
        cross
    }

    /// Of a wetted node: the fluxes through its faces, entrainment from upstream by the first order.
    fn wetted(grid: &Grid, at: &Linearised, k: usize) -> Cross {
        let [nx, ny] = grid.n;
        let mut cross = Cross::default();
        cross.add(grid, at, (0, k), 1.0, true);
        cross.add(grid, at, (0, k - 1), -1.0, false);
        // Beyond the centreline of a half all is mirrored.
        match grid.half && k / nx + 1 == ny {
            true => cross.add(grid, at, (1, k - nx), -2.0, false),
            false => {
                cross.add(grid, at, (1, k), 1.0, true);
                cross.add(grid, at, (1, k - nx), -1.0, false);
            }
        }
        cross
    }

    /// Adds a face of a direction, at whose first or second end the node lies.
    fn add(
        &mut self,
        grid: &Grid,
        at: &Linearised,
        (direction, face): (usize, usize),
        sign: f64,
        is_first: bool,
    ) {
        let f = &at.faces[direction][face];
        // What a gap that is not full passes on does not change with the pressure behind it: what flows back into it comes again.
        if f.by_content != 0.0 && f.from_second == is_first {
            return;
        }
        let weight = sign / grid.spacing[direction];
        let ends = [face, face + [1, grid.n[0]][direction]];
        let other = 1 + 2 * direction + usize::from(is_first);
        let slots = if is_first { [0, other] } else { [other, 0] };
        for (slot, slope) in slots.into_iter().zip(f.by_pressure) {
            self.by_pressure[slot] += weight * slope;
            self.by_film[slot] += weight * f.by_film;
        }
        let upstream = usize::from(f.from_second);
        let entrained: f64 = f.by_mass.iter().sum();
        let [mass_by_pressure, mass_by_film] = at.nodes[ends[upstream]].mass_by;
        self.by_pressure[slots[upstream]] += weight * entrained * mass_by_pressure;
        self.by_film[slots[upstream]] += weight * entrained * mass_by_film;
    }
}

/// Side of a square that holds the stencil of A S.
const SIDE: i64 = 2 * REACH + 1;

/// Position in that square of a place beside its centre.
fn at_square([i, j]: [i64; 2]) -> usize {
    ((j + REACH) * SIDE + i + REACH) as usize
}

/// The factorised approximation.
pub struct Preconditioner<'a> {
    pattern: &'a Pattern,
    lu: FrontalLu,
    /// Size of each row, by which residuals become heights of the film: 1 at nodes that are not solved for.
    pub scale: Vec<f64>,
}

impl<'a> Preconditioner<'a> {
    /// Factorises at a state; `None` where the matrix is singular.
    pub fn new(pattern: &'a Pattern, at: &Linearised) -> Option<Preconditioner<'a>> {
        let grid = &pattern.grid;
        let mut values = Vec::new();
        let mut scale = vec![1.0; grid.n_nodes()];
        for unknown in 0..pattern.len() {
            let k = pattern.node(unknown);
            let cross = match at.wetted[k] {
                true => Cross::wetted(grid, at, k),
                false => Cross::broken(),
            };
            let square = pattern.square(k, &cross);
            let row = values.len();
            values
                .extend(neighbours(pattern.n, unknown).map(|(place, _)| square[at_square(place)]));
            // Rows of like size, for single precision and for residuals that mean the same everywhere.
            let size = values[row..]
                .iter()
                .fold(0.0_f64, |m: f64, v: &f64| m.max(v.abs()));
            values[row..].iter_mut().for_each(|v| *v /= size);
            scale[k] = size;
        }
        let lu = FrontalLu::new(&pattern.frontal, &values).ok()?;
        Some(Preconditioner { pattern, lu, scale })
    }

    /// Pressures δP = S w for scaled residuals at all nodes.
    pub fn solve(&mut self, residual: &[f64]) -> Vec<f64> {
        let p = self.pattern;
        let grid = &p.grid;
        let [nx, ny] = grid.n;
        let mut w: Vec<f64> = (0..p.len())
            .map(|unknown| residual[p.node(unknown)])
            .collect();
        self.lu.solve(&mut w);
        let mut film = vec![0.0; grid.n_nodes()];
        for (unknown, w) in w.iter().enumerate() {
            film[p.node(unknown)] = *w;
        }
        let [s0, sx, sy, sd] = p.inverse;
        let mut pressure = vec![0.0; grid.n_nodes()];
        for k in (0..p.len()).map(|unknown| p.node(unknown)) {
            let below = k - nx;
            let above = match grid.half && k / nx + 1 == ny {
                true => below,
                false => k + nx,
            };
            let beside = |k: usize| film[k - 1] + film[k + 1];
            pressure[k] = s0 * film[k]
                + sx * beside(k)
                + sy * (film[below] + film[above])
                + sd * (beside(below) + beside(above));
        }
        pressure
    }
}
