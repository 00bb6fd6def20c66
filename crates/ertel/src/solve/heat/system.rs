//! Residual and Jacobian of the energy equation, in film and bodies at once.
//!
//! ```text
//!   film:    ∫∫ Ŵ(C v·∇T + cωT_s − hQ) − (Ŵ − W) κ T_ss + κ T_s W_s ds dA,   C = ρc h u_m/a, κ = k/h
//!   bodies:  ∫∫ Ŵ c T_X − (Ŵ − W) κ ΔT + κ ∇T·∇W dZ dA,              c = ρc u, κ = k/a
//!   Ŵ = W + τ_S v·∇W     streamline upwinding (Habchi 2008, eq. 5.26 and following)
//! ```
//! Film and bodies share the nodes at the walls: that heat fluxes meet there is the natural condition. The
//! heat of shearing is differentiated by the temperature, at its height and, through the stress, at all
//! others; velocities, densities and thermal properties are not. ω comes from the assembly before.

use ertel_fem::kernel;
use ertel_fem::linear::block_ilu::BlockMatrix;
use ertel_fem::linear::dense::vectorised;
use rayon::prelude::*;

use super::space::HeatSpace;
use crate::film::cross_film::CrossFilm;
use crate::film::{FilmFluid, MOST_NODES, Nodal};
use crate::forms::energy::{FilmColumn, FilmPlace, Heat, Layer, Source, film_column};
use crate::solve::discretisation::{Discretisation, on_edge};
use crate::solve::system::State;

/// Most surface nodes of an element.
const MOST_SURFACE: usize = 6;

/// Energy equation at a state.
pub struct HeatSystem {
    /// Residual, W/m² times half-widths squared, column by column.
    pub residual: Vec<f64>,
    /// Whether a temperature is prescribed.
    pub fixed: Vec<bool>,
    /// What heats the film, and where the heat goes.
    pub account: Account,
    /// ω at each height over each vertex of the contact area, over ρ_R u_m a/R.
    pub cross_flow: Vec<f64>,
}

/// Heat made and carried off over the whole (half) contact area, W/m² times half-widths squared.
#[derive(Clone, Copy, Debug, Default)]
pub struct Account {
    /// By shear.
    pub shear: f64,
    /// By compression, less by expansion.
    pub compression: f64,
    /// The same without regard to sign.
    pub compression_size: f64,
    /// Carried along by plane and ball.
    pub bodies: [f64; 2],
    /// Conducted out of plane and ball where their temperature is prescribed.
    pub conducted: [f64; 2],
}

/// Contributions of one element.
struct Element {
    /// Film block of each pair of surface nodes: `[(i·n + j)·f² + row + f·column]`.
    film: Vec<f64>,
    /// Blocks of the bodies, layer by layer, likewise.
    bodies: [Vec<f64>; 2],
    /// `[i·n_column + row]`.
    residual: Vec<f64>,
    account: Account,
    /// ∫ mass_below·∇λ at each height, for each vertex.
    rise: Vec<f64>,
}

/// Residual, and the Jacobian into `matrix` if there is one.
pub fn assemble(
    d: &Discretisation,
    fluid: &FilmFluid,
    heat: &Heat,
    state: &State,
    source: Source,
    cross_flow: &[f64],
    mut matrix: Option<&mut BlockMatrix>,
) -> HeatSystem {
    let space = d.heat.as_ref().expect("a discretisation with heat");
    let n = space.column.n();
    let mut system = HeatSystem {
        residual: vec![0.0; space.n()],
        fixed: prescribed(d, space, fluid, heat, state),
        account: Account::default(),
        cross_flow: vec![0.0; d.contact.surface.n_vertices() * space.column.heights.n()],
    };
    if let Some(matrix) = &mut matrix {
        matrix.clear();
    }
    let batches: Vec<usize> = (0..d.contact.n_elements()).step_by(BATCH).collect();
    let with_jacobian = matrix.is_some();
    for group in batches.chunks(GROUP) {
        let elements: Vec<Vec<Element>> = group
            .par_iter()
            .map(|first| {
                let mut rule = CrossFilm::default();
                let last = (first + BATCH).min(d.contact.n_elements());
                (*first..last)
                    .map(|c| {
                        element(
                            d,
                            space,
                            fluid,
                            heat,
                            state,
                            source,
                            cross_flow,
                            c,
                            with_jacobian,
                            &mut rule,
                        )
                    })
                    .collect()
            })
            .collect();
        for (first, elements) in group.iter().zip(&elements) {
            for (k, e) in elements.iter().enumerate() {
                let nodes = space.surface.nodes_of(first + k);
                for (i, node) in nodes.iter().enumerate() {
                    let rows = &mut system.residual[*node as usize * n..][..n];
                    for (sum, v) in rows.iter_mut().zip(&e.residual[i * n..]) {
                        *sum += v;
                    }
                }
                system.account.add(&e.account);
                let n_heights = space.column.heights.n();
                let vertices = d.contact.surface.cell(first + k);
                for (vertex, rise) in vertices.iter().zip(e.rise.chunks_exact(n_heights)) {
                    let sums = &mut system.cross_flow[*vertex as usize * n_heights..][..n_heights];
                    for (sum, v) in sums.iter_mut().zip(rise) {
                        *sum += v;
                    }
                }
                if let Some(matrix) = &mut matrix {
                    scatter(space, nodes, e, matrix);
                }
            }
        }
    }
    divide_by_area(d, &mut system.cross_flow);
    for (k, fixed) in system.fixed.iter().enumerate() {
        if *fixed {
            // What the prescribed temperature takes up, is conducted out of the body.
            let unknown = k % n;
            let body = usize::from(unknown > space.column.first);
            if !space.column.film_range().contains(&unknown) {
                system.account.conducted[body] -= system.residual[k];
            }
            system.residual[k] = 0.0;
            if let Some(matrix) = &mut matrix {
                matrix.fix((k / n) as u32, unknown);
            }
        }
    }
    system
}

/// Elements that a thread takes at a time, and such batches whose contributions are kept at once.
const BATCH: usize = 8;
const GROUP: usize = 32;

impl Account {
    fn add(&mut self, other: &Account) {
        self.shear += other.shear;
        self.compression += other.compression;
        self.compression_size += other.compression_size;
        for b in 0..2 {
            self.bodies[b] += other.bodies[b];
            self.conducted[b] += other.conducted[b];
        }
    }
}

fn scatter(space: &HeatSpace, nodes: &[u32], e: &Element, matrix: &mut BlockMatrix) {
    let (n, f) = (space.column.n(), space.column.film.n());
    let first = space.column.first;
    for (i, row) in nodes.iter().enumerate() {
        for (j, column) in nodes.iter().enumerate() {
            let pair = i * nodes.len() + j;
            let block = matrix.block_mut(*row, *column);
            for b in 0..f {
                let from = &e.film[(pair * f + b) * f..][..f];
                let to = &mut block[(first + b) * n + first..][..f];
                for (to, v) in to.iter_mut().zip(from) {
                    *to += v;
                }
            }
            for (layers, values) in space.column.bodies.iter().zip(&e.bodies) {
                let mut values = &values[pair * size_of_layers(layers)..];
                for layer in layers {
                    let m = layer.nodes.len();
                    for (b, column) in layer.nodes.iter().enumerate() {
                        for (a, row) in layer.nodes.iter().enumerate() {
                            block[column * n + row] += values[b * m + a];
                        }
                    }
                    values = &values[m * m..];
                }
            }
        }
    }
}

fn size_of_layers(layers: &[super::column::Layer]) -> usize {
    layers.iter().map(|l| l.nodes.len() * l.nodes.len()).sum()
}

/// Shape functions of the surface at a quadrature point: values, slopes and Laplacians.
struct SurfaceBasis {
    n: usize,
    values: [f64; MOST_SURFACE],
    slopes: [[f64; 2]; MOST_SURFACE],
    laplacians: [f64; MOST_SURFACE],
}

#[allow(clippy::too_many_arguments)]
fn element(
    d: &Discretisation,
    space: &HeatSpace,
    fluid: &FilmFluid,
    heat: &Heat,
    state: &State,
    source: Source,
    cross_flow: &[f64],
    c: usize,
    with_jacobian: bool,
    rule: &mut CrossFilm,
) -> Element {
    let (column, map) = (&space.column, &d.contact.maps[c]);
    let nodes = space.surface.nodes_of(c);
    let (n, n_surface, f) = (column.n(), nodes.len(), column.film.n());
    let pairs = if with_jacobian {
        n_surface * n_surface
    } else {
        0
    };
    let mut e = Element {
        film: vec![0.0; pairs * f * f],
        bodies: [0, 1].map(|b: usize| vec![0.0; pairs * size_of_layers(&column.bodies[b])]),
        residual: vec![0.0; n_surface * n],
        account: Account::default(),
        rise: vec![0.0; d.contact.surface.cell(c).len() * column.heights.n()],
    };
    let size = d.contact.sizes[c] / space.surface.element.order() as f64;
    for (q, weight) in space.rule.weights.iter().enumerate() {
        let area = weight * map.determinant;
        let mut basis = SurfaceBasis {
            n: n_surface,
            values: [0.0; MOST_SURFACE],
            slopes: [[0.0; 2]; MOST_SURFACE],
            laplacians: [0.0; MOST_SURFACE],
        };
        for j in 0..n_surface {
            let k = q * n_surface + j;
            basis.values[j] = space.table.values[k];
            let [x, y, _] = map.gradient(space.table.gradients[k]);
            basis.slopes[j] = [x, y];
            basis.laplacians[j] = map.laplacian(&space.table.hessians[k]);
        }
        let [x, y] = d.contact.point(c, space.rule.points[q]);
        let further = |layer: Layer| source.map_or(0.0, |f| f([x, y], layer));
        let place = space.film_at(d, state, c, q);
        let film = film_column(fluid, heat, &column.heights, &place, rule);
        let xi = space.rule.points[q];
        let lift = vertices_part(d, space, cross_flow, c, xi, &film, area, &mut e);
        vectorised(FilmPart {
            space,
            nodes,
            state,
            basis: &basis,
            film: &film,
            lift: &lift,
            further: &further,
            area,
            size,
            e: &mut e,
        });
        for body in 0..2 {
            vectorised(BodyPart {
                space,
                nodes,
                heat,
                state,
                basis: &basis,
                body,
                further: &further,
                area,
                size,
                e: &mut e,
            });
        }
    }
    e
}

/// ω at a point from the values at the vertices; adds what the point has to say of them.
#[allow(clippy::too_many_arguments)]
fn vertices_part(
    d: &Discretisation,
    space: &HeatSpace,
    cross_flow: &[f64],
    c: usize,
    xi: [f64; 3],
    film: &FilmColumn,
    area: f64,
    e: &mut Element,
) -> Nodal {
    let n = space.column.heights.n();
    let mut lift = [0.0; MOST_NODES];
    let surface = &d.contact.surface;
    for (v, vertex) in surface.cell(c).iter().enumerate() {
        // Barycentric coordinate of the vertex and its slopes.
        let mut reference = [0.0; 3];
        let value = if v == 0 {
            reference[..surface.dim].fill(-1.0);
            1.0 - xi[..surface.dim].iter().sum::<f64>()
        } else {
            reference[v - 1] = 1.0;
            xi[v - 1]
        };
        let [x, y, _] = d.contact.maps[c].gradient(reference);
        for k in 0..n {
            let [below_x, below_y] = film.heights[k].mass_below;
            e.rise[v * n + k] += area * (below_x * x + below_y * y);
            if let Some(known) = cross_flow.get(*vertex as usize * n + k) {
                lift[k] += value * known;
            }
        }
    }
    lift
}

/// ω from its integrals: over the area of each vertex; none at the edge of the contact area, where the integrals lack
/// what passes through it.
fn divide_by_area(d: &Discretisation, cross_flow: &mut [f64]) {
    let surface = &d.contact.surface;
    let n = cross_flow.len() / surface.n_vertices();
    let mut areas = vec![0.0; surface.n_vertices()];
    for c in 0..surface.n_cells() {
        for vertex in surface.cell(c) {
            areas[*vertex as usize] += surface.measure(c) / surface.cell(c).len() as f64;
        }
    }
    let values = cross_flow.chunks_exact_mut(n);
    for ((values, area), point) in values.zip(areas).zip(&surface.vertices) {
        let inside = !on_edge(d.contact.kind, &d.contact.extents, *point);
        let factor = if inside { 1.0 / area } else { 0.0 };
        values.iter_mut().for_each(|v| *v *= factor);
    }
}

kernel! {
    FilmPart ['a] ['a] (
        space: &'a HeatSpace,
        nodes: &'a [u32],
        state: &'a State,
        basis: &'a SurfaceBasis,
        film: &'a FilmColumn,
        lift: &'a Nodal,
        further: &'a dyn Fn(Layer) -> f64,
        area: f64,
        size: f64,
        e: &'a mut Element,
    ) -> () {
        film_part(space, nodes, state, basis, film, lift, further, area, size, e)
    }
}

kernel! {
    BodyPart ['a] ['a] (
        space: &'a HeatSpace,
        nodes: &'a [u32],
        heat: &'a Heat,
        state: &'a State,
        basis: &'a SurfaceBasis,
        body: usize,
        further: &'a dyn Fn(Layer) -> f64,
        area: f64,
        size: f64,
        e: &'a mut Element,
    ) -> () {
        body_part(space, nodes, heat, state, basis, body, further, area, size, e)
    }
}

/// Adds the film at a point of the surface.
#[allow(clippy::too_many_arguments)]
#[inline(always)]
fn film_part(
    space: &HeatSpace,
    nodes: &[u32],
    state: &State,
    basis: &SurfaceBasis,
    film: &FilmColumn,
    lift: &Nodal,
    further: &dyn Fn(Layer) -> f64,
    area: f64,
    size: f64,
    e: &mut Element,
) {
    let column = &space.column;
    let (n, f, first) = (column.n(), column.film.n(), column.first);
    let with_jacobian = !e.film.is_empty();
    let at = |j: usize, m: usize| state.temperature[nodes[j] as usize * n + first + m];
    let heights = &column.heights;
    // ∫ Ŵ ℓ ∂(hQ)/∂τ ds for each surface node and film node
    let mut by_stress = [[[0.0; 2]; MOST_NODES]; MOST_SURFACE];
    for k in 0..heights.n() {
        let point = &film.heights[k];
        let (shapes, [first_slopes, second_slopes]) = (&heights.shapes[k], &heights.slopes[k]);
        let weight = area * heights.weights()[k];
        let [u, v] = point.velocity.map(|v| v * point.capacity);
        let along: [f64; MOST_SURFACE] =
            std::array::from_fn(|j| u * basis.slopes[j][0] + v * basis.slopes[j][1]);
        // Convection over a cell, and conduction to walls of fixed temperature.
        let passage = 2.0 * u.hypot(v) / size;
        let tau = 1.0 / passage.hypot(std::f64::consts::PI.powi(2) * point.conduction);
        let (mut carried, mut slope, mut curvature) = (0.0, 0.0, 0.0);
        for j in 0..basis.n {
            for m in 0..f {
                let t = at(j, m);
                carried += along[j] * shapes[m] * t;
                slope += basis.values[j] * first_slopes[m] * t;
                curvature += basis.values[j] * second_slopes[m] * t;
            }
        }
        let up = lift[k] * point.lift_capacity;
        carried += up * slope;
        e.account.shear += weight * point.shear;
        e.account.compression += weight * point.compression;
        e.account.compression_size += weight * point.compression.abs();
        let source = point.shear + point.compression + further(Layer::Film(heights.points()[k]));
        let by_temperature = point.compression / point.temperature;
        for i in 0..basis.n {
            let streamline = tau * along[i];
            let test = basis.values[i] + streamline;
            let [whole, upwind, plain] = [test, streamline, basis.values[i]].map(|w| weight * w);
            for m in 0..f {
                e.residual[i * n + first + m] += shapes[m]
                    * (whole * (carried - source) - upwind * point.conduction * curvature)
                    + plain * point.conduction * slope * first_slopes[m];
                for (sum, by) in by_stress[i][m].iter_mut().zip(point.by_stress) {
                    *sum += whole * shapes[m] * by;
                }
            }
            if !with_jacobian {
                continue;
            }
            for j in 0..basis.n {
                let value = basis.values[j];
                let block = &mut e.film[(i * basis.n + j) * f * f..][..f * f];
                let convection = whole * along[j];
                let heating = whole * value;
                let (strong, weak) = (
                    upwind * value * point.conduction,
                    plain * value * point.conduction,
                );
                for b in 0..f {
                    let shape = shapes[b]
                        * (convection
                            - heating * (point.shear * film.thinning[b] + by_temperature))
                        - strong * second_slopes[b]
                        + heating * up * first_slopes[b];
                    let slope = weak * first_slopes[b];
                    for a in 0..f {
                        block[b * f + a] += shapes[a] * shape + first_slopes[a] * slope;
                    }
                }
            }
        }
    }
    if !with_jacobian {
        return;
    }
    for i in 0..basis.n {
        for j in 0..basis.n {
            let block = &mut e.film[(i * basis.n + j) * f * f..][..f * f];
            for b in 0..f {
                let [x, y] = film.stress_slopes[b].map(|s| basis.values[j] * s);
                for a in 0..f {
                    let [by_x, by_y] = by_stress[i][a];
                    block[b * f + a] -= by_x * x + by_y * y;
                }
            }
        }
    }
}

/// Adds a body at a point of the surface.
#[allow(clippy::too_many_arguments)]
#[inline(always)]
fn body_part(
    space: &HeatSpace,
    nodes: &[u32],
    heat: &Heat,
    state: &State,
    basis: &SurfaceBasis,
    body: usize,
    further: &dyn Fn(Layer) -> f64,
    area: f64,
    size: f64,
    e: &mut Element,
) {
    let column = &space.column;
    let n = column.n();
    let law = &heat.bodies[body];
    let with_jacobian = !e.film.is_empty();
    let per_pair = size_of_layers(&column.bodies[body]);
    let mut offset = 0;
    for layer in &column.bodies[body] {
        let m = layer.nodes.len();
        for point in &layer.points {
            let (mut temperature, mut carried, mut slope, mut curvature) = (0.0, 0.0, 0.0, 0.0);
            let mut across = [0.0; 2];
            for j in 0..basis.n {
                for (a, node) in layer.nodes.iter().enumerate() {
                    let t = state.temperature[nodes[j] as usize * n + node];
                    temperature += basis.values[j] * point.shapes[a] * t;
                    across[0] += basis.slopes[j][0] * point.shapes[a] * t;
                    across[1] += basis.slopes[j][1] * point.shapes[a] * t;
                    slope += basis.values[j] * point.slopes[0][a] * t;
                    curvature += basis.values[j] * point.slopes[1][a] * t
                        + basis.laplacians[j] * point.shapes[a] * t;
                }
            }
            let capacity = law.density * law.heat_capacity.heat_capacity(0.0, temperature);
            let convection = capacity * law.velocity;
            let conduction = law.conductivity.conductivity(0.0, temperature) / heat.length;
            carried += convection * across[0];
            // Shakib's time scale: convection over a cell, conduction along it.
            let tau = {
                let passage = 2.0 * convection / size;
                let spread = 12.0 * conduction / (size * size);
                1.0 / passage.hypot(spread)
            };
            let depth = (layer.nodes.iter().zip(point.shapes))
                .map(|(node, shape)| shape * column.depths[*node])
                .sum();
            let made = further(match body {
                0 => Layer::Plane(depth),
                _ => Layer::Ball(depth),
            });
            let weight = area * point.weight;
            e.account.bodies[body] += weight * carried;
            for i in 0..basis.n {
                let streamline = tau * convection * basis.slopes[i][0];
                let test = basis.values[i] + streamline;
                for (a, node) in layer.nodes.iter().enumerate() {
                    let shape = point.shapes[a];
                    let along = basis.slopes[i][0] * across[0] + basis.slopes[i][1] * across[1];
                    e.residual[i * n + node] += weight
                        * (test * shape * (carried - made)
                            - streamline * shape * conduction * curvature
                            + conduction
                                * (shape * along + basis.values[i] * point.slopes[0][a] * slope));
                }
                if !with_jacobian {
                    continue;
                }
                for j in 0..basis.n {
                    let gradients = basis.slopes[i][0] * basis.slopes[j][0]
                        + basis.slopes[i][1] * basis.slopes[j][1];
                    let flat = weight
                        * (test * convection * basis.slopes[j][0]
                            - streamline * conduction * basis.laplacians[j]
                            + conduction * gradients);
                    let strong = weight * streamline * conduction * basis.values[j];
                    let weak = weight * conduction * basis.values[i] * basis.values[j];
                    let start = (i * basis.n + j) * per_pair + offset;
                    let block = &mut e.bodies[body][start..start + m * m];
                    for b in 0..m {
                        let shape = flat * point.shapes[b] - strong * point.slopes[1][b];
                        let slope = weak * point.slopes[0][b];
                        for a in 0..m {
                            block[b * m + a] +=
                                point.shapes[a] * shape + point.slopes[0][a] * slope;
                        }
                    }
                }
            }
        }
        offset += m * m;
    }
}

/// Which temperatures are prescribed: those at the bottom of the bodies, and those with which bodies and
/// lubricant enter.
fn prescribed(
    d: &Discretisation,
    space: &HeatSpace,
    fluid: &FilmFluid,
    heat: &Heat,
    state: &State,
) -> Vec<bool> {
    let (column, extents) = (&space.column, &d.contact.extents);
    let n = column.n();
    let mut fixed = vec![false; space.n()];
    let tiny = 1e-9 * (extents.outlet - extents.inlet);
    let mut rule = CrossFilm::default();
    for (node, point) in space.surface.points.iter().enumerate() {
        let own = &mut fixed[node * n..(node + 1) * n];
        for body in 0..2 {
            own[column.bottom(body)] = true;
        }
        // Direction in which the outside lies, along the motion.
        let outward = if point[0] < extents.inlet + tiny {
            -1.0
        } else if point[0] > extents.outlet - tiny {
            1.0
        } else {
            continue;
        };
        let walls = [column.first, column.first + column.film.n() - 1];
        for (body, law) in heat.bodies.iter().enumerate() {
            if outward * law.velocity <= 0.0 {
                own[column.body_range(body)].fill(true);
            }
        }
        let inward = film_velocities(
            d,
            space,
            fluid,
            heat,
            state,
            [point[0], point[1]],
            &mut rule,
        );
        for (m, u) in inward.iter().enumerate() {
            let unknown = column.first + m;
            if outward * u < 0.0 && !walls.contains(&unknown) {
                own[unknown] = true;
            }
        }
    }
    fixed
}

/// Velocity along X, over the entrainment speed, at the film's nodes over a point.
fn film_velocities(
    d: &Discretisation,
    space: &HeatSpace,
    fluid: &FilmFluid,
    heat: &Heat,
    state: &State,
    point: [f64; 2],
    rule: &mut CrossFilm,
) -> Vec<f64> {
    let column = &space.column;
    let Some(f) = crate::solve::evaluate::fields_at(d, state, point) else {
        return vec![0.0; column.film.n()];
    };
    let place = FilmPlace {
        pressure: f.pressure,
        pressure_gradient: f.pressure_gradient,
        film: f.film,
        temperature: f
            .temperature
            .expect("a discretisation with heat")
            .temperature,
    };
    let film = film_column(fluid, heat, &column.heights, &place, rule);
    // at the height next to each node
    let s = column.heights.points();
    let nearest = |node: &f64| {
        let distance = |k: &usize| (s[*k] - node).abs();
        (0..s.len())
            .min_by(|a, b| distance(a).total_cmp(&distance(b)))
            .unwrap_or(0)
    };
    let nodes = column.film.points().iter();
    nodes
        .map(|node| film.heights[nearest(node)].velocity[0])
        .collect()
}
