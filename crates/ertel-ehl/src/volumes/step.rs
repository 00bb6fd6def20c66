//! Newton's step: the linearised equation and its load, by preconditioned Krylov iterations.

use ertel_fem::linear::gmres::{GmresParams, gmres};
use rayon::prelude::*;

use super::preconditioner::Preconditioner;
use super::system::{Linearised, State, System};

/// Newton's step.
pub struct Step {
    /// δP at all nodes.
    pub pressure: Vec<f64>,
    /// δH_0.
    pub separation: f64,
    /// Krylov iterations taken.
    pub krylov_iterations: usize,
}

/// Nodes that a thread takes at a time.
const BATCH: usize = 8192;

/// The linearised equation in pressures and separation: rows in heights of the film, P itself where it is not solved for, that of the oil between rough surfaces,
/// the load at the end.
pub struct Equation<'a> {
    system: &'a System,
    at: &'a Linearised,
    /// Size of each row.
    scale: Vec<f64>,
    /// Area that each node represents.
    areas: Vec<f64>,
}

impl<'a> Equation<'a> {
    /// At a state, with the sizes of its rows.
    pub fn new(system: &'a System, at: &'a Linearised, scale: &[f64]) -> Equation<'a> {
        let grid = &system.grid;
        Equation {
            system,
            at,
            scale: scale.to_vec(),
            areas: (grid.nodes())
                .map(|[i, j]| grid.share(i, j) * grid.cell(j))
                .collect(),
        }
    }

    /// Number of rows: nodes, and the load.
    pub fn n_rows(&self) -> usize {
        self.areas.len() + 1
    }

    /// The right side for which G changes by `rows` where the film is wetted, P elsewhere, and the load by `missing`. Values at nodes with given
    /// pressure are ignored.
    pub fn right(&self, rows: &[f64], missing: f64) -> Vec<f64> {
        let grid = &self.system.grid;
        let mut right = vec![0.0; self.n_rows()];
        for (k, [i, j]) in grid.nodes().enumerate() {
            if grid.is_unknown(i, j) {
                right[k] = rows[k] / self.scale[k];
            }
        }
        right[rows.len()] = missing;
        right
    }

    /// The product with changes of pressures and separation.
    pub fn apply(&self, x: &[f64], y: &mut [f64]) {
        let n = self.areas.len();
        let film = self.system.change_of_film(&x[..n], x[n]);
        let change = self.system.change_by(self.at, &x[..n], &film);
        let touching = &self.at.touching;
        let rows = y[..n].par_iter_mut().zip(&change).enumerate();
        rows.with_min_len(BATCH).for_each(|(k, (y, change))| {
            let row = match (self.at.wetted[k], touching.get(k)) {
                (true, _) => *change,
                (false, None) => x[k],
                (false, Some(of)) => of.change_of_oil(x[k], film[k]),
            };
            *y = row / self.scale[k];
        });
        y[n] = self.load(&x[..n], x[n]);
    }

    /// Change of the force residual, with the opposite sign.
    fn load(&self, pressure: &[f64], separation: f64) -> f64 {
        let sum: f64 = pressure.iter().zip(&self.areas).map(|(p, a)| p * a).sum();
        let balance = &self.system.balance;
        balance.load * sum - balance.separation * separation
    }
}

/// Approximate solutions of an [`Equation`].
pub struct Inverse<'a, 'p> {
    equation: &'a Equation<'a>,
    preconditioner: &'a mut Preconditioner<'p>,
    /// The preconditioner applied to the change of G by the separation, and its load.
    by_separation: Vec<f64>,
    load_by_separation: f64,
}

impl<'a, 'p> Inverse<'a, 'p> {
    /// By a preconditioner of the same state.
    pub fn new(
        equation: &'a Equation<'a>,
        preconditioner: &'a mut Preconditioner<'p>,
    ) -> Inverse<'a, 'p> {
        let (at, n) = (equation.at, equation.areas.len());
        let mut rows = (equation.system).change_by(at, &vec![0.0; n], &vec![1.0; n]);
        for (k, value) in rows.iter_mut().enumerate() {
            *value = match (at.wetted[k], at.touching.get(k)) {
                (true, _) => *value / equation.scale[k],
                (false, None) => 0.0,
                (false, Some(of)) => of.change_of_oil(0.0, 1.0) / equation.scale[k],
            };
        }
        let by_separation = preconditioner.solve(&rows);
        Inverse {
            // Pressures answer a separation by −`by_separation`.
            load_by_separation: equation.load(&by_separation, -1.0),
            equation,
            preconditioner,
            by_separation,
        }
    }

    /// Solves approximately in place.
    pub fn solve(&mut self, r: &mut [f64]) {
        let n = self.by_separation.len();
        let pressure = self.preconditioner.solve(&r[..n]);
        let separation = (self.equation.load(&pressure, 0.0) - r[n]) / self.load_by_separation;
        for ((r, pressure), by) in r.iter_mut().zip(&pressure).zip(&self.by_separation) {
            *r = pressure - separation * by;
        }
        r[n] = separation;
    }
}

impl System {
    /// Newton's step by preconditioned Krylov iterations in pressures and separation.
    pub fn step(
        &self,
        at: &Linearised,
        state: &State,
        preconditioner: &mut Preconditioner,
        params: GmresParams,
    ) -> Step {
        let n = self.grid.n_nodes();
        let rows: Vec<f64> = match at.slack() {
            None => (0..n)
                .map(|k| match at.wetted[k] {
                    true => -at.outflow[k],
                    false => -state.pressure[k],
                })
                .collect(),
            Some(slack) => {
                let by_slack = self.change_of_oil(at, &slack, &vec![0.0; n]);
                (0..n)
                    .map(|k| match at.wetted[k] {
                        true => -at.outflow[k] - by_slack[k],
                        false => -state.oil[k] - slack[k],
                    })
                    .collect()
            }
        };
        let equation = Equation::new(self, at, &preconditioner.scale);
        let mut inverse = Inverse::new(&equation, preconditioner);
        let right = equation.right(&rows, at.missing_load);
        let mut x = vec![0.0; n + 1];
        let apply = |x: &[f64], y: &mut [f64]| equation.apply(x, y);
        let precondition = |r: &mut [f64]| inverse.solve(r);
        let krylov_iterations = match gmres(apply, precondition, &right, &mut x, params) {
            Ok(info) => info.iterations,
            Err(error) => error.iterations,
        };
        let separation = x[n];
        x.truncate(n);
        Step {
            pressure: x,
            separation,
            krylov_iterations,
        }
    }
}
