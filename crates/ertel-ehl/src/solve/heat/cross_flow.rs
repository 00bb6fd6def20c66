//! The mass flow across the film, from one share of its thickness to another.
//!
//! ```text
//!   ω = −∇·m,   m(s) = h∫_{−½}^s ρu ds' − (s + ½) h∫ρu ds'
//!   ∫ λ_i ω dA = ∫ m·∇λ_i dA − ∮ λ_i m·n dl,   ω = Σ ω_j λ_j            λ: linear, one for each vertex
//! ```
//! With the whole mass matrix on the left, heat is conserved: for temperatures T = Σ T_j(s) λ_j what the energy equation lets the film
//! take up, ∫∫ ρu·∇T + ωT_s ds dA, is what flows out through the edge, because ∫ λ_j (∇·m + ω) dA is zero at each height for each j. With
//! the mass matrix lumped, or without the edge, it is not: in coarse inlets, where warm lubricant flows back, heat would be lost or made.
//!
//! Theory: Energy.

use super::space::HeatSpace;
use crate::solve::discretisation::Discretisation;
use crate::solve::tuning::heat::{MOST_ITERATIONS, TOLERANCE};

/// ω at each height over each vertex from ∫ λω dA, by conjugate gradients with the diagonal as preconditioner, all heights at once.
pub(super) fn divide_by_mass(d: &Discretisation, space: &HeatSpace, sums: &mut [f64]) {
    let n = space.column.heights.n();
    let surface = &d.contact.surface;
    let corners = surface.dim + 1;
    // ∫ λ_i λ_j = |c| (1 + δ_ij)/((dim + 1)(dim + 2))
    let share = 1.0 / (corners * (corners + 1)) as f64;
    let mut diagonal = vec![0.0; surface.n_vertices()];
    for c in 0..surface.n_cells() {
        for vertex in surface.cell(c) {
            diagonal[*vertex as usize] += 2.0 * share * surface.measure(c);
        }
    }
    let product = |x: &[f64], y: &mut [f64]| {
        y.fill(0.0);
        let mut whole = vec![0.0; n];
        for c in 0..surface.n_cells() {
            let cell = surface.cell(c);
            let weight = share * surface.measure(c);
            whole.fill(0.0);
            for vertex in cell {
                for (sum, x) in whole.iter_mut().zip(&x[*vertex as usize * n..]) {
                    *sum += x;
                }
            }
            for vertex in cell {
                let at = *vertex as usize * n;
                for (k, sum) in whole.iter().enumerate() {
                    y[at + k] += weight * (sum + x[at + k]);
                }
            }
        }
    };
    let scaled = |r: &[f64]| -> Vec<f64> {
        let rows = r.chunks_exact(n).zip(&diagonal);
        rows.flat_map(|(row, m)| row.iter().map(move |v| v / m))
            .collect()
    };
    let mut residual = sums.to_vec();
    let mut z = scaled(&residual);
    let mut direction = z.clone();
    let mut images = vec![0.0; sums.len()];
    let mut square = dot(&residual, &z);
    let goal = TOLERANCE * TOLERANCE * square;
    sums.fill(0.0);
    for _ in 0..MOST_ITERATIONS {
        // also where nothing flows across, or what does is not a number
        if square <= goal || square.is_nan() {
            break;
        }
        product(&direction, &mut images);
        let step = square / dot(&direction, &images);
        for (k, p) in direction.iter().enumerate() {
            sums[k] += step * p;
            residual[k] -= step * images[k];
        }
        z = scaled(&residual);
        let next = dot(&residual, &z);
        for (p, z) in direction.iter_mut().zip(&z) {
            *p = z + next / square * *p;
        }
        square = next;
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}
