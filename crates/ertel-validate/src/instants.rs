//! Films along the motion at instants of a contact over time, compared with published ones.

use ertel::run::transient::{InstantProfile, TransientSolution};
use ertel_input::{Bounds, InputError, Table};
use ertel_plot::{Axis, Chart, Look, PALETTE, Series, side_by_side};
use ertel_quantity::Dimension;

use super::{Run, Study};

/// Where and when the film is compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Time, s, one of the case's output times.
    pub time: f64,
    /// Place along the motion on the centreline, m.
    pub x: f64,
}

impl Place {
    pub(super) fn words(self) -> String {
        format!(
            "film at x = {:.1} µm, {:.3} ms",
            self.x * 1e6,
            self.time * 1e3
        )
    }
}

/// A published film along the motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Published {
    /// Time, s, one of the case's output times.
    pub time: f64,
    /// Places, µm, and films there, nm.
    pub points: Vec<[f64; 2]>,
}

/// Times are one if they differ by less than this share.
const SAME_TIME: f64 = 1e-9;

fn at_time(profiles: &[InstantProfile], time: f64) -> Option<&InstantProfile> {
    profiles
        .iter()
        .find(|p| (p.time - time).abs() <= SAME_TIME * time)
}

/// Film thickness at a place and an instant, m, between the nodes linear; `None` beyond the grid and at no output time.
pub(super) fn film_at(profiles: &[InstantProfile], place: Place) -> Option<f64> {
    let profile = at_time(profiles, place.time)?;
    let above = profile.x.iter().position(|x| *x >= place.x)?;
    if profile.x[above] == place.x {
        return Some(profile.film[above]);
    }
    let below = above.checked_sub(1)?;
    let share = (place.x - profile.x[below]) / (profile.x[above] - profile.x[below]);
    Some(profile.film[below] + share * (profile.film[above] - profile.film[below]))
}

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
                Series {
                    label: "published".into(),
                    points: one.points.clone(),
                    look: Look::Circles,
                    colour: PALETTE[1].into(),
                    ..Series::default()
                },
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

#[cfg(test)]
mod tests {
    use super::*;

    /// A film h = 100 + 10 x² at nodes is read between them along chords; nothing is read beyond them or at another time.
    #[test]
    fn films_are_read_between_nodes() {
        let x: Vec<f64> = vec![-2.0, -1.0, 0.0, 2.0];
        let profile = InstantProfile {
            time: 3e-3,
            pressure: vec![0.0; 4],
            film: x.iter().map(|x| 100.0 + 10.0 * x * x).collect(),
            x,
        };
        let at = |time, x| film_at(std::slice::from_ref(&profile), Place { time, x });
        assert_eq!(at(3e-3, -2.0), Some(140.0));
        assert_eq!(at(3e-3, -1.5), Some(125.0));
        assert_eq!(at(3e-3, 0.5), Some(110.0));
        assert_eq!(at(3e-3, 2.5), None);
        assert_eq!(at(3e-3, -2.5), None);
        assert_eq!(at(3.1e-3, 0.0), None);
    }
}
