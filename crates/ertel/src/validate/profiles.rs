//! Pictures that set centreline profiles of several runs beside each other.

use crate::output::plot::{Axis, Chart, Look, PALETTE, Series, Side, side_by_side};
use crate::solution::Solution;

/// Run by name, and its solution if it has one.
type Named<'a> = (String, Option<&'a Solution>);

/// Range of X shown: the contact and the inlet near it.
const WINDOW: [f64; 2] = [-1.5, 1.5];

/// Pressure and film of each run in a panel of its own, axes alike; `None` without any solution.
pub(super) fn panels(title: &str, runs: &[Named], columns: usize) -> Option<String> {
    runs.iter().find_map(|r| r.1)?;
    let charts: Vec<Chart> = runs.iter().map(|(name, s)| panel(name, *s)).collect();
    Some(side_by_side(title, &charts, columns))
}

fn panel(name: &str, solution: Option<&Solution>) -> Chart {
    let mut chart = Chart::new(
        name,
        Axis::linear("*X* = *x*/*a*", WINDOW[0], WINDOW[1]),
        Axis::linear("*P* = *p*/*p*_{h}", 0.0, 1.4),
    );
    chart.heading = match solution {
        Some(_) => name.to_owned(),
        None => format!("{name}: not converged"),
    };
    let Some(s) = solution else {
        return chart;
    };
    let centre = s.summary.film_central.value / s.scales.film;
    chart.y_right = Some(Axis::linear_around(
        "*H* = *hR*/*a*^{2}",
        [0.0, 3.5 * centre],
    ));
    let film = s.centreline.film_thickness.iter();
    let film: Vec<f64> = film.map(|h| h / s.scales.film).collect();
    chart.series = vec![
        Series {
            label: "pressure".into(),
            points: points(s, &pressure(s)),
            look: Look::Line,
            colour: PALETTE[0].into(),
            side: Side::Left,
        },
        Series {
            label: "film".into(),
            points: points(s, &film),
            look: Look::Line,
            colour: PALETTE[1].into(),
            side: Side::Right,
        },
    ];
    chart
}

/// Pressures of all runs, and the same within a range of X; `None` without any solution.
pub(super) fn pressures(title: &str, runs: &[Named], zoom: [f64; 2]) -> Option<String> {
    runs.iter().find_map(|r| r.1)?;
    let series: Vec<Series> = runs
        .iter()
        .enumerate()
        .filter_map(|(i, (name, s))| {
            s.map(|s| Series {
                label: name.clone(),
                points: points(s, &pressure(s)),
                look: if i == 0 { Look::Dashed } else { Look::Line },
                colour: PALETTE[i % PALETTE.len()].into(),
                side: Side::Left,
            })
        })
        .collect();
    let charts: Vec<Chart> = [WINDOW, zoom]
        .into_iter()
        .map(|[low, high]| {
            let inside = series.iter().flat_map(|s| s.points.iter());
            let inside = inside
                .filter(|p| (low..=high).contains(&p[0]))
                .map(|p| p[1]);
            let mut chart = Chart::new(
                title,
                Axis::linear("*X* = *x*/*a*", low, high),
                Axis::linear_around("*P* = *p*/*p*_{h}", inside),
            );
            chart.series = series.clone();
            chart
        })
        .collect();
    Some(side_by_side(title, &charts, 2))
}

fn pressure(s: &Solution) -> Vec<f64> {
    let scale = s.scales.pressure;
    s.centreline.pressure.iter().map(|p| p / scale).collect()
}

fn points(s: &Solution, values: &[f64]) -> Vec<[f64; 2]> {
    let x = s.centreline.x.iter().map(|x| x / s.scales.length);
    x.zip(values).map(|(x, v)| [x, *v]).collect()
}
