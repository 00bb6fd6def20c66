//! The elastic response of the contact surface, condensed from the body.

use ertel_fem::assembly::{CONSTRAINED, DofMap, NodeGraph, assemble_symmetric};
use ertel_fem::linear::condensed::{CholeskyError, CondensedStiffness};
use ertel_fem::mesh::{BodyMesh, SimplexMesh};
use ertel_fem::quadrature::Quadrature;
use ertel_fem::space::{Affine, Space};

use crate::forms::elasticity::{lame, stiffness_point};

/// Displacement space of the body with its constraints and its trace on the contact area.
pub struct BodySpace {
    /// Displacement nodes of the body.
    pub space: Space,
    /// Displacement unknowns.
    pub dofs: DofMap,
    /// Node graph of the body.
    pub graph: NodeGraph,
    /// Normal displacement unknown under each surface node.
    pub normal_dofs: Vec<usize>,
}

impl BodySpace {
    /// Space of the given order; `trace` is the surface space of the same order.
    ///
    /// Clamped at the bottom, no normal displacement on the symmetry plane y = 0 (3D).
    pub fn new(
        body: &BodyMesh,
        surface: &SimplexMesh,
        surface_to_body: &[u32],
        trace: &Space,
    ) -> BodySpace {
        let dim = body.mesh.dim;
        let depth = body.params().depth;
        let space = Space::new(&body.mesh, trace.element.order());
        let dofs = DofMap::new(space.n_nodes(), dim, |node, component| {
            let p = space.points[node];
            let bottom = p[2] + depth < 1e-9 * depth;
            let symmetry = dim == 3 && component == 1 && p[1] > -1e-12;
            !bottom && !symmetry
        });
        let graph = NodeGraph::new(&space);
        let normal_dofs = trace
            .trace_nodes(surface, surface_to_body, &space)
            .into_iter()
            .map(|node| dofs.of_node(node as usize)[dim - 1] as usize)
            .collect();
        BodySpace {
            space,
            dofs,
            graph,
            normal_dofs,
        }
    }

    /// Factorised stiffness of the body with unit Young's modulus.
    ///
    /// # Errors
    /// When the factorisation fails.
    pub fn factorise(
        &self,
        body: &BodyMesh,
        poissons_ratio: f64,
    ) -> Result<CondensedStiffness, CholeskyError> {
        let matrix = self.stiffness(body, poissons_ratio);
        CondensedStiffness::new(&matrix, &self.graph, &self.dofs, &self.normal_dofs)
    }

    /// Stiffness matrix of the body with unit Young's modulus, upper triangle.
    pub fn stiffness(
        &self,
        body: &BodyMesh,
        poissons_ratio: f64,
    ) -> ertel_fem::assembly::SymmetricMatrix {
        let dim = body.mesh.dim;
        let lame = lame(1.0, poissons_ratio);
        let rule = Quadrature::simplex(dim, 2 * (self.space.element.order() - 1));
        let table = self.space.element.tabulate(&rule);
        let n = table.n_nodes;
        assemble_symmetric(&self.space, &self.graph, &self.dofs, |cell, out| {
            out.fill(0.0);
            let map = Affine::new(&body.mesh, cell);
            let mut gradients = [[0.0; 3]; 10];
            for (q, weight) in rule.weights.iter().enumerate() {
                for i in 0..n {
                    gradients[i] = map.gradient(table.gradients[q * n + i]);
                }
                stiffness_point(dim, lame, &gradients[..n], weight * map.determinant, out);
            }
        })
    }

    /// Displacement of every node from a solution vector; constrained components are zero.
    pub fn displacement(&self, solution: &[f64]) -> Vec<[f64; 3]> {
        let dim = self.dofs.n_components;
        (0..self.space.n_nodes())
            .map(|node| {
                let mut u = [0.0; 3];
                for (c, d) in self.dofs.of_node(node).iter().enumerate() {
                    // components of a plane body are x and z
                    let axis = if dim == 2 { 2 * c } else { c };
                    if *d != CONSTRAINED {
                        u[axis] = solution[*d as usize];
                    }
                }
                u
            })
            .collect()
    }
}

/// One elastic body: condensed stiffness for unit modulus, and its dimensionless modulus.
pub struct ElasticBody {
    /// Condensed stiffness for E = 1.
    pub stiffness: CondensedStiffness,
    /// E/(R p_h/a).
    pub modulus: f64,
    /// Poisson's ratio.
    pub poissons_ratio: f64,
}

/// Bodies in series: the deflections under one load add up.
pub struct ElasticOperator {
    /// The equivalent body, or plane and ball.
    pub bodies: Vec<ElasticBody>,
}

impl ElasticOperator {
    /// Total deflection of the surface nodes under nodal loads ∫P N: δ = Σ_b S_b⁻¹ f/E_b.
    pub fn deflect(&self, load: &[f64]) -> Vec<f64> {
        let mut sum = vec![0.0; load.len()];
        for body in &self.bodies {
            let mut w = load.to_vec();
            body.stiffness.solve_condensed(&mut w);
            for (s, w) in sum.iter_mut().zip(&w) {
                *s += w / body.modulus;
            }
        }
        sum
    }

    /// Stiffness of the bodies in series between close surface nodes, approximately:
    /// the first body's, scaled by its share of the half-space compliance (1 − ν²)/E.
    pub fn near_stiffness(&self, pairs: &[(u32, u32)]) -> Vec<f64> {
        let compliance = |b: &ElasticBody| (1.0 - b.poissons_ratio.powi(2)) / b.modulus;
        let first = &self.bodies[0];
        let total: f64 = self.bodies.iter().map(compliance).sum();
        let scale = first.modulus * compliance(first) / total;
        first
            .stiffness
            .condensed_entries(pairs)
            .into_iter()
            .map(|s| s * scale)
            .collect()
    }
}
