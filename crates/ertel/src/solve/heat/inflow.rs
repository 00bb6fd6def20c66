//! Temperatures that are prescribed: where bodies and lubricant enter, and at the bottom of the bodies.

use super::space::HeatSpace;
use crate::contact::Symmetry;
use crate::film::FilmFluid;
use crate::film::cross_film::CrossFilm;
use crate::forms::energy::{FilmPlace, Heat, film_column};
use crate::solve::discretisation::{ContactSurface, Discretisation};
use crate::solve::system::State;

/// Which temperatures are prescribed: those at the bottom of the bodies, and those with which bodies and
/// lubricant enter.
pub(super) fn prescribed(
    d: &Discretisation,
    space: &HeatSpace,
    fluid: &FilmFluid,
    heat: &Heat,
    state: &State,
) -> Vec<bool> {
    let column = &space.column;
    let n = column.n();
    let mut fixed = vec![false; space.n()];
    let mut rule = CrossFilm::default();
    for (node, point) in space.surface.points.iter().enumerate() {
        let own = &mut fixed[node * n..(node + 1) * n];
        for body in 0..2 {
            own[column.bottom(body)] = true;
        }
        let Some(outward) = outward(&d.contact, *point) else {
            continue;
        };
        let walls = [column.first, column.first + column.film.n() - 1];
        for (body, law) in heat.bodies.iter().enumerate() {
            if outward[0] * law.velocity <= 0.0 {
                own[column.body_range(body)].fill(true);
            }
        }
        let inward = film_velocities(
            d,
            space,
            fluid,
            heat,
            state,
            [point[0], point[1]],
            &mut rule,
        );
        for (m, u) in inward.iter().enumerate() {
            let unknown = column.first + m;
            if outward[0] * u[0] + outward[1] * u[1] < 0.0 && !walls.contains(&unknown) {
                own[unknown] = true;
            }
        }
    }
    fixed
}

/// Direction in which the outside lies from a point of an edge that the motion crosses, along and across the motion.
fn outward(contact: &ContactSurface, [x, y, _]: [f64; 3]) -> Option<[f64; 2]> {
    let (e, shape) = (&contact.extents, &contact.shape);
    let tiny = 1e-9 * (e.outlet - e.inlet);
    let [x, y] = shape.zone.unit([x, y]);
    let normal = if x < e.inlet + tiny {
        [-1.0, 0.0]
    } else if x > e.outlet - tiny {
        [1.0, 0.0]
    } else if shape.symmetry == Symmetry::Half || y.abs() < e.side - tiny {
        return None;
    } else {
        [0.0, y.signum()]
    };
    Some(shape.zone.turn.to_motion(normal))
}

/// Velocity, over the entrainment speed, at the film's nodes over a point.
fn film_velocities(
    d: &Discretisation,
    space: &HeatSpace,
    fluid: &FilmFluid,
    heat: &Heat,
    state: &State,
    point: [f64; 2],
    rule: &mut CrossFilm,
) -> Vec<[f64; 2]> {
    let column = &space.column;
    let Some(f) = crate::solve::evaluate::fields_at(d, state, point) else {
        return vec![[0.0; 2]; column.film.n()];
    };
    let place = FilmPlace {
        pressure: f.pressure,
        pressure_gradient: f.pressure_gradient,
        film: f.film,
        temperature: f
            .temperature
            .expect("a discretisation with heat")
            .temperature,
        held_conductance: None,
    };
    let film = film_column(fluid, heat, &column.heights, &place, rule);
    // at the height next to each node
    let s = column.heights.points();
    let nearest = |node: &f64| {
        let distance = |k: &usize| (s[*k] - node).abs();
        (0..s.len())
            .min_by(|a, b| distance(a).total_cmp(&distance(b)))
            .unwrap_or(0)
    };
    let nodes = column.film.points().iter();
    nodes
        .map(|node| film.heights[nearest(node)].velocity)
        .collect()
}
