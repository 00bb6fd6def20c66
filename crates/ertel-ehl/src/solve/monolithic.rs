//! The whole coupled Jacobian in one sparse matrix, factorised directly (Habchi 2008, eq. 3.22,
//! appendix B). The reference that proves the condensed path right; far slower in 3D.
//!
//! ```text
//!          P     U_1..U_b   H0
//!   P    | R_P   −R_δ       r_0 |     δ = −Σ_b u_z,b on the contact area
//!   U_b  | M     E_b K_b        |     E_b K_b U_b = −M P: pressure pushes down
//!   H0   | cᵀ                   |
//! ```

use ertel_fem::assembly::SymmetricMatrix;
use ertel_fem::linear::lu::{LuError, SparseLu};
use faer::sparse::Triplet;

use super::discretisation::Discretisation;
use super::system::{Column, System};

/// Stiffness matrices of the bodies, dimensionless.
pub struct BodyMatrices {
    matrices: Vec<(SymmetricMatrix, f64)>,
    /// Normal displacement unknown under each surface node.
    normal: Vec<usize>,
}

impl BodyMatrices {
    /// Assembles the stiffness of each body.
    ///
    /// # Panics
    /// Above a half-space: input is checked before.
    pub fn new(d: &Discretisation) -> BodyMatrices {
        let (body, condensed) = d.contact.body().expect("a finite-element body");
        let space = body.space(&d.contact.deflection);
        let matrices = (condensed.bodies.iter())
            .map(|b| {
                (
                    space.stiffness(&body.mesh, b.material.poissons_ratio),
                    b.material.youngs_modulus,
                )
            })
            .collect();
        BodyMatrices {
            matrices,
            normal: space.normal_dofs.clone(),
        }
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
        let n_u = d.contact.n_displacement;
        let size = d.n_pressure + n_u * bodies.matrices.len() + 1;
        let first = |body: usize| d.n_pressure + body * n_u;
        let separation = size - 1;
        let normal = &bodies.normal;
        let mut t = Vec::new();
        System::for_each_entry(d, |row, column, index| {
            let (row, value) = (row as usize, system.blocks[index]);
            match column {
                Column::Pressure(dof) => t.push(Triplet::new(row, dof as usize, value)),
                Column::Deflection(node) => t
                    .extend((0..bodies.matrices.len()).map(|body| {
                        Triplet::new(row, first(body) + normal[node as usize], -value)
                    })),
            }
        });
        d.for_each_coupling(|node, dof, value| {
            t.extend((0..bodies.matrices.len()).map(|body| {
                Triplet::new(first(body) + normal[node as usize], dof as usize, value)
            }));
        });
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
