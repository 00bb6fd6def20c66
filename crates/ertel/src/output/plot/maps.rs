//! Maps of pressure and film thickness over the whole contact.

use super::field::{Bar, FieldMap, map_height};
use super::sampling::{Sampling, View};
use super::{axis, film_unit, pressure_unit, window_x};
use crate::contact::Symmetry;
use crate::solution::{Polynomials, Solution};

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
pub(super) fn window_map(solution: &Solution) -> [[f64; 2]; 2] {
    let [low, high] = window_x(solution);
    let [_, half] = solution.shape.zone.half_extents();
    let around = 1.5_f64.max(-0.75 * low) - 1.0;
    let ratio = solution.shape.zone.axis_ratio;
    let side = (ratio * solution.extents[2]).min(half + around).max(half);
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
        .fold(
            (-1.0_f64, solution.shape.zone.half_extents()[1]),
            |(l, w), (x, y)| (l.min(x), w.max(y)),
        );
    let low = low.max((2.0 * (first - MARGIN)).floor() / 2.0);
    let side = side.min(widest + MARGIN);
    [[low, high], [-side, side]]
}

fn hex(gradient: colorous::Gradient, i: usize, n: usize) -> String {
    format!("#{:x}", gradient.eval_rational(i, n))
}

/// Samples of a field over the whole contact, in half-widths, for contours at these levels; `factor` by which the field,
/// SI, is multiplied.
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
        pixel: (window[1][1] - window[1][0]) / map_height(window),
        factor,
        levels,
    };
    let part = Sampling::new(&solution.elements, field, &view);
    match solution.shape.symmetry {
        Symmetry::Half => part.mirrored(),
        Symmetry::Full => part,
    }
}

/// Levels and colours between two values that look continuous.
fn shades([low, high]: [f64; 2], gradient: colorous::Gradient) -> (Vec<f64>, Vec<String>) {
    let share = |i: usize| i as f64 / N_SHADES as f64;
    let levels = (1..N_SHADES).map(|i| low + (high - low) * share(i));
    let colours = (0..N_SHADES).map(|i| hex(gradient, i, N_SHADES));
    (levels.collect(), colours.collect())
}

/// Pressure over the whole contact, continuous colours.
pub fn pressure_map(title: &str, solution: &Solution) -> String {
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
        window,
        levels,
        colours,
        bar: Bar::Continuous([0.0, top]),
        bar_label: &format!("Pressure *p* ({unit})"),
        zone: solution.shape.zone.clone(),
        rim: "#ffffff",
    }
    .svg()
}

/// Temperature over the whole contact, K, continuous colours between the bounds.
pub fn temperature_map(
    title: &str,
    solution: &Solution,
    temperature: &Polynomials,
    label: &str,
    bounds: [f64; 2],
) -> String {
    let (levels, colours) = shades(bounds, colorous::INFERNO);
    let window = warm_window(solution);
    FieldMap {
        title,
        field: sampled(solution, temperature, 1.0, window, &levels),
        window,
        levels,
        colours,
        bar: Bar::Continuous(bounds),
        bar_label: label,
        zone: solution.shape.zone.clone(),
        rim: "#ffffff",
    }
    .svg()
}

/// Film thickness over the whole contact as contours, like an interferogram: close levels up to
/// `FINE_UP_TO` times the central film, wide ones to `FILM_UP_TO`, white beyond.
pub fn film_map(title: &str, solution: &Solution) -> String {
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
        window,
        levels,
        colours,
        bar: Bar::Steps,
        bar_label: &format!("Film thickness *h* ({unit})"),
        zone: solution.shape.zone.clone(),
        rim: "#ffffff",
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
