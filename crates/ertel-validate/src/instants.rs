//! Films along the motion at instants of a contact over time, compared with published ones.

use ertel::run::transient::TransientSolution;
use ertel_input::{Bounds, InputError, Table};
use ertel_plot::{Axis, Chart, Look, PALETTE, Series, side_by_side};
use ertel_quantity::Dimension;

use super::place::{Place, Published, SAME_TIME, at_time};
use super::{Run, Study};

/// Films of a run at the times of published ones, each in a panel with the published points; `None` without such a profile.
pub(super) fn panels(
    title: &str,
    found: &TransientSolution,
    published: &[Published],
    columns: usize,
) -> Option<String> {
    let ends = |values: &mut dyn Iterator<Item = f64>| {
        values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| {
            [low.min(v), high.max(v)]
        })
    };
    let all = || published.iter().flat_map(|p| &p.points);
    let [left, right] = ends(&mut all().map(|p| p[0]));
    let [_, highest] = ends(&mut all().map(|p| p[1]));
    let charts: Vec<Chart> = published
        .iter()
        .filter_map(|one| {
            let profile = at_time(&found.profiles, one.time)?;
            let places = profile.x.iter().zip(&profile.film);
            let ours = places.map(|(x, film)| [1e6 * x, 1e9 * film]);
            let mut chart = Chart::new(
                title,
                Axis::linear("*x* (µm)", left, right),
                Axis::linear("Film thickness *h* (nm)", 0.0, 1.15 * highest),
            );
            chart.heading = format!("{:.3} ms", 1e3 * one.time);
            chart.series = vec![
                Series {
                    label: "ertel".into(),
                    points: ours.collect(),
                    colour: PALETTE[0].into(),
                    ..Series::default()
                },
                Series::new("published", one.points.clone(), Look::Circles, PALETTE[1]),
            ];
            Some(chart)
        })
        .collect();
    (!charts.is_empty()).then(|| side_by_side(title, &charts, columns).svg())
}

/// `time` of a table: an output time of these runs.
fn read_time<'a>(
    table: &mut Table<'_>,
    runs: impl Iterator<Item = &'a Run>,
) -> Result<f64, InputError> {
    let time = table.required_quantity("time", Dimension::TIME, Bounds::POSITIVE)?;
    for run in runs {
        let times = run.case.transient.as_ref().map(|t| &t.output_times);
        let is_one = |t: &f64| (t - time).abs() <= SAME_TIME * time;
        if !times.is_some_and(|times| times.iter().any(is_one)) {
            let text = format!("the run `{}` has no such output time", run.name);
            return Err(table.error("time", text));
        }
    }
    Ok(time)
}

/// `time` and `x` of a check.
pub(super) fn read_place<'a>(
    table: &mut Table<'_>,
    runs: impl Iterator<Item = &'a Run>,
) -> Result<Place, InputError> {
    Ok(Place {
        time: read_time(table, runs)?,
        x: table.required_quantity("x", Dimension::LENGTH, Bounds::ANY)?,
    })
}

/// The tables `instant` of a picture of a run: `time`, `x_um` and `film_nm`.
pub(super) fn read_published(
    table: &mut Table<'_>,
    study: &Study,
    run: usize,
) -> Result<Vec<Published>, InputError> {
    let mut published = Vec::new();
    for mut one in table.tables("instant")? {
        let time = read_time(&mut one, std::iter::once(&study.runs[run]))?;
        let [x, film] = [("x_um", Bounds::ANY), ("film_nm", Bounds::POSITIVE)]
            .map(|(key, bounds)| Ok(one.optional_numbers(key, bounds)?.unwrap_or_default()));
        let (x, film): (Vec<f64>, Vec<f64>) = (x?, film?);
        if x.len() != film.len() || x.is_empty() {
            return Err(one.error("x_um", "`x_um` and `film_nm` are lists of the same length"));
        }
        one.finish()?;
        let points = x.into_iter().zip(film).map(|(x, film)| [x, film]);
        published.push(Published {
            time,
            points: points.collect(),
        });
    }
    if published.is_empty() {
        return Err(table.missing("instant"));
    }
    Ok(published)
}
