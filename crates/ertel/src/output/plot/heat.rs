//! Temperatures: along the contact, over it, and across the film.

use super::super::heat::profile_label;
use super::maps::temperature_map;
use super::{Axis, Chart, Look, PALETTE, Series, Side, Task, profile, window_x};
use crate::output::BODIES;
use crate::solution::{Polynomials, Solution, Thermal};

/// Least range of a colour scale, K: below it, a map would show noise.
const LEAST_RANGE: f64 = 0.1;

/// Every picture of the temperatures of a solution.
pub fn heat_pictures<'a>(
    title: &'a str,
    solution: &'a Solution,
    thermal: &'a Thermal,
) -> Vec<Task<'a>> {
    let mut pictures: Vec<Task> = vec![(
        "temperature",
        Box::new(|| temperature_chart(title, solution).svg()),
    )];
    let fields =
        (solution.elements.temperatures.as_ref()).filter(|_| solution.shape.kind.is_point());
    if let Some(t) = fields {
        let range = |fields: &[&Polynomials]| {
            let values = fields.iter().flat_map(|f| f.values.iter().copied());
            let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| {
                (l.min(v), h.max(v))
            });
            [low, high.max(low + LEAST_RANGE)]
        };
        // Both surfaces by one scale: which of them is the hotter one is seen.
        let walls = range(&[&t.plane, &t.ball]);
        for (name, field, place, range) in [
            ("temperature-mid", &t.mid, "mid-film", range(&[&t.mid])),
            ("temperature-body-1", &t.plane, BODIES[0], walls),
            ("temperature-body-2", &t.ball, BODIES[1], walls),
        ] {
            let label = format!("Temperature *T*, {place} (K)");
            let draw = move || temperature_map(title, solution, field, &label, range);
            pictures.push((name, Box::new(draw)));
        }
    }
    if !thermal.profiles.is_empty() {
        pictures.push((
            "cross-film",
            Box::new(|| cross_film_chart(title, solution, thermal).svg()),
        ));
    }
    pictures
}

/// Temperatures at mid-film, of both surfaces, and across the film on average, along y = 0.
pub fn temperature_chart(title: &str, solution: &Solution) -> Chart {
    let [low, high] = window_x(solution);
    let fields = (solution.elements.temperatures.iter()).flat_map(|t| {
        [
            ("mid-film", &t.mid, Look::Line, PALETTE[1]),
            ("mean of the film", &t.mean, Look::Dashed, PALETTE[1]),
            (BODIES[0], &t.plane, Look::Line, PALETTE[0]),
            (BODIES[1], &t.ball, Look::Line, PALETTE[2]),
        ]
    });
    let series: Vec<Series> = fields
        .map(|(label, field, look, colour)| Series {
            label: label.into(),
            points: profile(solution, field, 1.0),
            look,
            colour: colour.into(),
            side: Side::Left,
        })
        .collect();
    let shown = (series.iter())
        .flat_map(|s| s.points.iter())
        .filter(|p| (low..=high).contains(&p[0]))
        .map(|p| p[1]);
    let mut chart = Chart::new(
        title,
        Axis::linear("*x*/*a*", low, high),
        Axis::linear_around("Temperature *T* (K)", shown),
    );
    chart.series = series;
    chart
}

/// Temperature across the film at the chosen points (as in Habchi 2008, figure 5.9).
pub fn cross_film_chart(title: &str, solution: &Solution, thermal: &Thermal) -> Chart {
    let values = thermal.profiles.iter().flat_map(|p| &p.temperature);
    let mut chart = Chart::new(
        title,
        Axis::linear("Height over body 1 *z*/*h*", 0.0, 1.0),
        Axis::linear_around("Temperature *T* (K)", values.copied()),
    );
    for (i, profile) in thermal.profiles.iter().enumerate() {
        chart.series.push(Series {
            label: profile_label(profile, solution.hertz.half_width),
            points: (profile.z.iter().zip(&profile.temperature))
                .map(|(z, t)| [z / profile.film_thickness, *t])
                .collect(),
            look: if i < PALETTE.len() {
                Look::Line
            } else {
                Look::Dashed
            },
            colour: PALETTE[i % PALETTE.len()].into(),
            side: Side::Left,
        });
    }
    chart
}
