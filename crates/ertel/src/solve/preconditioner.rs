//! Sparse approximation of the coupled Jacobian, factorised.
//!
//! ```text
//!   | R_P   R_δ | | dP |     S̃: the stiffness of the surface, cut off after the second
//!   | −M    S̃   | | dδ |     ring of nodes
//! ```
//! The compliance of a half-space is long-range, its inverse is not: that is why cutting the
//! stiffness works where cutting the compliance does not.

use ertel_fem::assembly::{CONSTRAINED, NodeGraph};
use ertel_fem::linear::lu::{LuError, SparseLu};
use faer::sparse::Triplet;

use super::discretisation::Discretisation;
use super::system::System;

/// Pattern and values of the cut-off stiffness, made once per level.
pub struct NearStiffness {
    entries: Vec<(u32, u32, f64)>,
}

impl NearStiffness {
    /// Stiffness between nodes that are neighbours of neighbours.
    pub fn new(d: &Discretisation) -> NearStiffness {
        let graph = NodeGraph::new(&d.contact.deflection);
        let mut pairs = Vec::new();
        for i in 0..graph.n_nodes() {
            let mut near: Vec<u32> = graph
                .of(i)
                .iter()
                .flat_map(|j| graph.of(*j as usize).iter().copied())
                .collect();
            near.sort_unstable();
            near.dedup();
            pairs.extend(
                near.into_iter()
                    .filter(|j| *j as usize >= i)
                    .map(|j| (i as u32, j)),
            );
        }
        let values = d.contact.elastic.near_stiffness(&pairs);
        let mut entries = Vec::with_capacity(2 * pairs.len());
        for ((i, j), v) in pairs.into_iter().zip(values) {
            entries.push((i, j, v));
            if i != j {
                entries.push((j, i, v));
            }
        }
        NearStiffness { entries }
    }
}

/// Factorised approximation of the coupled system without the load equation.
pub struct Preconditioner {
    lu: SparseLu,
    n_pressure: usize,
    scratch: Vec<f64>,
}

impl Preconditioner {
    /// Factorises for the Jacobian of `system`.
    ///
    /// # Errors
    /// When the matrix is singular.
    pub fn new(
        d: &Discretisation,
        near: &NearStiffness,
        system: &System,
    ) -> Result<Preconditioner, LuError> {
        let (n, m) = (d.pressure_table.n_nodes, d.deflection_table.n_nodes);
        let size = d.n_pressure + d.contact.deflection.n_nodes();
        let mut triplets =
            Vec::with_capacity(system.blocks.len() + d.coupling.len() + near.entries.len());
        for c in 0..d.contact.n_elements() {
            let nodes = d.pressure.nodes_of(c);
            let below = d.contact.deflection.nodes_of(c);
            for (i, node) in nodes.iter().enumerate() {
                let row = d.pressure_dofs[*node as usize];
                if row == CONSTRAINED {
                    continue;
                }
                let start = (c * n + i) * (n + m);
                for (j, other) in nodes.iter().enumerate() {
                    let column = d.pressure_dofs[*other as usize];
                    if column != CONSTRAINED {
                        triplets.push(Triplet::new(
                            row as usize,
                            column as usize,
                            system.blocks[start + j],
                        ));
                    }
                }
                for (j, other) in below.iter().enumerate() {
                    let column = d.n_pressure + *other as usize;
                    triplets.push(Triplet::new(
                        row as usize,
                        column,
                        system.blocks[start + n + j],
                    ));
                    let block = d.coupling[c * n * m + j * n + i];
                    triplets.push(Triplet::new(column, row as usize, -block));
                }
            }
        }
        for &(i, j, v) in &near.entries {
            triplets.push(Triplet::new(
                d.n_pressure + i as usize,
                d.n_pressure + j as usize,
                v,
            ));
        }
        Ok(Preconditioner {
            lu: SparseLu::new(size, &triplets)?,
            n_pressure: d.n_pressure,
            scratch: vec![0.0; size],
        })
    }

    /// Solves approximately for the pressure update, in place.
    pub fn solve(&mut self, rhs: &mut [f64]) {
        self.scratch.fill(0.0);
        self.scratch[..self.n_pressure].copy_from_slice(rhs);
        self.lu.solve(&mut self.scratch);
        rhs.copy_from_slice(&self.scratch[..self.n_pressure]);
    }
}
