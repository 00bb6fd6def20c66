//! An approximation of the linearised film equation that can be solved.
//!
//! ```text
//!   δP = S w,   S ≈ K⁻¹ by nine points        (A S + B) w = r,   A: fluxes by the pressures, B: by the films, upwind of first order
//! ```
//! The compliance is long-range, its inverse is not. Long lines have special factors ([`super::line_factors`]). Small grids are factorised; on large ones a cycle over coarser grids does as well: GMRES takes as many iterations.

use std::sync::OnceLock;

use ertel_fem::linear::lu::LuError;
use ertel_fem::linear::ordering::OrderingError;
use rayon::prelude::*;

use super::contents::Arrival;
use super::deflection::Deflection;
use super::grid::Grid;
use super::inverse::Stencils;
use super::line_factors::{LineFactors, LineKernel, Triple};
use super::multigrid::{Cycle, Grids};
use super::rows::RING;
use super::stencil::{PLACES, REACH, Row, SIDE};
use super::system::{Linearised, System};
use super::transfer::Matrix;
use crate::engine::SolveError;

/// Data shared by all preconditioners of a grid.
pub struct Pattern {
    grid: Grid,
    /// Unknown nodes along each direction: a rectangle within the given ones.
    n: [usize; 2],
    pub(super) grids: Grids,
    /// The same with a complete factorisation, computed on first use.
    direct: OnceLock<Option<Grids>>,
    /// S.
    inverse: Stencils,
    /// K of a line on many nodes.
    line: Option<LineKernel>,
}

/// Most unknowns for a complete factorisation, and of the coarsest grid of a cycle; a factorisation of 7,000 unknowns takes three times as long as the cycle. That of a row is proportional to
/// its nodes.
const DIRECT: usize = 4_000;
const COARSEST: usize = 1_000;

/// The same where contents of the nodes are unknown: there coarse grids are poor, and on the first grid of a ball with a layer of oil the cycle took 2,400 Krylov iterations instead of 27.
const DIRECT_STARVED: usize = 10_000;
const COARSEST_STARVED: usize = 4_000;

/// Fewest nodes of a line with special factors: on fewer, Krylov iterations cost little, and 10 to 46 of them do.
const LONG_LINE: usize = 2_000;

/// Unknowns whose rows a thread takes at a time.
const BATCH: usize = 1024;

impl Pattern {
    /// For the grid of a system.
    ///
    /// # Errors
    /// When no order of elimination is found.
    pub fn new(system: &System) -> Result<Pattern, OrderingError> {
        let (grid, n) = (&system.grid, system.grid.n_nodes());
        let (direct, coarsest) = match system.arrival {
            Arrival::Flooded | Arrival::From(_) => (DIRECT, COARSEST),
            Arrival::FromEdges | Arrival::Layer(_) => (DIRECT_STARVED, COARSEST_STARVED),
        };
        let is_small = n <= direct || grid.is_line();
        Pattern::with_coarsest(
            grid,
            &system.convolution,
            if is_small { n } else { coarsest },
        )
    }

    /// The same with this many unknowns of the coarsest grid at most.
    pub(super) fn with_coarsest(
        grid: &Grid,
        deflection: &Deflection,
        coarsest: usize,
    ) -> Result<Pattern, OrderingError> {
        let n = [grid.n[0] - 2 * RING, grid.inner_rows().len()];
        let line = match deflection {
            Deflection::Line(_, coefficients) if grid.n_nodes() >= LONG_LINE => {
                Some(LineKernel::new(coefficients, n[0]))
            }
            _ => None,
        };
        Ok(Pattern {
            line,
            grids: Grids::new(n, grid.half, coarsest)?,
            direct: OnceLock::new(),
            grid: grid.clone(),
            n,
            inverse: deflection.stencils(),
        })
    }

    /// The node of an unknown.
    fn node(&self, unknown: usize) -> usize {
        let [i, j] = [unknown % self.n[0], unknown / self.n[0]];
        self.grid.index(i + RING, j + self.grid.inner_rows().start)
    }

    /// Number of unknowns.
    fn len(&self) -> usize {
        self.n[0] * self.n[1]
    }

    /// The row of a node.
    fn cross(&self, at: &Linearised, k: usize) -> Cross {
        let mut cross = match at.wetted[k] {
            true => Cross::wetted(&self.grid, at, k),
            false => Cross::broken(),
        };
        if !at.touching.is_empty() {
            cross.touch(&self.grid, at, k);
        }
        cross
    }

    /// The rows of a line, each over its size, and the sizes.
    fn triples(&self, at: &Linearised) -> (Vec<Triple>, Vec<f64>) {
        let row = |unknown: usize| {
            let k = self.node(unknown);
            let cross = self.cross(at, k);
            let size = (self.square(k, &cross).iter()).fold(0.0_f64, |m, v| m.max(v.abs()));
            let of_line =
                |[centre, west, east, ..]: [f64; 5]| [west, centre, east].map(|v| v / size);
            let triple = Triple {
                by_pressure: of_line(cross.by_pressure),
                by_film: of_line(cross.by_film),
            };
            (triple, size)
        };
        (0..self.len()).map(row).unzip()
    }

    /// A S + B at a state.
    pub(super) fn matrix(&self, at: &Linearised) -> Matrix {
        let row = |unknown: usize| {
            let k = self.node(unknown);
            let cross = self.cross(at, k);
            let mut square = self.square(k, &cross);
            for (t, value) in square.iter_mut().enumerate() {
                let place = [
                    unknown % self.n[0] + t % SIDE,
                    unknown / self.n[0] + t / SIDE,
                ];
                if (0..2).any(|d| !(REACH..REACH + self.n[d]).contains(&place[d])) {
                    *value = 0.0;
                }
            }
            // Rows of like size, for single precision and for residuals that mean the same everywhere.
            let size = square.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
            let row: Row = square.map(|v| (v / size) as f32);
            (row, (size as f32, at.wetted[k]))
        };
        let all = (0..self.len()).into_par_iter().with_min_len(BATCH);
        let (rows, kinds): (Vec<Row>, Vec<(f32, bool)>) = all.map(row).unzip();
        let (sizes, wetted) = kinds.into_iter().unzip();
        Matrix {
            rows,
            sizes,
            wetted,
        }
    }

    /// The stencil of A S + B at a node.
    fn square(&self, node: usize, cross: &Cross) -> [f64; PLACES] {
        let [nx, ny] = self.grid.n;
        let row = (node / nx) as i64;
        let mut square = [0.0; PLACES];
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
            let inverse = self.inverse.of((row + place[1]).max(0) as usize);
            for dj in -1..=1_i64 {
                for di in -1..=1_i64 {
                    let weight = inverse[(di.abs() + 2 * dj.abs()) as usize];
                    put([place[0] + di, place[1] + dj], by_pressure * weight);
                }
            }
        }
        square
    }
}

/// Entries of a row of the equation at its node and the four neighbours: centre, west, east, south, north.
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
        let stored = at.nodes[k].mass_by.map(|by| at.storage_rate * by);
        [cross.by_pressure[0], cross.by_film[0]] = stored;
        let [dx, dy] = [0, 1].map(|d: usize| grid.length(d, k / nx));
        cross.add(grid, at, (0, k), 1.0 / dx, true);
        cross.add(grid, at, (0, k - 1), -1.0 / dx, false);
        // Beyond the centreline of a half all is mirrored.
        match grid.half && k / nx + 1 == ny {
            _ if grid.is_line() => {}
            true => cross.add(grid, at, (1, k - nx), -2.0 / dy, false),
            false => {
                cross.add(grid, at, (1, k), 1.0 / dy, true);
                cross.add(grid, at, (1, k - nx), -1.0 / dy, false);
            }
        }
        cross
    }

    /// From entries by the pressures of the oil and the gaps that flow to those by P and H.
    fn touch(&mut self, grid: &Grid, at: &Linearised, k: usize) {
        let [nx, ny] = grid.n;
        for (slot, [i, j]) in CROSS.into_iter().enumerate() {
            let (x, y) = ((k % nx) as i64 + i, (k / nx) as i64 + j);
            if !(0..nx as i64).contains(&x) || !(0..ny as i64).contains(&y) {
                continue;
            }
            let of = &at.touching[grid.index(x as usize, y as usize)];
            self.by_film[slot] =
                of.gap[1] * self.by_film[slot] - of.pressure[1] * self.by_pressure[slot];
        }
    }

    /// Adds a face of a direction, whose flux has a weight in the balance, and at whose first or second end the node lies.
    fn add(
        &mut self,
        grid: &Grid,
        at: &Linearised,
        (direction, face): (usize, usize),
        weight: f64,
        is_first: bool,
    ) {
        let f = &at.faces[direction][face];
        // The outflow of a partly filled gap does not depend on the pressure behind it: backflow into it returns.
        if f.by_content != 0.0 && f.from_second == is_first {
            return;
        }
        let ends = [face, face + [1, grid.n[0]][direction]];
        let other = 1 + 2 * direction + usize::from(is_first);
        let slots = if is_first { [0, other] } else { [other, 0] };
        for (end, slot) in slots.into_iter().enumerate() {
            self.by_pressure[slot] += weight * f.by_pressure[end];
            self.by_film[slot] += weight * f.by_film[end];
        }
        let upstream = usize::from(f.from_second);
        let entrained: f64 = f.by_mass.iter().sum();
        let [mass_by_pressure, mass_by_film] = at.nodes[ends[upstream]].mass_by;
        self.by_pressure[slots[upstream]] += weight * entrained * mass_by_pressure;
        self.by_film[slots[upstream]] += weight * entrained * mass_by_film;
    }
}

/// Position in a stencil of a neighbour of its centre.
fn at_square([i, j]: [i64; 2]) -> usize {
    let [i, j] = [i, j].map(|along| (along + REACH as i64) as usize);
    j * SIDE + i
}

/// Solver of the approximation.
enum Approximation<'a> {
    /// In w, as a sparse matrix.
    Sparse(Cycle),
    /// In δP, with the compliance of a line as it is.
    Line(LineFactors<'a>),
}

/// The approximation, ready to be solved.
pub struct Preconditioner<'a> {
    pattern: &'a Pattern,
    approximation: Approximation<'a>,
    /// Whether it is factorised as a whole.
    pub is_direct: bool,
    /// Size of each row, by which residuals become heights of the film: 1 at nodes that are not solved for.
    pub scale: Vec<f64>,
}

impl<'a> Preconditioner<'a> {
    /// At a state; `None` where the matrix is singular.
    pub fn new(pattern: &'a Pattern, at: &Linearised) -> Option<Preconditioner<'a>> {
        Preconditioner::with(pattern, &pattern.grids, at)
    }

    /// Factorised as a whole, whatever the cost.
    pub fn factorised(pattern: &'a Pattern, at: &Linearised) -> Option<Preconditioner<'a>> {
        if pattern.grids.is_direct() {
            return Preconditioner::new(pattern, at);
        }
        let grids = pattern
            .direct
            .get_or_init(|| Grids::new(pattern.n, pattern.grid.half, pattern.len()).ok());
        Preconditioner::with(pattern, grids.as_ref()?, at)
    }

    fn with(pattern: &'a Pattern, grids: &Grids, at: &Linearised) -> Option<Preconditioner<'a>> {
        let mut scale = vec![1.0; pattern.grid.n_nodes()];
        let approximation = match &pattern.line {
            Some(line) => {
                let (rows, sizes) = pattern.triples(at);
                for (unknown, size) in sizes.into_iter().enumerate() {
                    scale[pattern.node(unknown)] = size;
                }
                Approximation::Line(LineFactors::new(line, &rows)?)
            }
            None => {
                let matrix = pattern.matrix(at);
                for (unknown, size) in matrix.sizes.iter().enumerate() {
                    scale[pattern.node(unknown)] = f64::from(*size);
                }
                Approximation::Sparse(Cycle::new(grids, matrix)?)
            }
        };
        Some(Preconditioner {
            pattern,
            approximation,
            is_direct: grids.is_direct(),
            scale,
        })
    }

    /// Pressures δP for scaled residuals at all nodes.
    pub fn solve(&mut self, residual: &[f64]) -> Vec<f64> {
        let p = self.pattern;
        let grid = &p.grid;
        let [nx, ny] = grid.n;
        let mut w: Vec<f64> = (0..p.len())
            .map(|unknown| residual[p.node(unknown)])
            .collect();
        let at_nodes = |values: &[f64]| {
            let mut all = vec![0.0; grid.n_nodes()];
            for (unknown, value) in values.iter().enumerate() {
                all[p.node(unknown)] = *value;
            }
            all
        };
        match &mut self.approximation {
            Approximation::Line(factors) => {
                factors.solve(&mut w);
                return at_nodes(&w);
            }
            Approximation::Sparse(cycle) => cycle.solve(&mut w),
        }
        // δP = S w.
        let film = at_nodes(&w);
        let mut pressure = vec![0.0; grid.n_nodes()];
        for k in (0..p.len()).map(|unknown| p.node(unknown)) {
            let [s0, sx, sy, sd] = *p.inverse.of(k / nx);
            let neighbours = |k: usize| film[k - 1] + film[k + 1];
            let along = s0 * film[k] + sx * neighbours(k);
            if grid.is_line() {
                pressure[k] = along;
                continue;
            }
            let below = k - nx;
            let above = match grid.half && k / nx + 1 == ny {
                true => below,
                false => k + nx,
            };
            pressure[k] = along
                + sy * (film[below] + film[above])
                + sd * (neighbours(below) + neighbours(above));
        }
        pressure
    }
}

/// Pattern shared by all preconditioners of a grid.
///
/// # Errors
/// When no order of elimination is found.
pub fn pattern(system: &System) -> Result<Pattern, SolveError> {
    Pattern::new(system).map_err(|error| {
        SolveError::Factorisation(LuError {
            n: system.grid.n_nodes(),
            reason: error.to_string(),
        })
    })
}
