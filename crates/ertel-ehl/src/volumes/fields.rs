//! Fields of a film on patches for output, in SI.

use super::composite::Composite;
use super::film::{PatchedFilm, node_fields};
use super::grid::Grid;
use crate::contact::Shape;
use crate::engine::{Film, PointFields, Problem, Profile};
use crate::post::fields::surface_of;
use crate::post::thermal::temperatures;
use crate::solution::{ElementFields, Polynomials, SurfaceField, TemperaturePolynomials};

/// The centreline: at the distance of the nodes of each grid, as far as the next one goes.
pub fn profile(film: &PatchedFilm) -> Profile {
    let mut places: Vec<f64> = Vec::new();
    for level in film.levels().iter().rev() {
        let grid = &level.system.grid;
        let [low, high] = along_motion(grid);
        let h = grid.spacing[0];
        let steps = (low / h).ceil() as i64..=(high / h).floor() as i64;
        let own: Vec<f64> = steps.map(|n| n as f64 * h).collect();
        let ends = places.first().copied().zip(places.last().copied());
        let beyond = |x: &f64, side: f64| match ends {
            None => side < 0.0,
            Some((first, _)) if side < 0.0 => *x < first - 0.5 * h,
            Some((_, last)) => *x > last + 0.5 * h,
        };
        let before = own.iter().copied().filter(|x| beyond(x, -1.0));
        let after = own.iter().copied().filter(|x| beyond(x, 1.0));
        places = before.chain(places.iter().copied()).chain(after).collect();
    }
    let mut profile = Profile::default();
    for x in places {
        if let Some(fields) = film.at([x, 0.0]) {
            profile.x.push(x);
            profile.fields.push(fields);
        }
    }
    profile
}

/// How far a grid reaches along the line through its centre in the direction of motion.
fn along_motion(grid: &Grid) -> [f64; 2] {
    let direction = grid.turn.to_axes([1.0, 0.0]);
    let mut reach = [f64::NEG_INFINITY, f64::INFINITY];
    for d in 0..2 {
        // The rows of a half end at the line itself.
        if direction[d] == 0.0 {
            continue;
        }
        let ends = (grid.ends(d)).map(|n| n as f64 * grid.spacing[d] / direction[d]);
        reach[0] = reach[0].max(ends[0].min(ends[1]));
        reach[1] = reach[1].min(ends[0].max(ends[1]));
    }
    reach
}

/// Fields at the nodes of all grids together.
pub fn nodes(shape: &Shape, film: &PatchedFilm) -> Vec<PointFields> {
    let mesh = Composite::new(film.levels());
    (mesh.nodes.iter())
        .map(|(l, [i, j])| node_fields(shape, &film.levels()[*l], *i, *j))
        .collect()
}

/// Fields at the nodes of all grids together, with triangles between them, or segments in line contacts.
pub fn surface<Plan>(problem: &Problem<Plan>, film: &PatchedFilm) -> (SurfaceField, ElementFields) {
    let mesh = Composite::new(film.levels());
    let points: Vec<PointFields> = (mesh.nodes.iter())
        .map(|(l, [i, j])| node_fields(&problem.shape, &film.levels()[*l], *i, *j))
        .collect();
    let dim = problem.shape.dim;
    let of_cell = |cell: &[u32; 3]| cell.iter().copied().take(dim + 1).collect::<Vec<u32>>();
    let corners: Vec<u32> = mesh.cells.iter().flat_map(of_cell).collect();
    let surface = SurfaceField {
        cells: mesh.cells.clone(),
        order: 1,
        elements: corners.clone(),
        ..surface_of(
            &points,
            &problem.shape,
            problem.friction_fluid(),
            &problem.scales,
        )
    };
    let linear = |values: &[f64]| Polynomials {
        order: 1,
        values: corners.iter().map(|node| values[*node as usize]).collect(),
    };
    let elements = ElementFields {
        dim,
        vertices: surface.points.clone(),
        cells: mesh.cells,
        pressure: linear(&surface.pressure),
        film_thickness: linear(&surface.film_thickness),
        temperatures: (problem.fluid.nodes())
            .filter(|_| points.iter().all(|point| point.temperature.is_some()))
            .map(|nodes| {
                let at_nodes = temperatures(nodes, &points);
                TemperaturePolynomials {
                    mid: linear(&at_nodes.mid),
                    mean: linear(&at_nodes.mean),
                    body_1: linear(&at_nodes.body_1),
                    body_2: linear(&at_nodes.body_2),
                }
            }),
    };
    (surface, elements)
}
