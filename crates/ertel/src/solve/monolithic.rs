//! The whole coupled Jacobian in one sparse matrix, factorised directly (Habchi 2008, eq. 3.22,
//! appendix B). The reference that proves the condensed path right; far slower in 3D.
//!
//! ```text
//!          P     U_1..U_b   H0
//!   P    | R_P   −R_δ       r_0 |     δ = −Σ_b u_z,b on the contact area
//!   U_b  | M     E_b K_b        |     E_b K_b U_b = −M P: pressure pushes down
//!   H0   | cᵀ                   |
//! ```

use ertel_fem::assembly::{CONSTRAINED, SymmetricMatrix};
use ertel_fem::linear::lu::{LuError, SparseLu};
use faer::sparse::Triplet;

use super::discretisation::Discretisation;
use super::system::System;

/// Stiffness matrices of the bodies, dimensionless.
pub struct BodyMatrices {
    matrices: Vec<(SymmetricMatrix, f64)>,
}

impl BodyMatrices {
    /// Assembles the stiffness of each body.
    pub fn new(d: &Discretisation) -> BodyMatrices {
        let c = &d.contact;
        let matrices = c
            .elastic
            .bodies
            .iter()
            .map(|b| (c.space.stiffness(&c.body, b.poissons_ratio), b.modulus))
            .collect();
        BodyMatrices { matrices }
    }
}

/// Factorised Jacobian of the coupled system.
pub struct Monolithic {
    lu: SparseLu,
    n: usize,
}

impl Monolithic {
    /// Assembles and factorises.
    ///
    /// # Errors
    /// When the matrix is singular or memory runs out.
    pub fn new(
        d: &Discretisation,
        bodies: &BodyMatrices,
        system: &System,
    ) -> Result<Monolithic, LuError> {
        let (n, m) = (d.pressure_table.n_nodes, d.deflection_table.n_nodes);
        let n_u = d.contact.space.dofs.n_dofs;
        let size = d.n_pressure + n_u * bodies.matrices.len() + 1;
        let first = |body: usize| d.n_pressure + body * n_u;
        let separation = size - 1;
        let mut t = Vec::new();
        for c in 0..d.contact.n_elements() {
            let nodes = d.pressure.nodes_of(c);
            for (i, node) in nodes.iter().enumerate() {
                let row = d.pressure_dofs[*node as usize];
                if row == CONSTRAINED {
                    continue;
                }
                let row = row as usize;
                let block = &system.blocks[(c * n + i) * (n + m)..][..n + m];
                for (j, other) in nodes.iter().enumerate() {
                    let column = d.pressure_dofs[*other as usize];
                    if column != CONSTRAINED {
                        t.push(Triplet::new(row, column as usize, block[j]));
                    }
                }
                for (j, other) in d.contact.deflection.nodes_of(c).iter().enumerate() {
                    let u = d.contact.space.normal_dofs[*other as usize];
                    for body in 0..bodies.matrices.len() {
                        t.push(Triplet::new(row, first(body) + u, -block[n + j]));
                        let coupling = d.coupling[c * n * m + j * n + i];
                        t.push(Triplet::new(first(body) + u, row, coupling));
                    }
                }
            }
        }
        for (body, (k, modulus)) in bodies.matrices.iter().enumerate() {
            for j in 0..k.n {
                for p in k.col_ptr[j]..k.col_ptr[j + 1] {
                    let (i, v) = (k.row_idx[p], modulus * k.values[p]);
                    t.push(Triplet::new(first(body) + i, first(body) + j, v));
                    if i != j {
                        t.push(Triplet::new(first(body) + j, first(body) + i, v));
                    }
                }
            }
        }
        for i in 0..d.n_pressure {
            t.push(Triplet::new(i, separation, system.by_separation[i]));
            t.push(Triplet::new(separation, i, d.load[i]));
        }
        Ok(Monolithic {
            lu: SparseLu::new(size, &t)?,
            n: size,
        })
    }

    /// Pressure and separation steps for a Reynolds residual and a load defect; the elastic
    /// equations hold already.
    pub fn solve(&self, residual: &[f64], load_defect: f64) -> (Vec<f64>, f64) {
        let mut x = vec![0.0; self.n];
        for (x, r) in x.iter_mut().zip(residual) {
            *x = -r;
        }
        x[self.n - 1] = load_defect;
        self.lu.solve(&mut x);
        (x[..residual.len()].to_vec(), x[self.n - 1])
    }
}
