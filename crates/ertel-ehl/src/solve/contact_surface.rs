//! Mesh of the contact area with the response of the bodies below it.

use ertel_fem::platform::Instant;
use std::sync::Arc;

use ertel_fem::linear::Stop;
use ertel_fem::locate::Locator;
use ertel_fem::mesh::{BodyParams, SimplexMesh, SurfaceMesh, SurfaceParams, surface_mesh};
use ertel_fem::space::{Affine, Space};

use super::sizes::{LevelSizes, size_at};
use crate::contact::{HertzZone, Inlet, Shape, Symmetry};
use crate::elastic::{
    BodyModel, Elasticity, FiniteBodies, FiniteBody, FiniteBodyError, HalfSpace, SurfaceResponse,
    near_pairs,
};
use crate::engine::Extents;

/// Mesh of the contact area with the response of the bodies; pressure spaces of any order are built on it.
#[derive(Clone)]
pub struct ContactSurface {
    /// Geometry of the contact.
    pub shape: Shape,
    /// Contact area and body.
    pub extents: Extents,
    /// The bodies.
    pub elasticity: Elasticity,
    support: Support,
    /// Displacement unknowns of a finite-element body; 0 for a half-space.
    pub n_displacement: usize,
    /// Contact area.
    pub surface: SimplexMesh,
    /// Finds the element under a point of it.
    pub locator: Locator,
    /// Deflection nodes of the contact area.
    pub deflection: Space,
    /// Elastic response of the bodies.
    pub response: Arc<dyn SurfaceResponse>,
    /// Pairs of deflection nodes whose stiffness the preconditioner includes.
    pub near_pairs: Vec<(u32, u32)>,
    /// Affine map of each element.
    pub maps: Vec<Affine>,
    /// Size h_e of each element along the motion: √(2 area) around a circle, the leg of a right isosceles triangle, or length.
    pub sizes: Vec<f64>,
    /// T of each element, see [`Cell`]; empty where it is the unit tensor everywhere.
    diffusion_tensors: Vec<[f64; 3]>,
    /// Seconds spent on the mesh and on the elastic operator.
    pub seconds: (f64, f64),
}

/// How long an element is, and how slender.
#[derive(Clone, Copy, Debug)]
pub struct Cell {
    /// h_e.
    pub size: f64,
    /// T by which diffusions are multiplied where it is shorter across the motion than along it, xx, xy, yy.
    pub diffusion_tensor: Option<[f64; 3]>,
    /// The undeformed gap at its centre.
    pub gap: f64,
    /// The larger curvature of the gap, over that along the first principal direction: across slender films the rupture is as much steeper.
    pub curvature: f64,
}

impl ContactSurface {
    /// Meshes the contact area, and a body below it where one is asked for, and makes its elastic response.
    ///
    /// # Errors
    /// When meshing or factorisation fails, or the caller wants to stop.
    pub fn new(
        shape: &Shape,
        extents: &Extents,
        sizes: &LevelSizes,
        elasticity: &Elasticity,
        stop: Stop,
    ) -> Result<ContactSurface, FiniteBodyError> {
        let start = Instant::now();
        let mesh = match elasticity.model {
            BodyModel::HalfSpace => {
                let params = SurfaceParams {
                    dim: shape.dim,
                    x: [extents.inlet, extents.outlet],
                    y: match shape.symmetry {
                        Symmetry::Half => [-extents.side, 0.0],
                        Symmetry::Full => [-extents.side, extents.side],
                    },
                };
                let size = |x: [f64; 2]| size_at(shape, extents, sizes, [x[0], x[1], 0.0]);
                Mesh::Surface(Arc::new(surface_mesh(&params, &size)?))
            }
            BodyModel::FiniteElements => {
                let params = body_params(shape.dim, extents);
                let size = |x: [f64; 3]| size_at(shape, extents, sizes, x);
                Mesh::Body(Arc::new(FiniteBody::new(&params, &size)?))
            }
        };
        let seconds = start.elapsed().as_secs_f64();
        ContactSurface::on(shape, extents, mesh, seconds, elasticity, stop)
    }

    /// The same with elements halved `halvings` times in length, and others as conformity demands.
    ///
    /// # Errors
    /// As [`ContactSurface::new`].
    pub fn refined(&self, halvings: &[u32], stop: Stop) -> Result<ContactSurface, FiniteBodyError> {
        let start = Instant::now();
        let sizes: Vec<f64> = halvings
            .iter()
            .enumerate()
            .map(|(c, n)| match n {
                0 => f64::INFINITY,
                // a little more, for rounding
                n => 1.001 * self.longest_unit_edge(c) / f64::from(1u32 << n),
            })
            .collect();
        let mesh = match &self.support {
            Support::Surface(surface) => Mesh::Surface(Arc::new(surface.refined(&sizes)?)),
            Support::Body(body, _) => Mesh::Body(Arc::new(body.refined(&sizes)?)),
        };
        let seconds = start.elapsed().as_secs_f64();
        ContactSurface::on(
            &self.shape,
            &self.extents,
            mesh,
            seconds,
            &self.elasticity,
            stop,
        )
    }

    /// The same where another amount of oil reaches the contact.
    pub fn with_inlet(&self, inlet: Inlet) -> ContactSurface {
        ContactSurface {
            shape: self.shape.clone().with_inlet(inlet),
            ..self.clone()
        }
    }

    /// The same mesh, moved along, around a contact of another shape; `None` above finite-element bodies, whose meshes do not move.
    pub fn reshaped(&self, shape: &Shape, stop: Stop) -> Option<ContactSurface> {
        let Support::Surface(mesh) = &self.support else {
            return None;
        };
        let mesh = Mesh::Surface(mesh.clone());
        let mut shape = shape.clone();
        if let (Some(own), Some(other)) = (&self.shape.zone.roller, &shape.zone.roller) {
            shape.zone.roller = Some(Arc::new(own.drawn_to(other.half_length())));
        }
        ContactSurface::on(&shape, &self.extents, mesh, 0.0, &self.elasticity, stop).ok()
    }

    /// Makes the elastic response of a mesh.
    fn on(
        shape: &Shape,
        extents: &Extents,
        mesh: Mesh,
        mesh_seconds: f64,
        elasticity: &Elasticity,
        stop: Stop,
    ) -> Result<ContactSurface, FiniteBodyError> {
        let start = Instant::now();
        let surface = match &mesh {
            Mesh::Surface(surface) => stretched(surface.mesh(), &shape.zone),
            Mesh::Body(body) => body.surface.clone(),
        };
        let deflection = Space::new(&surface, elasticity.order);
        let near_pairs = near_pairs(&deflection, shape.is_line());
        let mut n_displacement = 0;
        let bodies = &elasticity.bodies;
        let (support, response): (Support, Arc<dyn SurfaceResponse>) = match mesh {
            Mesh::Surface(mesh) => {
                let response = HalfSpace::new(&surface, &deflection, bodies, &near_pairs, shape);
                (Support::Surface(mesh), Arc::new(response))
            }
            Mesh::Body(body) => {
                let condensed;
                (condensed, n_displacement) =
                    body.condensed(bodies, &deflection, &near_pairs, stop)?;
                (Support::Body(body, condensed.clone()), Arc::new(condensed))
            }
        };
        let operator_seconds = start.elapsed().as_secs_f64();
        let maps: Vec<Affine> = (0..surface.n_cells())
            .map(|c| Affine::new(&surface, c))
            .collect();
        let along = shape.zone.stretch_along_motion();
        let element_sizes = maps
            .iter()
            .enumerate()
            .map(|(c, m)| {
                if surface.dim == 1 {
                    m.determinant
                } else {
                    // Cells are as stretched as the zone.
                    along * (m.determinant / shape.zone.stretch(surface.centre(c))).sqrt()
                }
            })
            .collect();
        let tensors = (0..maps.len()).map(|c| shape.zone.diffusion_tensor(surface.centre(c)));
        let diffusion_tensors = match tensors.clone().any(|t| t.is_some()) {
            true => tensors.map(|t| t.unwrap_or([1.0, 0.0, 1.0])).collect(),
            false => Vec::new(),
        };
        Ok(ContactSurface {
            shape: shape.clone(),
            extents: *extents,
            elasticity: elasticity.clone(),
            support,
            n_displacement,
            locator: Locator::new(&surface),
            surface,
            deflection,
            response,
            near_pairs,
            maps,
            sizes: element_sizes,
            diffusion_tensors,
            seconds: (mesh_seconds, operator_seconds),
        })
    }

    /// Size and slenderness of an element.
    pub fn cell(&self, element: usize) -> Cell {
        Cell {
            size: self.sizes[element],
            diffusion_tensor: self.diffusion_tensors.get(element).copied(),
            gap: self.shape.gap.value(self.surface.centre(element)),
            curvature: self.shape.gap.curvature_ratio.max(1.0),
        }
    }

    /// Longest edge of an element where the Hertz zone is the unit circle, as it was meshed.
    fn longest_unit_edge(&self, element: usize) -> f64 {
        match &self.support {
            Support::Surface(mesh) => mesh.mesh().longest_edge(element),
            Support::Body(..) => self.surface.longest_edge(element),
        }
    }

    /// The finite-element body below the contact area with its condensed answers; `None` above a half-space.
    pub fn body(&self) -> Option<(&FiniteBody, &FiniteBodies)> {
        match &self.support {
            Support::Surface(_) => None,
            Support::Body(body, condensed) => Some((body, condensed)),
        }
    }

    /// (X, Y) of reference coordinates in an element.
    pub fn point(&self, element: usize, xi: [f64; 3]) -> [f64; 2] {
        let v = |k: usize| self.surface.vertices[self.surface.cell(element)[k] as usize];
        let origin = v(0);
        [0, 1].map(|a| {
            origin[a]
                + (1..=self.surface.dim)
                    .map(|k| xi[k - 1] * (v(k)[a] - origin[a]))
                    .sum::<f64>()
        })
    }

    /// Number of elements on the contact area.
    pub fn n_elements(&self) -> usize {
        self.maps.len()
    }
}

/// Mesh of the contact area.
#[derive(Clone)]
enum Support {
    /// Nothing below it.
    Surface(Arc<SurfaceMesh>),
    /// A body below it, with its condensed answers.
    Body(Arc<FiniteBody>, FiniteBodies),
}

/// A mesh before its bodies answer.
enum Mesh {
    Surface(Arc<SurfaceMesh>),
    Body(Arc<FiniteBody>),
}

fn body_params(dim: usize, e: &Extents) -> BodyParams {
    BodyParams {
        dim: dim + 1,
        x_inlet: e.inlet,
        x_outlet: e.outlet,
        y_side: e.side,
        width: e.body_width,
        depth: e.body_depth,
    }
}

/// A mesh around the unit circle, stretched to the Hertz zone.
fn stretched(mesh: &SimplexMesh, zone: &HertzZone) -> SimplexMesh {
    let mut mesh = mesh.clone();
    for v in &mut mesh.vertices {
        let [x, y] = zone.place([v[0], v[1]]);
        (v[0], v[1]) = (x, y);
    }
    mesh
}
