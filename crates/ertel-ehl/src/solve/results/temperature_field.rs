//! Temperature of the whole film and of both bodies, for pictures.

use super::fields::sub_cells;
use crate::contact::Scales;
use crate::solution::TemperatureField;
use crate::solve::discretisation::Discretisation;
use crate::solve::evaluate::central_film;
use crate::solve::heat::space::HeatSpace;
use crate::solve::points::fields_in;
use crate::solve::state::State;

/// Approximate drawn thickness of the central film, in half-widths.
const DRAWN_FILM: f64 = 0.05;

/// Film and bodies as they are solved (the half y ≤ 0 of symmetric contacts), the film stretched by 1, 2 or 5 times a power of ten.
pub(super) fn temperature_field(
    d: &Discretisation,
    state: &State,
    space: &HeatSpace,
    scales: &Scales,
) -> TemperatureField {
    let column = &space.column;
    let n = column.n();
    let magnification = round(DRAWN_FILM * scales.length / (scales.film * central_film(d, state)));
    let element = &space.surface.element;
    let order = element.order() as f64;
    let mut films = vec![0.0; space.surface.n_nodes()];
    for c in 0..d.contact.n_elements() {
        for (alpha, node) in element.lattice().iter().zip(space.surface.nodes_of(c)) {
            let xi = [
                f64::from(alpha[1]) / order,
                f64::from(alpha[2]) / order,
                0.0,
            ];
            films[*node as usize] = fields_in(d, state, c, xi).film * scales.film;
        }
    }
    let mut field = TemperatureField {
        temperature: state.temperature.clone(),
        film_magnification: magnification,
        ..TemperatureField::default()
    };
    let film = column.film_range();
    for (point, h) in space.surface.points.iter().zip(&films) {
        let drawn = magnification * h;
        for k in 0..n {
            let depth = column.depths[k] * scales.length;
            let z = if k < film.start {
                -depth
            } else if k < film.end {
                (column.film.points()[k - film.start] + 0.5) * drawn
            } else {
                drawn + depth
            };
            field
                .points
                .push([point[0] * scales.length, point[1] * scales.length, z]);
        }
    }
    for cell in sub_cells(&space.surface) {
        for k in 0..n - 1 {
            let low = |corner: usize| cell[corner] * n as u32 + k as u32;
            field.cells.push(if d.contact.surface.dim == 1 {
                vec![low(0), low(1), low(1) + 1, low(0) + 1]
            } else {
                // Of a wedge, the normal of the first triangle points away from the second.
                let bottom = [low(0), low(2), low(1)];
                bottom.into_iter().chain(bottom.map(|p| p + 1)).collect()
            });
            field.region.push(if k < film.start {
                0
            } else {
                1 + u8::from(k + 1 >= film.end)
            });
        }
    }
    field
}

/// The nearest of 1, 2 and 5 times a power of ten, not below one.
fn round(value: f64) -> f64 {
    let power = 10f64.powf(value.max(1.0).log10().floor());
    match value.max(1.0) / power {
        f if f < 1.5 => power,
        f if f < 3.5 => 2.0 * power,
        f if f < 7.5 => 5.0 * power,
        _ => 10.0 * power,
    }
}
