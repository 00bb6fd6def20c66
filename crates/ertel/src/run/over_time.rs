//! Figures of a whole transient run: extremes with their instants, means, and final values.
//!
//! Films and pressures are known at instants, with error bars e_i. The minimum over time is within
//! ```text
//!   min_i (f_i − e_i)  ≤  min_i f_i  ≤  min_i (f_i + e_i)
//! ```
//! It may also be between two instants: the error bar covers both ends of this interval, and the overshoot of the parabola through an extreme and its neighbours.

use super::transient::{InstantSolution, TransientSolution};
use crate::solution::{Estimate, Figure, Kind};

/// A figure of a whole run, SI.
#[derive(Clone, Debug, PartialEq)]
pub struct TimeFigure {
    /// Name in results: `film_minimum_lowest`.
    pub name: &'static str,
    /// Description for users.
    pub words: &'static str,
    /// Kind of quantity.
    pub kind: Kind,
    /// The figure with its bar.
    pub estimate: Estimate,
    /// Instant of the figure, s; `None` for means.
    pub time: Option<f64>,
    /// Whether its error bar is narrow enough for a number.
    pub resolved: bool,
}

impl TimeFigure {
    /// Whether it is a figure with an error bar, if one is known.
    pub fn has_bar(&self) -> bool {
        REPORTED.iter().any(|row| row.name == self.name)
    }
}

/// Reduction of a figure over time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Over {
    Lowest,
    Highest,
    Mean,
    Last,
}

/// A reported figure of a whole run.
struct Row {
    figure: Figure,
    over: Over,
    name: &'static str,
    words: &'static str,
}

const fn row(figure: Figure, over: Over, name: &'static str, words: &'static str) -> Row {
    Row {
        figure,
        over,
        name,
        words,
    }
}

/// Instantaneous figures reported for a whole run, in order. The sign of friction is its direction: extremes are of its magnitude.
const REPORTED: [Row; 10] = [
    row(
        Figure::FilmCentral,
        Over::Lowest,
        "film_central_lowest",
        "lowest central film thickness",
    ),
    row(
        Figure::FilmCentral,
        Over::Highest,
        "film_central_highest",
        "highest central film thickness",
    ),
    row(
        Figure::FilmCentral,
        Over::Last,
        "film_central_last",
        "central film thickness at the end",
    ),
    row(
        Figure::FilmMinimum,
        Over::Lowest,
        "film_minimum_lowest",
        "lowest minimum film thickness",
    ),
    row(
        Figure::FilmMinimum,
        Over::Last,
        "film_minimum_last",
        "minimum film thickness at the end",
    ),
    row(
        Figure::PressureMaximum,
        Over::Highest,
        "pressure_maximum_highest",
        "highest pressure maximum",
    ),
    row(
        Figure::TractionCoefficient,
        Over::Highest,
        "traction_coefficient_highest",
        "highest traction coefficient",
    ),
    row(
        Figure::TractionCoefficient,
        Over::Mean,
        "traction_coefficient_mean",
        "mean traction coefficient",
    ),
    row(
        Figure::FrictionPower,
        Over::Mean,
        "friction_power_mean",
        "mean friction power",
    ),
    row(
        Figure::FilmTemperatureMaximum,
        Over::Highest,
        "film_temperature_maximum_highest",
        "highest film temperature",
    ),
];

/// Figures without error bars.
const WITHOUT_BAR: [(&str, &str, Kind); 7] = [
    (
        "amplitude_ratio_lowest",
        "lowest amplitude ratio of the waves",
        Kind::Coefficient,
    ),
    (
        "amplitude_ratio_highest",
        "highest amplitude ratio of the waves",
        Kind::Coefficient,
    ),
    (
        "amplitude_ratio_last",
        "amplitude ratio of the waves at the end",
        Kind::Coefficient,
    ),
    ("film_force_highest", "highest film force", Kind::Force),
    ("approach_highest", "largest approach", Kind::Length),
    (
        "coefficient_of_restitution",
        "coefficient of restitution",
        Kind::Coefficient,
    ),
    (
        "mass_error_highest",
        "largest mass error of a step",
        Kind::Share,
    ),
];

/// Description of a figure with this name.
pub fn words_of(name: &str) -> Option<&'static str> {
    let of_instants = REPORTED.iter().map(|row| (row.name, row.words));
    let others = WITHOUT_BAR.iter().map(|(name, words, _)| (*name, *words));
    let mut all = of_instants.chain(others);
    all.find(|(own, _)| *own == name).map(|(_, words)| words)
}

/// A value with its error bar at an instant.
#[derive(Clone, Copy, Debug)]
struct At {
    time: f64,
    value: f64,
    bar: Option<f64>,
}

/// The figures of a run up to the reached time; figures without values are omitted.
pub fn over_time(found: &TransientSolution) -> Vec<TimeFigure> {
    let mut figures: Vec<TimeFigure> = (REPORTED.iter())
        .filter_map(|row| of_instants(row, &found.instants))
        .collect();
    let rows = WITHOUT_BAR.iter().filter_map(|(name, words, kind)| {
        let (value, time) = without_bar(name, found)?;
        Some(TimeFigure {
            name,
            words,
            kind: *kind,
            estimate: Estimate { value, error: None },
            time,
            resolved: true,
        })
    });
    figures.extend(rows);
    figures
}

fn of_instants(row: &Row, instants: &[InstantSolution]) -> Option<TimeFigure> {
    let figure = row.figure;
    let is_directed = matches!(figure, Figure::TractionCoefficient | Figure::FrictionPower);
    let rows: Vec<At> = (instants.iter())
        .filter_map(|instant| {
            let value = instant.measured.figures.value(figure)?;
            Some(At {
                time: instant.time,
                value: if is_directed { value.abs() } else { value },
                bar: instant.measured.bars.get(figure).map(|bar| bar.value),
            })
        })
        .collect();
    let last = rows.last()?;
    let (estimate, time) = match row.over {
        Over::Lowest => lowest(&rows, 1.0)?,
        Over::Highest => lowest(&rows, -1.0)?,
        Over::Mean => (mean(&rows)?, None),
        Over::Last => {
            let (value, error) = (last.value, last.bar);
            (Estimate { value, error }, Some(last.time))
        }
    };
    let narrow = |error: f64| error <= figure.widest_bar() * estimate.value.abs();
    let resolved = match row.over {
        Over::Last => instants.last()?.measured.is_resolved(figure),
        // A temperature is judged by its rise, which the instant provides.
        _ if figure == Figure::FilmTemperatureMaximum => {
            let at = instants.iter().find(|instant| Some(instant.time) == time)?;
            at.measured.is_resolved(figure)
        }
        _ => estimate.error.is_none_or(narrow),
    };
    Some(TimeFigure {
        name: row.name,
        words: row.words,
        kind: figure.kind(),
        estimate,
        time,
        resolved,
    })
}

/// The lowest value, or with sign −1 the highest one, with error bar and instant.
fn lowest(rows: &[At], sign: f64) -> Option<(Estimate, Option<f64>)> {
    let signed = |at: &At| sign * at.value;
    let known = (0..rows.len()).filter(|i| rows[*i].value.is_finite());
    let place = known.min_by(|a, b| signed(&rows[*a]).total_cmp(&signed(&rows[*b])))?;
    let value = signed(&rows[place]);
    let error = rows[place].bar.map(|_| {
        let bar = |at: &At| at.bar.unwrap_or(0.0);
        let ends = |end: f64| {
            let ends = rows.iter().map(|at| signed(at) + end * bar(at));
            ends.fold(f64::INFINITY, f64::min)
        };
        (value - ends(-1.0)).max(ends(1.0) - value) + beyond(rows, place)
    });
    let estimate = Estimate {
        value: rows[place].value,
        error,
    };
    Some((estimate, Some(rows[place].time)))
}

/// Overshoot of the parabola through an extreme and its neighbours.
fn beyond(rows: &[At], place: usize) -> f64 {
    let (Some(before), Some(after)) = (place.checked_sub(1).map(|i| &rows[i]), rows.get(place + 1))
    else {
        return 0.0;
    };
    let at = &rows[place];
    let slope = |a: &At, b: &At| (b.value - a.value) / (b.time - a.time);
    let [left, right] = [slope(before, at), slope(at, after)];
    let curvature = (right - left) / (after.time - before.time);
    let tangent = left + curvature * (at.time - before.time);
    let found = tangent * tangent / (4.0 * curvature.abs());
    if found.is_finite() { found } else { 0.0 }
}

/// The mean over time by the trapezoidal rule; its bar covers those of the instants, and a third of the difference from every second instant.
fn mean(rows: &[At]) -> Option<Estimate> {
    let (first, last) = (rows.first()?, rows.last()?);
    let duration = last.time - first.time;
    let integral = |rows: &[(f64, f64)]| {
        let pairs = rows.windows(2);
        let areas = pairs.map(|pair| 0.5 * (pair[0].1 + pair[1].1) * (pair[1].0 - pair[0].0));
        areas.sum::<f64>() / duration
    };
    if duration <= 0.0 {
        return None;
    }
    let values: Vec<(f64, f64)> = rows.iter().map(|at| (at.time, at.value)).collect();
    let value = integral(&values);
    let bars: Option<Vec<(f64, f64)>> = (rows.iter()).map(|at| Some((at.time, at.bar?))).collect();
    let error = bars.map(|bars| {
        let mut coarse: Vec<(f64, f64)> = values.iter().copied().step_by(2).collect();
        if values.len().is_multiple_of(2) {
            coarse.extend(values.last());
        }
        integral(&bars) + (integral(&coarse) - value).abs() / 3.0
    });
    Some(Estimate { value, error })
}

/// A figure without error bar, with its instant.
fn without_bar(name: &str, found: &TransientSolution) -> Option<(f64, Option<f64>)> {
    let instants = &found.instants;
    let largest = |value: fn(&InstantSolution) -> f64| {
        let rows = instants.iter().map(|i| (value(i), Some(i.time)));
        rows.filter(|(value, _)| value.is_finite())
            .max_by(|a, b| a.0.total_cmp(&b.0))
    };
    let ratios = || {
        let rows = found.amplitude_ratios.iter().zip(instants);
        rows.filter_map(|(ratio, instant)| Some(((*ratio)?, Some(instant.time))))
    };
    let moves = || found.moves().then_some(());
    match name {
        "amplitude_ratio_lowest" => ratios().min_by(|a, b| a.0.total_cmp(&b.0)),
        "amplitude_ratio_highest" => ratios().max_by(|a, b| a.0.total_cmp(&b.0)),
        "amplitude_ratio_last" => ratios().next_back(),
        "film_force_highest" => moves().and_then(|()| largest(|i| i.film_force)),
        "approach_highest" => moves().and_then(|()| largest(|i| i.approach)),
        "coefficient_of_restitution" => Some((found.restitution()?.value, None)),
        "mass_error_highest" => largest(|i| i.mass_error.abs()),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;

    fn rows(of: &[[f64; 3]]) -> Vec<At> {
        let at = |[time, value, bar]: &[f64; 3]| At {
            time: *time,
            value: *value,
            bar: Some(*bar),
        };
        of.iter().map(at).collect()
    }

    /// By hand: 5 ± 1, 3 ± 0.5, 4 ± 2: from the bars, the lowest is between 2 and 3.5. The parabola through (0, 5), (1, 3), (3, 4) has the divided differences −2 and ½, the second
    /// difference 5/6 and at t = 1 the slope −7/6; it falls (7/6)²/(4·5/6) = 49/120 below 3. The highest value is at the end of the run and has no overshoot.
    #[test]
    fn extremes_by_hand() {
        let rows = rows(&[[0.0, 5.0, 1.0], [1.0, 3.0, 0.5], [3.0, 4.0, 2.0]]);
        let (found, time) = lowest(&rows, 1.0).unwrap();
        assert_eq!((found.value, time), (3.0, Some(1.0)));
        assert_relative_eq!(
            found.error.unwrap(),
            1.0 + 49.0 / 120.0,
            max_relative = 1e-14
        );
        let (found, time) = lowest(&rows, -1.0).unwrap();
        assert_eq!((found.value, time), (5.0, Some(0.0)));
        // At most 4 + 2 = 6, and at least 5 − 1.
        assert_relative_eq!(found.error.unwrap(), 1.0);
    }

    /// t² at 0, 1, 2, 3, 4: the trapezoidal rule gives 22 for 64/3 with steps of one and 24 with steps of two; without bars of the values, the bar equals the error.
    #[test]
    fn a_mean_by_hand() {
        let squares: Vec<[f64; 3]> = (0..5)
            .map(|i| [f64::from(i), f64::from(i * i), 0.0])
            .collect();
        let found = mean(&rows(&squares)).unwrap();
        assert_relative_eq!(found.value, 22.0 / 4.0);
        assert_relative_eq!(
            found.error.unwrap(),
            (22.0 - 64.0 / 3.0) / 4.0,
            max_relative = 1e-12
        );
        let with_bars: Vec<[f64; 3]> = squares.iter().map(|[t, v, _]| [*t, *v, 0.25]).collect();
        let wider = mean(&rows(&with_bars)).unwrap();
        assert_relative_eq!(
            wider.error.unwrap() - found.error.unwrap(),
            0.25,
            max_relative = 1e-12
        );
        assert!(mean(&rows(&[[1.0, 2.0, 0.0]])).is_none());
    }

    #[test]
    fn every_name_has_words_and_occurs_once() {
        let names: Vec<&str> = (REPORTED.iter().map(|row| row.name))
            .chain(WITHOUT_BAR.iter().map(|(name, ..)| *name))
            .collect();
        for (i, name) in names.iter().enumerate() {
            assert!(
                words_of(name).is_some() && !names[..i].contains(name),
                "{name}"
            );
        }
        assert_eq!(words_of("film"), None);
    }
}
