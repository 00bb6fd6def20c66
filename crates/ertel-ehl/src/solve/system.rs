//! Residual and Jacobian of the film equations on one level, and products with the Jacobian.
//!
//! ```text
//!   unknowns (P, H0); deflection δ = C M P eliminated, C the condensed compliance
//!
//!   | R_P + R_δ C M   r_0 | | dP  |     | R            |
//!   | cᵀ               0  | | dH0 | = − | cᵀP − load   |
//! ```
//! This is Newton's method on the whole coupled system (Habchi 2008, eq. 3.22): the elastic
//! equations are linear, so eliminating U from each step changes nothing but the cost.

use ertel_fem::assembly::CONSTRAINED;
use ertel_fem::kernel;
use ertel_fem::linear::dense::vectorised;
use rayon::prelude::*;

use super::discretisation::Discretisation;
use super::element::{Assembler, Element, N_SUMS};
use super::state::{FilmConstants, State};
use crate::elastic::Accuracy;
use crate::film::FilmFluid;

/// Linearised film equations.
pub struct System {
    /// Reynolds residual of each pressure unknown.
    pub residual: Vec<f64>,
    /// √Σ of the entrainment share of the residual: its scale.
    pub residual_scale: f64,
    /// ∂R/∂H0.
    pub by_separation: Vec<f64>,
    /// ∫(τR)² over each element: about the square of what it misses of the pressure (Hauke et al., Comput. Methods Appl. Mech.
    /// Eng. 195 (2006) 6026-6046); zero without stabilisation.
    pub missed: Vec<f64>,
    /// Element blocks, row-major: pressure node by (pressure nodes, then deflection nodes), rows of edge
    /// nodes included.
    pub blocks: Vec<f64>,
}

impl System {
    /// Evaluates residual and Jacobian. `source(x, y)` is f of the manufactured solutions.
    pub fn assemble(
        d: &Discretisation,
        fluid: &FilmFluid,
        constants: &FilmConstants,
        state: &State,
        source: Option<&(dyn Fn([f64; 3]) -> f64 + Sync)>,
    ) -> System {
        let (n, m) = (d.pressure_table.n_nodes, d.deflection_table.n_nodes);
        let n_elements = d.contact.n_elements();
        let mut system = System {
            residual: vec![0.0; d.n_pressure],
            residual_scale: 0.0,
            by_separation: vec![0.0; d.n_pressure],
            missed: vec![0.0; n_elements],
            blocks: vec![0.0; n_elements * n * (n + m)],
        };
        let mut sums = vec![[0.0; N_SUMS]; n_elements * n];
        let assembler = Assembler::new(d, fluid, constants, state, source);
        system
            .blocks
            .par_chunks_mut(BATCH * n * (n + m))
            .zip(sums.par_chunks_mut(BATCH * n))
            .enumerate()
            .for_each(|(batch, (blocks, sums))| {
                let mut element = Element::default();
                let blocks = blocks.chunks_exact_mut(n * (n + m));
                for (k, (block, sums)) in blocks.zip(sums.chunks_exact_mut(n)).enumerate() {
                    assembler.element(BATCH * batch + k, &mut element, block, sums);
                }
            });
        let mut entrainment = vec![0.0; d.n_pressure];
        for c in 0..n_elements {
            for (node, sums) in d.pressure.nodes_of(c).iter().zip(&sums[c * n..]) {
                system.missed[c] += sums[3];
                let dof = d.pressure_dofs[*node as usize];
                if dof != CONSTRAINED {
                    system.by_separation[dof as usize] += sums[0];
                    system.residual[dof as usize] += sums[1];
                    entrainment[dof as usize] += sums[2];
                }
            }
        }
        system.residual_scale = norm(&entrainment);
        system
    }

    /// Share of the residual at the edge of the contact area, at each pressure node:
    /// the mass flux through the edge, −∮ m·n N (zero at free nodes).
    pub fn edge_flux(
        d: &Discretisation,
        fluid: &FilmFluid,
        constants: &FilmConstants,
        state: &State,
    ) -> Vec<f64> {
        let (n, m) = (d.pressure_table.n_nodes, d.deflection_table.n_nodes);
        let assembler = Assembler::new(d, fluid, constants, state, None);
        let mut element = Element::default();
        let mut block = vec![0.0; n * (n + m)];
        let mut sums = vec![[0.0; N_SUMS]; n];
        let mut flux = vec![0.0; d.pressure.n_nodes()];
        let on_edge = |node: &u32| d.pressure_dofs[*node as usize] == CONSTRAINED;
        for c in 0..d.contact.n_elements() {
            let nodes = d.pressure.nodes_of(c);
            if !nodes.iter().any(on_edge) {
                continue;
            }
            assembler.element(c, &mut element, &mut block, &mut sums);
            for (node, sums) in nodes.iter().zip(&sums) {
                if on_edge(node) {
                    flux[*node as usize] += sums[1];
                }
            }
        }
        flux
    }

    /// Reynolds residual relative to the entrained flow.
    pub fn relative_residual(&self) -> f64 {
        norm(&self.residual) / self.residual_scale
    }

    /// Calls `f(row, column, index in blocks)` for every entry of R_P and R_δ, element by element.
    pub fn for_each_entry(d: &Discretisation, mut f: impl FnMut(u32, Column, usize)) {
        let (n, m) = (d.pressure_table.n_nodes, d.deflection_table.n_nodes);
        for c in 0..d.contact.n_elements() {
            let nodes = d.pressure.nodes_of(c);
            for (i, node) in nodes.iter().enumerate() {
                let row = d.pressure_dofs[*node as usize];
                if row == CONSTRAINED {
                    continue;
                }
                let start = (c * n + i) * (n + m);
                for (j, other) in nodes.iter().enumerate() {
                    let column = d.pressure_dofs[*other as usize];
                    if column != CONSTRAINED {
                        f(row, Column::Pressure(column), start + j);
                    }
                }
                for (j, other) in d.contact.deflection.nodes_of(c).iter().enumerate() {
                    f(row, Column::Deflection(*other), start + n + j);
                }
            }
        }
    }

    /// Products with R_P + R_δ C M: scratch memory for them.
    pub fn products<'a>(&'a self, d: &'a Discretisation, accuracy: Accuracy) -> Products<'a> {
        Products {
            system: self,
            d,
            accuracy,
            pressure: vec![0.0; d.pressure.n_nodes()],
            rows: Vec::new(),
        }
    }
}

/// Column of an entry of the linearised film equations.
#[derive(Clone, Copy, Debug)]
pub enum Column {
    /// Pressure unknown.
    Pressure(u32),
    /// Deflection node.
    Deflection(u32),
}

/// Products with the condensed Jacobian, without the separation.
pub struct Products<'a> {
    system: &'a System,
    d: &'a Discretisation,
    accuracy: Accuracy,
    pressure: Vec<f64>,
    /// Element by element.
    rows: Vec<f64>,
}

kernel! {
    Rows ['a, 'b] ['a, 'b] (products: &'b Products<'a>, deflection: &'b [f64], first: usize, rows: &'b mut [f64]) -> () {
        products.rows_here(deflection, first, rows)
    }
}

impl Products<'_> {
    /// y = (R_P + R_δ C M) x for the pressure unknowns.
    pub fn multiply(&mut self, x: &[f64], y: &mut [f64]) {
        for (value, dof) in self.pressure.iter_mut().zip(&self.d.pressure_dofs) {
            *value = x.get(*dof as usize).copied().unwrap_or(0.0);
        }
        let d = self.d;
        let deflection = d.deflect(&self.pressure, self.accuracy);
        let n = d.pressure_table.n_nodes;
        let mut rows = std::mem::take(&mut self.rows);
        rows.resize(d.contact.n_elements() * n, 0.0);
        (rows.par_chunks_mut(MULTIPLY_BATCH * n).enumerate()).for_each(|(batch, rows)| {
            vectorised(Rows {
                products: self,
                deflection: &deflection,
                first: MULTIPLY_BATCH * batch,
                rows,
            });
        });
        y.fill(0.0);
        for (c, rows) in rows.chunks_exact(n).enumerate() {
            for (node, row) in d.pressure.nodes_of(c).iter().zip(rows) {
                let dof = d.pressure_dofs[*node as usize];
                if dof != CONSTRAINED {
                    y[dof as usize] += row;
                }
            }
        }
        self.rows = rows;
    }

    /// Rows of the element blocks from element `first` on, times x.
    #[inline(always)]
    fn rows_here(&self, deflection: &[f64], first: usize, rows: &mut [f64]) {
        let d = self.d;
        let (n, m) = (d.pressure_table.n_nodes, d.deflection_table.n_nodes);
        let blocks = &self.system.blocks[first * n * (n + m)..];
        for (k, rows) in rows.chunks_exact_mut(n).enumerate() {
            let nodes = d.pressure.nodes_of(first + k);
            let below = d.contact.deflection.nodes_of(first + k);
            let block = &blocks[k * n * (n + m)..(k + 1) * n * (n + m)];
            for (row, y) in block.chunks_exact(n + m).zip(rows) {
                *y =
                    dot_at(&row[..n], nodes, &self.pressure) + dot_at(&row[n..], below, deflection);
            }
        }
    }
}

/// Σ row_j values[nodes_j].
#[inline(always)]
fn dot_at(row: &[f64], nodes: &[u32], values: &[f64]) -> f64 {
    row.iter()
        .zip(nodes)
        .map(|(v, j)| v * values[*j as usize])
        .sum()
}

/// Elements that a thread takes at a time.
const BATCH: usize = 16;

/// The same for products.
const MULTIPLY_BATCH: usize = 128;

fn norm(v: &[f64]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}
