//! Temperatures with which bodies and lubricant enter.
//!
//! ```text
//!   bodies:  T = T_b at the bottom and where the surface enters                     prescribed
//!   film:    ∫∫ W max(−C v·n, 0)(T − T_e) ds dl over the edge is added               C = ρc h u_m/a,  T_e that of what enters at a height
//! ```
//! The film's condition is weak: heights that flow in bring their heat along, those that flow out (in the inlet the middle of the film flows
//! back) keep their temperature, so that none jumps where one passes into the other. Nothing is prescribed, so that all the heat that leaves
//! through the edge leaves with the lubricant.

use ertel_fem::linear::block_ilu::BlockMatrix;

use super::element::Assembly;
use super::sides::SideRule;
use super::system::HeatSystem;
use crate::film::cross_film::CrossFilm;
use crate::forms::energy::film_column;
use crate::solve::discretisation::Discretisation;
use crate::solve::points::fields_in;

impl Assembly<'_> {
    /// Adds what flows through the edge of the contact area: the lubricant's heat where it flows in, and −∮ λ m·n dl to the sums of
    /// ω (see [`super::cross_flow`]).
    pub fn add_edges(&self, system: &mut HeatSystem, mut matrix: Option<&mut BlockMatrix>) {
        let (d, space) = (self.d, self.space);
        let mut rule = CrossFilm::default();
        for side in &space.edges {
            let SideRule { normal, points } = SideRule::new(&d.contact, *side);
            for (xi, weight) in &points {
                let mut fields = fields_in(d, self.state, side.0, *xi);
                fields.missing += self.streams.map_or(0.0, |of| of.missing(&fields));
                let place = fields.film_place();
                let heights = &space.column.heights;
                let film = film_column(self.fluid, self.heat, heights, &place, &mut rule);
                let n = heights.n();
                for (vertex, share) in barycentric(d, side.0, *xi) {
                    let sums = &mut system.cross_flow[vertex * n..][..n];
                    for (sum, point) in sums.iter_mut().zip(&film.heights) {
                        let [x, y] = point.mass_below;
                        *sum -= weight * share * (x * normal[0] + y * normal[1]);
                    }
                }
                let basis: Vec<f64> = space.surface.element.values(*xi).collect();
                let nodes = space.surface.nodes_of(side.0);
                let (unknowns, first) = (space.column.n(), space.column.first);
                let f = space.column.film.n();
                for (k, w) in heights.weights().iter().enumerate() {
                    let point = &film.heights[k];
                    let out = point.velocity[0] * normal[0] + point.velocity[1] * normal[1];
                    let inflow = weight * w * point.capacity * (-out).max(0.0);
                    if inflow == 0.0 {
                        continue;
                    }
                    let shapes = &heights.shapes[k];
                    let entering = self.heat.entering(heights.points()[k], f - 1);
                    let brought = inflow * (point.temperature - entering);
                    system.taken_up[side.0] += brought;
                    for (value, node) in basis.iter().zip(nodes) {
                        let rows = &mut system.residual[*node as usize * unknowns + first..][..f];
                        for (sum, shape) in rows.iter_mut().zip(shapes) {
                            *sum += value * shape * brought;
                        }
                    }
                    let Some(matrix) = &mut matrix else {
                        continue;
                    };
                    for (own, row) in basis.iter().zip(nodes) {
                        for (other, column) in basis.iter().zip(nodes) {
                            let block = matrix.block_mut(*row, *column);
                            for b in 0..f {
                                let entries = &mut block[(first + b) * unknowns + first..][..f];
                                let factor = inflow * own * other * shapes[b];
                                for (entry, shape) in entries.iter_mut().zip(shapes) {
                                    *entry += factor * shape;
                                }
                            }
                        }
                    }
                }
            }
        }
    }
}

/// Vertices of an element with their barycentric coordinates of a point.
fn barycentric(
    d: &Discretisation,
    c: usize,
    xi: [f64; 3],
) -> impl Iterator<Item = (usize, f64)> + '_ {
    let surface = &d.contact.surface;
    let first = 1.0 - xi[..surface.dim].iter().sum::<f64>();
    let shares = std::iter::once(first).chain(xi);
    let vertices = surface.cell(c).iter().map(|v| *v as usize);
    vertices.zip(shares)
}
