//! Pictures as SVG: pressure and film along the contact, maps over it, convergence, fluids.

mod axis;
mod chart;
mod contour;
mod field;
pub mod png;
mod svg;

pub use axis::{Axis, AxisScale};
pub use chart::{Chart, Look, Marker, PALETTE, Series, Side};

use field::{Bar, FieldMap};

use super::report::digits;
use super::surface::full_surface;
use crate::contact::{ContactKind, hertz};
use crate::solution::{IterationRecord, Solution};

/// Film thicknesses are shown in nm below this value (m), else in µm.
const NANOMETRES_BELOW: f64 = 1e-6;
/// Colours of a map that shall look continuous.
const N_SHADES: usize = 64;

/// Film maps: fine levels up to this multiple of the central film,
const FINE_UP_TO: f64 = 1.15;
/// and coarse ones up to this.
const FILM_UP_TO: f64 = 2.5;

/// A picture: file name without suffix, and SVG text.
pub struct Picture {
    /// File name without suffix.
    pub name: &'static str,
    /// SVG file.
    pub svg: String,
}

/// Every picture of a solution; the convergence target is drawn where given.
pub fn pictures(title: &str, solution: &Solution, tolerance: Option<f64>) -> Vec<Picture> {
    let mut pictures = vec![Picture {
        name: "centreline",
        svg: centreline(title, solution).svg(),
    }];
    if solution.kind == ContactKind::Circular {
        pictures.push(Picture {
            name: "pressure",
            svg: pressure_map(title, solution),
        });
        pictures.push(Picture {
            name: "film",
            svg: film_map(title, solution),
        });
    }
    pictures.push(Picture {
        name: "convergence",
        svg: convergence(title, solution, tolerance).svg(),
    });
    pictures
}

/// Factor and unit in which lengths of this size (m) are shown.
fn film_unit(size: f64) -> (f64, &'static str) {
    if size < NANOMETRES_BELOW {
        (1e9, "nm")
    } else {
        (1e6, "µm")
    }
}

/// Factor and unit in which pressures of this size (Pa) are shown.
fn pressure_unit(size: f64) -> (f64, &'static str) {
    if size < 0.1e9 {
        (1e-6, "MPa")
    } else {
        (1e-9, "GPa")
    }
}

/// Part of the x axis worth showing, in half-widths: where there is pressure, and some inlet.
fn window_x(solution: &Solution) -> [f64; 2] {
    let a = solution.hertz.half_width;
    let line = &solution.centreline;
    let ends = line.x.iter().map(|x| x / a);
    let (first, last) = (
        ends.clone().fold(f64::INFINITY, f64::min),
        ends.fold(f64::NEG_INFINITY, f64::max),
    );
    let pressed = line
        .x
        .iter()
        .zip(&line.pressure)
        .filter(|(_, p)| **p > 0.01 * solution.hertz.pressure)
        .map(|(x, _)| x / a);
    let reach = pressed.clone().fold(-1.0, f64::min);
    let end = pressed.fold(1.0, f64::max);
    let low = (2.0 * (1.15 * reach - 0.6)).floor() / 2.0;
    let high = (2.0 * (1.1 * end + 0.2)).ceil() / 2.0;
    [low.max(first), high.min(last)]
}

/// Pressure (with the Hertz pressure) and film thickness along y = 0.
pub fn centreline(title: &str, solution: &Solution) -> Chart {
    let a = solution.hertz.half_width;
    let line = &solution.centreline;
    let (p_factor, p_unit) = pressure_unit(solution.hertz.pressure);
    // Room above the film for the pressure: the film stays in the lower part of the frame
    let film_top = 3.0 * solution.summary.film_central.value;
    let (h_factor, h_unit) = film_unit(film_top);
    let [low, high] = window_x(solution);
    let curve = |values: &[f64], factor: f64| -> Vec<[f64; 2]> {
        line.x
            .iter()
            .zip(values)
            .map(|(x, v)| [x / a, factor * v])
            .collect()
    };
    let highest = solution
        .summary
        .pressure_maximum
        .value
        .max(solution.hertz.pressure);
    let n_hertz = 400;
    let hertz_curve = (0..=n_hertz)
        .map(|i| -(std::f64::consts::PI * f64::from(i) / f64::from(n_hertz)).cos())
        .map(|x| {
            [
                x,
                p_factor * solution.hertz.pressure * hertz::pressure_profile(x),
            ]
        })
        .collect();
    let mut chart = Chart::new(
        title,
        Axis::linear("*x*/*a*", low, high),
        Axis::linear_around(
            &format!("Pressure *p* ({p_unit})"),
            [0.0, 1.1 * p_factor * highest],
        ),
    );
    let (x_factor, x_unit) = if a < 20e-6 { (1e6, "µm") } else { (1e3, "mm") };
    chart.x_top = Some(Axis::linear(
        &format!("*x* ({x_unit})"),
        x_factor * a * low,
        x_factor * a * high,
    ));
    chart.y_right = Some(Axis::linear_around(
        &format!("Film thickness *h* ({h_unit})"),
        [0.0, h_factor * film_top],
    ));
    chart.series = vec![
        Series {
            label: "Hertz pressure".into(),
            points: hertz_curve,
            look: Look::Dashed,
            colour: "#7f7f7f".into(),
            side: Side::Left,
        },
        Series {
            label: "pressure".into(),
            points: curve(&line.pressure, p_factor),
            look: Look::Line,
            colour: PALETTE[0].into(),
            side: Side::Left,
        },
        Series {
            label: "film thickness".into(),
            points: curve(&line.film_thickness, h_factor),
            look: Look::Line,
            colour: PALETTE[1].into(),
            side: Side::Right,
        },
    ];
    chart
}

/// Window of the maps, in half-widths.
fn window_map(solution: &Solution) -> [[f64; 2]; 2] {
    let [low, high] = window_x(solution);
    let side = solution.extents[2].min(1.5_f64.max(-0.75 * low)).max(1.0);
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
        bar: Bar::Continuous(top),
        bar_label: &format!("Pressure *p* ({unit})"),
        circle: "#ffffff",
    }
    .svg()
}

/// Film thickness over the whole contact as contours, like an interferogram: close levels up to
/// [`FINE_UP_TO`] times the central film, wide ones to [`FILM_UP_TO`], white beyond.
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

/// Residual and update of every Newton iteration, levels one after the other.
pub fn convergence(title: &str, solution: &Solution, tolerance: Option<f64>) -> Chart {
    let history = &solution.history;
    let curve = |value: fn(&IterationRecord) -> f64| -> Vec<[f64; 2]> {
        let mut points = Vec::new();
        for (i, record) in history.iter().enumerate() {
            if i > 0 && history[i - 1].level != record.level {
                // A new mesh starts a new line
                points.push([f64::NAN; 2]);
            }
            points.push([(i + 1) as f64, value(record)]);
        }
        points
    };
    let residual = curve(|r| r.residual);
    let update = curve(|r| r.update);
    let heights = residual
        .iter()
        .chain(&update)
        .map(|p| p[1])
        .chain(tolerance);
    let mut chart = Chart::new(
        title,
        Axis::count("Newton iteration", history.len()),
        Axis::log_around("Relative residual and update", heights),
    );
    if let Some(tolerance) = tolerance {
        chart.series.push(Series {
            label: "tolerance".into(),
            points: vec![[0.0, tolerance], [history.len() as f64 + 1.0, tolerance]],
            look: Look::Dashed,
            colour: "#7f7f7f".into(),
            side: Side::Left,
        });
    }
    for (label, points, colour) in [
        ("Reynolds residual", residual, PALETTE[0]),
        ("pressure update / *p*_{h}", update, PALETTE[1]),
    ] {
        chart.series.push(Series {
            label: label.into(),
            points,
            look: Look::LineAndDots,
            colour: colour.into(),
            side: Side::Left,
        });
    }
    let mut level = None;
    for (i, record) in history.iter().enumerate() {
        if level != Some(record.level) {
            level = Some(record.level);
            chart.markers.push(Marker {
                x: i as f64 + 0.5,
                label: format!("mesh {}", record.level + 1),
            });
        }
    }
    chart
}

/// Viscosity against pressure at one temperature.
pub struct ViscosityCurve {
    /// Temperature, K.
    pub temperature: f64,
    /// Pressures, Pa, rising.
    pub pressure: Vec<f64>,
    /// Viscosities, Pa·s.
    pub viscosity: Vec<f64>,
}

/// Viscosity-pressure curves of a fluid on a logarithmic axis. Where a range of validity
/// (Pa) is given, what lies outside of it is shaded, and dashed.
pub fn viscosity_chart(
    title: &str,
    curves: &[ViscosityCurve],
    valid_pressure: Option<[f64; 2]>,
) -> Chart {
    let highest = curves.iter().flat_map(|c| c.pressure.iter().copied());
    let highest = highest.filter(|p| p.is_finite()).fold(0.0, f64::max);
    let (factor, unit) = pressure_unit(highest);
    let values = curves.iter().flat_map(|c| c.viscosity.iter().copied());
    let mut chart = Chart::new(
        title,
        Axis::linear_around(&format!("Pressure *p* ({unit})"), [0.0, factor * highest]),
        Axis::log_around("Viscosity *μ* (Pa s)", values),
    );
    chart.x.high = chart
        .x
        .high
        .min(factor * highest)
        .max(chart.x.low + f64::MIN_POSITIVE);
    let [from, to] = valid_pressure.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
    if from > 0.0 && from.is_finite() {
        chart.shaded.push([0.0, factor * from]);
    }
    if to < highest {
        chart.shaded.push([factor * to, factor * highest]);
        chart.markers.push(Marker {
            x: factor * to,
            label: "extrapolated".into(),
        });
    }
    for (i, curve) in curves.iter().enumerate() {
        let points: Vec<[f64; 2]> = curve
            .pressure
            .iter()
            .zip(&curve.viscosity)
            .map(|(p, v)| [*p, *v])
            .collect();
        let label = format!("{} °C", digits(curve.temperature - 273.15, 4));
        let parts = [
            (label, from, to, Look::Line),
            (String::new(), f64::NEG_INFINITY, from, Look::Dashed),
            (String::new(), to, f64::INFINITY, Look::Dashed),
        ];
        for (label, low, high, look) in parts {
            let part = between(&points, low, high);
            if part.len() > 1 {
                chart.series.push(Series {
                    label,
                    points: part.into_iter().map(|[p, v]| [factor * p, v]).collect(),
                    look,
                    colour: PALETTE[i % PALETTE.len()].into(),
                    side: Side::Left,
                });
            }
        }
    }
    chart
}

/// Part of a curve with x between the bounds; ends between two points by interpolation in ln y.
fn between(points: &[[f64; 2]], low: f64, high: f64) -> Vec<[f64; 2]> {
    let mut part = Vec::new();
    for (i, [x, y]) in points.iter().enumerate() {
        if let Some([x0, y0]) = i.checked_sub(1).map(|j| points[j]) {
            for bound in [low, high] {
                if x0 < bound && bound < *x {
                    let t = (bound - x0) / (x - x0);
                    part.push([bound, y0 * (y / y0).powf(t)]);
                }
            }
        }
        if (low..=high).contains(x) {
            part.push([*x, *y]);
        }
    }
    part
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

    /// An exponential is straight on a logarithmic axis: cut at 0.5 it has e^0.5.
    #[test]
    fn curve_is_cut_at_the_end_of_its_range() {
        let curve = [[0.0, 1.0], [1.0, 1f64.exp()], [2.0, 2f64.exp()]];
        let inside = between(&curve, 0.0, 0.5);
        assert_eq!((inside.len(), inside[1][0]), (2, 0.5));
        assert!((inside[1][1] - 0.5f64.exp()).abs() < 1e-12);
        assert_eq!(between(&curve, 0.5, f64::INFINITY).len(), 3);
    }
}
