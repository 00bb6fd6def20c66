//! Sensitivity of a film thickness, or of another figure: the adjoint of the film equations.
//!
//! ```text
//!   j = H0 + δ(x) + gap(x)          the film at a point; w_x the deflection shape functions there
//!
//!   | R_Pᵀ + Mᵀ C R_δᵀ   c | | z |   | Mᵀ C w_x |
//!   | r_0ᵀ               0 | | s | = | 1        |
//! ```
//! Other figures have their own right sides (j_P + Mᵀ C j_δ over j_H0). A defect r of the film equations then changes j by −z·r, one of the load, ∫P too large, by −s times it, and a defect e of the deflection changes it
//! by w·e with w = w_x − R_δᵀz; ζ = C w is the deflection under the loads w. At the place of the minimum
//! film ∇H = 0, so that its shift does not count.

use ertel_fem::assembly::CONSTRAINED;
use ertel_fem::linear::gmres::{GmresError, GmresParams, gmres};
use rayon::prelude::*;

use super::discretisation::Discretisation;
use super::preconditioner::Preconditioner;
use super::step::{dot, scatter};
use super::system::System;
use crate::elastic::Accuracy;
use crate::engine::SolveError;
use crate::solve::tuning::newton::{MOST_ROUNDS, ROUGH};

/// Derivatives of a figure by the pressures, the deflections and the separation.
pub struct Functional {
    /// By the pressure at every pressure node.
    pub by_pressure: Vec<f64>,
    /// By the deflection at every deflection node.
    pub by_deflection: Vec<f64>,
    /// By H0.
    pub by_separation: f64,
}

impl Functional {
    /// Of what depends on nothing yet.
    pub fn zero(d: &Discretisation) -> Functional {
        Functional {
            by_pressure: vec![0.0; d.pressure.n_nodes()],
            by_deflection: vec![0.0; d.contact.deflection.n_nodes()],
            by_separation: 0.0,
        }
    }

    /// The film thickness at a point of the contact area.
    pub fn film_at(d: &Discretisation, point: [f64; 2]) -> Functional {
        let mut film = Functional {
            by_separation: 1.0,
            ..Functional::zero(d)
        };
        if let Some((cell, xi)) = d.contact.locator.find(&d.contact.surface, point) {
            let basis = d.contact.deflection.element.values(xi);
            for (b, node) in basis.zip(d.contact.deflection.nodes_of(cell)) {
                film.by_deflection[*node as usize] += b;
            }
        }
        film
    }

    /// The pressure at a point of the contact area.
    pub fn pressure_at(d: &Discretisation, point: [f64; 2]) -> Functional {
        let mut pressure = Functional::zero(d);
        if let Some((cell, xi)) = d.contact.locator.find(&d.contact.surface, point) {
            let basis = d.pressure.element.values(xi);
            for (b, node) in basis.zip(d.pressure.nodes_of(cell)) {
                pressure.by_pressure[*node as usize] += b;
            }
        }
        pressure
    }
}

/// Adjoint of a figure.
#[derive(Clone)]
pub struct Adjoint {
    /// z at every pressure node, zero on the edge.
    pub film: Vec<f64>,
    /// s, of the load.
    pub load: f64,
    /// ζ = C w at every deflection node.
    pub deflection: Vec<f64>,
}

/// Approximate adjoints of the error estimate, from which exact adjoints on the same mesh start.
#[derive(Clone)]
pub struct RoughAdjoints {
    /// Preconditioner of the last linear system, if it was solved by iterations.
    pub preconditioner: Option<Preconditioner>,
    /// Adjoints of central and minimum film; none where they were not solved for.
    pub films: Vec<Adjoint>,
}

/// How exactly adjoints are solved for.
#[derive(Clone, Copy, Debug)]
pub struct Exactness {
    /// Relative residual.
    pub tolerance: f64,
    /// Whether no equation counts more in it than the typical one: the coefficients of the film equations grow as H³, and around a thick
    /// film those far away would be all that counts. Where a layer of oil arrives they always are.
    pub weighed: bool,
}

/// Adjoints of several figures, to the accuracy requested, from those of the first of them in `starts`.
///
/// # Errors
/// When the Krylov iterations run out.
pub fn adjoints(
    d: &Discretisation,
    system: &System,
    mut preconditioner: Preconditioner,
    functionals: &[Functional],
    starts: &[Adjoint],
    Exactness { tolerance, weighed }: Exactness,
) -> Result<Vec<Adjoint>, SolveError> {
    let n = d.n_pressure;
    let mut response = d.load.clone();
    preconditioner.solve_transposed(&mut response);
    let schur = dot(&system.by_separation, &response);
    let weights = match weighed || d.contact.shape.inlet.layer().is_some() {
        true => weights(d, system),
        false => vec![1.0; d.n_pressure],
    };
    let adjoint = |(k, functional): (usize, &Functional)| -> Result<Adjoint, SolveError> {
        let mut sparse = preconditioner.clone();
        let mut at = functional.by_deflection.clone();
        let mut rhs = d.deflect_transposed(&at, Accuracy::Full);
        for (value, dof) in functional.by_pressure.iter().zip(&d.pressure_dofs) {
            if *dof != CONSTRAINED {
                rhs[*dof as usize] += value;
            }
        }
        rhs.push(functional.by_separation);
        multiply(&mut rhs, &weights);
        let apply = |x: &[f64], y: &mut [f64], accuracy: Accuracy| {
            let (by_pressure, by_deflection) = multiply_transposed(d, system, &x[..n]);
            let through = d.deflect_transposed(&by_deflection, accuracy);
            for i in 0..n {
                y[i] = by_pressure[i] + through[i] + d.load[i] * x[n];
            }
            y[n] = dot(&system.by_separation, &x[..n]);
            multiply(y, &weights);
        };
        let mut precondition = |x: &mut [f64]| {
            let (film, load) = x.split_at_mut(n);
            film.iter_mut().zip(&weights).for_each(|(x, w)| *x /= w);
            sparse.solve_transposed(film);
            let s = (dot(&system.by_separation, film) - load[0]) / schur;
            for (z, r) in film.iter_mut().zip(&response) {
                *z -= s * r;
            }
            load[0] = s;
        };
        let mut x = vec![0.0; n + 1];
        let mut residual = rhs.clone();
        let mut reached = 1.0;
        let leave = |x: &[f64], residual: &mut Vec<f64>| {
            apply(x, residual, Accuracy::Full);
            (residual.iter_mut().zip(&rhs)).for_each(|(r, b)| *r = b - *r);
            (dot(residual, residual) / dot(&rhs, &rhs)).sqrt()
        };
        if let Some(start) = starts.get(k) {
            for (node, dof) in d.pressure_dofs.iter().enumerate() {
                if *dof != CONSTRAINED {
                    x[*dof as usize] = start.film[node];
                }
            }
            x[n] = start.load;
            reached = leave(&x, &mut residual);
        }
        // Rough products of areas cost half as much: the remaining residual is computed with a full one, and solved for again.
        let (products, least) = match !d.contact.shape.is_line() || tolerance >= ROUGH {
            true => (Accuracy::Krylov, ROUGH),
            false => (Accuracy::Full, 0.0),
        };
        for round in 1.. {
            let params = GmresParams {
                tolerance: (tolerance / reached).max(least),
                max_iterations: 100,
                ..GmresParams::default()
            };
            let mut step = vec![0.0; n + 1];
            let product = |x: &[f64], y: &mut [f64]| apply(x, y, products);
            let info = gmres(product, &mut precondition, &residual, &mut step, params)?;
            x.iter_mut().zip(&step).for_each(|(x, s)| *x += s);
            if params.tolerance <= tolerance && round == 1 {
                break;
            }
            reached = leave(&x, &mut residual);
            if reached <= tolerance {
                break;
            }
            if round == MOST_ROUNDS {
                return Err(GmresError {
                    iterations: info.iterations,
                    residual: reached,
                }
                .into());
            }
        }
        let mut film = vec![0.0; d.pressure.n_nodes()];
        scatter(d, &x[..n], &mut film);
        let (_, by_deflection) = multiply_transposed(d, system, &x[..n]);
        for (w, b) in at.iter_mut().zip(&by_deflection) {
            *w -= b;
        }
        Ok(Adjoint {
            film,
            load: x[n],
            deflection: d.contact.response.respond(&d.trace, &at),
        })
    };
    functionals
        .par_iter()
        .enumerate()
        .with_max_len(1)
        .map(adjoint)
        .collect()
}

/// Relative residual at which an adjoint weighs errors: 1e-3 would do for bars, but then rounding decides which elements are halved.
pub const TO_WEIGH_ERRORS: Exactness = Exactness {
    tolerance: 1e-4,
    weighed: false,
};

/// Weights of the equations of each pressure unknown in the norm of the residual: where a layer of oil arrives, z does not fall off
/// upstream, while the coefficients of the film equations grow as H³; without, all count alike.
fn weights(d: &Discretisation, system: &System) -> Vec<f64> {
    let (n, m) = (d.pressure_table.n_nodes, d.deflection_table.n_nodes);
    let mut diagonal = vec![0.0; d.n_pressure];
    for c in 0..d.contact.n_elements() {
        for (i, node) in d.pressure.nodes_of(c).iter().enumerate() {
            let dof = d.pressure_dofs[*node as usize];
            if dof != CONSTRAINED {
                diagonal[dof as usize] += system.blocks[(c * n + i) * (n + m) + i];
            }
        }
    }
    let mut sorted: Vec<f64> = diagonal.iter().map(|v| v.abs()).collect();
    sorted.sort_by(f64::total_cmp);
    let typical = sorted[sorted.len() / 2];
    (diagonal.iter())
        .map(|v| (typical / v.abs()).min(1.0))
        .collect()
}

/// Weighs the equations of the pressure unknowns.
fn multiply(x: &mut [f64], weights: &[f64]) {
    x.iter_mut().zip(weights).for_each(|(x, w)| *x *= w);
}

/// R_Pᵀ z and R_δᵀ z.
fn multiply_transposed(d: &Discretisation, system: &System, z: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let (n, m) = (d.pressure_table.n_nodes, d.deflection_table.n_nodes);
    let mut by_pressure = vec![0.0; d.n_pressure];
    let mut by_deflection = vec![0.0; d.contact.deflection.n_nodes()];
    for c in 0..d.contact.n_elements() {
        let nodes = d.pressure.nodes_of(c);
        let below = d.contact.deflection.nodes_of(c);
        for (i, node) in nodes.iter().enumerate() {
            let dof = d.pressure_dofs[*node as usize];
            if dof == CONSTRAINED {
                continue;
            }
            let weight = z[dof as usize];
            let start = (c * n + i) * (n + m);
            let row = &system.blocks[start..start + n + m];
            for (v, j) in row[..n].iter().zip(nodes) {
                let column = d.pressure_dofs[*j as usize];
                if column != CONSTRAINED {
                    by_pressure[column as usize] += weight * v;
                }
            }
            for (v, j) in row[n..].iter().zip(below) {
                by_deflection[*j as usize] += weight * v;
            }
        }
    }
    (by_pressure, by_deflection)
}
