//! Newton's step: the linearised equation and its load, by preconditioned Krylov iterations.

use ertel_fem::linear::gmres::{GmresParams, gmres};

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

impl System {
    /// Newton's step by preconditioned Krylov iterations in pressures and separation.
    pub fn step(
        &self,
        at: &Linearised,
        state: &State,
        preconditioner: &mut Preconditioner,
        params: GmresParams,
    ) -> Step {
        let rows: Vec<f64> = (0..self.grid.n_nodes())
            .map(|k| match at.wetted[k] {
                true => -at.outflow[k],
                false => -state.pressure[k],
            })
            .collect();
        let by_separation = self.by_separation(at, preconditioner);
        let right = (rows.as_slice(), at.missing_load);
        self.respond(at, right, &by_separation, preconditioner, params)
    }

    /// What the preconditioner makes of the change of G by the separation.
    pub fn by_separation(&self, at: &Linearised, preconditioner: &mut Preconditioner) -> Vec<f64> {
        let n = self.grid.n_nodes();
        let mut rows = self.change_by(at, &vec![0.0; n], &vec![1.0; n]);
        for (k, value) in rows.iter_mut().enumerate() {
            *value = match at.wetted[k] {
                true => *value / preconditioner.scale[k],
                false => 0.0,
            };
        }
        preconditioner.solve(&rows)
    }

    /// Changes of pressures and separation for which G changes by `rows` where the film is wetted, P elsewhere, and the load by `load`. What
    /// stands at nodes whose pressure is given counts for nothing.
    pub fn respond(
        &self,
        at: &Linearised,
        (rows, missing): (&[f64], f64),
        by_separation: &[f64],
        preconditioner: &mut Preconditioner,
        params: GmresParams,
    ) -> Step {
        let grid = &self.grid;
        let n = grid.n_nodes();
        let areas: Vec<f64> = (grid.nodes())
            .map(|[i, j]| grid.share(i, j) * grid.cell(j))
            .collect();
        let load = |p: &[f64]| -> f64 { p.iter().zip(&areas).map(|(p, a)| p * a).sum() };
        // Rows in heights of the film; the load at the end.
        let scale = preconditioner.scale.clone();
        let mut right = vec![0.0; n + 1];
        for (k, [i, j]) in grid.nodes().enumerate() {
            if grid.is_unknown(i, j) {
                right[k] = rows[k] / scale[k];
            }
        }
        right[n] = missing;
        let load_by_separation = load(by_separation);
        let apply = |x: &[f64], y: &mut [f64]| {
            let change = self.change(at, &x[..n], x[n]);
            for k in 0..n {
                let row = if at.wetted[k] { change[k] } else { x[k] };
                y[k] = row / scale[k];
            }
            y[n] = load(&x[..n]);
        };
        let precondition = |r: &mut [f64]| {
            let pressure = preconditioner.solve(&r[..n]);
            let separation = (load(&pressure) - r[n]) / load_by_separation;
            for k in 0..n {
                r[k] = pressure[k] - separation * by_separation[k];
            }
            r[n] = separation;
        };
        let mut x = vec![0.0; n + 1];
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
