//! Maps of pressure and film thickness over the whole contact.

use super::field::{Bar, FieldMap, OtherScale};
use super::layout::Layout;
use super::sampling::{Sampling, View};
use super::shared::film_unit;
use crate::contact::Symmetry;
use crate::solution::{Polynomials, Solution};
use crate::words::{TemperatureScale, pressure_unit};
use ertel_plot::drawing::Drawing;

/// Number of colours of a continuous map.
const N_SHADES: usize = 64;
/// Margin around the contact, as a fraction of its smaller half-extent,
const MARGIN: f64 = 0.25;
/// and around the area with more than this fraction of the Hertz pressure, if that is larger.
const PRESSED: f64 = 0.05;
/// Smallest range of a temperature scale, K: below it, a map would show noise.
const LEAST_RANGE: f64 = 0.1;
/// Film maps: fine levels up to this multiple of the central film,
const FINE_UP_TO: f64 = 1.15;
/// coarse levels up to this one.
const FILM_UP_TO: f64 = 2.5;

/// Window of the maps, in half-widths: the contact, other loaded areas, and a margin.
pub(super) fn window_map(solution: &Solution) -> [[f64; 2]; 2] {
    let a = solution.hertz.half_width;
    let [along, across] = solution.shape.zone.half_extents();
    let margin = MARGIN * along.min(across);
    let surface = &solution.surface;
    let pressed = (surface.points.iter().zip(&surface.pressure))
        .filter(|(_, p)| **p > PRESSED * solution.hertz.pressure)
        .map(|(at, _)| at.map(|x| x / a));
    let (low, high, side) = pressed.fold((-along, along, across), |(l, h, s), [x, y]| {
        (l.min(x), h.max(x), s.max(y.abs()))
    });
    let ends = || solution.centreline.x.iter().map(|x| x / a);
    let first = ends().fold(f64::INFINITY, f64::min);
    let last = ends().fold(f64::NEG_INFINITY, f64::max);
    let widest = solution.shape.zone.axis_ratio * solution.extents[2];
    let side = (side + margin).min(widest.max(across));
    [
        [(low - margin).max(first), (high + margin).min(last)],
        [-side, side],
    ]
}

/// Smallest and largest value of a field within a window, times a factor.
fn range_within(
    solution: &Solution,
    field: &Polynomials,
    factor: f64,
    window: [[f64; 2]; 2],
) -> [f64; 2] {
    let samples = sampled(solution, field, factor, window, &[]);
    let is_within = |p: &[f64; 2]| (0..2).all(|k| (window[k][0]..=window[k][1]).contains(&p[k]));
    let inside = samples.points.iter().zip(&samples.values);
    (inside.filter(|(p, _)| is_within(p)))
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], (_, v)| {
            [l.min(*v), h.max(*v)]
        })
}

fn hex(gradient: colorous::Gradient, i: usize, n: usize) -> String {
    format!("#{:x}", gradient.eval_rational(i, n))
}

/// Samples of a field over the whole contact, in half-widths, for contours at these levels; the SI field is multiplied by
/// `factor`.
fn sampled(
    solution: &Solution,
    field: &Polynomials,
    factor: f64,
    window: [[f64; 2]; 2],
    levels: &[f64],
) -> Sampling {
    let view = View {
        unit: solution.hertz.half_width,
        window,
        pixel: Layout::of(window).pixel(),
        factor,
        levels,
    };
    let part = Sampling::new(&solution.elements, field, &view);
    match solution.shape.symmetry {
        Symmetry::Half => part.mirrored(),
        Symmetry::Full => part,
    }
}

/// Levels and colours between two values for a continuous map.
pub(super) fn shades(
    [low, high]: [f64; 2],
    gradient: colorous::Gradient,
) -> (Vec<f64>, Vec<String>) {
    let share = |i: usize| i as f64 / N_SHADES as f64;
    let levels = (1..N_SHADES).map(|i| low + (high - low) * share(i));
    let colours = (0..N_SHADES).map(|i| hex(gradient, i, N_SHADES));
    (levels.collect(), colours.collect())
}

/// Pressure over the whole contact, continuous colours.
pub fn pressure_map(title: &str, solution: &Solution) -> Drawing {
    let (factor, unit) = pressure_unit(solution.hertz.pressure);
    let top = factor * solution.summary.pressure_maximum.value;
    let (levels, colours) = shades([0.0, top], colorous::VIRIDIS);
    let window = window_map(solution);
    FieldMap {
        title,
        field: sampled(
            solution,
            &solution.elements.pressure,
            factor,
            window,
            &levels,
        ),
        layout: Layout::of(window),
        levels,
        colours,
        bar: Bar::Continuous([0.0, top]),
        bar_label: &format!("Pressure *p* ({unit})"),
        zone: solution.shape.zone.clone(),
        rim: "#ffffff",
        half_width: solution.hertz.half_width,
        other: None,
    }
    .drawing()
}

/// Temperature over the whole contact, continuous colours over its range; the other scale (Celsius or Kelvin) on the left
/// of the bar.
pub fn temperature_map(
    title: &str,
    solution: &Solution,
    temperature: &Polynomials,
    place: &str,
    scale: TemperatureScale,
) -> Drawing {
    let window = window_map(solution);
    let [low, high] = range_within(solution, temperature, 1.0, window);
    let bounds = [low, high.max(low + LEAST_RANGE)];
    let (levels, colours) = shades(bounds, colorous::PLASMA);
    let shown = bounds.map(|t| scale.shown(t));
    let other = scale.other();
    FieldMap {
        title,
        field: sampled(solution, temperature, 1.0, window, &levels),
        layout: Layout::of(window),
        levels,
        colours,
        bar: Bar::Continuous(shown),
        bar_label: &format!("Temperature *T*, {place} ({})", scale.unit()),
        zone: solution.shape.zone.clone(),
        rim: "#ffffff",
        half_width: solution.hertz.half_width,
        other: Some(OtherScale {
            ends: bounds.map(|t| other.shown(t)),
            units: [other.unit(), scale.unit()],
        }),
    }
    .drawing()
}

/// Film thickness over the whole contact as contours, like an interferogram: fine levels up to
/// `FINE_UP_TO` times the central film, coarse ones to `FILM_UP_TO`, white beyond.
pub fn film_map(title: &str, solution: &Solution) -> Drawing {
    let summary = &solution.summary;
    let (factor, unit) = film_unit(FILM_UP_TO * summary.film_central.value);
    let levels = film_levels(
        factor * summary.film_minimum.value,
        factor * summary.film_central.value,
    );
    let n = levels.len();
    let mut colours: Vec<String> = (0..n).map(|i| hex(colorous::VIRIDIS, i, n)).collect();
    colours.push("#ffffff".to_owned());
    let window = window_map(solution);
    let film = &solution.elements.film_thickness;
    FieldMap {
        title,
        field: sampled(solution, film, factor, window, &levels),
        layout: Layout::of(window),
        levels,
        colours,
        bar: Bar::Steps,
        bar_label: &format!("Film thickness *h* ({unit})"),
        zone: solution.shape.zone.clone(),
        rim: "#ffffff",
        half_width: solution.hertz.half_width,
        other: None,
    }
    .drawing()
}

/// Levels of a film map for the minimum and central film.
fn film_levels(minimum: f64, central: f64) -> Vec<f64> {
    let fine = ertel_plot::axis::tick_step(0.8 * central);
    let coarse = 5.0 * fine;
    let first = (minimum / fine).floor().max(0.0) as usize + 1;
    let last = ((FINE_UP_TO * central / coarse).ceil() * 5.0) as usize;
    let last_coarse = (FILM_UP_TO * central / coarse).ceil() as usize;
    let fine_levels = (first..=last).map(|i| fine * i as f64);
    let coarse_levels = (last / 5 + 1..=last_coarse).map(|i| coarse * i as f64);
    fine_levels.chain(coarse_levels).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::sample;

    /// The whole contact, and at most two and a half times its extent.
    #[test]
    fn the_frame_is_the_contact_and_a_margin() {
        for (_, solution) in [sample::circle(), sample::ellipse()] {
            let [along, across] = solution.shape.zone.half_extents();
            let [[x0, x1], [y0, y1]] = window_map(solution);
            assert!(x0 < -along && x1 > along && y0 < -across && y1 > across);
            let contact = std::f64::consts::PI * along * across;
            let share = contact / ((x1 - x0) * (y1 - y0));
            assert!(share > 1.0 / 3.5, "{}: {share}", solution.kind.name());
        }
    }

    /// The scale covers exactly the values in the frame.
    #[test]
    fn colours_cover_the_data_in_the_frame() {
        let (_, solution) = sample::circle();
        let window = window_map(solution);
        let film = &solution.elements.film_thickness;
        let [low, high] = range_within(solution, film, 1e9, window);
        let a = solution.hertz.half_width;
        let surface = &solution.surface;
        // From the nodes in the frame, and in a frame wider by about an element.
        let of_nodes = |wider: f64| {
            let inside = (surface.points.iter().zip(&surface.film_thickness)).filter(|(p, _)| {
                (0..2).all(|k| (window[k][0] - wider..=window[k][1] + wider).contains(&(p[k] / a)))
            });
            inside.fold((f64::INFINITY, 0.0_f64), |(l, h), (_, v)| {
                (l.min(1e9 * v), h.max(1e9 * v))
            })
        };
        let ((least, most), (_, beyond)) = (of_nodes(0.0), of_nodes(0.5));
        let within = 0.02 * (most - least);
        assert!((low - least).abs() < within, "{low} {least}");
        assert!(
            high >= most - within && high < beyond,
            "{high} {most} {beyond}"
        );
    }

    /// Central film 245 nm, minimum 107 nm: every 20 nm up to 300, then every 100 to 700 nm.
    #[test]
    fn film_levels_are_round_and_close_inside_the_contact() {
        let expected: Vec<f64> = (6..=15)
            .map(|i| 20.0 * f64::from(i))
            .chain([400.0, 500.0, 600.0, 700.0])
            .collect();
        assert_eq!(film_levels(107.0, 245.0), expected);
    }
}
