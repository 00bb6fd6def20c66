//! Finite-element bodies, condensed to their loaded surface (Habchi 2008, section 3.3 and appendix A).

use std::sync::{Arc, OnceLock};

use ertel_fem::assembly::{CONSTRAINED, DofMap, NodeGraph, assemble_symmetric};
use ertel_fem::linear::Stop;
use ertel_fem::linear::compliance::Compliance;
use ertel_fem::linear::condensed::{CholeskyError, CondensedStiffness, Keep};
use ertel_fem::mesh::{BodyMesh, BodyParams, MeshError, SimplexMesh, body_mesh};
use ertel_fem::quadrature::Quadrature;
use ertel_fem::space::{Affine, Space};

use super::{Accuracy, SurfaceResponse, Trace, compliance};
use crate::contact::Material;
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
pub struct CondensedResponse {
    /// Deflection of each surface node under unit loads on the others.
    pub compliance: Compliance,
    /// Condensed stiffness between near nodes, in the order of their list of pairs.
    pub near: Vec<f64>,
}

impl CondensedResponse {
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
    ) -> Result<CondensedResponse, CholeskyError> {
        let stiffness = space.factorise(body, poissons_ratio, Keep::Condensed, stop)?;
        if stop() {
            return Err(CholeskyError::Interrupted);
        }
        let near = near_pairs.iter();
        Ok(CondensedResponse {
            near: near
                .map(|(i, j)| stiffness.condensed_entry(*i as usize, *j as usize))
                .collect(),
            compliance: stiffness.into_compliance()?,
        })
    }
}

/// One elastic body: response for unit modulus, and its constants.
#[derive(Clone)]
pub struct ElasticBody {
    /// Response for E = 1; bodies of one Poisson's ratio share it.
    pub response: Arc<CondensedResponse>,
    /// Constants, the modulus over R p_h/a.
    pub material: Material,
}

/// Bodies in series: the deflections under one load add up.
#[derive(Clone)]
pub struct FiniteBodies {
    /// The equivalent body, or plane and ball.
    pub bodies: Vec<ElasticBody>,
}

impl FiniteBodies {
    /// Distinct responses with Σ1/E of the bodies that have them.
    fn responses(&self) -> impl Iterator<Item = (&CondensedResponse, f64)> {
        let shares = |b: &ElasticBody| {
            let same = |o: &&ElasticBody| Arc::ptr_eq(&o.response, &b.response);
            self.bodies
                .iter()
                .filter(same)
                .map(|o| 1.0 / o.material.youngs_modulus)
                .sum()
        };
        self.bodies.iter().enumerate().filter_map(move |(k, b)| {
            let seen = |o: &ElasticBody| Arc::ptr_eq(&o.response, &b.response);
            let first = !self.bodies[..k].iter().any(seen);
            first.then(|| (&*b.response, shares(b)))
        })
    }

    /// Total deflection of the surface nodes under nodal loads ∫P N: δ = Σ_b C_b f/E_b.
    pub fn deflect_loads(&self, load: &[f64]) -> Vec<f64> {
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

    /// The same in single precision, for products with the Jacobian.
    fn deflect_single(&self, load: &[f64]) -> Vec<f64> {
        let load: Vec<f32> = load.iter().map(|v| *v as f32).collect();
        let mut sum = vec![0.0f32; load.len()];
        let mut part = vec![0.0f32; load.len()];
        for (response, share) in self.responses() {
            response.compliance.apply_single(&load, &mut part);
            for (s, w) in sum.iter_mut().zip(&part) {
                *s += share as f32 * w;
            }
        }
        sum.into_iter().map(f64::from).collect()
    }

    fn deflection_of(&self, load: &[f64], accuracy: Accuracy) -> Vec<f64> {
        match accuracy {
            Accuracy::Full => self.deflect_loads(load),
            Accuracy::Krylov => self.deflect_single(load),
        }
    }
}

/// Loads and deflections belong together as ∫p N and its energy: the condensed compliance is symmetric.
impl SurfaceResponse for FiniteBodies {
    fn deflect(&self, trace: &Trace, pressure: &[f64], accuracy: Accuracy) -> Vec<f64> {
        self.deflection_of(&trace.loads(pressure), accuracy)
    }

    /// Of bodies in series approximately: the first body's, scaled by its share of the half-space compliance.
    fn near_stiffness(&self) -> Vec<f64> {
        let Some(first) = self.bodies.first() else {
            return Vec::new();
        };
        let own = compliance(&[first.material]);
        let scale = first.material.youngs_modulus * own / self.compliance();
        first.response.near.iter().map(move |s| s * scale).collect()
    }

    fn compliance(&self) -> f64 {
        let materials: Vec<Material> = self.bodies.iter().map(|b| b.material).collect();
        compliance(&materials)
    }
}

/// Building a finite-element body failed.
#[derive(Debug, thiserror::Error)]
pub enum FiniteBodyError {
    /// The mesh could not be built.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The elastic problem could not be factorised.
    #[error(transparent)]
    Elastic(#[from] CholeskyError),
}

/// A meshed body below the contact area, with its condensed responses.
pub struct FiniteBody {
    /// The body with its boundary facets.
    pub mesh: BodyMesh,
    /// Contact area.
    pub surface: SimplexMesh,
    body_vertices: Vec<u32>,
    space: OnceLock<BodySpace>,
}

impl FiniteBody {
    /// Meshes a body; `size` is the longest edge allowed at a point.
    ///
    /// # Errors
    /// Those of the mesh.
    pub fn new(
        params: &BodyParams,
        size: &dyn Fn([f64; 3]) -> f64,
    ) -> Result<FiniteBody, MeshError> {
        Ok(FiniteBody::on(body_mesh(params, size)?))
    }

    /// The same with elements of the contact area no longer than `sizes`.
    ///
    /// # Errors
    /// Those of the mesh.
    pub fn refined(&self, sizes: &[f64]) -> Result<FiniteBody, MeshError> {
        let mut mesh = self.mesh.clone();
        mesh.refine_contact(sizes)?;
        Ok(FiniteBody::on(mesh))
    }

    fn on(mesh: BodyMesh) -> FiniteBody {
        let contact = mesh.contact_mesh();
        FiniteBody {
            mesh,
            surface: contact.mesh,
            body_vertices: contact.body_vertices,
            space: OnceLock::new(),
        }
    }

    /// Displacement space, made when first asked for; `deflection` is its trace.
    pub fn space(&self, deflection: &Space) -> &BodySpace {
        (self.space).get_or_init(|| {
            BodySpace::new(&self.mesh, &self.surface, &self.body_vertices, deflection)
        })
    }

    /// Condensed responses of bodies of the given constants, with the number of displacement unknowns.
    ///
    /// # Errors
    /// When a factorisation fails, or `stop` says so.
    pub fn condensed(
        &self,
        bodies: &[Material],
        deflection: &Space,
        near_pairs: &[(u32, u32)],
        stop: Stop,
    ) -> Result<(FiniteBodies, usize), CholeskyError> {
        let space = self.space(deflection);
        let mut condensed = FiniteBodies { bodies: Vec::new() };
        for &material in bodies {
            let ratio = material.poissons_ratio;
            let known = |b: &&ElasticBody| b.material.poissons_ratio == ratio;
            let response = match condensed.bodies.iter().find(known) {
                Some(b) => Arc::clone(&b.response),
                None => Arc::new(CondensedResponse::new(
                    space, &self.mesh, ratio, near_pairs, stop,
                )?),
            };
            condensed.bodies.push(ElasticBody { response, material });
        }
        Ok((condensed, space.dofs.n_dofs))
    }
}
