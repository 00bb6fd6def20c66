//! How far temperatures of linear elements are from those by recovered gradients.

use ertel_fem::element::Lagrange;
use ertel_fem::quadrature::Quadrature;

use super::recovery::{ORDER, Recovery};
use super::space::HeatSpace;
use crate::engine::heat::walls;
use crate::solution::{Figure, TemperatureErrors};
use crate::solve::discretisation::Discretisation;
use crate::solve::state::State;
use crate::solve::tuning::heat::AROUND;

/// Temperatures that are recovered: at mid-film, of plane and ball.
const N_ROWS: usize = 3;

/// Figures that are a temperature somewhere, and which of the rows is looked at around them.
const LOCAL: [(Figure, usize); 4] = [
    (Figure::FilmTemperatureMaximum, 0),
    (Figure::FilmTemperatureLowest, 0),
    (Figure::TemperatureBody1Maximum, 1),
    (Figure::TemperatureBody2Maximum, 2),
];

/// Deviation of the temperatures of a state; none where elements are not linear.
///
/// `place` gives the places of figures, in half-widths.
pub fn deviation(
    d: &Discretisation,
    heat: &HeatSpace,
    state: &State,
    place: impl Fn(Figure) -> Option<[f64; 2]>,
) -> TemperatureErrors {
    let (space, column) = (&heat.surface, &heat.column);
    let mut found = TemperatureErrors::default();
    if space.element.order() != 1 {
        return found;
    }
    let places = LOCAL.map(|(figure, _)| place(figure));
    let recovery = Recovery::new(space, d.contact.shape.symmetry);
    let nodal: [Vec<f64>; N_ROWS] = std::array::from_fn(|row| {
        let columns = state.temperature.chunks_exact(column.n());
        let values = columns.map(|values| {
            let film = column.film_of(values);
            match row {
                0 => column.film.through(&film).at(0.0),
                _ => walls(&column.film, &film)[row - 1],
            }
        });
        values.collect()
    });
    let cubics = nodal.each_ref().map(|values| recovery.cubics(values));
    let dim = space.element.dim();
    let rule = Quadrature::simplex(dim, 2 * ORDER);
    let cubic = Lagrange::new(dim, ORDER).tabulate(&rule);
    let linear = space.element.tabulate(&rule);
    let mut zone = 0.0;
    for cell in 0..space.n_elements() {
        let nodes = space.nodes_of(cell);
        let reach = AROUND.max(d.contact.sizes[cell]);
        for (q, weight) in rule.weights.iter().enumerate() {
            let shapes = &linear.values[q * linear.n_nodes..][..linear.n_nodes];
            let thirds = &cubic.values[q * cubic.n_nodes..][..cubic.n_nodes];
            let mut x = [0.0; 2];
            for (shape, node) in shapes.iter().zip(nodes) {
                let point = space.points[*node as usize];
                x = [x[0] + shape * point[0], x[1] + shape * point[1]];
            }
            let difference: [f64; N_ROWS] = std::array::from_fn(|row| {
                let values = &cubics[row][cell * cubic.n_nodes..];
                let smooth: f64 = thirds.iter().zip(values).map(|(s, v)| s * v).sum();
                let corners = shapes.iter().zip(nodes);
                smooth
                    - corners
                        .map(|(s, node)| s * nodal[row][*node as usize])
                        .sum::<f64>()
            });
            for ((local, place), (_, row)) in found.local.iter_mut().zip(places).zip(LOCAL) {
                if place.is_some_and(|p| (x[0] - p[0]).hypot(x[1] - p[1]) < reach) {
                    *local = local.max(difference[row].abs());
                }
            }
            if d.contact.shape.zone.contains(x) {
                let area = weight * d.contact.maps[cell].determinant;
                zone += area;
                found.rms += area * difference[0] * difference[0];
            }
        }
    }
    found.rms = (found.rms / zone).sqrt();
    found
}
