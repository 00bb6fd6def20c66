//! Pictures as SVG: pressure and film along the contact, maps over it, convergence, fluids.

mod convergence;
mod field;
mod fluid;
mod heat;
mod interferogram;
mod layout;
mod maps;
mod profile;
mod sampling;
mod shared;
mod stress;
mod wear;

pub use convergence::convergence;
pub use fluid::{ViscosityCurve, viscosity_chart};
pub use heat::{cross_film_chart, temperature_chart};
pub use interferogram::Image;
pub(super) use layout::draw_ticks;
pub use maps::{film_map, pressure_map};
pub use profile::{profile, profile_across};
pub use shared::film_unit;
pub(super) use stress::stress_map;

use shared::{Task, window_x};

use ertel_plot::{Axis, Chart, Drawing, Look, PALETTE, Series, Side, side_by_side};
use rayon::prelude::*;

use crate::params::Method;
use crate::solution::Solution;
use crate::words::TemperatureScale;

/// Legend label of the error bars of computed figures.
pub(crate) const ERROR_BARS: &str = "numerical error";
/// Smallest ratio of the largest to the smallest value for a logarithmic axis.
const LOG_FROM: f64 = 5.0;
/// Colour of what stands for all colours.
pub(super) const LEGEND_GREY: &str = "#404040";

/// Whether values need a logarithmic axis.
pub(super) fn is_wide(values: impl Iterator<Item = f64>) -> bool {
    let (low, high) = values.fold((f64::INFINITY, 0.0), |(l, h): (f64, f64), v| {
        (l.min(v), h.max(v))
    });
    low > 0.0 && high >= LOG_FROM * low
}

/// Legend entry for curves of all colours.
pub(super) fn legend_entry(look: Look, label: &str) -> Series {
    Series {
        label: label.to_owned(),
        look,
        colour: LEGEND_GREY.to_owned(),
        ..Series::default()
    }
}

/// A named picture.
pub struct Picture {
    /// File name without suffix.
    pub name: &'static str,
    /// SVG file.
    pub svg: String,
    /// Its drawing, for other formats.
    pub drawing: Drawing,
}

impl Picture {
    /// A picture with a file name without suffix.
    pub fn new(name: &'static str, drawing: Drawing) -> Picture {
        Picture {
            name,
            svg: drawing.svg(),
            drawing,
        }
    }
}

/// Whether residuals and updates converge to `solver.tolerance`; finite volumes stop at a tolerance of the films and pressures.
pub(super) fn has_one_tolerance(solution: &Solution) -> bool {
    solution.stats.method == Method::FiniteElements
}

/// Every picture of a solution, temperatures in Kelvin first; the convergence tolerance is drawn if given.
pub fn pictures(title: &str, solution: &Solution, tolerance: Option<f64>) -> Vec<Picture> {
    pictures_in(title, solution, tolerance, TemperatureScale::default())
}

/// The same with the given temperature scale first.
pub fn pictures_in(
    title: &str,
    solution: &Solution,
    tolerance: Option<f64>,
    scale: TemperatureScale,
) -> Vec<Picture> {
    let tolerance = tolerance.filter(|_| has_one_tolerance(solution));
    let mut tasks: Vec<Task> = vec![(
        "centreline",
        Box::new(|| centreline(title, solution).drawing()),
    )];
    if !solution.shape.is_line() {
        tasks.push(("pressure", Box::new(|| pressure_map(title, solution))));
        tasks.push(("film", Box::new(|| film_map(title, solution))));
    }
    if let Some(thermal) = &solution.thermal {
        tasks.extend(heat::heat_pictures(title, solution, thermal, scale));
    }
    if solution.stresses.is_some() {
        let draw = || stress_map(title, solution).expect("there are stresses");
        tasks.push(("stress", Box::new(draw)));
    }
    if let Some(wear) = &solution.wear {
        tasks.push(("wear", Box::new(|| wear::picture(title, solution, wear))));
    }
    tasks.push((
        "convergence",
        Box::new(move || side_by_side(title, &convergence(title, solution, tolerance), 2)),
    ));
    (tasks.into_par_iter())
        .map(|(name, draw)| Picture::new(name, draw()))
        .collect()
}

/// Factor and unit for pressures of this size (Pa).
pub(super) fn pressure_unit(size: f64) -> (f64, &'static str) {
    if size < 0.1e9 {
        (1e-6, "MPa")
    } else {
        (1e-9, "GPa")
    }
}

/// Pressure (with the Hertz pressure) and film thickness along y = 0.
pub fn centreline(title: &str, solution: &Solution) -> Chart {
    let a = solution.hertz.half_width;
    let (p_factor, p_unit) = pressure_unit(solution.hertz.pressure);
    // Margin above the film for the pressure: the film is in the lower part of the frame
    let film_top = 3.0 * solution.summary.film_central.value;
    let (h_factor, h_unit) = film_unit(film_top);
    let [low, high] = window_x(solution);
    let highest = solution
        .summary
        .pressure_maximum
        .value
        .max(solution.hertz.pressure);
    let n_hertz = 400;
    let hertz_curve = (0..=n_hertz)
        .map(|i| -(std::f64::consts::PI * f64::from(i) / f64::from(n_hertz)).cos())
        .map(|x| {
            let x = x * solution.shape.zone.centreline_half_width();
            [
                x,
                p_factor * solution.hertz.pressure * solution.shape.zone.pressure([x, 0.0]),
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
        Series::new("Hertz pressure", hertz_curve, Look::Dashed, "#7f7f7f"),
        Series::new(
            "pressure",
            profile(solution, &solution.elements.pressure, p_factor),
            Look::Line,
            PALETTE[0],
        ),
        Series {
            label: "film thickness".into(),
            points: profile(solution, &solution.elements.film_thickness, h_factor),
            look: Look::Line,
            colour: PALETTE[1].into(),
            side: Side::Right,
        },
    ];
    chart
}
