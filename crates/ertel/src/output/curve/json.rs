//! `curve.json`: the points in machine-readable form.

use serde_json::{Value, json};

use super::super::result_json::{FORMAT_VERSION, figures_json, units};
use super::super::rows::rows_json;
use crate::case::CaseEcho;
use crate::run::NUMERICS;
use crate::study::{CurveSolution, Outcome, PointSolution};
use crate::warning::{codes, silenced, texts};

/// Value of the key `format` that identifies curve results.
pub const CURVE_FORMAT: &str = "ertel-curve";

/// The JSON document in SI units.
pub fn curve_json(case: &CaseEcho, curve: &CurveSolution) -> serde_json::Result<Value> {
    let points = (curve.points.iter().enumerate())
        .map(|(i, point)| point_json(i, point))
        .collect::<serde_json::Result<Vec<Value>>>()?;
    let warnings: Vec<_> = curve
        .points
        .iter()
        .flat_map(PointSolution::warnings)
        .collect();
    Ok(json!({
        "format": CURVE_FORMAT,
        "format_version": FORMAT_VERSION,
        "ertel_version": env!("CARGO_PKG_VERSION"),
        "numerics_version": NUMERICS,
        "title": case.title,
        "quantity": {
            "path": curve.quantity.path,
            "name": curve.quantity.name,
            "unit": curve.quantity.unit(),
        },
        "n_points": curve.n_points,
        "n_failed": curve.n_failed(),
        "complete": !curve.is_partial(),
        "wall_seconds": curve.wall_seconds,
        "silenced": silenced(&warnings),
        "points": points,
        "case": { "given": case.given, "si": serde_json::to_value(case)? },
        "units": units((curve.points.first()).is_some_and(|p| p.case.contact.kind.is_line())),
    }))
}

/// A point of a curve, as in `points` of [`curve_json`]; `index` counts from 0. Machines have their figures.
///
/// # Errors
/// Those of serde.
pub fn point_json(index: usize, point: &PointSolution) -> serde_json::Result<Value> {
    let mut json = json!({
        "point": index + 1,
        "value": point.value,
        "converged": point.outcome.is_solved(),
        "seconds": point.seconds,
    });
    if point.machine.is_some() || point.is_in_time {
        add_rows(&mut json, point);
        if let Some(reason) = point.outcome.reason() {
            json["reason"] = json!(reason);
        }
        return Ok(json);
    }
    json["formulas"] = (point.formulas.iter())
        .map(|f| json!({ "name": f.name, "film_central": f.central, "film_minimum": f.minimum }))
        .collect();
    match &point.outcome {
        Outcome::Solved(s) => {
            json["figures"] = figures_json(s);
            json["summary"] = serde_json::to_value(&s.summary)?;
            json["hertz"] = serde_json::to_value(s.hertz)?;
            json["groups"] = serde_json::to_value(s.groups)?;
            json["traction"] = serde_json::to_value(&s.traction)?;
            json["film_reduction"] = serde_json::to_value(point.film_reduction())?;
            if let Some(mixed) = &s.mixed {
                json["mixed"] = serde_json::to_value(mixed)?;
            }
            if let Some(thermal) = &s.thermal {
                json["thermal"] = serde_json::to_value(thermal)?;
                json["thermal"]["reduction"] = serde_json::to_value(point.thermal_reduction())?;
            }
            json["stats"] = serde_json::to_value(&s.stats)?;
            json["unresolved"] = serde_json::to_value(&s.unresolved)?;
            json["warnings"] = json!(texts(&s.warnings));
            json["warning_codes"] = json!(codes(&s.warnings));
        }
        // Handled above.
        Outcome::InTime(_) => {}
        Outcome::Failed(reason) => json["reason"] = json!(reason),
    }
    if let Some(newtonian) = &point.newtonian {
        json["newtonian"] = simpler_json(newtonian)?;
    }
    if let Some(isothermal) = &point.isothermal {
        json["isothermal"] = simpler_json(isothermal)?;
    }
    Ok(json)
}

/// The figures of a whole machine or of a run in time.
fn add_rows(json: &mut Value, point: &PointSolution) {
    let rows = Value::from(rows_json(point.rows()));
    if let Some(machine) = &point.machine {
        json["figures"] = rows;
        json["n_contacts"] = json!(machine.solution.n_contacts());
        json["n_failed"] = json!(machine.solution.n_failed());
        json["unresolved"] = json!(point.is_unresolved());
    } else if let Some(run) = point.outcome.in_time() {
        json["over_time"] = rows;
        json["steps"] = json!(run.steps[0]);
        json["refused_steps"] = json!(run.steps[1]);
        json["newton_iterations"] = json!(run.newton_iterations);
        json["unresolved"] = json!(run.unresolved);
    } else {
        return;
    }
    let warnings = point.warnings();
    json["warnings"] = json!(texts(&warnings));
    json["warning_codes"] = json!(codes(&warnings));
}

/// A simpler case solved at the same point.
fn simpler_json(outcome: &Outcome) -> serde_json::Result<Value> {
    Ok(match outcome {
        Outcome::Solved(s) => json!({
            "converged": true,
            "figures": figures_json(s),
            "summary": serde_json::to_value(&s.summary)?,
            "traction": serde_json::to_value(&s.traction)?,
            "warnings": texts(&s.warnings),
        }),
        // Curves of transient cases have no simpler solutions.
        Outcome::InTime(_) => json!({ "converged": true }),
        Outcome::Failed(reason) => json!({ "converged": false, "reason": reason }),
    })
}
