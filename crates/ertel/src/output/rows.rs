//! Figures of machines and of runs in time, as text and as JSON.

use serde_json::{Map, Value, json};

use super::figure::{estimate, in_unit, peak_of, pressure_estimate, temperature};
use crate::figures::{Definition, Row, bearing, gears, machine, run};
use crate::mark::Mark;
use crate::solution::{Estimate, Kind};
use crate::words::{digits, pressure};

/// Figures listed in the report of a curve for each machine or run, and by the statistics of samples.
pub(super) const REPORTED: [Definition; 20] = [
    machine::FILM_MINIMUM,
    machine::LAMBDA_MINIMUM,
    bearing::FRICTION_TORQUE,
    bearing::FRICTION_POWER,
    gears::MESH_LOSS,
    gears::FRICTION_COEFFICIENT_MEAN,
    bearing::BEARING_TEMPERATURE,
    gears::CONTACT_TEMPERATURE,
    bearing::STATIC_SAFETY_FACTOR,
    gears::SCUFFING_SAFETY,
    gears::MICROPITTING_SAFETY,
    bearing::MODIFIED_RATING_LIFE,
    run::FILM_CENTRAL_LOWEST,
    run::FILM_MINIMUM_LOWEST,
    run::FILM_CENTRAL_LAST,
    run::PRESSURE_MAXIMUM_HIGHEST,
    run::TRACTION_COEFFICIENT_HIGHEST,
    run::TRACTION_COEFFICIENT_MEAN,
    run::AMPLITUDE_RATIO_LAST,
    run::COEFFICIENT_OF_RESTITUTION,
];

/// Rows by name.
pub(super) fn rows_json(rows: &[Row]) -> Map<String, Value> {
    let json = |row: &Row| {
        let (estimate, is_of_run) = (row.estimate, row.figure.is_of_run());
        let mut json = json!({ "value": estimate.value, "error": estimate.error });
        if is_of_run {
            json["time"] = json!(row.time);
        }
        json["resolved"] = json!(estimate.is_resolved());
        if !is_of_run {
            json["marks"] = estimate.marks.iter().map(Mark::name).collect();
        }
        json["unit"] = json!(row.unit);
        json["words"] = json!(row.figure.words);
        if !is_of_run {
            json["source"] = json!(row.source);
        }
        (row.figure.name.to_owned(), json)
    };
    rows.iter().map(json).collect()
}

/// A figure with its display unit and the symbols of its marks; where it is not resolved there is no number, or a lower bound of a largest pressure.
pub(super) fn shown(row: &Row) -> String {
    let marks = row.estimate.marks;
    match (marks.has(Mark::Unresolved), row.figure.kind) {
        (true, Kind::PeakPressure) => peak_of(row.estimate.estimate(), false),
        (true, _) => format!("not resolved{}", marks.symbols()),
        (false, _) => with_unit(row) + &marks.symbols(),
    }
}

/// A figure with its unit.
fn with_unit(row: &Row) -> String {
    let e = row.estimate.estimate();
    let is_small = e.value.abs() < 1.0;
    match row.figure.kind {
        Kind::Length => estimate(&e),
        Kind::Temperature => temperature(e, None),
        Kind::Stress if e.error.is_none() => pressure(e.value),
        Kind::PeakPressure | Kind::Stress => pressure_estimate(e),
        // Powers of runs may be per length.
        Kind::Power if is_small && !row.figure.is_of_run() => in_unit(e, 1e3, "mW"),
        Kind::Moment if is_small => in_unit(e, 1e3, "N mm"),
        Kind::Duration => life(e, 1.0 / 3600.0, "h"),
        Kind::Revolutions => life(e, 1.0, row.unit),
        Kind::Angle => in_unit(e, 1f64.to_degrees(), "deg"),
        _ => in_unit(e, 1.0, row.unit),
    }
}

/// Larger numbers are written with a power of ten: a life does not have that many digits.
const MANY: f64 = 1e6;

/// A rating life.
fn life(e: Estimate, factor: f64, unit: &str) -> String {
    match (e.error, factor * e.value) {
        (None, value) if value >= MANY => format!("{value:.3e} {unit}"),
        (None, value) => format!("{} {unit}", digits(value, 4)),
        (Some(_), _) => in_unit(e, factor, unit),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mark::{Marked, Marks};

    /// By hand. Powers of runs, which may be per length, keep their unit; a largest pressure that is not resolved is a lower bound.
    #[test]
    fn rows_have_display_units() {
        for (figure, value, text) in [
            (bearing::FRICTION_POWER, 0.25, "250 mW"),
            (run::FRICTION_POWER_MEAN, 0.25, "0.25 W"),
            (bearing::FRICTION_TORQUE, 0.0125, "12.5 N mm"),
            (gears::FLASH_TEMPERATURE, 20.0, "20 K"),
            (gears::MESH_LOSS, 0.0125, "0.0125"),
            (bearing::BASIC_RATING_LIFE_TIME, 7200.0, "2 h"),
            (machine::FILM_MINIMUM, 250e-9, "250 nm"),
        ] {
            assert_eq!(shown(&figure.row(value, "")), text);
        }
        let unresolved = |value: f64| Marked {
            marks: Marks::when(true, Mark::Unresolved),
            ..Marked::exact(value)
        };
        let peak = run::PRESSURE_MAXIMUM_HIGHEST.row(unresolved(1.0169e9), "");
        assert_eq!(shown(&peak), "at least 1.01 GPa, not resolved");
        let film = run::FILM_MINIMUM_LAST.row(unresolved(1e-7), "");
        assert_eq!(shown(&film), "not resolved");
    }

    #[test]
    fn rows_of_machines_have_sources_and_those_of_runs_instants() {
        let rows = [
            bearing::KAPPA.row(2.0, "ISO 281"),
            run::APPROACH_HIGHEST.row(1e-6, ""),
        ];
        let json = rows_json(&rows);
        let keys =
            |name: &str| -> Vec<&String> { json[name].as_object().unwrap().keys().collect() };
        assert_eq!(
            keys("kappa"),
            [
                "value", "error", "resolved", "marks", "unit", "words", "source"
            ]
        );
        assert_eq!(
            keys("approach_highest"),
            ["value", "error", "time", "resolved", "unit", "words"]
        );
    }
}
