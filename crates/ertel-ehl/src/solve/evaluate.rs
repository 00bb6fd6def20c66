//! Pressure and film thickness at any point of the contact area, dimensionless.

use ertel_fem::element::{Lagrange, Tabulation};

use crate::film::TemperatureProfile;
use crate::forms::energy::FilmPlace;
use crate::forms::oil_layer::{filling_length, missing};
use crate::solve::discretisation::Discretisation;
use crate::solve::system::State;

/// Fields at a point of the contact area.
#[derive(Clone, Copy, Debug, Default)]
pub struct PointFields {
    /// (X, Y).
    pub place: [f64; 2],
    /// P.
    pub pressure: f64,
    /// ∇P.
    pub pressure_gradient: [f64; 2],
    /// H.
    pub film: f64,
    /// F, what the gap lacks where a layer of oil does not fill it (see [`crate::forms::oil_layer`]).
    pub missing: f64,
    /// Deflection.
    pub deflection: f64,
    /// Temperature across the film, where it varies.
    pub temperature: Option<TemperatureProfile>,
}

impl PointFields {
    /// θ, the share of the gap that is filled with oil.
    pub fn filling(&self) -> f64 {
        1.0 - self.missing / self.film
    }

    /// Finds what the gap lacks, in an element of a discretisation.
    fn with_missing(self, d: &Discretisation, cell: usize) -> PointFields {
        let Some(layer) = d.contact.shape.inlet.layer() else {
            return self;
        };
        let length = filling_length(d.contact.sizes[cell], d.pressure.element.order());
        let missing = missing(layer, self.pressure, self.film, length);
        PointFields {
            missing: missing.map_or(0.0, |missing| missing.film),
            ..self
        }
    }

    /// What the energy equation sees of the film, its flow not held.
    pub fn film_place(&self) -> FilmPlace {
        FilmPlace {
            at: self.place,
            pressure: self.pressure,
            pressure_gradient: self.pressure_gradient,
            film: self.film,
            filling: self.filling(),
            temperature: self.temperature.unwrap_or_default().temperature,
            held_conductance: None,
        }
    }
}

/// Pressure at a point, within the nodal values of its element; zero outside of the contact area.
pub fn pressure_at(d: &Discretisation, pressure: &[f64], point: [f64; 2]) -> f64 {
    let contact = &d.contact;
    let Some((cell, xi)) = contact.locator.find(&contact.surface, point) else {
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

/// Evaluates the fields; `None` outside the contact area.
pub fn fields_at(d: &Discretisation, state: &State, point: [f64; 2]) -> Option<PointFields> {
    let (cell, xi) = d.contact.locator.find(&d.contact.surface, point)?;
    Some(fields_in(d, state, cell, xi))
}

/// Evaluates the fields at reference coordinates of an element.
pub fn fields_in(d: &Discretisation, state: &State, cell: usize, xi: [f64; 3]) -> PointFields {
    let mut fields = PointFields {
        place: [0.0; 2],
        pressure: 0.0,
        pressure_gradient: [0.0; 2],
        film: state.rigid_separation,
        missing: 0.0,
        deflection: 0.0,
        temperature: d
            .heat
            .as_ref()
            .map(|heat| heat.profile_in(d, state, cell, xi)),
    };
    let basis = d.pressure.element.gradients(xi);
    for ((value, gradient), node) in basis.zip(d.pressure.nodes_of(cell)) {
        let p = state.pressure[*node as usize];
        let g = d.contact.maps[cell].gradient(gradient);
        fields.pressure += p * value;
        fields.pressure_gradient[0] += p * g[0];
        fields.pressure_gradient[1] += p * g[1];
    }
    let mut point = [0.0; 3];
    let basis = d.contact.deflection.element.values(xi);
    for (value, node) in basis.zip(d.contact.deflection.nodes_of(cell)) {
        fields.deflection += value * state.deflection[*node as usize];
        for (x, px) in point
            .iter_mut()
            .zip(d.contact.deflection.points[*node as usize])
        {
            *x += value * px;
        }
    }
    fields.place = [point[0], point[1]];
    fields.film += fields.deflection + d.contact.shape.gap.value(fields.place);
    fields.with_missing(d, cell)
}

/// The same at the `q`-th quadrature point of an element, from tables, with the place of the point.
pub fn fields_at_quadrature(
    d: &Discretisation,
    state: &State,
    cell: usize,
    q: usize,
) -> ([f64; 3], PointFields) {
    let temperature = (d.heat.as_ref()).map(|heat| heat.profile_at(d, state, cell, q));
    let tables = [&d.pressure_table, &d.deflection_table];
    let (point, fields) = fields_from(d, state, cell, q, tables);
    let fields = PointFields {
        temperature,
        ..fields
    };
    (point, fields)
}

/// The same, without temperatures, at the `q`-th point of tables of the pressure's and the deflection's shape
/// functions.
pub fn fields_from(
    d: &Discretisation,
    state: &State,
    cell: usize,
    q: usize,
    [pressure, deflection]: [&Tabulation; 2],
) -> ([f64; 3], PointFields) {
    let mut fields = PointFields {
        film: state.rigid_separation,
        ..PointFields::default()
    };
    let table = pressure;
    let mut reference = [0.0; 3];
    for (j, node) in d.pressure.nodes_of(cell).iter().enumerate() {
        let (k, p) = (q * table.n_nodes + j, state.pressure[*node as usize]);
        fields.pressure += p * table.values[k];
        for (sum, gradient) in reference.iter_mut().zip(table.gradients[k]) {
            *sum += p * gradient;
        }
    }
    let gradient = d.contact.maps[cell].gradient(reference);
    fields.pressure_gradient = [gradient[0], gradient[1]];
    let table = deflection;
    let mut point = [0.0; 3];
    for (j, node) in d.contact.deflection.nodes_of(cell).iter().enumerate() {
        let value = table.values[q * table.n_nodes + j];
        fields.deflection += value * state.deflection[*node as usize];
        let place = d.contact.deflection.points[*node as usize];
        for (x, px) in point.iter_mut().zip(place) {
            *x += value * px;
        }
    }
    fields.place = [point[0], point[1]];
    fields.film += fields.deflection + d.contact.shape.gap.value(fields.place);
    (point, fields.with_missing(d, cell))
}

/// Film thickness at the centre of the contact.
pub fn central_film(d: &Discretisation, state: &State) -> f64 {
    fields_at(d, state, [0.0, 0.0]).map_or(f64::NAN, |f| f.film)
}

/// Lattice of an element with `n` points per edge, and shape functions there: point by point.
struct Lattice {
    points: Vec<[f64; 3]>,
    /// `values[point * element.n_nodes() + node]`.
    values: Vec<f64>,
}

impl Lattice {
    fn new(element: &Lagrange, n: usize) -> Lattice {
        let mut points = Vec::new();
        for i in 0..=n {
            for j in 0..=(if element.dim() == 2 { n - i } else { 0 }) {
                points.push([i as f64 / n as f64, j as f64 / n as f64, 0.0]);
            }
        }
        let values = points.iter().flat_map(|xi| element.values(*xi));
        Lattice {
            values: values.collect(),
            points,
        }
    }

    /// Shape functions at each point.
    fn basis(&self) -> impl Iterator<Item = (&[f64; 3], &[f64])> {
        let n = self.values.len() / self.points.len();
        self.points.iter().zip(self.values.chunks_exact(n))
    }
}

/// Elements in which the smallest film is searched for: the one with the thinnest point of the lattice need not have it.
const THINNEST_ELEMENTS: usize = 6;

/// Smallest film thickness of the contact area and where it is.
///
/// Each element is sampled on a lattice; in those with the thinnest points the lattice is refined until its
/// spacing is 1e-6 of the element: derivatives of the film see that.
pub fn minimum_film(d: &Discretisation, state: &State) -> (f64, [f64; 2]) {
    let mut thinnest = thinnest_points(d, state);
    if thinnest.len() > THINNEST_ELEMENTS {
        thinnest.select_nth_unstable_by(THINNEST_ELEMENTS, |a, b| {
            a.film.total_cmp(&b.film).then(a.cell.cmp(&b.cell))
        });
        thinnest.truncate(THINNEST_ELEMENTS);
    }
    thinnest.sort_by(|a, b| a.film.total_cmp(&b.film).then(a.cell.cmp(&b.cell)));
    (thinnest.into_iter())
        .map(|start| refined(d, state, start))
        .min_by(|a, b| a.0.total_cmp(&b.0))
        .unwrap_or((f64::NAN, [0.0; 2]))
}

/// Thinnest point of an element.
#[derive(Clone, Copy, Debug)]
pub(super) struct Thinnest {
    /// Film there.
    pub film: f64,
    /// The element.
    pub cell: usize,
    /// The point in it.
    pub xi: [f64; 3],
}

/// Points per edge of the lattice on which the thinnest point of an element is searched for.
const THINNEST_LATTICE: usize = 4;

/// The thinnest point of each element on a lattice.
pub(super) fn thinnest_points(d: &Discretisation, state: &State) -> Vec<Thinnest> {
    let lattice = Lattice::new(&d.contact.deflection.element, THINNEST_LATTICE);
    let thinnest = |cell: usize| {
        let nodes = d.contact.deflection.nodes_of(cell);
        let mut best = Thinnest {
            film: f64::INFINITY,
            cell,
            xi: [0.0; 3],
        };
        for (xi, basis) in lattice.basis() {
            let mut h = state.rigid_separation;
            let mut point = [0.0; 3];
            for (value, node) in basis.iter().zip(nodes) {
                h += value * state.deflection[*node as usize];
                let place = d.contact.deflection.points[*node as usize];
                for (x, px) in point.iter_mut().zip(place) {
                    *x += value * px;
                }
            }
            h += d.contact.shape.gap.value([point[0], point[1]]);
            if h < best.film {
                (best.film, best.xi) = (h, *xi);
            }
        }
        best
    };
    (0..d.contact.n_elements()).map(thinnest).collect()
}

/// The film and the place of the thinnest point of an element, from that of the lattice.
pub(super) fn refined(d: &Discretisation, state: &State, start: Thinnest) -> (f64, [f64; 2]) {
    let start = (start.film, start.cell, start.xi);
    let (h, cell, xi) = thinnest_in(d, state, start, 0.5 / THINNEST_LATTICE as f64);
    (h, d.contact.point(cell, xi))
}

/// Shrinks a cross around a point of an element, inside which H is smooth.
fn thinnest_in(
    d: &Discretisation,
    state: &State,
    start: (f64, usize, [f64; 3]),
    mut radius: f64,
) -> (f64, usize, [f64; 3]) {
    let plane = d.contact.surface.dim == 2;
    let mut best = start;
    while radius > 1e-6 {
        let (_, cell, centre) = best;
        let mut improved = false;
        for (dx, dy) in [
            (1.0, 0.0),
            (-1.0, 0.0),
            (0.0, 1.0),
            (0.0, -1.0),
            (1.0, -1.0),
            (-1.0, 1.0),
        ] {
            let y = if plane { centre[1] + radius * dy } else { 0.0 };
            let xi = [centre[0] + radius * dx, y, 0.0];
            if xi[0] < 0.0 || xi[1] < 0.0 || xi[0] + xi[1] > 1.0 {
                continue;
            }
            let h = fields_in(d, state, cell, xi).film;
            if h < best.0 {
                best = (h, cell, xi);
                improved = true;
            }
        }
        if !improved {
            radius *= 0.5;
        }
    }
    best
}

/// Largest pressure, on a lattice of eight points per element edge, and where it is.
pub fn largest_pressure(d: &Discretisation, state: &State) -> (f64, [f64; 2]) {
    largest_pressure_where(d, state, |_| true)
}

/// Largest pressure in each element, on the same lattice, and where it is.
pub fn largest_of_elements(d: &Discretisation, state: &State) -> Vec<(f64, [f64; 2])> {
    let lattice = Lattice::new(&d.pressure.element, 8);
    (0..d.contact.n_elements())
        .map(|c| {
            let nodes = d.pressure.nodes_of(c);
            let mut best = (f64::NEG_INFINITY, [0.0; 3]);
            for (xi, basis) in lattice.basis() {
                let values = nodes.iter().map(|n| state.pressure[*n as usize]);
                let p = basis.iter().zip(values).map(|(b, v)| b * v).sum();
                if p > best.0 {
                    best = (p, *xi);
                }
            }
            (best.0, d.contact.point(c, best.1))
        })
        .collect()
}

/// Largest pressure over the places that `counts`; minus infinity where none does.
pub fn largest_pressure_where(
    d: &Discretisation,
    state: &State,
    counts: impl Fn([f64; 2]) -> bool,
) -> (f64, [f64; 2]) {
    let lattice = Lattice::new(&d.pressure.element, 8);
    let mut best = (f64::NEG_INFINITY, [0.0; 2]);
    for c in 0..d.contact.n_elements() {
        let nodes = d.pressure.nodes_of(c);
        for (xi, basis) in lattice.basis() {
            let values = nodes.iter().map(|n| state.pressure[*n as usize]);
            let p = basis.iter().zip(values).map(|(b, v)| b * v).sum();
            if p > best.0 && counts(d.contact.point(c, *xi)) {
                best = (p, d.contact.point(c, *xi));
            }
        }
    }
    best
}
