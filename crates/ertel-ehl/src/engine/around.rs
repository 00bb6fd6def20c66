//! Oil between the edge of the contact area and the end of the bodies: sheared by the sliding surfaces, without pressure.
//!
//! ```text
//!   H = H_0 + G,   θ = 1 before the contact, (H_0 + G at the closest place)/H behind it
//! ```
//! Around a point contact the force of sliding grows with the logarithm of the distance, the moment of spin with its square: where the contact area ends before the bodies, its edge
//! must not determine them. Before a line the force grows with 1/x from the edge on, behind it with 1/x³. Oil streams behind the contact are those of finite volumes (`volumes/behind.rs`).
//!
//! Theory: Traction and heat.

use std::f64::consts::PI;

use super::region::Region;
use super::{Film, Point, PointFields, Problem};
use crate::contact::{Inlet, Outline, Symmetry};

/// Rays around a contact, and points along each; their distances grow by the same factor from point to point.
const RAYS: usize = 128;
const POINTS: usize = 24;

/// Bisections by which a ray finds the edge of the contact area: to 1e-9 of its length.
const BISECTIONS: usize = 30;

/// Strips along which the oil before and behind a roller is summed.
const STRIPS: usize = 64;

/// Points between the contact area of a film and the end of the bodies; none around starved contacts, whose oil is known.
pub fn around<Plan>(problem: &Problem<Plan>, film: &impl Film) -> Vec<Point> {
    let shape = &problem.shape;
    if shape.inlet != Inlet::Flooded || !problem.fluid.slides() || !shape.ends[0].is_finite() {
        return Vec::new();
    }
    match shape.outline() {
        Outline::Ellipse if shape.ends[1].is_finite() => rays(problem, film),
        Outline::Ellipse => Vec::new(),
        Outline::Strip => strip(problem, film, 0.0, 1.0),
        Outline::Roller(roller) => {
            let half = roller.half_length();
            let length = match shape.symmetry {
                Symmetry::Half => half,
                Symmetry::Full => 2.0 * half,
            };
            let width = length / STRIPS as f64;
            (0..STRIPS)
                .flat_map(|n| strip(problem, film, (n as f64 + 0.5) * width - half, width))
                .collect()
        }
    }
}

/// Share of the way to the end of the bodies at which the contact area ends.
fn edge(film: &impl Film, place: impl Fn(f64) -> [f64; 2]) -> f64 {
    if film.covers(place(1.0)) {
        return 1.0;
    }
    let (mut inside, mut outside) = (0.0, 1.0);
    for _ in 0..BISECTIONS {
        let middle = 0.5 * (inside + outside);
        match film.covers(place(middle)) {
            true => inside = middle,
            false => outside = middle,
        }
    }
    inside
}

/// Distances from an edge to the end, 1, with the lengths that they represent.
fn beyond(edge: f64) -> impl Iterator<Item = (f64, f64)> {
    let step = -edge.max(f64::MIN_POSITIVE).ln() / POINTS as f64;
    (0..POINTS).filter(move |_| step > 0.0).map(move |n| {
        let r = edge * (step * (n as f64 + 0.5)).exp();
        (r, r * step)
    })
}

/// Around a point contact, along rays.
fn rays<Plan>(problem: &Problem<Plan>, film: &impl Film) -> Vec<Point> {
    let (shape, ends) = (&problem.shape, problem.shape.ends);
    let Some(centre) = film.at([0.0; 2]) else {
        return Vec::new();
    };
    let separation = centre.film - centre.gap - centre.deflection;
    let shorter = Region::of(shape).shorter(shape);
    let turn = 2.0 * PI / RAYS as f64;
    let rays = match shape.symmetry {
        Symmetry::Half => RAYS / 2,
        Symmetry::Full => RAYS,
    };
    let of_ray = |ray: usize| {
        let (sin, cos) = (-PI + turn * (ray as f64 + 0.5)).sin_cos();
        let place =
            move |r: f64| (shape.gap.turn).to_motion([r * ends[0] * cos, r * ends[1] * sin]);
        beyond(edge(film, place)).filter_map(move |(r, length)| {
            let fields = sheared(problem, place(r), separation);
            // Next to a thin film the deflection, neglected here, still opens the gap.
            (fields.film > 0.0).then(|| Point {
                area: ends[0] * ends[1] * r * length * turn,
                within: [1.0, inside(&shorter, fields.place)],
                in_zone: false,
                fields,
            })
        })
    };
    (0..rays).flat_map(of_ray).collect()
}

/// 1 within a region, 0 outside.
fn inside(region: &Region, place: [f64; 2]) -> f64 {
    let [x, y] = region.unit(place);
    f64::from(u8::from(x.hypot(y) <= 1.0))
}

/// Before and behind a line or a strip of a roller at y: the surfaces continue from the edges as parabolas, and the oil behind the film is that which leaves the contact area.
fn strip<Plan>(problem: &Problem<Plan>, film: &impl Film, y: f64, width: f64) -> Vec<Point> {
    let (shape, end) = (&problem.shape, problem.shape.ends[0]);
    let shorter = Region::of(shape).shorter(shape);
    let of_side = |side: f64| {
        let place = move |r: f64| [side * r * end, y];
        let edge = edge(film, place);
        let at_edge = film.at(place(edge));
        beyond(edge).filter_map(move |(r, length)| {
            let from = at_edge.as_ref()?;
            let [x, _] = place(r);
            let height = from.film + 0.5 * (x * x - from.place[0] * from.place[0]);
            let content = match side > 0.0 {
                true => from.film - from.missing,
                false => height,
            };
            Some(Point {
                area: end * length * width,
                within: [1.0, f64::from(u8::from(x.abs() <= shorter.along()))],
                in_zone: false,
                fields: PointFields {
                    place: [x, y],
                    film: height,
                    missing: height - content,
                    ..PointFields::default()
                },
            })
        })
    };
    [-1.0, 1.0].into_iter().flat_map(of_side).collect()
}

/// Fields at a place far from the contact.
fn sheared<Plan>(problem: &Problem<Plan>, place: [f64; 2], separation: f64) -> PointFields {
    let gap = &problem.shape.gap;
    let [u, v] = problem.entrainment.at(place);
    let height = gap.value(place);
    let film = separation + height;
    let since = gap.since_closest(place, [u, v]);
    let closest = gap.value([place[0] - since * u, place[1] - since * v]);
    let missing = match since > 0.0 {
        true => film - (separation + closest).max(0.0).min(film),
        false => 0.0,
    };
    PointFields {
        place,
        gap: height,
        film,
        missing,
        ..PointFields::default()
    }
}
