//! Heat flow from node to node, and the temperatures that follow from those of the walls.
//!
//! ```text
//!   C = c [H ρ̄ ∂T/∂t + Σ_f m_f (T_f − T_P) + ω ∂T/∂s],   T_f = T_u + a(T_u − T_uu)       second-order upwind at each height (Warming and Beam 1976)
//!   a = ½ step to the next node/step from the one before: ½ but across a roller, whose rows are uneven
//!   ω(s) = −Σ_f ∫_{−½}^s m_f ds' + (s + ½) Σ_f ∫ m_f ds                        mass flow across the film
//! ```
//! The first term of C is there in time alone. m_f is the mean of both nodes, scaled to the mass flow F that the film equation has for the face: inflow at a height flows out or to other heights, and
//! heat is conserved like mass.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use rayon::prelude::*;

use super::columns::{Columns, FilmHeat};
use super::flow::{BATCH, Flow, Side};
use super::march::March;
use crate::volumes::faces::Face;

/// The equations of a grid at some temperatures.
pub struct Transport<'a> {
    flow: Flow<'a>,
    /// Nodes, each behind those upstream of it where the flow does not recirculate: flow across that changes sides with height has
    /// one order for each side.
    orders: [Vec<u32>; 2],
    /// The march that gives its temperatures.
    march: March,
    /// R.
    residual: Vec<f64>,
    /// Convection ∫C ds, W/m².
    carried: Vec<f64>,
}

/// Inner temperatures of the film and heat into both bodies.
pub struct Moved {
    /// Changes of temperatures, node by node.
    pub temperature: Vec<f64>,
    /// Heat into the bodies, W/m².
    pub flux: [Vec<f64>; 2],
    /// Sweeps that changed something.
    pub sweeps: usize,
}

/// Number of sweeps over the nodes.
#[derive(Clone, Copy, Debug)]
pub enum Sweeps {
    /// A fixed number: linear in the right side.
    Count(usize),
    /// Until a sweep changes no more than this share of the largest change, so often at most.
    UpTo(usize, f64),
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
        let flow = Flow::new(of, columns, faces);
        let mut slopes = columns.slopes.clone();
        let mut residual = columns.rows.clone();
        let mut carried = vec![0.0; grid.n_nodes()];
        let at_heights = flow.at_heights(temperature);
        let equations = (slopes.par_chunks_exact_mut(f * f))
            .zip(residual.par_chunks_exact_mut(f))
            .zip(&mut carried)
            .enumerate()
            .with_min_len(BATCH);
        equations.filter(|(k, _)| flow.is_unknown(*k)).for_each(
            |(k, ((slopes, rows), carried))| {
                let convection = flow.convection(k, &temperature[k * f..][..f], &at_heights);
                *carried = flow.add(k, &convection, rows, slopes);
            },
        );
        Transport {
            march: March::new(&flow, &slopes),
            orders: [false, true].map(|from_last_row| downstream(&flow, faces, from_last_row)),
            flow,
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
        let (flow, march) = (&self.flow, &self.march);
        let by_rows = rows.map(|rows| march.by_rows(rows));
        let mut marching = march.start(flow);
        let of_walls = walls.map(|wall| wall.iter().fold(0.0_f64, |m, t| m.max(t.abs())));
        let mut done = 0;
        loop {
            let order = self.orders[done % 2].as_slice();
            let way = (order, done % 4 > 1);
            let [size, change] = march.sweep(flow, way, walls, by_rows.as_deref(), &mut marching);
            let size = of_walls.into_iter().fold(size, f64::max);
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
        let (temperature, flux) = march.outcome(flow, walls, &marching);
        Moved {
            temperature,
            flux,
            sweeps: done.max(1),
        }
    }
}

/// Unknown nodes, each behind those that mass flows from, otherwise column by column; nodes in circles last.
fn downstream(flow: &Flow, faces: &[Vec<Face>; 2], from_last_row: bool) -> Vec<u32> {
    let [nx, ny] = flow.grid.n;
    let out =
        |side: &Side| side.weight * faces[usize::from(side.direction)][side.face as usize].flux;
    let place = |k: usize| {
        let j = k / nx;
        (k % nx, if from_last_row { ny - 1 - j } else { j }, k)
    };
    let mut waiting = vec![0_u8; flow.grid.n_nodes()];
    let mut ready = BinaryHeap::new();
    for k in (0..waiting.len()).filter(|k| flow.is_unknown(*k)) {
        let waits = |side: &&Side| out(side) < 0.0 && flow.is_unknown(side.next[0] as usize);
        waiting[k] = flow.sides[k].iter().filter(waits).count() as u8;
        if waiting[k] == 0 {
            ready.push(Reverse(place(k)));
        }
    }
    let mut order: Vec<u32> = Vec::new();
    while let Some(Reverse((_, _, k))) = ready.pop() {
        order.push(k as u32);
        for side in &flow.sides[k] {
            let to = side.next[0] as usize;
            if out(side) > 0.0 && flow.is_unknown(to) && waiting[to] > 0 {
                waiting[to] -= 1;
                if waiting[to] == 0 {
                    ready.push(Reverse(place(to)));
                }
            }
        }
    }
    let mut remaining: Vec<usize> = (0..waiting.len()).filter(|k| waiting[*k] > 0).collect();
    remaining.sort_by_key(|k| place(*k));
    order.extend(remaining.into_iter().map(|k| k as u32));
    order
}
