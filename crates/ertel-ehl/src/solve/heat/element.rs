//! Contribution of an element of the contact area to the energy equation: film and bodies over it.

use ertel_fem::kernel;
use ertel_fem::linear::dense::vectorised;

use super::space::HeatSpace;
use crate::film::cross_film::CrossFilm;
use crate::film::{FilmFluid, MOST_NODES, Nodal};
use crate::forms::energy::{FilmColumn, FilmPlace, Heat, Layer, Source, film_column};
use crate::solve::discretisation::Discretisation;
use crate::solve::state::State;
use crate::solve::streams::Streams;

/// Most surface nodes of an element.
const MOST_SURFACE: usize = 6;

/// Contributions of one element.
pub(super) struct Element {
    /// Film block of each pair of surface nodes: `[(i·n + j)·f² + row + f·column]`.
    pub film: Vec<f64>,
    /// Blocks of the bodies, layer by layer, likewise.
    pub bodies: [Vec<f64>; 2],
    /// `[i·n_column + row]`.
    pub residual: Vec<f64>,
    pub account: Account,
    /// ∫ mass_below·∇λ at each height, for each vertex.
    pub rise: Vec<f64>,
    /// ∫∫ C v·∇T + cωT_s ds dA.
    pub taken_up: f64,
    /// Ψ at each point.
    pub conductances: Vec<f64>,
}

pub(super) fn size_of_layers(layers: &[super::column::Layer]) -> usize {
    layers.iter().map(|l| l.nodes.len() * l.nodes.len()).sum()
}

/// Shape functions of the surface at a quadrature point: values, slopes and Laplacians.
struct SurfaceBasis {
    n: usize,
    values: [f64; MOST_SURFACE],
    slopes: [[f64; 2]; MOST_SURFACE],
    laplacians: [f64; MOST_SURFACE],
}

/// Input of the assembly of elements.
pub(super) struct Assembly<'a> {
    pub d: &'a Discretisation,
    pub space: &'a HeatSpace,
    pub fluid: &'a FilmFluid,
    pub heat: &'a Heat,
    pub state: &'a State,
    pub source: Source<'a>,
    /// ω at each height over each vertex, of the assembly before; empty: none.
    pub cross_flow: &'a [f64],
    /// Ψ of the frozen flow, at each point of each element; empty: none is.
    pub conductances: &'a [f64],
    /// Oil behind the film.
    pub streams: Option<&'a Streams>,
    pub with_jacobian: bool,
    /// Inverse 1/θ of a temperature, 1/K: the heat of shearing is taken to fall by 1/θ of itself per K in addition to what the fluid makes
    /// of it; in the Jacobian only.
    pub damping: f64,
}

impl Assembly<'_> {
    pub fn element(&self, c: usize, rule: &mut CrossFilm) -> Element {
        let (d, space, heat, state) = (self.d, self.space, self.heat, self.state);
        let (column, map) = (&space.column, &d.contact.maps[c]);
        let nodes = space.surface.nodes_of(c);
        let (n, n_surface, f) = (column.n(), nodes.len(), column.film.n());
        let pairs = usize::from(self.with_jacobian) * n_surface * n_surface;
        let mut e = Element {
            film: vec![0.0; pairs * f * f],
            bodies: [0, 1].map(|b: usize| vec![0.0; pairs * size_of_layers(&column.bodies[b])]),
            residual: vec![0.0; n_surface * n],
            account: Account::default(),
            rise: vec![0.0; d.contact.surface.cell(c).len() * column.heights.n()],
            taken_up: 0.0,
            conductances: Vec::with_capacity(space.rule.weights.len()),
        };
        let n_points = space.rule.weights.len();
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
            let xi = space.rule.points[q];
            let [x, y] = d.contact.point(c, xi);
            let further = |layer: Layer| self.source.map_or(0.0, |f| f([x, y], layer));
            let place = FilmPlace {
                held_conductance: self.conductances.get(c * n_points + q).copied(),
                ..space.film_at(d, state, self.streams, (c, q))
            };
            let film = film_column(self.fluid, heat, &column.heights, &place, rule);
            e.conductances.push(film.conductance);
            let lift = self.lift(c, xi);
            self.add_rise(c, &film, area, &mut e);
            vectorised(FilmPart {
                space,
                nodes,
                state,
                basis: &basis,
                film: &film,
                lift: &lift,
                further: &further,
                damping: self.damping,
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
                    velocity: heat.bodies[body].velocity.at([x, y]),
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

    /// ω at each height over a point, from the values at the vertices.
    fn lift(&self, c: usize, xi: [f64; 3]) -> Nodal {
        let mut lift = [0.0; MOST_NODES];
        if self.cross_flow.is_empty() {
            return lift;
        }
        let n = self.space.column.heights.n();
        let surface = &self.d.contact.surface;
        for (v, vertex) in surface.cell(c).iter().enumerate() {
            let share = match v {
                0 => 1.0 - xi[..surface.dim].iter().sum::<f64>(),
                _ => xi[v - 1],
            };
            let known = &self.cross_flow[*vertex as usize * n..][..n];
            for (lift, known) in lift.iter_mut().zip(known) {
                *lift += share * known;
            }
        }
        lift
    }

    /// Adds what a point has to say of ω at the vertices.
    fn add_rise(&self, c: usize, film: &FilmColumn, area: f64, e: &mut Element) {
        let n = self.space.column.heights.n();
        let dim = self.d.contact.surface.dim;
        for (v, rise) in e.rise.chunks_exact_mut(n).enumerate() {
            // Slopes of the barycentric coordinate of the vertex.
            let mut slopes = [0.0; 3];
            match v {
                0 => slopes[..dim].fill(-1.0),
                _ => slopes[v - 1] = 1.0,
            }
            let [x, y, _] = self.d.contact.maps[c].gradient(slopes);
            for (sum, height) in rise.iter_mut().zip(&film.heights) {
                let [below_x, below_y] = height.mass_below;
                *sum += area * (below_x * x + below_y * y);
            }
        }
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
        damping: f64,
        area: f64,
        size: f64,
        e: &'a mut Element,
    ) -> () {
        film_part(space, nodes, state, basis, film, lift, further, damping, area, size, e)
    }
}

kernel! {
    BodyPart ['a] ['a] (
        space: &'a HeatSpace,
        nodes: &'a [u32],
        heat: &'a Heat,
        state: &'a State,
        basis: &'a SurfaceBasis,
        velocity: [f64; 2],
        body: usize,
        further: &'a dyn Fn(Layer) -> f64,
        area: f64,
        size: f64,
        e: &'a mut Element,
    ) -> () {
        body_part(space, nodes, heat, state, basis, velocity, body, further, area, size, e)
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
    damping: f64,
    area: f64,
    size: f64,
    e: &mut Element,
) {
    let column = &space.column;
    let (n, f, first) = (column.n(), column.film.n(), column.first);
    let with_jacobian = !e.film.is_empty();
    let at = |j: usize, m: usize| state.temperature[nodes[j] as usize * n + first + m];
    let heights = &column.heights;
    // ∫ Ŵ ℓ ∂(hQ)/∂(τ, κ) ds for each surface node and film node
    let mut by_stress = [[[0.0; 3]; MOST_NODES]; MOST_SURFACE];
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
        e.taken_up += weight * carried;
        e.account.shear += weight * point.shear;
        e.account.compression += weight * point.compression;
        e.account.compression_size += weight * point.compression.abs();
        let source = point.shear + point.compression + further(Layer::Film(heights.points()[k]));
        let by_temperature = point.compression / point.temperature;
        let [by_x, by_y] = point.by_stress;
        let by = [by_x, by_y, point.by_gradient_factor];
        for i in 0..basis.n {
            let streamline = tau * along[i];
            let test = basis.values[i] + streamline;
            let [whole, upwind, plain] = [test, streamline, basis.values[i]].map(|w| weight * w);
            for m in 0..f {
                e.residual[i * n + first + m] += shapes[m]
                    * (whole * (carried - source) - upwind * point.conduction * curvature)
                    + plain * point.conduction * slope * first_slopes[m];
                for (sum, by) in by_stress[i][m].iter_mut().zip(by) {
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
                let damped = plain * value * damping * point.shear.abs();
                let (strong, weak) = (
                    upwind * value * point.conduction,
                    plain * value * point.conduction,
                );
                for b in 0..f {
                    let shape = shapes[b]
                        * (convection + damped
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
                let factor = basis.values[j] * film.gradient_factor_slopes[b];
                for a in 0..f {
                    let [by_x, by_y, by_factor] = by_stress[i][a];
                    block[b * f + a] -= by_x * x + by_y * y + by_factor * factor;
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
    velocity: [f64; 2],
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
            let [u, v] = velocity.map(|u| capacity * u);
            let conduction = law.conductivity.conductivity(0.0, temperature) / heat.length;
            carried += u * across[0] + v * across[1];
            // Shakib's time scale: convection over a cell, conduction along it.
            let tau = {
                let passage = 2.0 * u.hypot(v) / size;
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
                let streamline = tau * u * basis.slopes[i][0] + tau * v * basis.slopes[i][1];
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
                        * (test * u * basis.slopes[j][0] + test * v * basis.slopes[j][1]
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

impl Account {
    pub(super) fn add(&mut self, other: &Account) {
        self.shear += other.shear;
        self.compression += other.compression;
        self.compression_size += other.compression_size;
        for b in 0..2 {
            self.bodies[b] += other.bodies[b];
            self.conducted[b] += other.conducted[b];
        }
    }
}
