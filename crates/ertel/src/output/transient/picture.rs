//! Films and conditions over time, and the film over position and time.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use super::super::OutputError;
use super::super::pictures::{draw_ticks, film_unit};
use super::report::time_unit;
use crate::run::transient::{InstantSolution, TransientSolution};
use crate::solution::Figure;
use crate::words::force_unit;
use ertel_plot::axis::Axis;
use ertel_plot::drawing::{
    Anchor, Drawing, DrawingError, INK, LABEL_SIZE, Raster, Stroke, TICK_SIZE, text_width,
};
use ertel_plot::frame::{FRAME_WIDTH, Frame, label_x_axis, label_y_axis};
use ertel_plot::png::encode;
use ertel_plot::{Chart, Look, PALETTE, Series, Side};

/// Central and minimum film over time. On the right, dashed: entrainment speed and load if they change, normalised by their maxima if both do, or the film force if a body moves by inertia.
pub fn film_over_time(title: &str, found: &TransientSolution, is_line: bool) -> Chart {
    let instants = &found.instants;
    let film = |instant: &InstantSolution, figure| instant.measured.estimate(figure).value;
    let largest = (instants.iter())
        .map(|instant| film(instant, Figure::FilmCentral))
        .fold(0.0, f64::max);
    let (factor, unit) = film_unit(largest);
    let last = instants.last().map_or(0.0, |instant| instant.time);
    let (per_second, time) = time_unit(last);
    let series =
        |label: &str, colour: &str, look, side, value: &dyn Fn(&InstantSolution) -> f64| Series {
            label: label.to_owned(),
            points: (instants.iter())
                .map(|instant| [per_second * instant.time, value(instant)])
                .collect(),
            look,
            colour: colour.to_owned(),
            side,
        };
    let films = [
        (Figure::FilmCentral, PALETTE[0]),
        (Figure::FilmMinimum, PALETTE[1]),
    ]
    .map(|(figure, colour)| {
        series(figure.words(), colour, Look::Line, Side::Left, &|instant| {
            factor * film(instant, figure)
        })
    });
    let speed = |instant: &InstantSolution| 0.5 * (instant.speeds[0] + instant.speeds[1]);
    let heights = films.iter().flat_map(|s| &s.points).map(|point| point[1]);
    let mut chart = Chart::new(
        title,
        Axis::linear(&format!("Time *t* ({time})"), 0.0, per_second * last),
        Axis::linear_around(
            &format!("Film thickness *h* ({unit})"),
            heights.chain([0.0]),
        ),
    );
    chart.series = films.to_vec();
    let largest_force = (instants.iter()).fold(0.0, |m: f64, i| m.max(i.load).max(i.film_force));
    let (per_force, force_unit) = force_unit(largest_force, is_line);
    let load = |instant: &InstantSolution| per_force * instant.load;
    let label = format!("Load ({force_unit})");
    let courses: [Course<'_>; 2] = [
        ("entrainment speed", "Entrainment speed (m/s)", &speed),
        ("load", &label, &load),
    ];
    let changing: Vec<Course<'_>> = (courses.into_iter())
        .filter(|(_, _, value)| instants.windows(2).any(|w| value(&w[0]) != value(&w[1])))
        .collect();
    if found.moves() {
        let force = |instant: &InstantSolution| per_force * instant.film_force;
        let forces = with_room(instants.iter().map(force).chain([0.0]));
        let label = format!("Film force ({force_unit})");
        chart.y_right = Some(Axis::linear_around(&label, forces));
        chart.series.push(series(
            "film force",
            PALETTE[2],
            Look::Dashed,
            Side::Right,
            &force,
        ));
    } else if !changing.is_empty() {
        let mut shown = vec![0.0];
        for ((name, _, value), colour) in changing.iter().zip(&PALETTE[2..]) {
            let largest = (instants.iter()).fold(0.0, |m: f64, i| m.max(value(i).abs()));
            let unit = if changing.len() > 1 { largest } else { 1.0 };
            let own = series(name, colour, Look::Dashed, Side::Right, &|i| {
                value(i) / unit
            });
            shown.extend(own.points.iter().map(|point| point[1]));
            chart.series.push(own);
        }
        let label = match changing[..] {
            [(_, label, _)] => label,
            _ => "Speed and load over their largest",
        };
        chart.y_right = Some(Axis::linear_around(label, with_room(shown)));
    }
    chart
}

/// Values and a margin above them, to keep a curve at its maximum off the frame.
fn with_room(values: impl IntoIterator<Item = f64>) -> impl Iterator<Item = f64> {
    values.into_iter().map(|value| 1.05 * value)
}

/// Name and axis of a quantity over time, and its value at an instant.
type Course<'a> = (&'a str, &'a str, &'a dyn Fn(&InstantSolution) -> f64);

/// Frame of the map, px, its pixels along time, and those of the colour bar.
const WIDTH: f64 = 420.0;
const HEIGHT: f64 = 330.0;
const ROWS: usize = 330;
const BAR: f64 = 16.0;

/// Films above this multiple of the largest central film have the last colour.
const UP_TO: f64 = 1.5;

/// The film on the centreline over position and time; `None` with a single instant.
///
/// # Errors
/// If the image cannot be encoded.
pub fn map_of_film(title: &str, found: &TransientSolution) -> Result<Option<Drawing>, OutputError> {
    let (instants, map) = (&found.instants, &found.map);
    let last = instants.last().map_or(0.0, |instant| instant.time);
    let n = map.x.len();
    if instants.len() < 2 || n < 2 || last <= 0.0 {
        return Ok(None);
    }
    let [low, high] = film_range(found);
    let mut pixels = Vec::with_capacity(3 * n * ROWS);
    for row in 0..ROWS {
        // Time increases upwards.
        let time = last * (ROWS - row) as f64 / ROWS as f64 - 0.5 * last / ROWS as f64;
        let after = instants
            .partition_point(|instant| instant.time < time)
            .clamp(1, instants.len() - 1);
        let [t0, t1] = [after - 1, after].map(|i| instants[i].time);
        let share = ((time - t0) / (t1 - t0)).clamp(0.0, 1.0);
        for i in 0..n {
            let [a, b] = [after - 1, after].map(|k| f64::from(map.films[k][i]));
            let film = a + share * (b - a);
            pixels.extend(colour_of(film, [low, high]));
        }
    }
    let (per_second, unit) = time_unit(last);
    let a = found.half_width;
    let drawing = coloured(
        title,
        [n, ROWS],
        pixels,
        &Scales {
            x: Axis::linear("*x*/*a*", map.x[0] / a, map.x[n - 1] / a),
            y: Axis::linear(&format!("Time *t* ({unit})"), 0.0, per_second * last),
            film: [low, high],
            height: HEIGHT,
            label: "Film thickness *h* on the centreline",
        },
    )?;
    Ok(Some(drawing))
}

/// Axes of a map and the film range of its colours, m.
pub(super) struct Scales<'a> {
    pub x: Axis,
    pub y: Axis,
    pub film: [f64; 2],
    /// Height of the frame, px.
    pub height: f64,
    /// Label of the film.
    pub label: &'a str,
}

/// A film map in colours, rows of pixels from the top, with axes and a colour bar.
pub(super) fn coloured(
    title: &str,
    [n, rows]: [usize; 2],
    pixels: Vec<u8>,
    scales: &Scales<'_>,
) -> Result<Drawing, DrawingError> {
    let png = encode(n as u32, rows as u32, &pixels, None)?;
    let (x, y, height) = (&scales.x, &scales.y, scales.height);
    let [low, high] = scales.film;
    let (factor, film_unit) = film_unit(high);
    let frame = Frame {
        left: 66.0,
        top: 16.0,
        width: WIDTH,
        height,
    };
    let bar = Frame {
        left: frame.left + WIDTH + 22.0,
        top: frame.top,
        width: BAR,
        height,
    };
    let scale = Axis::linear("", factor * low, factor * high);
    let ticks = scale.ticks();
    let widest = ticks
        .iter()
        .map(|t| text_width(&t.1, TICK_SIZE))
        .fold(0.0, f64::max);
    let mut drawing = Drawing::new(
        bar.left + BAR + widest + 40.0,
        frame.top + height + 52.0,
        title,
    );
    let image = Raster {
        width: n,
        height: rows,
        pixels,
        png: STANDARD.encode(png),
    };
    drawing.image([frame.left, frame.top, WIDTH, height], image);
    drawing.stroke(&frame.outline(), Stroke::solid(INK, FRAME_WIDTH));
    label_x_axis(&mut drawing, frame, x, false);
    draw_ticks(&mut drawing, [frame; 2], x, y);
    label_y_axis(&mut drawing, frame, y, Side::Left, INK);
    for i in 0..ROWS {
        let share = (ROWS - i) as f64 / ROWS as f64;
        let colour = colorous::VIRIDIS.eval_continuous(share);
        let top = bar.top + height * (1.0 - share);
        drawing.rectangle(
            bar.left,
            top,
            BAR,
            bar.top + height - top,
            &format!("#{colour:x}"),
        );
    }
    drawing.stroke(&bar.outline(), Stroke::solid(INK, 0.7));
    for (value, label) in ticks {
        let y = bar.top + (1.0 - scale.position(value)) * height;
        drawing.text(
            [bar.left + BAR + 7.0, y + 4.2],
            &label,
            TICK_SIZE,
            Anchor::Start,
            INK,
        );
    }
    let at = [bar.left + BAR + widest + 26.0, bar.top + 0.5 * height];
    let label = format!("{} ({film_unit})", scales.label);
    drawing.turned_text(at, &label, LABEL_SIZE, Anchor::Middle, INK, -90.0);
    Ok(drawing)
}

/// Colour of a film within the scale.
pub(super) fn colour_of(film: f64, [low, high]: [f64; 2]) -> [u8; 3] {
    let at = ((film - low) / (high - low)).clamp(0.0, 1.0);
    let colour = colorous::VIRIDIS.eval_continuous(at);
    [colour.r, colour.g, colour.b]
}

/// Axis limits for films on a centreline, m, from the range of all.
pub(in crate::output) fn film_axis([low, high]: [f64; 2]) -> [f64; 2] {
    [0.9 * low, high]
}

/// The film range of the colours, m: from the smallest film to a multiple of the largest central one.
pub(in crate::output) fn film_range(found: &TransientSolution) -> [f64; 2] {
    let of = |figure| {
        (found.instants.iter()).map(move |instant| instant.measured.estimate(figure).value)
    };
    let high = UP_TO * of(Figure::FilmCentral).fold(0.0, f64::max);
    let low = of(Figure::FilmMinimum).fold(high, f64::min).max(0.0);
    [low, high]
}
