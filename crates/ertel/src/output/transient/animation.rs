//! `animation.png`: the contact at the output times.

use super::super::OutputError;
use super::super::pictures::film_unit;
use super::picture::{Scales, colour_of, coloured, film_axis, film_range};
use super::report::{at, time_unit};
use crate::run::transient::TransientSolution;
use ertel_plot::axis::Axis;
use ertel_plot::drawing::{Drawing, DrawingError};
use ertel_plot::png::animate;
use ertel_plot::{Chart, Look, PALETTE, Series, Side};

/// Maximum number of frames; of more output times, every second or third one is shown.
const MOST_FRAMES: usize = 120;
/// Image pixels per px.
const SCALE: f64 = 1.25;
/// Duration of the animation and limits of each frame, ms.
const WHOLE: usize = 6000;
const SHORTEST: usize = 50;
const LONGEST: usize = 500;

/// Extent of a centreline about the centre, in half-widths.
const REACH: f64 = 2.0;

/// Width of the frame of a map and limits of its height, px.
const WIDTH: f64 = 420.0;
const HEIGHTS: [f64; 2] = [140.0, 640.0];

/// The file; `None` without output times. Pressure and film on the centreline of a line contact; a film map for others.
///
/// # Errors
/// If a picture cannot be encoded.
pub fn animation(title: &str, found: &TransientSolution) -> Result<Option<Vec<u8>>, OutputError> {
    let fields = &found.fields;
    let n = fields.times.len();
    if n == 0 || fields.x.len() < 2 {
        return Ok(None);
    }
    let stride = n.div_ceil(MOST_FRAMES);
    let shown: Vec<usize> = (0..n).step_by(stride).collect();
    let each = (WHOLE / shown.len()).clamp(SHORTEST, LONGEST);
    let range = film_range(found);
    let highest = fields.pressure.iter().flatten().copied();
    let highest = f64::from(highest.fold(0.0, f32::max));
    let frame = |i: usize| match fields.is_line() {
        true => Ok(centreline(title, found, i, film_axis(range), highest)),
        false => map(title, found, i, range),
    };
    let frames = shown.into_iter().map(frame);
    Ok(Some(animate(frames, each as u16, SCALE)?))
}

/// *x*/*a* with the time of a frame.
fn along(found: &TransientSolution, i: usize, ends: [f64; 2]) -> Axis {
    let times = &found.fields.times;
    let unit = time_unit(times[times.len() - 1]);
    let label = format!("*x*/*a* at *t* = {}", at(times[i], unit));
    Axis::linear(&label, ends[0], ends[1])
}

fn centreline(
    title: &str,
    found: &TransientSolution,
    i: usize,
    [lowest_film, highest_film]: [f64; 2],
    highest_pressure: f64,
) -> Drawing {
    let fields = &found.fields;
    let a = found.half_width;
    let (factor, unit) = film_unit(highest_film);
    let first = (fields.x[0] / a).max(-REACH);
    let last = (fields.x[fields.x.len() - 1] / a).min(REACH);
    let mut chart = Chart::new(
        title,
        along(found, i, [first, last]),
        Axis::linear(
            &format!("Film thickness *h* ({unit}), solid"),
            factor * lowest_film,
            factor * highest_film,
        ),
    );
    chart.y_right = Some(Axis::linear_around(
        "Pressure *p* (GPa), dashed",
        [0.0, 1e-9 * highest_pressure],
    ));
    let mut series = |values: &[f32], factor: f64, look, side, colour: &str| {
        let points = fields.x.iter().zip(values);
        chart.series.push(Series {
            label: String::new(),
            points: points
                .map(|(x, value)| [x / a, factor * f64::from(*value)])
                .filter(|[x, _]| x.abs() <= 1.1 * REACH)
                .collect(),
            look,
            colour: colour.to_owned(),
            side,
        });
    };
    series(&fields.film[i], factor, Look::Line, Side::Left, PALETTE[0]);
    let pressure = &fields.pressure[i];
    series(pressure, 1e-9, Look::Dashed, Side::Right, PALETTE[1]);
    chart.drawing()
}

fn map(
    title: &str,
    found: &TransientSolution,
    i: usize,
    range: [f64; 2],
) -> Result<Drawing, DrawingError> {
    let fields = &found.fields;
    let a = found.half_width;
    let [nx, ny] = [fields.x.len(), fields.y.len()];
    let rows = fields.film[i].chunks_exact(nx).rev().flatten();
    let pixels = rows.flat_map(|film| colour_of(f64::from(*film), range));
    let [x, y] = [&fields.x, &fields.y].map(|places| [places[0] / a, places[places.len() - 1] / a]);
    let height = WIDTH * (y[1] - y[0]) / (x[1] - x[0]);
    coloured(
        title,
        [nx, ny],
        pixels.collect(),
        &Scales {
            x: along(found, i, x),
            y: Axis::linear("*y*/*a*", y[0], y[1]),
            film: range,
            height: height.clamp(HEIGHTS[0], HEIGHTS[1]),
            label: "Film thickness *h*",
        },
    )
}
