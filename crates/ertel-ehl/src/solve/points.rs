//! Fields at points of the contact area, dimensionless: where separation, gap and deflection become a film.
//!
//! ```text
//!   H = H_0 + G + δ        H_0 rigid separation, G undeformed gap, δ deflection
//! ```
//! The Newton system computes the same in its own loop over the elements (`element.rs`); everything else uses this module. Sums over the
//! contact area after a solve read the [`PointTable`](crate::engine::PointTable).

use ertel_fem::element::Tabulation;

use super::discretisation::Discretisation;
use super::state::State;
use crate::engine::PointFields;
use crate::forms::oil_layer::{filling_length, missing};

/// Fields at any place; `None` outside the contact area.
pub fn fields_at(d: &Discretisation, state: &State, place: [f64; 2]) -> Option<PointFields> {
    let (cell, xi) = d.contact.locator.find(&d.contact.surface, place)?;
    Some(fields_in(d, state, cell, xi))
}

/// Fields at reference coordinates of an element.
pub fn fields_in(d: &Discretisation, state: &State, cell: usize, xi: [f64; 3]) -> PointFields {
    let heat = d.heat.as_ref();
    let mut fields = PointFields {
        temperature: heat.map(|heat| Box::new(heat.profile_in(d, state, cell, xi))),
        ..PointFields::default()
    };
    let basis = d.pressure.element.gradients(xi);
    for ((value, gradient), node) in basis.zip(d.pressure.nodes_of(cell)) {
        let p = state.pressure[*node as usize];
        let g = d.contact.maps[cell].gradient(gradient);
        fields.pressure += p * value;
        fields.pressure_gradient[0] += p * g[0];
        fields.pressure_gradient[1] += p * g[1];
    }
    let basis = d.contact.deflection.element.values(xi);
    (fields.place, fields.deflection) = surface(d, &state.deflection, cell, basis, 0.0);
    with_film(fields, d, state, cell)
}

/// The same, without temperatures, at the `q`-th point of tables of the pressure's and the deflection's shape functions.
pub fn fields_from(
    d: &Discretisation,
    state: &State,
    cell: usize,
    q: usize,
    [pressure, deflection]: [&Tabulation; 2],
) -> PointFields {
    let mut fields = PointFields::default();
    let mut reference = [0.0; 3];
    for (j, node) in d.pressure.nodes_of(cell).iter().enumerate() {
        let (k, p) = (q * pressure.n_nodes + j, state.pressure[*node as usize]);
        fields.pressure += p * pressure.values[k];
        for (sum, gradient) in reference.iter_mut().zip(pressure.gradients[k]) {
            *sum += p * gradient;
        }
    }
    let [gx, gy, _] = d.contact.maps[cell].gradient(reference);
    fields.pressure_gradient = [gx, gy];
    let basis = of_point(deflection, q).iter().copied();
    (fields.place, fields.deflection) = surface(d, &state.deflection, cell, basis, 0.0);
    with_film(fields, d, state, cell)
}

/// Film where the deflection's shape functions are these, with the place.
pub fn film_of(d: &Discretisation, state: &State, cell: usize, basis: &[f64]) -> ([f64; 2], f64) {
    let start = state.rigid_separation;
    let (place, film) = surface(d, &state.deflection, cell, basis.iter().copied(), start);
    (place, film + d.contact.shape.gap.value(place))
}

/// Films at the quadrature points of an element, and by how much a step of deflections and separation changes each.
pub(super) fn films_and_changes<'a>(
    d: &'a Discretisation,
    state: &'a State,
    (deflection, separation): (&'a [f64], f64),
    cell: usize,
) -> impl Iterator<Item = (f64, f64)> + 'a {
    (0..d.rule.len()).map(move |q| {
        let basis = of_point(&d.deflection_table, q);
        let (_, film) = film_of(d, state, cell, basis);
        let (_, change) = surface(d, deflection, cell, basis.iter().copied(), separation);
        (film, change)
    })
}

/// Pressure at a place, within the nodal values of its element; zero outside of the contact area.
pub fn pressure_at(d: &Discretisation, pressure: &[f64], place: [f64; 2]) -> f64 {
    let contact = &d.contact;
    let Some((cell, xi)) = contact.locator.find(&contact.surface, place) else {
        return 0.0;
    };
    let nodes = d.pressure.nodes_of(cell);
    let values = nodes.iter().map(|n| pressure[*n as usize]);
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| {
        (l.min(v), h.max(v))
    });
    let basis = d.pressure.element.values(xi);
    let value: f64 = (basis.zip(nodes))
        .map(|(b, n)| b * pressure[*n as usize])
        .sum();
    // No clamp: it panics where the nodal values are no numbers.
    value.max(low).min(high)
}

/// Shape functions at the `q`-th point of a table.
fn of_point(table: &Tabulation, q: usize) -> &[f64] {
    &table.values[q * table.n_nodes..][..table.n_nodes]
}

/// Place of a point of the surface and a field of the deflection's space there, on top of a `start`, from the shape functions.
#[inline]
fn surface(
    d: &Discretisation,
    values: &[f64],
    cell: usize,
    basis: impl Iterator<Item = f64>,
    start: f64,
) -> ([f64; 2], f64) {
    let (mut place, mut sum) = ([0.0; 2], start);
    for (value, node) in basis.zip(d.contact.deflection.nodes_of(cell)) {
        sum += value * values[*node as usize];
        let at_node = d.contact.deflection.points[*node as usize];
        for (x, px) in place.iter_mut().zip(at_node) {
            *x += value * px;
        }
    }
    (place, sum)
}

/// Computes the film from separation, gap and deflection, and the missing film in an element.
fn with_film(
    mut fields: PointFields,
    d: &Discretisation,
    state: &State,
    cell: usize,
) -> PointFields {
    fields.gap = d.contact.shape.gap.value(fields.place);
    fields.film = state.rigid_separation + (fields.deflection + fields.gap);
    if let Some(layer) = d.contact.shape.inlet.layer() {
        let length = filling_length(d.contact.sizes[cell], d.pressure.element.order());
        let missing = missing(layer, fields.pressure, fields.film, length);
        fields.missing = missing.map_or(0.0, |missing| missing.film);
    }
    fields
}
