//! Maps of pressure and film thickness over the whole contact.

use super::super::surface::{full_surface, sources};
use super::field::{Bar, FieldMap};
use super::{axis, film_unit, pressure_unit, window_x};
use crate::solution::Solution;

/// Colours of a map that shall look continuous.
const N_SHADES: usize = 64;
/// Share of the largest rise of the film's temperature that counts as cold,
const COLD: f64 = 0.05;
/// and half-widths shown around what is not.
const MARGIN: f64 = 0.25;
/// Film maps: fine levels up to this multiple of the central film,
const FINE_UP_TO: f64 = 1.15;
/// and coarse ones up to this.
const FILM_UP_TO: f64 = 2.5;

/// Window of the maps, in half-widths.
fn window_map(solution: &Solution) -> [[f64; 2]; 2] {
    let [low, high] = window_x(solution);
    let side = solution.extents[2].min(1.5_f64.max(-0.75 * low)).max(1.0);
    [[low, high], [-side, side]]
}

/// Window of the maps of temperatures, in half-widths: the contact, and where a surface or mid-film is warm.
fn warm_window(solution: &Solution) -> [[f64; 2]; 2] {
    let [[low, high], [_, side]] = window_map(solution);
    let a = solution.hertz.half_width;
    let Some(thermal) = &solution.thermal else {
        return [[low, high], [-side, side]];
    };
    let t = &thermal.surface;
    let inlet = thermal.inlet_temperature;
    let warm = inlet + COLD * (thermal.film_maximum.value - inlet);
    let points = solution.surface.points.iter().enumerate();
    let (first, widest) = points
        .filter(|(i, _)| [&t.mid, &t.plane, &t.ball].iter().any(|f| f[*i] > warm))
        .map(|(_, p)| (p[0] / a, (p[1] / a).abs()))
        .fold((-1.0_f64, 1.0_f64), |(l, w), (x, y)| (l.min(x), w.max(y)));
    let low = low.max((2.0 * (first - MARGIN)).floor() / 2.0);
    let side = side.min(widest + MARGIN);
    [[low, high], [-side, side]]
}

fn hex(gradient: colorous::Gradient, i: usize, n: usize) -> String {
    format!("#{:x}", gradient.eval_rational(i, n))
}

/// Pressure over the whole contact, continuous colours.
pub fn pressure_map(title: &str, solution: &Solution) -> String {
    let (factor, unit) = pressure_unit(solution.hertz.pressure);
    let surface = full_surface(solution.kind, &solution.surface);
    let values: Vec<f64> = surface.pressure.iter().map(|p| factor * p).collect();
    let top = factor * solution.summary.pressure_maximum.value;
    FieldMap {
        title,
        points: &in_half_widths(&surface.points, solution.hertz.half_width),
        triangles: &surface.cells,
        values: &values,
        window: window_map(solution),
        levels: (1..N_SHADES)
            .map(|i| top * i as f64 / N_SHADES as f64)
            .collect(),
        colours: (0..N_SHADES)
            .map(|i| hex(colorous::VIRIDIS, i, N_SHADES))
            .collect(),
        bar: Bar::Continuous([0.0, top]),
        bar_label: &format!("Pressure *p* ({unit})"),
        circle: "#ffffff",
    }
    .svg()
}

/// Temperature over the whole contact, K at the points of the surface, continuous colours between the bounds.
pub fn temperature_map(
    title: &str,
    solution: &Solution,
    values: &[f64],
    label: &str,
    [low, high]: [f64; 2],
) -> String {
    let surface = full_surface(solution.kind, &solution.surface);
    let values: Vec<f64> = sources(solution.kind, &solution.surface)
        .into_iter()
        .map(|i| values[i])
        .collect();
    FieldMap {
        title,
        points: &in_half_widths(&surface.points, solution.hertz.half_width),
        triangles: &surface.cells,
        values: &values,
        window: warm_window(solution),
        levels: (1..N_SHADES)
            .map(|i| low + (high - low) * i as f64 / N_SHADES as f64)
            .collect(),
        colours: (0..N_SHADES)
            .map(|i| hex(colorous::INFERNO, i, N_SHADES))
            .collect(),
        bar: Bar::Continuous([low, high]),
        bar_label: label,
        circle: "#ffffff",
    }
    .svg()
}

/// Film thickness over the whole contact as contours, like an interferogram: close levels up to
/// `FINE_UP_TO` times the central film, wide ones to `FILM_UP_TO`, white beyond.
pub fn film_map(title: &str, solution: &Solution) -> String {
    let summary = &solution.summary;
    let (factor, unit) = film_unit(FILM_UP_TO * summary.film_central.value);
    let surface = full_surface(solution.kind, &solution.surface);
    let values: Vec<f64> = surface.film_thickness.iter().map(|h| factor * h).collect();
    let levels = film_levels(
        factor * summary.film_minimum.value,
        factor * summary.film_central.value,
    );
    let n = levels.len();
    let mut colours: Vec<String> = (0..n).map(|i| hex(colorous::VIRIDIS, i, n)).collect();
    colours.push("#ffffff".to_owned());
    FieldMap {
        title,
        points: &in_half_widths(&surface.points, solution.hertz.half_width),
        triangles: &surface.cells,
        values: &values,
        window: window_map(solution),
        levels,
        colours,
        bar: Bar::Steps,
        bar_label: &format!("Film thickness *h* ({unit})"),
        circle: "#ffffff",
    }
    .svg()
}

/// Rising levels of a film map for the minimum and central film.
fn film_levels(minimum: f64, central: f64) -> Vec<f64> {
    let fine = axis::tick_step(0.8 * central);
    let coarse = 5.0 * fine;
    let first = (minimum / fine).floor().max(0.0) as usize + 1;
    let last = ((FINE_UP_TO * central / coarse).ceil() * 5.0) as usize;
    let last_coarse = (FILM_UP_TO * central / coarse).ceil() as usize;
    let fine_levels = (first..=last).map(|i| fine * i as f64);
    let coarse_levels = (last / 5 + 1..=last_coarse).map(|i| coarse * i as f64);
    fine_levels.chain(coarse_levels).collect()
}

fn in_half_widths(points: &[[f64; 2]], half_width: f64) -> Vec<[f64; 2]> {
    points.iter().map(|p| p.map(|x| x / half_width)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

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
