//! The elastic response of the contact surface, condensed from the body.

use std::sync::Arc;

use ertel_fem::assembly::{CONSTRAINED, DofMap, NodeGraph, assemble_symmetric};
use ertel_fem::linear::Stop;
use ertel_fem::linear::compliance::Compliance;
use ertel_fem::linear::condensed::{CholeskyError, CondensedStiffness, Keep};
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
    /// When the factorisation fails, or `stop` says so.
    pub fn factorise(
        &self,
        body: &BodyMesh,
        poissons_ratio: f64,
        keep: Keep,
        stop: Stop,
    ) -> Result<CondensedStiffness, CholeskyError> {
        CondensedStiffness::new(
            &self.space,
            &self.graph,
            &self.dofs,
            &self.normal_dofs,
            keep,
            self.element_stiffness(body, poissons_ratio),
            stop,
        )
    }

    /// Stiffness matrix of the body with unit Young's modulus, upper triangle.
    pub fn stiffness(
        &self,
        body: &BodyMesh,
        poissons_ratio: f64,
    ) -> ertel_fem::assembly::SymmetricMatrix {
        let element = self.element_stiffness(body, poissons_ratio);
        assemble_symmetric(&self.space, &self.graph, &self.dofs, element)
    }

    /// Stiffness matrix of an element of the body with unit Young's modulus.
    fn element_stiffness(
        &self,
        body: &BodyMesh,
        poissons_ratio: f64,
    ) -> impl Fn(usize, &mut [f64]) + Sync {
        let dim = body.mesh.dim;
        let lame = lame(1.0, poissons_ratio);
        let rule = Quadrature::simplex(dim, 2 * (self.space.element.order() - 1));
        let table = self.space.element.tabulate(&rule);
        let n = table.n_nodes;
        move |cell, out| {
            out.fill(0.0);
            let map = Affine::new(&body.mesh, cell);
            let mut gradients = [[0.0; 3]; 10];
            for (q, weight) in rule.weights.iter().enumerate() {
                for i in 0..n {
                    gradients[i] = map.gradient(table.gradients[q * n + i]);
                }
                stiffness_point(dim, lame, &gradients[..n], weight * map.determinant, out);
            }
        }
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

/// Condensed response of the contact area of a body with unit Young's modulus: all that Newton's
/// method needs of a body.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceResponse {
    /// Deflection of each surface node under unit loads on the others.
    pub compliance: Compliance,
    /// Condensed stiffness between near nodes, in the order of their list of pairs.
    pub near: Vec<f64>,
}

impl SurfaceResponse {
    /// Factorises a body and condenses it.
    ///
    /// # Errors
    /// When the factorisation fails, or `stop` says so.
    pub fn new(
        space: &BodySpace,
        body: &BodyMesh,
        poissons_ratio: f64,
        near_pairs: &[(u32, u32)],
        stop: Stop,
    ) -> Result<SurfaceResponse, CholeskyError> {
        let stiffness = space.factorise(body, poissons_ratio, Keep::Condensed, stop)?;
        if stop() {
            return Err(CholeskyError::Interrupted);
        }
        let near = near_pairs.iter();
        Ok(SurfaceResponse {
            near: near
                .map(|(i, j)| stiffness.condensed_entry(*i as usize, *j as usize))
                .collect(),
            compliance: stiffness.into_compliance()?,
        })
    }
}

/// Pairs of surface nodes (i ≤ j) that share an element, in line contacts also neighbours of neighbours: the stiffness
/// of the surface is short-ranged, and what a preconditioner needs of it ends there.
pub fn near_pairs(surface: &Space) -> Vec<(u32, u32)> {
    let graph = NodeGraph::new(surface);
    let line = surface.element.dim() == 1;
    let mut pairs = Vec::new();
    for i in 0..graph.n_nodes() {
        let mut near: Vec<u32> = graph.of(i).to_vec();
        if line {
            near.extend(graph.of(i).iter().flat_map(|j| graph.of(*j as usize)));
            near.sort_unstable();
            near.dedup();
        }
        let near = near.into_iter().filter(|j| *j as usize >= i);
        pairs.extend(near.map(|j| (i as u32, j)));
    }
    pairs
}

/// One elastic body: response for unit modulus, and its dimensionless modulus.
pub struct ElasticBody {
    /// Response for E = 1; bodies of one Poisson's ratio share it.
    pub response: Arc<SurfaceResponse>,
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
    /// Distinct responses with Σ1/E of the bodies that have them.
    fn responses(&self) -> impl Iterator<Item = (&SurfaceResponse, f64)> {
        let shares = |b: &ElasticBody| {
            let same = |o: &&ElasticBody| Arc::ptr_eq(&o.response, &b.response);
            self.bodies
                .iter()
                .filter(same)
                .map(|o| 1.0 / o.modulus)
                .sum()
        };
        self.bodies.iter().enumerate().filter_map(move |(k, b)| {
            let seen = |o: &ElasticBody| Arc::ptr_eq(&o.response, &b.response);
            let first = !self.bodies[..k].iter().any(seen);
            first.then(|| (&*b.response, shares(b)))
        })
    }

    /// Total deflection of the surface nodes under nodal loads ∫P N: δ = Σ_b C_b f/E_b.
    pub fn deflect(&self, load: &[f64]) -> Vec<f64> {
        let mut sum = vec![0.0; load.len()];
        let mut part = vec![0.0; load.len()];
        for (response, share) in self.responses() {
            response.compliance.apply(load, &mut part);
            for (s, w) in sum.iter_mut().zip(&part) {
                *s += share * w;
            }
        }
        sum
    }

    /// The same in single precision, for products with the Jacobian; `part` is scratch.
    pub fn deflect_single(&self, load: &[f32], sum: &mut [f32], part: &mut [f32]) {
        sum.fill(0.0);
        for (response, share) in self.responses() {
            response.compliance.apply_single(load, part);
            for (s, w) in sum.iter_mut().zip(&*part) {
                *s += share as f32 * w;
            }
        }
    }

    /// Stiffness of the bodies in series between near surface nodes, approximately: the first
    /// body's, scaled by its share of the half-space compliance (1 − ν²)/E.
    pub fn near_stiffness(&self) -> impl Iterator<Item = f64> {
        let compliance = |b: &ElasticBody| (1.0 - b.poissons_ratio.powi(2)) / b.modulus;
        let first = &self.bodies[0];
        let total: f64 = self.bodies.iter().map(compliance).sum();
        let scale = first.modulus * compliance(first) / total;
        first.response.near.iter().map(move |s| s * scale)
    }
}
