//! Wear over the sliding distance, and the worn depth.

use super::super::figure::BODIES;
use super::shared::film_unit;
use crate::solution::{Solution, Wear, WearStep};
use ertel_plot::{Axis, Chart, Drawing, Look, PALETTE, Series, Side, side_by_side};

/// Depth with film, and load of the asperities with friction, over the sliding distance; depth over the place.
pub(super) fn picture(title: &str, solution: &Solution, wear: &Wear) -> Drawing {
    let over = |label: &str, colour: &str, side, value: &dyn Fn(&WearStep) -> f64| Series {
        label: label.to_owned(),
        points: (wear.course.iter())
            .map(|at| [at.sliding_distance, value(at)])
            .collect(),
        look: if side == Side::Left {
            Look::Line
        } else {
            Look::Dashed
        },
        colour: colour.to_owned(),
        side,
    };
    let deepest = wear
        .bodies()
        .fold(0.0, |m: f64, (_, body)| m.max(body.depth.value));
    let (per_depth, depth_unit) = film_unit(deepest);
    let axis = || Axis::linear("Sliding distance *s* (m)", 0.0, wear.sliding_distance);
    let films = |at: &WearStep| [at.film_central, at.film_minimum];
    let thickest = wear
        .course
        .iter()
        .flat_map(films)
        .fold(0.0, |m: f64, h| m.max(h.abs()));
    let (per_film, unit) = film_unit(thickest);
    let mut depth = Chart::new(
        title,
        axis(),
        Axis::linear_around(
            &format!("Largest worn depth, trend ({depth_unit})"),
            [0.0, per_depth * deepest],
        ),
    );
    let heights = wear.course.iter().flat_map(films).map(|h| per_film * h);
    depth.y_right = Some(Axis::linear_around(
        &format!("Film thickness *h* ({unit})"),
        heights,
    ));
    let of = |n: usize, at: &WearStep| [at.body_1_depth, at.body_2_depth][n - 1].unwrap_or(0.0);
    for (n, _) in wear.bodies() {
        let value = |at: &WearStep| per_depth * of(n, at);
        depth
            .series
            .push(over(BODIES[n - 1], PALETTE[n - 1], Side::Left, &value));
    }
    depth
        .series
        .push(over("central film", PALETTE[2], Side::Right, &|at| {
            per_film * at.film_central
        }));
    depth
        .series
        .push(over("minimum film", PALETTE[3], Side::Right, &|at| {
            per_film * at.film_minimum
        }));
    let mut load = Chart::new(
        title,
        axis(),
        Axis::linear("Load on asperities (%)", 0.0, 100.0),
    );
    load.series
        .push(over("load on asperities", PALETTE[0], Side::Left, &|at| {
            100.0 * at.asperity_load_share
        }));
    let friction = |at: &WearStep| at.friction_total.map(f64::abs);
    if let Some(all) = wear
        .course
        .iter()
        .map(friction)
        .collect::<Option<Vec<f64>>>()
    {
        load.y_right = Some(Axis::linear_around(
            "Friction coefficient",
            all.into_iter().chain([0.0]),
        ));
        load.series
            .push(over("total friction", PALETTE[1], Side::Right, &|at| {
                friction(at).unwrap_or(0.0)
            }));
    }
    let a = solution.hertz.half_width;
    let mut profile = Chart::new(
        title,
        Axis::linear_around(
            match solution.shape.is_line() {
                true => "*x*/*a*",
                false => "*x*/*a*, *y*/*a*",
            },
            wear.bodies()
                .flat_map(|(_, body)| body.profiles.iter().flatten().map(move |[x, _]| x / a)),
        ),
        Axis::linear_around(
            &format!("Worn depth, trend ({depth_unit})"),
            [0.0, per_depth * deepest],
        ),
    );
    for (n, body) in wear.bodies() {
        for (i, points) in body
            .profiles
            .iter()
            .enumerate()
            .filter(|(_, points)| !points.is_empty())
        {
            profile.series.push(Series {
                label: format!("{}, {}", BODIES[n - 1], ["along", "across"][i]),
                points: points.iter().map(|[x, d]| [x / a, per_depth * d]).collect(),
                look: [Look::Line, Look::Dashed][i],
                colour: PALETTE[n - 1].into(),
                side: Side::Left,
            });
        }
    }
    let charts = match profile.series.is_empty() {
        true => vec![depth, load],
        false => vec![depth, load, profile],
    };
    side_by_side(title, &charts, charts.len())
}
