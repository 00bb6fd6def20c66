//! Fields at points of the contact area, dimensionless: where separation, gap and deflection become a film.
//!
//! ```text
//!   H = H_0 + G + δ        H_0 rigid separation, G undeformed gap, δ deflection
//! ```
//! The Newton system puts the same together in its own loop over the elements ([`super::element`]); everything else asks here. What is
//! summed over the contact area after a solve reads the [`PointTable`].

use ertel_fem::element::Tabulation;
use rayon::prelude::*;

use super::discretisation::Discretisation;
use super::element::Metric;
use super::system::State;
use crate::contact::HertzZone;
use crate::film::TemperatureProfile;
use crate::forms::energy::FilmPlace;
use crate::forms::flow::PointState;
use crate::forms::oil_layer::{filling_length, missing};

/// Fields at a point of the contact area.
#[derive(Clone, Debug, Default)]
pub struct PointFields {
    /// (X, Y).
    pub place: [f64; 2],
    /// P.
    pub pressure: f64,
    /// ∇P.
    pub pressure_gradient: [f64; 2],
    /// G, the undeformed gap.
    pub gap: f64,
    /// δ, the deflection.
    pub deflection: f64,
    /// H.
    pub film: f64,
    /// F, what the gap lacks where a layer of oil does not fill it (see [`crate::forms::oil_layer`]).
    pub missing: f64,
    /// Temperature across the film, where it varies.
    pub temperature: Option<Box<TemperatureProfile>>,
}

impl PointFields {
    /// θ, the share of the gap that is filled with oil.
    pub fn filling(&self) -> f64 {
        1.0 - self.missing / self.film
    }

    /// What the energy equation sees of the film, its flow not held.
    pub fn film_place(&self) -> FilmPlace {
        let profile = self.temperature.as_deref().copied().unwrap_or_default();
        FilmPlace {
            at: self.place,
            pressure: self.pressure,
            pressure_gradient: self.pressure_gradient,
            film: self.film,
            filling: self.filling(),
            temperature: profile.temperature,
            held_conductance: None,
        }
    }

    /// Puts the film together from separation, gap and deflection, and finds what it lacks in an element.
    fn with_film(mut self, d: &Discretisation, state: &State, cell: usize) -> PointFields {
        self.gap = d.contact.shape.gap.value(self.place);
        self.film = state.rigid_separation + (self.deflection + self.gap);
        if let Some(layer) = d.contact.shape.inlet.layer() {
            let length = filling_length(d.contact.sizes[cell], d.pressure.element.order());
            let missing = missing(layer, self.pressure, self.film, length);
            self.missing = missing.map_or(0.0, |missing| missing.film);
        }
        self
    }
}

/// One row of the table: what a quadrature point stands for.
#[derive(Clone, Debug)]
pub struct Point {
    /// Weight of the point: the area that it stands for, or the length in line contacts, in half-widths.
    pub area: f64,
    /// Fields there.
    pub fields: PointFields,
}

/// Fields at all quadrature points of the film equations, element by element.
#[derive(Clone, Debug)]
pub struct PointTable {
    points: Vec<Point>,
    per_element: usize,
}

impl PointTable {
    /// Of a state.
    pub fn new(d: &Discretisation, state: &State) -> PointTable {
        let per_element = d.rule.len();
        let tables = [&d.pressure_table, &d.deflection_table];
        let row = |i: usize| {
            let (cell, q) = (i / per_element, i % per_element);
            let heat = d.heat.as_ref();
            Point {
                area: d.rule.weights[q] * d.contact.maps[cell].determinant,
                fields: PointFields {
                    temperature: heat.map(|heat| Box::new(heat.profile_at(d, state, cell, q))),
                    ..fields_from(d, state, cell, q, tables)
                },
            }
        };
        let points = (0..per_element * d.contact.n_elements())
            .into_par_iter()
            .with_min_len(BATCH)
            .map(row)
            .collect();
        PointTable {
            points,
            per_element,
        }
    }

    /// The points of an element, in the order of the rule.
    pub fn of_element(&self, cell: usize) -> &[Point] {
        &self.points[cell * self.per_element..][..self.per_element]
    }

    /// Means over the Hertz zone. Where the film is so thick that no element is as small as the zone, what is nearest its centre; not a number
    /// where no point has the values.
    pub fn mean_in<const N: usize>(
        &self,
        zone: &HertzZone,
        values: impl Fn(&PointFields) -> Option<[f64; N]>,
    ) -> [f64; N] {
        let (mut sums, mut total) = ([0.0; N], 0.0);
        let (mut nearest, mut centre) = (f64::INFINITY, [f64::NAN; N]);
        for point in &self.points {
            let Some(values) = values(&point.fields) else {
                continue;
            };
            let [x, y] = point.fields.place;
            if x.hypot(y) < nearest {
                (nearest, centre) = (x.hypot(y), values);
            }
            if zone.contains([x, y]) {
                total += point.area;
                for (sum, value) in sums.iter_mut().zip(values) {
                    *sum += point.area * value;
                }
            }
        }
        match total > 0.0 {
            true => sums.map(|sum| sum / total),
            false => centre,
        }
    }

    /// All points.
    pub fn iter(&self) -> impl Iterator<Item = &Point> {
        self.points.iter()
    }
}

/// Points that a thread takes at a time.
const BATCH: usize = 256;

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
    fields.with_film(d, state, cell)
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
    fields.with_film(d, state, cell)
}

/// What the film equations see at the `q`-th quadrature point of an element, with its place: derivatives of pressure and film, too.
pub(super) fn point_state(
    d: &Discretisation,
    state: &State,
    metric: &Metric,
    cell: usize,
    q: usize,
) -> ([f64; 2], PointState<f64>) {
    let [pressure, px, py, _, unseen, xx, xy, yy] =
        pressure_sums(d, &state.pressure, metric, cell, q);
    let table = &d.deflection_table;
    let (mut place, mut film) = ([0.0; 2], [state.rigid_separation, 0.0, 0.0]);
    for (j, node) in d.contact.deflection.nodes_of(cell).iter().enumerate() {
        let (k, v) = (q * table.n_nodes + j, state.deflection[*node as usize]);
        let [gx, gy] = metric.gradient(&table.gradients[k]);
        let basis = [table.values[k], gx, gy];
        film.iter_mut().zip(basis).for_each(|(s, b)| *s += v * b);
        let at_node = d.contact.deflection.points[*node as usize];
        for (x, at) in place.iter_mut().zip(at_node) {
            *x += table.values[k] * at;
        }
    }
    let gap = d.contact.shape.gap.at(place);
    let state = PointState {
        pressure,
        pressure_gradient: [px, py],
        pressure_unseen: unseen,
        pressure_curvature: [xx, xy, yy],
        film: film[0] + gap.value,
        film_gradient: [film[1] + gap.gradient[0], film[2] + gap.gradient[1]],
    };
    (place, state)
}

/// Nodal values of the pressure's space at the `q`-th quadrature point of an element: V, V_x, V_y, ΔV, κV, V_xx, V_xy, V_yy.
pub(super) fn pressure_sums(
    d: &Discretisation,
    values: &[f64],
    metric: &Metric,
    cell: usize,
    q: usize,
) -> [f64; 8] {
    let table = &d.pressure_table;
    let mut sums = [0.0; 8];
    for (j, node) in d.pressure.nodes_of(cell).iter().enumerate() {
        let (k, v) = (q * table.n_nodes + j, values[*node as usize]);
        let [gx, gy] = metric.gradient(&table.gradients[k]);
        let [xx, xy, yy] = metric.second(&table.hessians[k]);
        let basis = [
            table.values[k],
            gx,
            gy,
            metric.laplacian(&table.hessians[k]),
            d.pressure_unseen[k],
            xx,
            xy,
            yy,
        ];
        sums.iter_mut().zip(basis).for_each(|(s, b)| *s += v * b);
    }
    sums
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

/// G at the pressure nodes.
pub fn gap_at_nodes(d: &Discretisation) -> Vec<f64> {
    let gap = &d.contact.shape.gap;
    let places = d.pressure.points.iter();
    places.map(|p| gap.value([p[0], p[1]])).collect()
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
