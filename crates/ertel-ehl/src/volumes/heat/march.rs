//! A march along the flow: the temperatures within the film by those of the walls, one node after the other.
//!
//! ```text
//!   T = T_r − M Σ_f m_f T_f − v_1 T_1 − v_2 T_2        of the nodes within the film, Σ_f of the temperatures around at each height
//!   M = (∂R/∂T)⁻¹ ∫ φ c ds,    v_b = (∂R/∂T)⁻¹ ∂R/∂T_b,    T_r = (∂R/∂T)⁻¹ rows
//! ```
//! Nodes and heights are filled up to whole vectors: loops of fixed length over them are fast.

use ertel_fem::kernel;
use ertel_fem::linear::dense::vectorised;
use rayon::prelude::*;

use super::flow::{AtHeights, BATCH, Flow};

/// Response of the nodes within the film to inflow and walls, at each node of a grid.
pub struct March {
    /// Nodes within the film, and so many as they are filled up to.
    inner: usize,
    width: usize,
    /// Heights.
    heights: usize,
    /// M, column by column, and v of both walls.
    by_arriving: Vec<f64>,
    by_walls: Vec<f64>,
    /// Factors of ∂R/∂T within the film, row by row, with their pivots.
    factors: Vec<f64>,
    pivots: Vec<u8>,
    /// Rows of ∂R/∂T at both walls.
    at_walls: Vec<f64>,
}

/// Temperatures of all nodes on the way.
pub struct Marching {
    /// Within the film.
    inner: Vec<f64>,
    /// At all heights.
    at_heights: Vec<AtHeights>,
}

impl March {
    /// Of ∂R/∂T of all nodes, `[row + f·column]`.
    pub fn new(flow: &Flow, slopes: &[f64]) -> March {
        let [f, heights] = flow.columns.n;
        let n = flow.grid.n_nodes();
        let inner = f - 2;
        let width = match inner {
            ..=4 => 4,
            5..=8 => 8,
            _ => 12,
        };
        let mut march = March {
            inner,
            width,
            heights,
            by_arriving: vec![0.0; n * heights * width],
            by_walls: vec![0.0; n * 2 * width],
            factors: vec![0.0; n * inner * inner],
            pivots: vec![0; n * inner],
            at_walls: vec![0.0; n * 2 * f],
        };
        let nodes = (march.by_arriving.par_chunks_exact_mut(heights * width))
            .zip(march.by_walls.par_chunks_exact_mut(2 * width))
            .zip(march.factors.par_chunks_exact_mut(inner * inner))
            .zip(march.pivots.par_chunks_exact_mut(inner))
            .zip(march.at_walls.par_chunks_exact_mut(2 * f))
            .enumerate()
            .with_min_len(BATCH);
        nodes.filter(|(k, _)| flow.is_unknown(*k)).for_each(
            |(k, ((((by_arriving, by_walls), factors), pivots), at_walls))| {
                let slopes = &slopes[k * f * f..][..f * f];
                for b in 0..inner {
                    for a in 0..inner {
                        factors[a * inner + b] = slopes[(b + 1) * f + a + 1];
                    }
                }
                factorise(factors, pivots);
                for (l, column) in by_arriving.chunks_exact_mut(width).enumerate() {
                    for (a, value) in column[..inner].iter_mut().enumerate() {
                        *value = flow.projection(k, l, a + 1);
                    }
                    solve(factors, pivots, &mut column[..inner]);
                }
                for (b, column) in by_walls.chunks_exact_mut(width).enumerate() {
                    let wall = b * (f - 1);
                    column[..inner].copy_from_slice(&slopes[wall * f + 1..][..inner]);
                    solve(factors, pivots, &mut column[..inner]);
                    for (m, value) in at_walls[b * f..][..f].iter_mut().enumerate() {
                        *value = slopes[m * f + wall];
                    }
                }
            },
        );
        march
    }

    /// Before the first sweep: all changes are zero.
    pub fn start(&self, flow: &Flow) -> Marching {
        let n = flow.grid.n_nodes();
        Marching {
            inner: vec![0.0; n * self.width],
            at_heights: vec![AtHeights::default(); n],
        }
    }

    /// T_r of all nodes.
    pub fn by_rows(&self, rows: &[f64]) -> Vec<f64> {
        let (f, inner) = (self.inner + 2, self.inner);
        let mut all = vec![0.0; rows.len() / f * self.width];
        let nodes = all.par_chunks_exact_mut(self.width).enumerate();
        nodes.with_min_len(BATCH).for_each(|(k, own)| {
            own[..inner].copy_from_slice(&rows[k * f + 1..][..inner]);
            solve(
                &self.factors[k * inner * inner..][..inner * inner],
                &self.pivots[k * inner..][..inner],
                &mut own[..inner],
            );
        });
        all
    }

    /// Takes nodes in an order, or against it; returns the largest temperature and the largest change within the film.
    pub fn sweep(
        &self,
        flow: &Flow,
        way: (&[u32], bool),
        walls: [&[f64]; 2],
        by_rows: Option<&[f64]>,
        marching: &mut Marching,
    ) -> [f64; 2] {
        match self.width {
            4 => self.sweep_of::<4>(flow, way, walls, by_rows, marching),
            8 => self.sweep_of::<8>(flow, way, walls, by_rows, marching),
            _ => self.sweep_of::<12>(flow, way, walls, by_rows, marching),
        }
    }

    /// The same where nodes are filled up to a width.
    fn sweep_of<const W: usize>(
        &self,
        flow: &Flow,
        (order, against): (&[u32], bool),
        walls: [&[f64]; 2],
        by_rows: Option<&[f64]>,
        marching: &mut Marching,
    ) -> [f64; 2] {
        vectorised(Sweep::<W> {
            march: self,
            flow,
            order,
            against,
            walls,
            by_rows,
            inner: &mut marching.inner,
            at_heights: &mut marching.at_heights,
        })
    }

    /// Temperatures node by node, and the heat into both bodies, W/m².
    pub fn outcome(
        &self,
        flow: &Flow,
        walls: [&[f64]; 2],
        marching: &Marching,
    ) -> (Vec<f64>, [Vec<f64>; 2]) {
        let f = self.inner + 2;
        let n = flow.grid.n_nodes();
        let mut temperature = vec![0.0; n * f];
        let mut flux = [vec![0.0; n], vec![0.0; n]];
        let [first, second] = &mut flux;
        let nodes = (temperature.par_chunks_exact_mut(f))
            .zip(first.par_iter_mut().zip(second))
            .enumerate()
            .with_min_len(BATCH);
        nodes
            .filter(|(k, _)| flow.is_unknown(*k))
            .for_each(|(k, (nodes, flux))| {
                nodes[0] = walls[0][k];
                nodes[f - 1] = walls[1][k];
                nodes[1..f - 1].copy_from_slice(&marching.inner[k * self.width..][..self.inner]);
                let from = flow.arriving(k, &marching.at_heights);
                let into = [0, 1].map(|b: usize| {
                    let slopes = &self.at_walls[(2 * k + b) * f..][..f];
                    let own: f64 = slopes.iter().zip(&*nodes).map(|(s, t)| s * t).sum();
                    let carried = (0..self.heights)
                        .map(|l| flow.projection(k, l, b * (f - 1)) * from[l])
                        .sum::<f64>();
                    -own - carried
                });
                (*flux.0, *flux.1) = into.into();
            });
        (temperature, flux)
    }
}

kernel!(Sweep ['a, const W: usize] ['a, W] (
    march: &'a March,
    flow: &'a Flow<'a>,
    order: &'a [u32],
    against: bool,
    walls: [&'a [f64]; 2],
    by_rows: Option<&'a [f64]>,
    inner: &'a mut [f64],
    at_heights: &'a mut [AtHeights],
) -> [f64; 2] {
    let h = march.heights;
    let by_arriving = march.by_arriving.as_chunks::<W>().0;
    let by_walls = march.by_walls.as_chunks::<W>().0;
    let by_rows = by_rows.map(|rows| rows.as_chunks::<W>().0);
    let inner = inner.as_chunks_mut::<W>().0;
    let raised = flow.raised.as_slice();
    let [wall_1, within @ .., wall_2] = raised else {
        return [0.0; 2];
    };
    let (mut largest, mut changes) = ([0.0_f64; W], [0.0_f64; W]);
    for n in 0..order.len() {
        let k = order[if against { order.len() - 1 - n } else { n }] as usize;
        let from = flow.arriving(k, at_heights);
        let mut new = by_rows.map_or([0.0; W], |rows| rows[k]);
        for (column, from) in by_arriving[k * h..][..h].iter().zip(&from) {
            for (t, m) in new.iter_mut().zip(column) {
                *t -= m * from;
            }
        }
        let [first, second] = [walls[0][k], walls[1][k]];
        for (t, (by_1, by_2)) in new.iter_mut().zip(by_walls[2 * k].iter().zip(&by_walls[2 * k + 1])) {
            *t -= by_1 * first + by_2 * second;
        }
        let own = &mut at_heights[k];
        for ((own, by_1), by_2) in own.iter_mut().zip(wall_1).zip(wall_2) {
            *own = first * by_1 + second * by_2;
        }
        for (t, shapes) in new.iter().zip(within) {
            for (own, shape) in own.iter_mut().zip(shapes) {
                *own += t * shape;
            }
        }
        for (((largest, change), old), t) in largest.iter_mut().zip(&mut changes).zip(&mut inner[k]).zip(&new) {
            *largest = larger(*largest, t.abs());
            *change = larger(*change, (t - *old).abs());
            *old = *t;
        }
    }
    [largest, changes].map(|of| of.into_iter().fold(0.0, f64::max))
});

/// The larger number, as a single instruction.
#[inline(always)]
fn larger(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
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
