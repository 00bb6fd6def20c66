//! Temperatures along the contact, over it, and across the film.

use super::super::heat::profile_label;
use super::maps::temperature_map;
use super::profile::profile;
use super::shared::{Task, window_x};
use crate::output::figure::BODIES;
use crate::solution::{Solution, Thermal};
use crate::words::TemperatureScale;
use ertel_plot::{Axis, Chart, Look, PALETTE, Series};

/// Every picture of the temperatures of a solution.
pub fn heat_pictures<'a>(
    title: &'a str,
    solution: &'a Solution,
    thermal: &'a Thermal,
    scale: TemperatureScale,
) -> Vec<Task<'a>> {
    let mut pictures: Vec<Task> = vec![(
        "temperature",
        Box::new(move || temperature_chart(title, solution, scale).drawing()),
    )];
    let fields = (solution.elements.temperatures.as_ref()).filter(|_| !solution.shape.is_line());
    if let Some(t) = fields {
        for (name, field, place) in [
            ("temperature-mid", &t.mid, "mid-film"),
            ("temperature-body-1", &t.body_1, BODIES[0]),
            ("temperature-body-2", &t.body_2, BODIES[1]),
        ] {
            let draw = move || temperature_map(title, solution, field, place, scale);
            pictures.push((name, Box::new(draw)));
        }
    }
    if !thermal.profiles.is_empty() {
        pictures.push((
            "cross-film",
            Box::new(move || cross_film_chart(title, solution, thermal, scale).drawing()),
        ));
    }
    pictures
}

/// Temperatures at mid-film and at both surfaces, and the film average, along y = 0.
pub fn temperature_chart(title: &str, solution: &Solution, scale: TemperatureScale) -> Chart {
    let [low, high] = window_x(solution);
    let fields = (solution.elements.temperatures.iter()).flat_map(|t| {
        [
            ("mid-film", &t.mid, Look::Line, PALETTE[1]),
            ("mean of the film", &t.mean, Look::Dashed, PALETTE[1]),
            (BODIES[0], &t.body_1, Look::Line, PALETTE[0]),
            (BODIES[1], &t.body_2, Look::Line, PALETTE[2]),
        ]
    });
    let series: Vec<Series> = fields
        .map(|(label, field, look, colour)| {
            Series::new(
                label,
                (profile(solution, field, 1.0).into_iter())
                    .map(|[x, t]| [x, scale.shown(t)])
                    .collect(),
                look,
                colour,
            )
        })
        .collect();
    let shown = (series.iter())
        .flat_map(|s| s.points.iter())
        .filter(|p| (low..=high).contains(&p[0]))
        .map(|p| p[1] - scale.shown(0.0));
    let [y, other] = axes(scale, shown);
    let mut chart = Chart::new(title, Axis::linear("*x*/*a*", low, high), y);
    chart.y_other = Some(other);
    chart.series = series;
    chart
}

/// Temperature across the film at the chosen points (as in Habchi 2008, figure 5.9).
pub fn cross_film_chart(
    title: &str,
    solution: &Solution,
    thermal: &Thermal,
    scale: TemperatureScale,
) -> Chart {
    let values = thermal.profiles.iter().flat_map(|p| &p.temperature);
    let [y, other] = axes(scale, values.copied());
    let x = Axis::linear("Height over body 1 *z*/*h*", 0.0, 1.0);
    let mut chart = Chart::new(title, x, y);
    chart.y_other = Some(other);
    for (i, profile) in thermal.profiles.iter().enumerate() {
        chart.series.push(Series::new(
            profile_label(profile, solution.hertz.half_width),
            (profile.z.iter().zip(&profile.temperature))
                .map(|(z, t)| [z / profile.film_thickness, scale.shown(*t)])
                .collect(),
            if i < PALETTE.len() {
                Look::Line
            } else {
                Look::Dashed
            },
            PALETTE[i % PALETTE.len()],
        ));
    }
    chart
}

/// Axis around temperatures in K, and the axis of the other scale over the same range.
fn axes(scale: TemperatureScale, kelvin: impl Iterator<Item = f64>) -> [Axis; 2] {
    let label = |shown: TemperatureScale| format!("Temperature *T* ({})", shown.unit());
    let axis = Axis::linear_around(&label(scale), kelvin.map(|t| scale.shown(t)));
    let shift = scale.other().shown(0.0) - scale.shown(0.0);
    let other = Axis::linear(&label(scale.other()), axis.low + shift, axis.high + shift);
    [axis, other]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scale_is_that_of_the_user() {
        for (given, scale) in [
            ("40 degC", TemperatureScale::Celsius),
            ("313 K", TemperatureScale::Kelvin),
            ("104 degF", TemperatureScale::Kelvin),
        ] {
            assert_eq!(TemperatureScale::of(given), scale);
        }
    }

    /// 313.15 K is 40 °C on both axes, whichever is on the left.
    #[test]
    fn both_scales_agree_on_both_sides() {
        for scale in [TemperatureScale::Kelvin, TemperatureScale::Celsius] {
            let [own, other] = axes(scale, [313.15, 371.2].into_iter());
            for kelvin in [313.15, 371.2] {
                let at = own.position(scale.shown(kelvin));
                let opposite = other.position(scale.other().shown(kelvin));
                assert!((at - opposite).abs() < 1e-12 && (0.0..=1.0).contains(&at));
            }
        }
    }
}
