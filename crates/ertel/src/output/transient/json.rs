//! `transient.json`: the instants in machine-readable form.

use serde_json::{Map, Value, json};

use super::super::result_json::{FORMAT_VERSION, units};
use super::super::rows::rows_json;
use super::conditions::CONDITIONS;
use super::table::unresolved;
use crate::case::CaseEcho;
use crate::run::NUMERICS;
use crate::run::over_time::over_time;
use crate::run::transient::TransientSolution;
use crate::solution::Figure;
use crate::warning::{codes, silenced, texts};

/// Value of the key `format` that identifies the results of a transient case.
pub const TRANSIENT_FORMAT: &str = "ertel-transient";

/// The JSON document in SI units.
pub fn transient_json(case: &CaseEcho, found: &TransientSolution) -> serde_json::Result<Value> {
    let is_line = case.contact.kind.is_line();
    let instants: Vec<Value> = (found.instants.iter().enumerate())
        .map(|(i, instant)| {
            let measured = &instant.measured;
            let figures: Map<String, Value> = (Figure::ALL.into_iter())
                .filter_map(|figure| {
                    let reading = measured.figures.get(figure)?;
                    let mut json = json!({ "value": reading.value });
                    if let Some(bar) = measured.bars.get(figure) {
                        json["error"] = json!(bar.value);
                    }
                    if let Some(place) = reading.place {
                        json["place"] = json!(place);
                    }
                    Some((figure.name().to_owned(), json))
                })
                .collect();
            let mut row = json!({ "time": instant.time });
            for condition in &CONDITIONS {
                row[condition.name] = json!((condition.value)(instant));
            }
            row["figures"] = figures.into();
            row["unresolved"] = json!(unresolved(instant));
            row["step"] = json!(instant.step);
            row["newton_iterations"] = json!(instant.newton_iterations);
            row["mass_error"] = json!(instant.mass_error);
            if let Some(ratio) = found.amplitude_ratios.get(i) {
                row["amplitude_ratio"] = json!(ratio);
            }
            row
        })
        .collect();
    let profiles: Vec<Value> = (found.profiles.iter())
        .map(|profile| {
            json!({
                "time": profile.time,
                "x": profile.x,
                "pressure": profile.pressure,
                "film_thickness": profile.film,
            })
        })
        .collect();
    let mut units = units(is_line);
    for (name, unit) in [
        ("radius", "m"),
        ("temperature", "K"),
        ("oil_layer", "m"),
        ("body_1_spin", "rad/s"),
        ("body_2_spin", "rad/s"),
        ("approach", "m"),
        ("approach_velocity", "m/s"),
        ("film_force", if is_line { "N/m" } else { "N" }),
        ("coefficient_of_restitution", "1"),
        ("coefficient_of_restitution_error", "1"),
        ("amplitude_ratio", "1"),
    ] {
        units[name] = json!(unit);
    }
    let restitution = found.restitution();
    Ok(json!({
        "format": TRANSIENT_FORMAT,
        "format_version": FORMAT_VERSION,
        "ertel_version": env!("CARGO_PKG_VERSION"),
        "numerics_version": NUMERICS,
        "title": case.title,
        "complete": found.failure.is_none(),
        "reason": found.failure.as_ref().map(ToString::to_string),
        "coefficient_of_restitution": restitution.map(|of| of.value),
        "coefficient_of_restitution_error": restitution.and_then(|of| of.error),
        "over_time": rows_json(&over_time(found, is_line)),
        "steps": found.info.steps,
        "refused_steps": found.info.refused,
        "newton_iterations": found.info.newton_iterations,
        "wall_seconds": found.wall_seconds,
        "warnings": texts(&found.warnings),
        "warning_codes": codes(&found.warnings),
        "silenced": silenced(&found.warnings),
        "instants": instants,
        "profiles": profiles,
        "case": { "given": case.given, "si": serde_json::to_value(case)? },
        "units": units,
    }))
}
