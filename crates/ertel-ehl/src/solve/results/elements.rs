//! Fields as polynomials, in SI.

use ertel_fem::element::Lagrange;
use ertel_fem::space::Space;

use crate::contact::{Scales, Symmetry};
use crate::solution::{ElementFields, FilmTemperatures, Polynomials, TemperaturePolynomials};
use crate::solve::discretisation::Discretisation;
use crate::solve::heat::recovery::{self, Recovery};
use crate::solve::heat::space::HeatSpace;
use crate::solve::points::film_of;
use crate::solve::sequence::StageSolution;
use crate::solve::state::State;

/// The undeformed gap is a polynomial of this order.
const GAP_ORDER: usize = 2;

/// The polynomials that were solved for.
pub fn elements(solution: &StageSolution, scales: &Scales) -> ElementFields {
    let (d, state) = (&solution.discretisation, &solution.state);
    let surface = &d.contact.surface;
    let cells = (0..surface.n_cells()).map(|c| {
        let mut corners = [0; 3];
        corners[..=surface.dim].copy_from_slice(surface.cell(c));
        corners
    });
    ElementFields {
        dim: surface.dim,
        vertices: (surface.vertices.iter())
            .map(|v| [v[0] * scales.length, v[1] * scales.length])
            .collect(),
        cells: cells.collect(),
        pressure: nodal(&d.pressure, |node| state.pressure[node] * scales.pressure),
        film_thickness: film(d, state, scales),
        temperatures: (d.heat.as_ref())
            .map(|space| temperatures(space, state, d.contact.shape.symmetry)),
    }
}

/// A field given at the nodes of a space.
fn nodal(space: &Space, value: impl Fn(usize) -> f64) -> Polynomials {
    Polynomials {
        order: space.element.order(),
        values: (space.element_nodes.iter())
            .map(|node| value(*node as usize))
            .collect(),
    }
}

/// Film thickness: deflection and gap together, exactly.
fn film(d: &Discretisation, state: &State, scales: &Scales) -> Polynomials {
    let deflection = &d.contact.deflection;
    let order = deflection.element.order().max(GAP_ORDER);
    let element = Lagrange::new(deflection.element.dim(), order);
    // Shape functions of the deflection at the nodes of the film, the same in every element
    let table: Vec<Vec<f64>> = (element.points())
        .map(|xi| deflection.element.values(xi).collect())
        .collect();
    let mut values = Vec::with_capacity(table.len() * d.contact.n_elements());
    for cell in 0..d.contact.n_elements() {
        for basis in &table {
            let (_, film) = film_of(d, state, cell, basis);
            values.push(scales.film * film);
        }
    }
    Polynomials { order, values }
}

/// Temperatures of film and surfaces: each a sum over the column's nodes, so a polynomial as the columns are; of linear
/// elements the cubics by recovered gradients, whose kinks would be those of the mesh.
fn temperatures(space: &HeatSpace, state: &State, symmetry: Symmetry) -> TemperaturePolynomials {
    let column = &space.column;
    let mut at_nodes = FilmTemperatures::default();
    for values in state.temperature.chunks_exact(column.n()) {
        at_nodes.push(&column.film, &column.film_of(values));
    }
    let recovery =
        (space.surface.element.order() == 1).then(|| Recovery::new(&space.surface, symmetry));
    let field = |values: &[f64]| match &recovery {
        Some(recovery) => Polynomials {
            order: recovery::ORDER,
            values: recovery.cubics(values),
        },
        None => nodal(&space.surface, |node| values[node]),
    };
    TemperaturePolynomials {
        mid: field(&at_nodes.mid),
        mean: field(&at_nodes.mean),
        body_1: field(&at_nodes.body_1),
        body_2: field(&at_nodes.body_2),
    }
}
