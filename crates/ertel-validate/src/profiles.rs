//! Pictures with profiles of several runs side by side.

use ertel::output::pictures::{self, film_unit};
use ertel::solution::Solution;
use ertel::words::TemperatureScale;
use ertel_plot::{Axis, Chart, Look, PALETTE, Series, Side, side_by_side};

/// Run by name, and its solution if it has one.
type Named<'a> = (String, Option<&'a Solution>);

/// Range of X shown: the contact and the inlet near it.
const WINDOW: [f64; 2] = [-1.5, 1.5];
/// Pressures P below this count as zero.
const DUST: f64 = 2e-3;
/// Films are shown up to this multiple of the central one.
const FILM_SHOWN: f64 = 2.0;

/// Pressure and film of each run that converged in a separate panel, axes alike; the heading of the last one names the others.
/// `None` without any solution.
pub(super) fn panels(title: &str, runs: &[Named], columns: usize) -> Option<String> {
    let solved = runs.iter().filter_map(|(name, s)| Some((name, (*s)?)));
    let mut charts: Vec<Chart> = solved.map(|(name, s)| panel(name, s)).collect();
    let failed = runs.iter().filter(|r| r.1.is_none());
    let failed: Vec<&str> = failed.map(|r| r.0.as_str()).collect();
    let last = charts.last_mut()?;
    if !failed.is_empty() {
        last.heading += &format!(" (not converged: {})", failed.join(", "));
    }
    Some(side_by_side(title, &charts, columns).svg())
}

fn panel(name: &str, s: &Solution) -> Chart {
    let mut chart = Chart::new(
        name,
        Axis::linear("*X* = *x*/*a*", WINDOW[0], WINDOW[1]),
        Axis::linear("*P* = *p*/*p*_{h}", 0.0, 1.4),
    );
    chart.heading = name.to_owned();
    let centre = s.summary.film_central.value / s.scales.film;
    chart.y_right = Some(Axis::linear_around(
        "*H* = *hR*/*a*^{2}",
        [0.0, 3.5 * centre],
    ));
    chart.series = vec![
        Series::new("pressure", pressure(s), Look::Line, PALETTE[0]),
        Series {
            label: "film".into(),
            points: pictures::profile(s, &s.elements.film_thickness, 1.0 / s.scales.film),
            look: Look::Line,
            colour: PALETTE[1].into(),
            side: Side::Right,
        },
    ];
    chart
}

/// Profiles drawn in one chart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Profile {
    /// Pressure.
    Pressure,
    /// Pressure along X = 0, over |Y|.
    PressureAcross,
    /// Film thickness.
    Film,
    /// Temperature at mid-film.
    Temperature,
}

/// Such profiles of all runs, the first one dashed, and the same within a range of X; `None` without any solution.
pub(super) fn overlay(
    profile: Profile,
    title: &str,
    runs: &[Named],
    zoom: [f64; 2],
) -> Option<String> {
    let largest = runs
        .iter()
        .filter_map(|r| Some(r.1?.summary.film_central.value));
    let (factor, unit) = film_unit(largest.reduce(f64::max)?);
    let label = match profile {
        Profile::Pressure | Profile::PressureAcross => "*P* = *p*/*p*_{h}".to_owned(),
        Profile::Film => format!("Film thickness *h* ({unit})"),
        Profile::Temperature => "Temperature *T* at mid-film (K)".to_owned(),
    };
    let points = |s: &Solution| -> Vec<[f64; 2]> {
        match profile {
            Profile::Pressure => pressure(s),
            Profile::PressureAcross => {
                let across =
                    pictures::profile_across(s, &s.elements.pressure, 1.0 / s.scales.pressure);
                across.into_iter().rev().map(|[y, p]| [-y, p]).collect()
            }
            Profile::Film => pictures::profile(s, &s.elements.film_thickness, factor),
            Profile::Temperature => (s.elements.temperatures.as_ref())
                .map_or_else(Vec::new, |t| pictures::profile(s, &t.mid, 1.0)),
        }
    };
    // The inlet gap would leave no room for the contact.
    let ceiling = match profile {
        Profile::Pressure | Profile::PressureAcross | Profile::Temperature => f64::INFINITY,
        Profile::Film => {
            FILM_SHOWN * factor * runs.iter().find_map(|r| r.1)?.summary.film_central.value
        }
    };
    let series: Vec<Series> = runs
        .iter()
        .enumerate()
        .filter_map(|(i, (name, s))| {
            s.map(|s| {
                Series::new(
                    name.clone(),
                    points(s),
                    if i == 0 { Look::Dashed } else { Look::Line },
                    PALETTE[i % PALETTE.len()],
                )
            })
        })
        .collect();
    let (window, axis) = match profile {
        Profile::PressureAcross => ([0.0, WINDOW[1]], "*Y* = |*y*|/*a*"),
        _ => (WINDOW, "*X* = *x*/*a*"),
    };
    let charts: Vec<Chart> = [window, zoom]
        .into_iter()
        .map(|[low, high]| {
            let inside = series.iter().flat_map(|s| s.points.iter());
            let inside = inside
                .filter(|p| (low..=high).contains(&p[0]))
                .map(|p| p[1].min(ceiling));
            let mut chart = Chart::new(
                title,
                Axis::linear(axis, low, high),
                Axis::linear_around(&label, inside),
            );
            chart.series = series.clone();
            chart
        })
        .collect();
    Some(side_by_side(title, &charts, 2).svg())
}

/// Temperatures of each run in a separate panel, axes alike: across the film at its chosen points, or along the
/// centreline. `None` without any thermal solution.
pub(super) fn temperatures(
    across: bool,
    title: &str,
    runs: &[Named],
    columns: usize,
) -> Option<String> {
    let scale = TemperatureScale::Kelvin;
    let mut charts: Vec<Chart> = runs
        .iter()
        .filter_map(|(name, s)| {
            let thermal = s.as_ref()?.thermal.as_ref()?;
            let chart = match across {
                true => pictures::cross_film_chart(title, (*s)?, thermal, scale),
                false => pictures::temperature_chart(title, (*s)?, scale),
            };
            Some(Chart {
                heading: name.clone(),
                ..chart
            })
        })
        .collect();
    let ends: Vec<f64> = charts.iter().flat_map(|c| [c.y.low, c.y.high]).collect();
    let y = Axis::linear_around(&charts.first()?.y.label, ends);
    for chart in &mut charts {
        chart.y_other = (chart.y_other.take()).map(|other| {
            let shift = other.low - chart.y.low;
            Axis::linear(&other.label, y.low + shift, y.high + shift)
        });
        chart.y = y.clone();
    }
    Some(side_by_side(title, &charts, columns).svg())
}

fn pressure(s: &Solution) -> Vec<[f64; 2]> {
    // Penalties leave dust below zero where the film is broken, which would cost the axis a tick.
    let shown = |p: f64| if p.abs() < DUST { 0.0 } else { p };
    (pictures::profile(s, &s.elements.pressure, 1.0 / s.scales.pressure).into_iter())
        .map(|[x, p]| [x, shown(p)])
        .collect()
}
