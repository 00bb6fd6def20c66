//! Films and pressures that are looked for over the contact area: at its centre, smallest, largest; dimensionless.

use ertel_fem::element::Lagrange;

use crate::solve::discretisation::Discretisation;
use crate::solve::points::{fields_at, fields_in, film_of};
use crate::solve::state::State;
use crate::solve::tuning::meshes::{THINNEST_ELEMENTS, THINNEST_LATTICE};

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

/// Smallest film thickness of the contact area and where it is.
///
/// Each element is sampled on a lattice; in those with the thinnest points the lattice is refined until its
/// spacing is 1e-6 of the element: derivatives of the film resolve that.
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

/// The thinnest point of each element on a lattice.
pub(super) fn thinnest_points(d: &Discretisation, state: &State) -> Vec<Thinnest> {
    let lattice = Lattice::new(&d.contact.deflection.element, THINNEST_LATTICE);
    let thinnest = |cell: usize| {
        let mut best = Thinnest {
            film: f64::INFINITY,
            cell,
            xi: [0.0; 3],
        };
        for (xi, basis) in lattice.basis() {
            let (_, h) = film_of(d, state, cell, basis);
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
