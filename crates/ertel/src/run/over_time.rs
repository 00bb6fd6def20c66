//! Figures of a whole transient run: extremes with their instants, means, and final values.
//!
//! Films and pressures are known at instants, with error bars e_i. The minimum over time is within
//! ```text
//!   min_i (f_i − e_i)  ≤  min_i f_i  ≤  min_i (f_i + e_i)
//! ```
//! It may also be between two instants: the error bar covers both ends of this interval, and the overshoot of the parabola through an extreme and its neighbours.

use super::transient::{InstantSolution, TransientSolution};
use crate::figures::run::{
    AMPLITUDE_RATIO_HIGHEST, AMPLITUDE_RATIO_LAST, AMPLITUDE_RATIO_LOWEST, APPROACH_HIGHEST,
    ASPERITY_LOAD_SHARE_HIGHEST, COEFFICIENT_OF_RESTITUTION, FILM_CENTRAL_HIGHEST,
    FILM_CENTRAL_LAST, FILM_CENTRAL_LOWEST, FILM_FORCE_HIGHEST, FILM_MINIMUM_LAST,
    FILM_MINIMUM_LOWEST, FILM_TEMPERATURE_MAXIMUM_HIGHEST, FRICTION_POWER_MEAN,
    FRICTION_TOTAL_HIGHEST, FRICTION_TOTAL_MEAN, MASS_ERROR_HIGHEST, MEAN_GAP_MINIMUM_LOWEST,
    NEAR_SURFACE_DANG_VAN_BODY_1_HIGHEST, NEAR_SURFACE_DANG_VAN_BODY_2_HIGHEST,
    PRESSURE_MAXIMUM_HIGHEST, TRACTION_COEFFICIENT_HIGHEST, TRACTION_COEFFICIENT_MEAN,
    VON_MISES_BODY_1_HIGHEST, VON_MISES_BODY_2_HIGHEST,
};
use crate::figures::{Definition, Row};
use crate::mark::{Mark, Marked, Marks};
use crate::solution::{Estimate, Figure};

/// Reduction of a figure over time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Over {
    Lowest,
    Highest,
    Mean,
    Last,
}

/// Reported reductions of the figures of instants, in order. The sign of friction is its direction: extremes are of its magnitude.
const REDUCTIONS: [(Figure, Over, Definition); 18] = [
    (Figure::FilmCentral, Over::Lowest, FILM_CENTRAL_LOWEST),
    (Figure::FilmCentral, Over::Highest, FILM_CENTRAL_HIGHEST),
    (Figure::FilmCentral, Over::Last, FILM_CENTRAL_LAST),
    (Figure::FilmMinimum, Over::Lowest, FILM_MINIMUM_LOWEST),
    (
        Figure::MeanGapMinimum,
        Over::Lowest,
        MEAN_GAP_MINIMUM_LOWEST,
    ),
    (Figure::FilmMinimum, Over::Last, FILM_MINIMUM_LAST),
    (
        Figure::PressureMaximum,
        Over::Highest,
        PRESSURE_MAXIMUM_HIGHEST,
    ),
    (
        Figure::TractionCoefficient,
        Over::Highest,
        TRACTION_COEFFICIENT_HIGHEST,
    ),
    (
        Figure::TractionCoefficient,
        Over::Mean,
        TRACTION_COEFFICIENT_MEAN,
    ),
    (
        Figure::AsperityLoadShare,
        Over::Highest,
        ASPERITY_LOAD_SHARE_HIGHEST,
    ),
    (Figure::FrictionTotal, Over::Highest, FRICTION_TOTAL_HIGHEST),
    (Figure::FrictionTotal, Over::Mean, FRICTION_TOTAL_MEAN),
    (Figure::FrictionPower, Over::Mean, FRICTION_POWER_MEAN),
    (
        Figure::FilmTemperatureMaximum,
        Over::Highest,
        FILM_TEMPERATURE_MAXIMUM_HIGHEST,
    ),
    (
        Figure::VonMisesBody1,
        Over::Highest,
        VON_MISES_BODY_1_HIGHEST,
    ),
    (
        Figure::VonMisesBody2,
        Over::Highest,
        VON_MISES_BODY_2_HIGHEST,
    ),
    (
        Figure::NearSurfaceDangVanBody1,
        Over::Highest,
        NEAR_SURFACE_DANG_VAN_BODY_1_HIGHEST,
    ),
    (
        Figure::NearSurfaceDangVanBody2,
        Over::Highest,
        NEAR_SURFACE_DANG_VAN_BODY_2_HIGHEST,
    ),
];

/// A value with its error bar at an instant.
#[derive(Clone, Copy, Debug)]
struct At {
    time: f64,
    value: f64,
    bar: Option<f64>,
}

/// The figures of a run of a line or another contact up to the reached time; figures without values are omitted.
pub fn over_time(found: &TransientSolution, is_line: bool) -> Vec<Row> {
    let reduced = REDUCTIONS
        .into_iter()
        .filter_map(|reduction| of_instants(reduction, &found.instants));
    let others = without_bar(found).into_iter();
    let others = others.filter_map(|(figure, value)| {
        let (value, time) = value?;
        let row = figure.row(value, "");
        Some(Row { time, ..row })
    });
    let rows = reduced.chain(others);
    rows.map(|row| Row {
        unit: row.figure.kind.unit(is_line),
        ..row
    })
    .collect()
}

fn of_instants(
    (figure, over, reduced): (Figure, Over, Definition),
    instants: &[InstantSolution],
) -> Option<Row> {
    let is_directed = matches!(
        figure,
        Figure::TractionCoefficient | Figure::FrictionTotal | Figure::FrictionPower
    );
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
    let (estimate, time) = match over {
        Over::Lowest => lowest(&rows, 1.0)?,
        Over::Highest => lowest(&rows, -1.0)?,
        Over::Mean => (mean(&rows)?, None),
        Over::Last => {
            let (value, error) = (last.value, last.bar);
            (Estimate { value, error }, Some(last.time))
        }
    };
    let narrow = |error: f64| error <= figure.widest_bar() * estimate.value.abs();
    let resolved = match over {
        Over::Last => instants.last()?.measured.is_resolved(figure),
        // A temperature is judged by its rise, which the instant provides.
        _ if figure == Figure::FilmTemperatureMaximum => {
            let at = instants.iter().find(|instant| Some(instant.time) == time)?;
            at.measured.is_resolved(figure)
        }
        _ => estimate.error.is_none_or(narrow),
    };
    let unresolved = Marks::when(!resolved, Mark::Unresolved);
    let row = reduced.row(Marked::from(estimate).with(unresolved), "");
    Some(Row { time, ..row })
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

/// A value with its instant, s.
type AtInstant = (f64, Option<f64>);

/// Figures without error bars.
fn without_bar(found: &TransientSolution) -> [(Definition, Option<AtInstant>); 7] {
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
    let of_moving = |value| found.moves().then(|| largest(value)).flatten();
    [
        (
            AMPLITUDE_RATIO_LOWEST,
            ratios().min_by(|a, b| a.0.total_cmp(&b.0)),
        ),
        (
            AMPLITUDE_RATIO_HIGHEST,
            ratios().max_by(|a, b| a.0.total_cmp(&b.0)),
        ),
        (AMPLITUDE_RATIO_LAST, ratios().next_back()),
        (FILM_FORCE_HIGHEST, of_moving(|i| i.film_force)),
        (APPROACH_HIGHEST, of_moving(|i| i.approach)),
        (
            COEFFICIENT_OF_RESTITUTION,
            found.restitution().map(|found| (found.value, None)),
        ),
        (MASS_ERROR_HIGHEST, largest(|i| i.mass_error.abs())),
    ]
}

#[cfg(test)]
mod tests {
    use crate::near::near;
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
        near(found.error.unwrap(), 1.0 + 49.0 / 120.0, 1e-14);
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
        near(found.error.unwrap(), (22.0 - 64.0 / 3.0) / 4.0, 1e-12);
        let with_bars: Vec<[f64; 3]> = squares.iter().map(|[t, v, _]| [*t, *v, 0.25]).collect();
        let wider = mean(&rows(&with_bars)).unwrap();
        near(wider.error.unwrap() - found.error.unwrap(), 0.25, 1e-12);
        assert!(mean(&rows(&[[1.0, 2.0, 0.0]])).is_none());
    }
}
