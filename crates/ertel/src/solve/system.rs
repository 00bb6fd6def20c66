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
use nalgebra::SVector;
use num_dual::{Derivative, DualSVec64};
use rayon::prelude::*;

use super::discretisation::Discretisation;
use crate::film::FilmFluid;
use crate::forms::reynolds::{ElementConstants, PointState, reynolds_point};
use crate::params::{Formulation, PenaltyScaling};

type Dual = DualSVec64<8>;

/// Coefficients of the Reynolds equation that do not vary over a level.
#[derive(Clone, Copy, Debug)]
pub struct FilmConstants {
    /// λ.
    pub lambda: f64,
    /// Galerkin, SUPG or GLS.
    pub formulation: Formulation,
    /// ρ_id.
    pub isotropic_diffusion: f64,
    /// Whether the stabilisation reckons with the deflection.
    pub elastic_stabilisation: bool,
    /// ξ₀ in force.
    pub penalty: f64,
    /// Its scaling.
    pub penalty_scaling: PenaltyScaling,
    /// Predicted central film H_f.
    pub film_scale: f64,
}

impl FilmConstants {
    fn on_element(&self, size: f64, order: usize) -> ElementConstants {
        let penalty = match self.penalty_scaling {
            PenaltyScaling::ElementSquared => self.penalty * size * size,
            PenaltyScaling::Constant => self.penalty,
            PenaltyScaling::Film => {
                self.penalty * (self.film_scale * self.film_scale / self.lambda).max(1.0)
            }
            PenaltyScaling::InverseElementSquared => self.penalty / (size * size),
        };
        ElementConstants {
            lambda: self.lambda,
            size,
            order,
            penalty,
            formulation: self.formulation,
            isotropic_diffusion: self.isotropic_diffusion,
            elastic_stabilisation: self.elastic_stabilisation,
        }
    }
}

/// State of the contact on a level.
#[derive(Clone, Debug)]
pub struct State {
    /// Pressure at every pressure node (zero on the edge).
    pub pressure: Vec<f64>,
    /// Deflection at every deflection node.
    pub deflection: Vec<f64>,
    /// Film constant H0.
    pub rigid_separation: f64,
}

/// Linearised film equations.
pub struct System {
    /// Reynolds residual of each pressure unknown.
    pub residual: Vec<f64>,
    /// √Σ of the entrainment share of the residual: its scale.
    pub residual_scale: f64,
    /// ∂R/∂H0.
    pub by_separation: Vec<f64>,
    /// Share of the residual that the edge of the contact area takes up, at each pressure node:
    /// the mass flux through the edge, −∮ m·n N (zero at free nodes).
    pub edge_flux: Vec<f64>,
    /// Element blocks, row-major: pressure node by (pressure nodes, then deflection nodes).
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
        let width = n + m + 3; // pressure, deflection | H0, residual, entrainment
        let mut local = vec![0.0; d.contact.n_elements() * n * width];
        local
            .par_chunks_mut(n * width)
            .enumerate()
            .for_each(|(c, out)| {
                element(d, fluid, constants, state, source, c, out);
            });
        let mut system = System {
            residual: vec![0.0; d.n_pressure],
            residual_scale: 0.0,
            by_separation: vec![0.0; d.n_pressure],
            edge_flux: vec![0.0; d.pressure.n_nodes()],
            blocks: vec![0.0; d.contact.n_elements() * n * (n + m)],
        };
        let mut entrainment = vec![0.0; d.n_pressure];
        for c in 0..d.contact.n_elements() {
            for (i, node) in d.pressure.nodes_of(c).iter().enumerate() {
                let row = &local[(c * n + i) * width..(c * n + i + 1) * width];
                let dof = d.pressure_dofs[*node as usize];
                if dof == CONSTRAINED {
                    system.edge_flux[*node as usize] += row[n + m + 1];
                } else {
                    system.by_separation[dof as usize] += row[n + m];
                    system.residual[dof as usize] += row[n + m + 1];
                    entrainment[dof as usize] += row[n + m + 2];
                    let start = (c * n + i) * (n + m);
                    system.blocks[start..start + n + m].copy_from_slice(&row[..n + m]);
                }
            }
        }
        system.residual_scale = norm(&entrainment);
        system
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
    pub fn products<'a>(&'a self, d: &'a Discretisation, precision: Precision) -> Products<'a> {
        let n = d.contact.deflection.n_nodes();
        Products {
            system: self,
            d,
            precision,
            pressure: vec![0.0; d.pressure.n_nodes()],
            loads: vec![0.0; n],
            deflection: vec![0.0; n],
            single: std::array::from_fn(|_| vec![0.0; n]),
        }
    }
}

/// Precision of the elastic response in products with the Jacobian.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// Enough for a step of Newton's method, whose residual is computed in double.
    Single,
    /// Double.
    Double,
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
    precision: Precision,
    pressure: Vec<f64>,
    loads: Vec<f64>,
    deflection: Vec<f64>,
    /// Loads, deflections and scratch.
    single: [Vec<f32>; 3],
}

impl Products<'_> {
    /// y = (R_P + R_δ C M) x for the pressure unknowns.
    pub fn multiply(&mut self, x: &[f64], y: &mut [f64]) {
        let d = self.d;
        for (value, dof) in self.pressure.iter_mut().zip(&d.pressure_dofs) {
            *value = x.get(*dof as usize).copied().unwrap_or(0.0);
        }
        let (n, m) = (d.pressure_table.n_nodes, d.deflection_table.n_nodes);
        self.loads.fill(0.0);
        for c in 0..d.contact.n_elements() {
            let block = &d.coupling[c * n * m..(c + 1) * n * m];
            let nodes = d.pressure.nodes_of(c);
            for (row, target) in block.chunks_exact(n).zip(d.contact.deflection.nodes_of(c)) {
                self.loads[*target as usize] += dot_at(row, nodes, &self.pressure);
            }
        }
        self.deflect();
        y.fill(0.0);
        for c in 0..d.contact.n_elements() {
            let nodes = d.pressure.nodes_of(c);
            let below = d.contact.deflection.nodes_of(c);
            let blocks = &self.system.blocks[c * n * (n + m)..(c + 1) * n * (n + m)];
            for (row, node) in blocks.chunks_exact(n + m).zip(nodes) {
                let dof = d.pressure_dofs[*node as usize];
                if dof != CONSTRAINED {
                    y[dof as usize] += dot_at(&row[..n], nodes, &self.pressure)
                        + dot_at(&row[n..], below, &self.deflection);
                }
            }
        }
    }

    /// Deflections of the loads.
    fn deflect(&mut self) {
        let elastic = &self.d.contact.elastic;
        if self.precision == Precision::Double {
            self.deflection = elastic.deflect(&self.loads);
            return;
        }
        let [loads, deflection, part] = &mut self.single;
        for (single, load) in loads.iter_mut().zip(&self.loads) {
            *single = *load as f32;
        }
        elastic.deflect_single(loads, deflection, part);
        for (value, single) in self.deflection.iter_mut().zip(&*deflection) {
            *value = f64::from(*single);
        }
    }
}

/// Σ row_j values[nodes_j].
fn dot_at(row: &[f64], nodes: &[u32], values: &[f64]) -> f64 {
    row.iter()
        .zip(nodes)
        .map(|(v, j)| v * values[*j as usize])
        .sum()
}

/// Adds one element's rows: [∂R/∂P | ∂R/∂δ | ∂R/∂H0 | R | entrainment] for each pressure node.
fn element(
    d: &Discretisation,
    fluid: &FilmFluid,
    constants: &FilmConstants,
    state: &State,
    source: Option<&(dyn Fn([f64; 3]) -> f64 + Sync)>,
    c: usize,
    out: &mut [f64],
) {
    let (n, m) = (d.pressure_table.n_nodes, d.deflection_table.n_nodes);
    let width = n + m + 3;
    let map = &d.contact.maps[c];
    let local = constants.on_element(d.contact.sizes[c], d.pressure.element.order());
    let p_nodes = d.pressure.nodes_of(c);
    let w_nodes = d.contact.deflection.nodes_of(c);
    let mut p_basis = vec![[0.0; 5]; n]; // N, N_x, N_y, ΔN, κN
    let mut w_basis = vec![[0.0; 3]; m]; // N, N_x, N_y
    for (q, weight) in d.rule.weights.iter().enumerate() {
        let mut p = [0.0; 5];
        for (j, basis) in p_basis.iter_mut().enumerate() {
            let g = map.gradient(d.pressure_table.gradients[q * n + j]);
            let laplacian = map.laplacian(&d.pressure_table.hessians[q * n + j]);
            *basis = [
                d.pressure_table.values[q * n + j],
                g[0],
                g[1],
                laplacian,
                d.pressure_unseen[q * n + j],
            ];
            let value = state.pressure[p_nodes[j] as usize];
            for (a, b) in p.iter_mut().zip(*basis) {
                *a += value * b;
            }
        }
        let mut point = [0.0; 3];
        let mut w = [0.0; 3];
        for (j, basis) in w_basis.iter_mut().enumerate() {
            let node = w_nodes[j] as usize;
            let g = map.gradient(d.deflection_table.gradients[q * m + j]);
            *basis = [d.deflection_table.values[q * m + j], g[0], g[1]];
            for (a, b) in w.iter_mut().zip(*basis) {
                *a += state.deflection[node] * b;
            }
            for (x, px) in point.iter_mut().zip(d.contact.deflection.points[node]) {
                *x += basis[0] * px;
            }
        }
        let dual = |value: f64, k: usize| {
            Dual::new(
                value,
                Derivative::some(SVector::from_fn(|i, _| if i == k { 1.0 } else { 0.0 })),
            )
        };
        let h = state.rigid_separation + d.contact.undeformed_gap(point) + w[0];
        let s = PointState {
            pressure: dual(p[0], 0),
            pressure_gradient: [dual(p[1], 1), dual(p[2], 2)],
            pressure_laplacian: dual(p[3], 3),
            film: dual(h, 4),
            film_gradient: [dual(point[0] + w[1], 5), dual(point[1] + w[2], 6)],
            pressure_unseen: dual(p[4], 7),
        };
        let fluid = fluid.at(p[0]);
        let f = source.map_or(0.0, |f| f(point));
        let t = reynolds_point(&s, &fluid, &local, f);
        let test = [t.value, t.gradient[0], t.gradient[1], t.laplacian, t.unseen];
        let scale = weight * map.determinant;
        let value = test.map(|v| scale * v.re);
        let slopes = test.map(|v| {
            let e = v
                .eps
                .unwrap_generic(nalgebra::Const::<8>, nalgebra::Const::<1>);
            std::array::from_fn::<f64, 8, _>(|k| scale * e[k])
        });
        let entrainment = scale * fluid.density[0] * h;
        for i in 0..n {
            let test = p_basis[i];
            let row = &mut out[i * width..(i + 1) * width];
            let mut by: [f64; 8] = [0.0; 8];
            for (k, b) in by.iter_mut().enumerate() {
                *b = (0..5).map(|a| test[a] * slopes[a][k]).sum();
            }
            for (r, b) in row[..n].iter_mut().zip(&p_basis) {
                *r += by[0] * b[0] + by[1] * b[1] + by[2] * b[2] + by[3] * b[3] + by[7] * b[4];
            }
            for (r, b) in row[n..n + m].iter_mut().zip(&w_basis) {
                *r += by[4] * b[0] + by[5] * b[1] + by[6] * b[2];
            }
            row[n + m] += by[4];
            row[n + m + 1] += (0..5).map(|a| test[a] * value[a]).sum::<f64>();
            row[n + m + 2] += test[1] * entrainment;
        }
    }
}

fn norm(v: &[f64]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}
