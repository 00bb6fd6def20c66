//! One mesh level: meshes, spaces, elastic operator and everything that Newton's method reuses.

use std::sync::{Arc, OnceLock};
use std::time::Instant;

use ertel_fem::assembly::CONSTRAINED;
use ertel_fem::element::Tabulation;
use ertel_fem::linear::condensed::CholeskyError;
use ertel_fem::linear::{NEVER, Stop};
use ertel_fem::locate::Locator;
use ertel_fem::mesh::{
    BodyMesh, BodyParams, MeshError, SimplexMesh, SizeField, SizeZone, Zone, body_mesh,
};
use ertel_fem::quadrature::Quadrature;
use ertel_fem::space::{Affine, Space};

use super::cache::{OperatorCache, OperatorKey, SMALLEST};
use super::elastic::{BodySpace, ElasticBody, ElasticOperator, SurfaceResponse, near_pairs};
use super::heat::column::Column;
use super::heat::space::HeatSpace;
use crate::contact::ContactKind;

/// Cell sizes of one level and the region they cover, in Hertz half-widths.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LevelSizes {
    /// Cell size in the Hertz zone.
    pub hertz: f64,
    /// Cell size at the outlet constriction and the side lobes.
    pub constriction: f64,
    /// Cell size on the rim of the Hertz zone, where a thin film builds up and breaks off.
    pub rim: f64,
    /// Half the width of the strip along the rim.
    pub rim_width: f64,
    /// Largest cell size within three half-widths; beyond, it grows with the distance.
    pub edge: f64,
    /// Growth per distance along the surface.
    pub growth: f64,
    /// Growth per depth.
    pub depth_growth: f64,
}

impl LevelSizes {
    /// The same with the cells all around the rim and at the constriction halved.
    pub fn with_finer_rim(&self) -> LevelSizes {
        LevelSizes {
            constriction: 0.5 * self.constriction,
            rim: 0.5 * self.rim,
            ..*self
        }
    }
}

/// Geometry of the half-space body, in Hertz half-widths.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extents {
    /// Inlet edge X of the contact area.
    pub inlet: f64,
    /// Outlet edge X.
    pub outlet: f64,
    /// Side edge |Y|.
    pub side: f64,
    /// Width of the body.
    pub body_width: f64,
    /// Depth of the body.
    pub body_depth: f64,
}

/// Building a level failed.
#[derive(Debug, thiserror::Error)]
pub enum DiscretisationError {
    /// The mesh could not be built.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The elastic problem could not be factorised.
    #[error(transparent)]
    Elastic(#[from] CholeskyError),
}

/// Mesh of one level with its elastic response; pressure spaces of any order stand on it.
pub struct ContactBody {
    /// Line or circular.
    pub kind: ContactKind,
    /// Contact area and body.
    pub extents: Extents,
    /// Body with its boundary facets.
    pub body: BodyMesh,
    /// Order of the displacement.
    pub elastic_order: usize,
    /// Displacement unknowns of the body.
    pub n_displacement: usize,
    space: OnceLock<BodySpace>,
    body_vertices: Vec<u32>,
    /// Where elastic responses are kept, if anywhere.
    pub cache: Option<OperatorCache>,
    /// Whether all of this one came from there.
    pub from_cache: bool,
    /// Contact area.
    pub surface: SimplexMesh,
    /// Finds the element under a point of it.
    pub locator: Locator,
    /// Deflection nodes of the contact area.
    pub deflection: Space,
    /// Elastic response.
    pub elastic: ElasticOperator,
    /// Pairs of deflection nodes whose stiffness the preconditioner sees.
    pub near_pairs: Vec<(u32, u32)>,
    /// Affine map of each element.
    pub maps: Vec<Affine>,
    /// Size h_e of each element: √(2 area), the leg of a right isosceles triangle, or length.
    pub sizes: Vec<f64>,
    /// Seconds spent on the mesh and on the elastic operator.
    pub seconds: (f64, f64),
}

/// By what means elastic responses are come by.
#[derive(Clone, Copy)]
pub struct Means<'a> {
    /// Where they are kept, if anywhere.
    pub cache: Option<&'a OperatorCache>,
    /// Whether the user wants to stop.
    pub stop: Stop<'a>,
}

impl Default for Means<'_> {
    fn default() -> Self {
        Means {
            cache: None,
            stop: NEVER,
        }
    }
}

/// Dimensionless elastic constants of one body: E/(R p_h/a) and ν.
pub type BodyConstants = (f64, f64);

impl ContactBody {
    /// Meshes the body and factorises its elastic response.
    ///
    /// # Errors
    /// When meshing or factorisation fails.
    pub fn new(
        kind: ContactKind,
        extents: &Extents,
        sizes: &LevelSizes,
        elastic_order: usize,
        bodies: &[BodyConstants],
    ) -> Result<ContactBody, DiscretisationError> {
        ContactBody::with_cache(
            kind,
            extents,
            sizes,
            elastic_order,
            bodies,
            Means::default(),
        )
    }

    /// The same with responses from a cache where it has them.
    ///
    /// # Errors
    /// When meshing or factorisation fails, or the caller wants to stop.
    pub fn with_cache(
        kind: ContactKind,
        extents: &Extents,
        sizes: &LevelSizes,
        elastic_order: usize,
        bodies: &[BodyConstants],
        means: Means,
    ) -> Result<ContactBody, DiscretisationError> {
        let start = Instant::now();
        let body = body_mesh(&body_params(kind, extents), &|x| {
            size_at(kind, extents, sizes, x)
        })?;
        let mesh_seconds = start.elapsed().as_secs_f64();
        ContactBody::on(
            kind,
            extents,
            body,
            mesh_seconds,
            elastic_order,
            bodies,
            means,
        )
    }

    /// The same with elements halved `halvings` times in length, and the cells below as conformity demands.
    ///
    /// # Errors
    /// As [`ContactBody::with_cache`].
    pub fn refined(
        &self,
        halvings: &[u32],
        bodies: &[BodyConstants],
        means: Means,
    ) -> Result<ContactBody, DiscretisationError> {
        let start = Instant::now();
        let sizes: Vec<f64> = halvings
            .iter()
            .enumerate()
            .map(|(c, n)| match n {
                0 => f64::INFINITY,
                // a little more, for rounding
                n => 1.001 * self.surface.longest_edge(c) / f64::from(1u32 << n),
            })
            .collect();
        let mut body = self.body.clone();
        body.refine_contact(&sizes)?;
        let mesh_seconds = start.elapsed().as_secs_f64();
        ContactBody::on(
            self.kind,
            &self.extents,
            body,
            mesh_seconds,
            self.elastic_order,
            bodies,
            means,
        )
    }

    /// Factorises the elastic response of a meshed body.
    fn on(
        kind: ContactKind,
        extents: &Extents,
        body: BodyMesh,
        mesh_seconds: f64,
        elastic_order: usize,
        bodies: &[BodyConstants],
        means: Means,
    ) -> Result<ContactBody, DiscretisationError> {
        let start = Instant::now();
        let contact = body.contact_mesh();
        let surface = contact.mesh;
        let deflection = Space::new(&surface, elastic_order);
        let near_pairs = near_pairs(&deflection);
        let mut builder = ResponseBuilder {
            body: &body,
            near_pairs: &near_pairs,
            n: deflection.n_nodes(),
            new_space: || BodySpace::new(&body, &surface, &contact.body_vertices, &deflection),
            space: OnceLock::new(),
            cache: means.cache.filter(|_| body.mesh.n_cells() > SMALLEST),
            stop: means.stop,
            elastic_order,
            n_displacement: 0,
        };
        let mut elastic = ElasticOperator { bodies: Vec::new() };
        for &(modulus, poissons_ratio) in bodies {
            let known = |b: &&ElasticBody| b.poissons_ratio == poissons_ratio;
            let response = match elastic.bodies.iter().find(known) {
                Some(b) => Arc::clone(&b.response),
                None => Arc::new(builder.response(poissons_ratio)?),
            };
            elastic.bodies.push(ElasticBody {
                response,
                modulus,
                poissons_ratio,
            });
        }
        let (space, n_displacement) = (builder.space, builder.n_displacement);
        let from_cache = !bodies.is_empty() && space.get().is_none();
        let operator_seconds = start.elapsed().as_secs_f64();
        let maps: Vec<Affine> = (0..surface.n_cells())
            .map(|c| Affine::new(&surface, c))
            .collect();
        let element_sizes = maps
            .iter()
            .map(|m| {
                if surface.dim == 1 {
                    m.determinant
                } else {
                    m.determinant.sqrt()
                }
            })
            .collect();
        Ok(ContactBody {
            kind,
            extents: *extents,
            body,
            elastic_order,
            n_displacement,
            space,
            body_vertices: contact.body_vertices,
            cache: means.cache.cloned(),
            from_cache,
            locator: Locator::new(&surface),
            surface,
            deflection,
            elastic,
            near_pairs,
            maps,
            sizes: element_sizes,
            seconds: (mesh_seconds, operator_seconds),
        })
    }

    /// Displacement space of the body, made when first asked for: a solve whose elastic response is
    /// in the cache never does.
    pub fn space(&self) -> &BodySpace {
        self.space.get_or_init(|| {
            let trace = &self.deflection;
            BodySpace::new(&self.body, &self.surface, &self.body_vertices, trace)
        })
    }

    /// Undeformed gap at a surface point: X²/2 (line), (X² + Y²)/2 (circular).
    pub fn undeformed_gap(&self, point: [f64; 3]) -> f64 {
        0.5 * (point[0] * point[0] + point[1] * point[1])
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

/// Finds responses in the cache or builds and keeps them.
struct ResponseBuilder<'a, F> {
    body: &'a BodyMesh,
    near_pairs: &'a [(u32, u32)],
    /// Surface nodes.
    n: usize,
    new_space: F,
    space: OnceLock<BodySpace>,
    cache: Option<&'a OperatorCache>,
    stop: Stop<'a>,
    elastic_order: usize,
    n_displacement: usize,
}

impl<F: Fn() -> BodySpace> ResponseBuilder<'_, F> {
    fn response(&mut self, poissons_ratio: f64) -> Result<SurfaceResponse, CholeskyError> {
        let key = self.cache.map(|c| {
            (
                c,
                OperatorKey::new(self.body, self.elastic_order, poissons_ratio),
            )
        });
        if let Some((cache, key)) = key
            && let Some((response, n)) = cache.get(key, self.n, self.near_pairs.len())
        {
            self.n_displacement = n;
            return Ok(response);
        }
        let space = self.space.get_or_init(&self.new_space);
        self.n_displacement = space.dofs.n_dofs;
        let response =
            SurfaceResponse::new(space, self.body, poissons_ratio, self.near_pairs, self.stop)?;
        if let Some((cache, key)) = key {
            cache.put(key, &response, self.n_displacement);
        }
        Ok(response)
    }
}

/// Pressure space on a contact body, and everything that Newton's method reuses.
#[derive(Clone)]
pub struct Discretisation {
    /// Mesh and elastic response.
    pub contact: Arc<ContactBody>,
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
    /// κN, the share of each pressure shape function that the deflection does not see, there.
    pub pressure_unseen: Vec<f64>,
    /// Deflection shape functions at its points.
    pub deflection_table: Tabulation,
    /// ∫N of each pressure unknown.
    pub load: Vec<f64>,
    /// Element matrices ∫N_δ N_P, row-major, deflection by pressure node.
    pub coupling: Vec<f64>,
    /// Temperatures, where heat counts.
    pub heat: Option<Arc<HeatSpace>>,
}

impl Discretisation {
    /// Pressure space of the given order on the contact area of a body.
    pub fn new(contact: &Arc<ContactBody>, pressure_order: usize) -> Discretisation {
        let surface = &contact.surface;
        let pressure = Space::new(surface, pressure_order);
        let mut n_pressure = 0;
        let pressure_dofs: Vec<u32> = pressure
            .points
            .iter()
            .map(|p| {
                if on_edge(contact.kind, &contact.extents, *p) {
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
        // Of a linear pressure the deflection, linear at least, sees everything.
        let seen = (pressure_order - 1)
            .min(contact.deflection.element.order())
            .max(1);
        let pressure_unseen = pressure.element.fluctuations(seen, &rule);
        let (n, m) = (pressure_table.n_nodes, deflection_table.n_nodes);
        let mut load = vec![0.0; n_pressure];
        let mut coupling = vec![0.0; contact.n_elements() * n * m];
        for (c, map) in contact.maps.iter().enumerate() {
            let block = &mut coupling[c * n * m..(c + 1) * n * m];
            for (q, weight) in rule.weights.iter().enumerate() {
                let w = weight * map.determinant;
                for (j, node) in pressure.nodes_of(c).iter().enumerate() {
                    let v = w * pressure_table.values[q * n + j];
                    let dof = pressure_dofs[*node as usize];
                    if dof != CONSTRAINED {
                        load[dof as usize] += v;
                    }
                    for i in 0..m {
                        block[i * n + j] += v * deflection_table.values[q * m + i];
                    }
                }
            }
        }
        Discretisation {
            contact: Arc::clone(contact),
            pressure,
            pressure_dofs,
            n_pressure,
            rule,
            pressure_table,
            pressure_unseen,
            deflection_table,
            load,
            coupling,
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
        let (n, m) = (self.pressure_table.n_nodes, self.deflection_table.n_nodes);
        for c in 0..self.contact.n_elements() {
            let block = &self.coupling[c * n * m..(c + 1) * n * m];
            for (i, node) in self.contact.deflection.nodes_of(c).iter().enumerate() {
                for (j, other) in self.pressure.nodes_of(c).iter().enumerate() {
                    let dof = self.pressure_dofs[*other as usize];
                    if dof != CONSTRAINED {
                        f(*node, dof, block[i * n + j]);
                    }
                }
            }
        }
    }

    /// Nodal loads ∫P N_δ of nodal pressures (all nodes, edge included).
    pub fn nodal_loads(&self, pressure: &[f64]) -> Vec<f64> {
        let (n, m) = (self.pressure_table.n_nodes, self.deflection_table.n_nodes);
        let mut f = vec![0.0; self.contact.deflection.n_nodes()];
        for c in 0..self.contact.n_elements() {
            let block = &self.coupling[c * n * m..(c + 1) * n * m];
            let nodes = self.pressure.nodes_of(c);
            for (i, target) in self.contact.deflection.nodes_of(c).iter().enumerate() {
                let mut sum = 0.0;
                for (j, node) in nodes.iter().enumerate() {
                    sum += block[i * n + j] * pressure[*node as usize];
                }
                f[*target as usize] += sum;
            }
        }
        f
    }

    /// Deflection of the surface nodes under nodal pressures.
    pub fn deflect(&self, pressure: &[f64]) -> Vec<f64> {
        self.contact.elastic.deflect(&self.nodal_loads(pressure))
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

fn body_params(kind: ContactKind, e: &Extents) -> BodyParams {
    BodyParams {
        dim: kind.body_dimension(),
        x_inlet: e.inlet,
        x_outlet: e.outlet,
        y_side: e.side,
        width: e.body_width,
        depth: e.body_depth,
    }
}

/// Whether a surface point lies where P = 0 is prescribed (not on the symmetry line).
pub(super) fn on_edge(kind: ContactKind, e: &Extents, p: [f64; 3]) -> bool {
    let tiny = 1e-9 * (e.outlet - e.inlet);
    p[0] < e.inlet + tiny
        || p[0] > e.outlet - tiny
        || (kind == ContactKind::Circular && p[1] < -e.side + tiny)
}

/// Size field: fine under the Hertz zone, finer in a crescent at its outlet side, `edge` on the
/// rest of the contact area, growing into the body.
fn size_at(kind: ContactKind, e: &Extents, s: &LevelSizes, x: [f64; 3]) -> f64 {
    let origin = [0.0; 3];
    let zones = [
        SizeZone {
            zone: Zone::Disc {
                center: origin,
                radius: 1.0,
            },
            size: s.hertz,
        },
        SizeZone {
            zone: Zone::Arc {
                center: origin,
                radius: 0.95,
                half_width: 0.1,
                x_min: if kind == ContactKind::Circular {
                    -0.3
                } else {
                    0.5
                },
            },
            size: s.constriction,
        },
        SizeZone {
            zone: Zone::Arc {
                center: origin,
                radius: 1.0,
                half_width: s.rim_width,
                x_min: f64::NEG_INFINITY,
            },
            size: s.rim,
        },
    ];
    // Far from the contact the film varies on the scale of the distance; beyond the contact area
    // there is no film.
    let r = x[0].hypot(x[1]);
    let side = if kind == ContactKind::Circular {
        e.side
    } else {
        0.0
    };
    let area = Zone::Box {
        min: [e.inlet, -side, 0.0],
        max: [e.outlet, 0.0, 0.0],
    };
    let outside = area.distance([x[0], x[1], 0.0]);
    let largest = s.edge * (r / 3.0).max(1.0) + s.growth * outside;
    let surface = SizeField {
        zones: zones.to_vec(),
        growth: s.growth,
    }
    .size([x[0], x[1], 0.0]);
    surface.min(largest) + s.depth_growth * -x[2]
}
