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
    /// Number of each unknown.
    number: Vec<u32>,
    /// Nodes of the unknowns.
    nodes: Vec<u32>,
    entries: Vec<(u32, u32)>,
    /// Offsets of the stencil's points.
    points: Vec<[i64; 2]>,
    frontal: Arc<FrontalPattern>,
    inverse: [f64; 4],
}

/// Nodes along each side of the blocks that are eliminated together.
const BLOCK: usize = 2;
/// Reach of the stencil of A S along each direction.
const REACH: i64 = 2;

const NONE: u32 = u32::MAX;

impl Pattern {
    /// For a grid, with the stencil S.
    ///
    /// # Errors
    /// When no order of elimination is found.
    pub fn new(grid: &Grid, inverse: [f64; 4]) -> Result<Pattern, OrderingError> {
        let mut number = vec![NONE; grid.len()];
        let mut nodes = Vec::new();
        for [i, j] in grid.nodes().filter(|[i, j]| grid.is_unknown(*i, *j)) {
            number[grid.index(i, j)] = nodes.len() as u32;
            nodes.push(grid.index(i, j) as u32);
        }
        let points: Vec<[i64; 2]> = (-REACH..=REACH)
            .flat_map(|j| (-REACH..=REACH).map(move |i| [i, j]))
            .filter(|[i, j]| i.abs() + j.abs() < 2 * REACH)
            .collect();
        let nx = grid.n[0];
        let mut entries = Vec::new();
        for (row, k) in nodes.iter().enumerate() {
            let (i, j) = ((*k as usize % nx) as i64, (*k as usize / nx) as i64);
            for [di, dj] in &points {
                let (ni, nj) = (i + di, j + dj);
                if nj < 0 || nj >= grid.n[1] as i64 || ni < 0 || ni >= nx as i64 {
                    continue;
                }
                let column = number[grid.index(ni as usize, nj as usize)];
                if column != NONE {
                    entries.push((row as u32, column));
                }
            }
        }
        // Blocks of nodes, whose stencils reach neighbouring blocks alone.
        let [bx, by] = [0, 1].map(|d: usize| (grid.n[d] - RING).div_ceil(BLOCK));
        let block = |i: usize, j: usize| ((j - RING) / BLOCK) * bx + (i - RING) / BLOCK;
        let mut unknowns = vec![Vec::new(); bx * by];
        for k in &nodes {
            let (i, j) = (*k as usize % nx, *k as usize / nx);
            unknowns[block(i, j)].push(number[*k as usize]);
        }
        let present: Vec<usize> = (0..bx * by).filter(|b| !unknowns[*b].is_empty()).collect();
        let mut of = vec![NONE; bx * by];
        for (new, old) in present.iter().enumerate() {
            of[*old] = new as u32;
        }
        let mut graph = NodeGraph {
            offsets: vec![0],
            neighbours: Vec::new(),
        };
        for b in &present {
            let (i, j) = ((b % bx) as i64, (b / bx) as i64);
            for dj in -1..=1 {
                for di in -1..=1 {
                    let (ni, nj) = (i + di, j + dj);
                    if (0..bx as i64).contains(&ni) && (0..by as i64).contains(&nj) {
                        let other = of[nj as usize * bx + ni as usize];
                        if other != NONE {
                            graph.neighbours.push(other);
                        }
                    }
                }
            }
            graph.offsets.push(graph.neighbours.len());
        }
        let blocks = Blocks {
            graph: &graph,
            n_inner: present.len(),
            carriers: None,
            unknowns: present
                .iter()
                .map(|b| std::mem::take(&mut unknowns[*b]))
                .collect(),
        };
        let frontal = FrontalPattern::new(&blocks, &entries)?;
        Ok(Pattern {
            grid: grid.clone(),
            number,
            nodes,
            entries,
            points,
            frontal: Arc::new(frontal),
            inverse,
        })
    }
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
        let [nx, ny] = grid.n;
        let [dx, dy] = grid.spacing;
        let [s0, sx, sy, sd] = pattern.inverse;
        let s = |i: i64, j: i64| match (i.abs(), j.abs()) {
            (0, 0) => s0,
            (1, 0) => sx,
            (0, 1) => sy,
            (1, 1) => sd,
            _ => 0.0,
        };
        let mut values = vec![0.0; pattern.entries.len()];
        let mut next = 0;
        let width = (2 * REACH + 1) as usize;
        let mut stencil = vec![0.0; width * width];
        for k in &pattern.nodes {
            let k = *k as usize;
            let (i, j) = (k % nx, k / nx);
            // By P and by H at the node and its four neighbours: centre, west, east, south, north.
            let (mut by_p, mut by_h) = ([0.0; 5], [0.0; 5]);
            if at.wetted[k] {
                let mut add = |sign: f64, direction: usize, face: usize, here_is_first: bool| {
                    let f = &at.faces[direction][face];
                    let step = [1, nx][direction];
                    let (a, b) = (face, face + step);
                    let w = sign / [dx, dy][direction];
                    let other = match (direction, here_is_first) {
                        (0, false) => 1,
                        (0, true) => 2,
                        (_, false) => 3,
                        (_, true) => 4,
                    };
                    let slot = |is_a: bool| if is_a == here_is_first { 0 } else { other };
                    by_p[slot(true)] += w * f.by_pressure[0];
                    by_p[slot(false)] += w * f.by_pressure[1];
                    by_h[slot(true)] += w * f.by_film;
                    by_h[slot(false)] += w * f.by_film;
                    let total: f64 = f.by_mass.iter().sum();
                    let upstream = !f.from_second;
                    let [mass_by_p, mass_by_h] = at.nodes[if upstream { a } else { b }].mass_by;
                    by_h[slot(upstream)] += w * total * mass_by_h;
                    by_p[slot(upstream)] += w * total * mass_by_p;
                };
                add(1.0, 0, k, true);
                add(-1.0, 0, k - 1, false);
                match grid.half && j + 1 == ny {
                    true => add(-2.0, 1, k - nx, false),
                    false => {
                        add(1.0, 1, k, true);
                        add(-1.0, 1, k - nx, false);
                    }
                }
            } else {
                by_p[0] = 1.0;
            }
            stencil.fill(0.0);
            let mirror = |dj: i64| {
                let row = j as i64 + dj;
                match grid.half && row >= ny as i64 {
                    true => 2 * (ny as i64 - 1) - row - j as i64,
                    false => dj,
                }
            };
            let mut put = |di: i64, dj: i64, v: f64| {
                let dj = mirror(dj);
                stencil[((dj + REACH) as usize) * width + (di + REACH) as usize] += v;
            };
            for (slot, [ci, cj]) in [[0, 0], [-1, 0], [1, 0], [0, -1], [0, 1]]
                .into_iter()
                .enumerate()
            {
                if by_h[slot] != 0.0 {
                    put(ci, cj, by_h[slot]);
                }
                if by_p[slot] == 0.0 {
                    continue;
                }
                for dj in -1..=1 {
                    for di in -1..=1 {
                        // Mirrored about the row of the neighbour that is itself mirrored: rows beyond fold back.
                        put(ci + di, cj + dj, by_p[slot] * s(di, dj));
                    }
                }
            }
            for [di, dj] in &pattern.points {
                let (ni, nj) = (i as i64 + di, j as i64 + dj);
                if ni < 0 || ni >= nx as i64 || nj < 0 || nj >= ny as i64 {
                    continue;
                }
                if pattern.number[grid.index(ni as usize, nj as usize)] == NONE {
                    continue;
                }
                values[next] = stencil[((dj + REACH) as usize) * width + (di + REACH) as usize];
                next += 1;
            }
        }
        // Rows of like size for single precision
        let mut of_row = vec![0.0_f64; pattern.nodes.len()];
        for ((row, _), v) in pattern.entries.iter().zip(&values) {
            of_row[*row as usize] = of_row[*row as usize].max(v.abs());
        }
        for ((row, _), v) in pattern.entries.iter().zip(&mut values) {
            *v /= of_row[*row as usize];
        }
        let mut scale = vec![1.0; grid.len()];
        for (k, s) in pattern.nodes.iter().zip(of_row) {
            scale[*k as usize] = s;
        }
        let lu = FrontalLu::new(&pattern.frontal, &values).ok()?;
        Some(Preconditioner { pattern, lu, scale })
    }

    /// Pressures δP = S w for scaled residuals at all nodes.
    pub fn solve(&mut self, residual: &[f64]) -> Vec<f64> {
        let p = self.pattern;
        let grid = &p.grid;
        let mut w: Vec<f64> = (p.nodes.iter()).map(|k| residual[*k as usize]).collect();
        self.lu.solve(&mut w);
        let mut film = vec![0.0; grid.len()];
        for (k, w) in p.nodes.iter().zip(&w) {
            film[*k as usize] = *w;
        }
        let [nx, ny] = grid.n;
        let [s0, sx, sy, sd] = p.inverse;
        let mut pressure = vec![0.0; grid.len()];
        for k in &p.nodes {
            let k = *k as usize;
            let above = if grid.half && k / nx + 1 == ny {
                k - nx
            } else {
                k + nx
            };
            let below = k - nx;
            pressure[k] = s0 * film[k]
                + sx * (film[k - 1] + film[k + 1])
                + sy * (film[below] + film[above])
                + sd * (film[below - 1] + film[below + 1] + film[above - 1] + film[above + 1]);
        }
        pressure
    }
}
