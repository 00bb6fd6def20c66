//! One mesh level: meshes, spaces, elastic operator and everything that Newton's method reuses.

use std::sync::Arc;

use ertel_fem::assembly::CONSTRAINED;
use ertel_fem::element::Tabulation;
use ertel_fem::quadrature::Quadrature;
use ertel_fem::space::Space;

use super::contact_surface::ContactSurface;
use super::heat::column::Column;
use super::heat::space::HeatSpace;
pub use super::sizes::LevelSizes;
use crate::contact::{Shape, Symmetry};
use crate::elastic::{Accuracy, Trace};
pub use crate::engine::Extents;

/// Pressure space on a contact surface, and everything that Newton's method reuses.
#[derive(Clone)]
pub struct Discretisation {
    /// Mesh and elastic response.
    pub contact: Arc<ContactSurface>,
    /// Pressure nodes.
    pub pressure: Space,
    /// Pressure unknown of each node, or `CONSTRAINED` on the edge of the contact area.
    pub pressure_dofs: Vec<u32>,
    /// Number of pressure unknowns.
    pub n_pressure: usize,
    /// Quadrature rule of the film equations.
    pub rule: Quadrature,
    /// Pressure shape functions at its points.
    pub pressure_table: Tabulation,
    /// κN, the part of each pressure shape function without effect on the deflection, there.
    pub pressure_unresolved: Vec<f64>,
    /// Deflection shape functions at its points.
    pub deflection_table: Tabulation,
    /// ∫N of each pressure unknown.
    pub load: Vec<f64>,
    /// Operator from pressures to deflections.
    pub trace: Arc<Trace>,
    /// Share of each element in the diffusion at a ridge of the pressure; empty: none.
    pub at_ridge: Vec<f64>,
    /// Temperatures, where heat counts.
    pub heat: Option<Arc<HeatSpace>>,
}

impl Discretisation {
    /// Share of an element in the diffusion at a ridge of the pressure.
    pub fn share_at_ridge(&self, c: usize) -> f64 {
        self.at_ridge.get(c).copied().unwrap_or(0.0)
    }

    /// Pressure space of the given order on a contact area.
    pub fn new(contact: &Arc<ContactSurface>, pressure_order: usize) -> Discretisation {
        let surface = &contact.surface;
        let pressure = Space::new(surface, pressure_order);
        let mut n_pressure = 0;
        let pressure_dofs: Vec<u32> = pressure
            .points
            .iter()
            .map(|p| {
                if on_edge(&contact.shape, &contact.extents, *p) {
                    CONSTRAINED
                } else {
                    n_pressure += 1;
                    n_pressure as u32 - 1
                }
            })
            .collect();
        // ε∇P·∇W has degree 2k − 2 and H³ six more; viscosity makes it no polynomial at all.
        let rule = Quadrature::simplex(surface.dim, 2 * pressure_order.max(2) + 2);
        let pressure_table = pressure.element.tabulate(&rule);
        let deflection_table = contact.deflection.element.tabulate(&rule);
        // A deflection of at least linear order takes up all of a linear pressure.
        let seen = (pressure_order - 1)
            .min(contact.deflection.element.order())
            .max(1);
        let pressure_unresolved = pressure.element.fluctuations(seen, &rule);
        let n = pressure_table.n_nodes;
        let mut load = vec![0.0; n_pressure];
        for (c, map) in contact.maps.iter().enumerate() {
            for (q, weight) in rule.weights.iter().enumerate() {
                let w = weight * map.determinant;
                for (j, node) in pressure.nodes_of(c).iter().enumerate() {
                    let v = w * pressure_table.values[q * n + j];
                    let dof = pressure_dofs[*node as usize];
                    if dof != CONSTRAINED {
                        load[dof as usize] += v;
                    }
                }
            }
        }
        let trace = Arc::new(Trace::new(surface, &pressure, &contact.deflection, &rule));
        Discretisation {
            contact: Arc::clone(contact),
            trace,
            pressure,
            pressure_dofs,
            n_pressure,
            rule,
            pressure_table,
            pressure_unresolved,
            deflection_table,
            load,
            at_ridge: Vec::new(),
            heat: None,
        }
    }

    /// The same with temperatures of an order over the contact area, in columns of the given layers and
    /// temperatures before they are heated.
    pub fn with_heat(mut self, order: usize, column: Column, unheated: Vec<f64>) -> Discretisation {
        let heat = HeatSpace::new(
            &self.contact,
            &self.pressure.element,
            &self.rule,
            order,
            column,
            unheated,
        );
        self.heat = Some(Arc::new(heat));
        self
    }

    /// Calls `f(deflection node, pressure unknown, ∫N_δ N_P)` for every entry of M, element by element.
    pub fn for_each_coupling(&self, mut f: impl FnMut(u32, u32, f64)) {
        for (below, nodes, block) in self.trace.elements() {
            for (row, node) in block.chunks_exact(nodes.len()).zip(below) {
                for (entry, other) in row.iter().zip(nodes) {
                    let dof = self.pressure_dofs[*other as usize];
                    if dof != CONSTRAINED {
                        f(*node, dof, *entry);
                    }
                }
            }
        }
    }

    /// Deflection of the surface nodes under nodal pressures (all nodes, edge included).
    pub fn deflect(&self, pressure: &[f64], accuracy: Accuracy) -> Vec<f64> {
        self.contact
            .response
            .deflect(&self.trace, pressure, accuracy)
    }

    /// Weights of the pressure unknowns that correspond to `weights` of the surface nodes' deflections.
    pub fn deflect_transposed(&self, weights: &[f64], accuracy: Accuracy) -> Vec<f64> {
        let nodes = (self.contact.response).deflect_transposed(&self.trace, weights, accuracy);
        let mut unknowns = vec![0.0; self.n_pressure];
        for (value, dof) in nodes.iter().zip(&self.pressure_dofs) {
            if *dof != CONSTRAINED {
                unknowns[*dof as usize] = *value;
            }
        }
        unknowns
    }

    /// ∫P over the contact area.
    pub fn integral(&self, pressure: &[f64]) -> f64 {
        self.pressure_dofs
            .iter()
            .zip(pressure)
            .filter(|(d, _)| **d != CONSTRAINED)
            .map(|(d, p)| self.load[*d as usize] * p)
            .sum()
    }
}

/// Whether a surface point lies where P = 0 is prescribed (not on the symmetry line).
pub(super) fn on_edge(shape: &Shape, e: &Extents, p: [f64; 3]) -> bool {
    let tiny = 1e-9 * (e.outlet - e.inlet);
    let [x, y] = shape.zone.unit([p[0], p[1]]);
    x < e.inlet + tiny
        || x > e.outlet - tiny
        || (!shape.is_line()
            && (y < -e.side + tiny || (shape.symmetry == Symmetry::Full && y > e.side - tiny)))
}
