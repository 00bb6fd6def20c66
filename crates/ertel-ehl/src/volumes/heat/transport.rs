//! What flows from node to node, and the temperatures that follow from those of the walls.
//!
//! ```text
//!   C = c [H ρ̄ ∂T/∂t + Σ_f m_f (T_f − T_P) + ω ∂T/∂s],   T_f = T_u + a(T_u − T_uu)       second-order upwind at each height (Warming and Beam 1976)
//!   a = ½ step to the next node/step from the one before: ½ but across a roller, whose rows are uneven
//!   ω(s) = −Σ_f ∫_{−½}^s m_f ds' + (s + ½) Σ_f ∫ m_f ds                        mass flow across the film
//! ```
//! The first term of C is there in time alone. m_f is the mean of both nodes, scaled to the mass flow F that the film equation has for the face: what flows in at a height, flows out or to other heights, and
//! heat is kept as mass is.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use rayon::prelude::*;

use super::columns::{Columns, FilmHeat};
use crate::film::MOST_NODES;
use crate::forms::energy::Heights;
use crate::volumes::contents::sides;
use crate::volumes::faces::Face;
use crate::volumes::grid::Grid;
use crate::volumes::system::Storage;

/// Mass that flows through the film of a grid, and the heat that it carries.
pub struct Flow<'a> {
    grid: &'a Grid,
    heights: &'a Heights,
    columns: &'a Columns,
    /// m through the faces behind each node along both directions, height by height.
    through: [Vec<f64>; 2],
    /// How temperatures change in time, where they do.
    stored: Option<&'a Storage>,
}

/// The equations of a grid at some temperatures.
pub struct Transport<'a> {
    flow: Flow<'a>,
    /// Nodes, each behind those upstream of it where the flow goes in no circles: what flows across to one side at some heights and to the other one at others is followed by
    /// one order each.
    orders: [Vec<u32>; 2],
    /// ∂R/∂T of each unknown node: `[row + f·column]`.
    slopes: Vec<f64>,
    /// Factors of its inner rows and columns, with their pivots.
    factors: Vec<f64>,
    pivots: Vec<u8>,
    /// R.
    residual: Vec<f64>,
    /// Convection ∫C ds, W/m².
    carried: Vec<f64>,
}

/// A side of a node.
struct Side {
    direction: usize,
    face: usize,
    weight: f64,
    /// The node beyond it, the next one, and the one behind the node itself.
    next: [usize; 2],
    behind: usize,
    /// a of what flows in and of what flows out.
    ahead: [f64; 2],
}

fn sides_of(grid: &Grid, k: usize) -> [Side; 4] {
    let [nx, ny] = grid.n;
    let (i, j) = (k % nx, k / nx);
    // Beyond the centreline of a half all is mirrored.
    let row = |j: usize| match j < ny {
        true => j,
        false => 2 * (ny - 1) - j,
    };
    let along = |di: i64| (i as i64 + di) as usize + nx * j;
    let across = |dj: i64| match grid.is_line() {
        true => k,
        false => i + nx * row((j as i64 + dj) as usize),
    };
    let own = sides(grid, k);
    // Steps between the node behind, the node, the next one and the one beyond it.
    let ahead = |towards: bool, direction: usize| match (&grid.rows, direction) {
        (Some(rows), 1) => {
            let step = |j: i64| rows.step(row(j as usize).min(row((j + 1) as usize)));
            let j = j as i64;
            let [behind, own, beyond] = match towards {
                true => [step(j - 1), step(j), step(j + 1)],
                false => [step(j), step(j - 1), step(j - 2)],
            };
            [0.5 * own / beyond, 0.5 * own / behind]
        }
        _ => [0.5; 2],
    };
    let reach = [
        ([along(1), along(2)], along(-1)),
        ([along(-1), along(-2)], along(1)),
        ([across(1), across(2)], across(-1)),
        ([across(-1), across(-2)], across(1)),
    ];
    std::array::from_fn(|s| Side {
        direction: own[s].direction,
        face: own[s].face,
        weight: own[s].weight,
        next: reach[s].0,
        behind: reach[s].1,
        ahead: ahead(s % 2 == 0, own[s].direction),
    })
}

/// Ratios of a face's mass flow to the mean of its nodes within which the profile is scaled, and not shifted.
const SCALED: [f64; 2] = [0.5, 2.0];

/// What the inner temperatures of the film and the heat into both bodies come to.
pub struct Moved {
    /// Changes of temperatures, node by node.
    pub temperature: Vec<f64>,
    /// Heat into the bodies, W/m².
    pub flux: [Vec<f64>; 2],
    /// Sweeps that changed something.
    pub sweeps: usize,
}

/// How often nodes are taken.
#[derive(Clone, Copy, Debug)]
pub enum Sweeps {
    /// So often: linear in what is asked for.
    Count(usize),
    /// Until a sweep changes no more than this share of the largest change, so often at most.
    UpTo(usize, f64),
}

/// Convection of a node at each height.
struct Convection {
    /// What it takes off by its own temperature.
    diagonal: [f64; MOST_NODES],
    /// ω.
    up: [f64; MOST_NODES],
    /// C over the capacity.
    value: [f64; MOST_NODES],
}

/// Nodes that a thread takes at a time.
const BATCH: usize = 256;

impl<'a> Flow<'a> {
    /// With the mass flow of the film equation through the faces.
    pub fn new(of: &FilmHeat<'a>, columns: &'a Columns, faces: &[Vec<Face>; 2]) -> Flow<'a> {
        let (grid, heights) = (of.grid, of.heights);
        Flow {
            grid,
            heights,
            columns,
            stored: of.stored,
            through: [0, 1].map(|d| through(grid, heights, columns, &faces[d], d)),
        }
    }

    /// R at temperatures; without convection where they are given.
    pub fn residual(&self, temperature: &[f64]) -> Vec<f64> {
        let [f, h] = self.columns.n;
        let at_heights = self.at_heights(temperature);
        let mut residual = self.columns.rows.clone();
        let nodes = residual
            .par_chunks_exact_mut(f)
            .enumerate()
            .with_min_len(BATCH);
        nodes
            .filter(|(k, _)| self.is_unknown(*k))
            .for_each(|(k, rows)| {
                let convection = self.convection(k, &temperature[k * f..][..f], &at_heights);
                let capacity = &self.columns.capacity[k * h..][..h];
                for l in 0..h {
                    let weight = self.heights.weights()[l] * capacity[l];
                    for (row, shape) in rows.iter_mut().zip(&self.heights.shapes[l]) {
                        *row += weight * shape * convection.value[l];
                    }
                }
            });
        residual
    }

    fn is_unknown(&self, k: usize) -> bool {
        let nx = self.grid.n[0];
        self.grid.is_unknown(k % nx, k / nx)
    }

    /// Temperatures at all heights.
    fn at_heights(&self, temperature: &[f64]) -> Vec<f64> {
        let [f, h] = self.columns.n;
        let mut all = vec![0.0; self.grid.n_nodes() * h];
        (all.par_chunks_exact_mut(h)
            .zip(temperature.par_chunks_exact(f)))
        .with_min_len(BATCH)
        .for_each(|(values, nodes)| self.raise(nodes, values));
        all
    }

    /// Temperatures at the heights over a node.
    #[inline(always)]
    fn raise(&self, nodes: &[f64], values: &mut [f64]) {
        for (value, shapes) in values.iter_mut().zip(&self.heights.shapes) {
            *value = nodes.iter().zip(shapes).map(|(t, s)| t * s).sum();
        }
    }

    /// Adds the convection of a node to its equation; returns it, W/m².
    fn add(&self, k: usize, convection: &Convection, rows: &mut [f64], slopes: &mut [f64]) -> f64 {
        let [f, h] = self.columns.n;
        let Convection {
            diagonal,
            up,
            value,
        } = convection;
        let capacity = &self.columns.capacity[k * h..][..h];
        let mut carried = 0.0;
        for l in 0..h {
            let (shapes, [first, _]) = (&self.heights.shapes[l], &self.heights.slopes[l]);
            let weight = self.heights.weights()[l] * capacity[l];
            carried += weight * value[l];
            for a in 0..f {
                rows[a] += weight * shapes[a] * value[l];
            }
            for b in 0..f {
                let by = weight * (diagonal[l] * shapes[b] + up[l] * first[b]);
                for a in 0..f {
                    slopes[b * f + a] += shapes[a] * by;
                }
            }
        }
        carried
    }

    fn convection(&self, k: usize, own: &[f64], at_heights: &[f64]) -> Convection {
        let h = self.columns.n[1];
        let mut from = [0.0; MOST_NODES];
        let mut diagonal = [0.0; MOST_NODES];
        self.arriving(k, at_heights, &mut from);
        let mut up = [0.0; MOST_NODES];
        let mut outflow = 0.0;
        for side in sides_of(self.grid, k) {
            if side.weight == 0.0 {
                continue;
            }
            let flow = &self.through[side.direction][side.face * h..][..h];
            for l in 0..h {
                let out = side.weight * flow[l];
                diagonal[l] += if out > 0.0 { side.ahead[1] * out } else { -out };
                outflow += self.heights.weights()[l] * out;
                for (m, up) in up[..h].iter_mut().enumerate() {
                    *up -= self.heights.below()[m][l] * out;
                }
            }
        }
        let mut value = [0.0; MOST_NODES];
        for l in 0..h {
            up[l] += (self.heights.points()[l] + 0.5) * outflow;
            let [first, _] = &self.heights.slopes[l];
            let slope: f64 = own.iter().zip(first).map(|(t, s)| t * s).sum();
            value[l] = from[l] + diagonal[l] * at_heights[k * h + l] + up[l] * slope;
        }
        if let Some(stored) = self.stored {
            let f = own.len();
            let mut past = [0.0; MOST_NODES];
            self.raise(&stored.past[k * f..][..f], &mut past[..h]);
            for l in 0..h {
                let content = self.columns.content[k * h + l];
                diagonal[l] += content * stored.rate;
                value[l] += content * (stored.rate * at_heights[k * h + l] + past[l]);
            }
        }
        Convection {
            diagonal,
            up,
            value,
        }
    }

    /// Σ_f m_f T_f of the temperatures around a node, its own left out, at each height.
    #[inline(always)]
    fn arriving(&self, k: usize, at_heights: &[f64], sums: &mut [f64; MOST_NODES]) {
        let h = self.columns.n[1];
        *sums = [0.0; MOST_NODES];
        for side in sides_of(self.grid, k) {
            if side.weight == 0.0 {
                continue;
            }
            let flow = &self.through[side.direction][side.face * h..][..h];
            let [next, second] = side.next.map(|n| &at_heights[n * h..][..h]);
            let behind = &at_heights[side.behind * h..][..h];
            for l in 0..h {
                let out = side.weight * flow[l];
                let [inwards, outwards] = side.ahead;
                sums[l] += match out > 0.0 {
                    true => -outwards * out * behind[l],
                    false => out * ((1.0 + inwards) * next[l] - inwards * second[l]),
                };
            }
        }
    }
}

impl<'a> Transport<'a> {
    /// With the mass flow of the film equation through the faces, at temperatures.
    pub fn new(
        of: &FilmHeat<'a>,
        columns: &'a Columns,
        faces: &[Vec<Face>; 2],
        temperature: &[f64],
    ) -> Transport<'a> {
        let grid = of.grid;
        let [f, _] = columns.n;
        let n = grid.n_nodes();
        let inner = f - 2;
        let flow = Flow::new(of, columns, faces);
        let mut slopes = columns.slopes.clone();
        let mut factors = vec![0.0; n * inner * inner];
        let mut pivots = vec![0; n * inner];
        let mut residual = columns.rows.clone();
        let mut carried = vec![0.0; n];
        let at_heights = flow.at_heights(temperature);
        let equations = (slopes.par_chunks_exact_mut(f * f))
            .zip(factors.par_chunks_exact_mut(inner * inner))
            .zip(pivots.par_chunks_exact_mut(inner))
            .zip(residual.par_chunks_exact_mut(f))
            .zip(&mut carried)
            .enumerate()
            .with_min_len(BATCH);
        equations.filter(|(k, _)| flow.is_unknown(*k)).for_each(
            |(k, ((((slopes, factors), pivots), rows), carried))| {
                let convection = flow.convection(k, &temperature[k * f..][..f], &at_heights);
                *carried = flow.add(k, &convection, rows, slopes);
                for b in 0..inner {
                    for a in 0..inner {
                        factors[a * inner + b] = slopes[(b + 1) * f + a + 1];
                    }
                }
                factorise(factors, pivots);
            },
        );
        Transport {
            flow,
            orders: [false, true].map(|from_last_row| downstream(grid, faces, from_last_row)),
            slopes,
            factors,
            pivots,
            residual,
            carried,
        }
    }

    /// R of each node.
    pub fn residual(&self) -> &[f64] {
        &self.residual
    }

    /// Convection of each node, W/m².
    pub fn carried(&self) -> &[f64] {
        &self.carried
    }

    /// Unknown nodes.
    pub fn unknown(&self) -> &[u32] {
        &self.orders[0]
    }

    /// Changes of the temperatures within the film for which R changes by `rows` there, and the heat into both bodies, by changes of the walls. Nodes are taken in both
    /// orders of the flow and against them in turn, as often as `sweeps` says.
    pub fn moved(&self, walls: [&[f64]; 2], rows: Option<&[f64]>, sweeps: Sweeps) -> Moved {
        let [f, h] = self.flow.columns.n;
        let n = self.flow.grid.n_nodes();
        let mut temperature = vec![0.0; n * f];
        let mut at_heights = vec![0.0; n * h];
        let mut done = 0;
        loop {
            let mut largest = [0.0_f64; 2];
            let mut visit = |k: usize| {
                let mut from = [0.0; MOST_NODES];
                self.flow.arriving(k, &at_heights, &mut from);
                let mut nodes = [0.0; MOST_NODES];
                self.inner(k, &from, [walls[0][k], walls[1][k]], rows, &mut nodes[..f]);
                let own = &mut temperature[k * f..][..f];
                for (old, new) in own.iter_mut().zip(nodes) {
                    largest = [
                        largest[0].max(new.abs()),
                        largest[1].max((new - *old).abs()),
                    ];
                    *old = new;
                }
                self.flow.raise(own, &mut at_heights[k * h..][..h]);
            };
            let order = &self.orders[done % 2];
            match done % 4 {
                0 | 1 => order.iter().for_each(|k| visit(*k as usize)),
                _ => order.iter().rev().for_each(|k| visit(*k as usize)),
            }
            let [size, change] = largest;
            match sweeps {
                Sweeps::Count(count) if done + 1 >= count => break,
                // The last one changed nothing.
                Sweeps::UpTo(_, settled) if done > 0 && change <= settled * size => break,
                Sweeps::UpTo(most, _) if done + 1 >= most => {
                    done += 1;
                    break;
                }
                _ => done += 1,
            }
        }
        let mut flux = [vec![0.0; n], vec![0.0; n]];
        for k in self.unknown().iter().map(|k| *k as usize) {
            let mut from = [0.0; MOST_NODES];
            self.flow.arriving(k, &at_heights, &mut from);
            let nodes = &temperature[k * f..][..f];
            let slopes = &self.slopes[k * f * f..][..f * f];
            for (b, row) in [0, f - 1].into_iter().enumerate() {
                let own: f64 = (0..f).map(|m| slopes[m * f + row] * nodes[m]).sum();
                flux[b][k] = -own - self.projected(k, &from, row);
            }
        }
        Moved {
            temperature,
            flux,
            sweeps: done.max(1),
        }
    }

    /// ∫ φ_a c C ds of convection at each height.
    #[inline(always)]
    fn projected(&self, k: usize, from: &[f64; MOST_NODES], a: usize) -> f64 {
        let h = self.flow.columns.n[1];
        let capacity = &self.flow.columns.capacity[k * h..][..h];
        (0..h)
            .map(|l| {
                self.flow.heights.weights()[l]
                    * capacity[l]
                    * self.flow.heights.shapes[l][a]
                    * from[l]
            })
            .sum()
    }

    /// Solves the inner rows of a node.
    #[inline(always)]
    fn inner(
        &self,
        k: usize,
        from: &[f64; MOST_NODES],
        walls: [f64; 2],
        rows: Option<&[f64]>,
        nodes: &mut [f64],
    ) {
        let f = nodes.len();
        let inner = f - 2;
        let slopes = &self.slopes[k * f * f..][..f * f];
        let mut right = [0.0; MOST_NODES];
        for a in 0..inner {
            let own = rows.map_or(0.0, |rows| rows[k * f + a + 1]);
            right[a] = own
                - self.projected(k, from, a + 1)
                - slopes[a + 1] * walls[0]
                - slopes[(f - 1) * f + a + 1] * walls[1];
        }
        let factors = &self.factors[k * inner * inner..][..inner * inner];
        solve(
            factors,
            &self.pivots[k * inner..][..inner],
            &mut right[..inner],
        );
        nodes[0] = walls[0];
        nodes[f - 1] = walls[1];
        nodes[1..f - 1].copy_from_slice(&right[..inner]);
    }
}

/// m through the faces behind all nodes along a direction.
fn through(
    grid: &Grid,
    heights: &Heights,
    columns: &Columns,
    faces: &[Face],
    direction: usize,
) -> Vec<f64> {
    let h = columns.n[1];
    let step = [1, grid.n[0]][direction];
    let n = grid.n_nodes();
    let mut through = vec![0.0; n * h];
    for (k, flow) in through.chunks_exact_mut(h).enumerate() {
        if k + step >= n {
            break;
        }
        let [here, there] = [k, k + step].map(|k| &columns.mass[k * h..][..h]);
        let mut whole = 0.0;
        for l in 0..h {
            flow[l] = 0.5 * (here[l][direction] + there[l][direction]);
            whole += heights.weights()[l] * flow[l];
        }
        let wanted = faces[k].flux;
        let ratio = wanted / whole;
        match SCALED[0] < ratio && ratio < SCALED[1] {
            true => flow.iter_mut().for_each(|m| *m *= ratio),
            false => flow.iter_mut().for_each(|m| *m += wanted - whole),
        }
    }
    through
}

/// Unknown nodes, each behind those that mass flows from, otherwise column by column; nodes in circles last.
fn downstream(grid: &Grid, faces: &[Vec<Face>; 2], from_last_row: bool) -> Vec<u32> {
    let [nx, ny] = grid.n;
    let is_unknown = |k: usize| grid.is_unknown(k % nx, k / nx);
    let out = |side: &Side| side.weight * faces[side.direction][side.face].flux;
    let place = |k: usize| {
        let j = k / nx;
        (k % nx, if from_last_row { ny - 1 - j } else { j }, k)
    };
    let mut waiting = vec![0_u8; grid.n_nodes()];
    let mut ready = BinaryHeap::new();
    for k in (0..waiting.len()).filter(|k| is_unknown(*k)) {
        waiting[k] = sides_of(grid, k)
            .iter()
            .filter(|side| out(side) < 0.0 && is_unknown(side.next[0]))
            .count() as u8;
        if waiting[k] == 0 {
            ready.push(Reverse(place(k)));
        }
    }
    let mut order: Vec<u32> = Vec::new();
    while let Some(Reverse((_, _, k))) = ready.pop() {
        order.push(k as u32);
        for side in sides_of(grid, k) {
            let to = side.next[0];
            if out(&side) > 0.0 && is_unknown(to) && waiting[to] > 0 {
                waiting[to] -= 1;
                if waiting[to] == 0 {
                    ready.push(Reverse(place(to)));
                }
            }
        }
    }
    let mut left: Vec<usize> = (0..waiting.len()).filter(|k| waiting[*k] > 0).collect();
    left.sort_by_key(|k| place(*k));
    order.extend(left.into_iter().map(|k| k as u32));
    order
}

/// Gaussian elimination with pivots, row by row.
fn factorise(a: &mut [f64], pivots: &mut [u8]) {
    let n = pivots.len();
    for k in 0..n {
        let pivot = (k..n)
            .max_by(|i, j| a[i * n + k].abs().total_cmp(&a[j * n + k].abs()))
            .unwrap_or(k);
        pivots[k] = pivot as u8;
        if pivot != k {
            for c in 0..n {
                a.swap(k * n + c, pivot * n + c);
            }
        }
        let inverse = 1.0 / a[k * n + k];
        for i in k + 1..n {
            let factor = a[i * n + k] * inverse;
            a[i * n + k] = factor;
            for c in k + 1..n {
                a[i * n + c] -= factor * a[k * n + c];
            }
        }
    }
}

fn solve(a: &[f64], pivots: &[u8], b: &mut [f64]) {
    let n = pivots.len();
    for k in 0..n {
        b.swap(k, pivots[k] as usize);
    }
    for i in 0..n {
        let sum: f64 = (0..i).map(|c| a[i * n + c] * b[c]).sum();
        b[i] -= sum;
    }
    for i in (0..n).rev() {
        let sum: f64 = (i + 1..n).map(|c| a[i * n + c] * b[c]).sum();
        b[i] = (b[i] - sum) / a[i * n + i];
    }
}
