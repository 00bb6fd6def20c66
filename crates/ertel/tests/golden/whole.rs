//! Courses in time and whole machines, recorded as the documents that programs read.

use ertel::case::Case;
use ertel::engine::NoObserver;
use ertel::machine::figures;
use ertel::output::{machine_json, transient_json};
use ertel::run::transient;
use ertel::study::solve_in_balance;
use serde_json::{Value, json};

use super::record::Record;

/// Keys that differ from run to run or repeat the case.
const NOT_RECORDED: [&str; 10] = [
    "case",
    "contact_figures",
    "shaft",
    "ertel_version",
    "numerics_version",
    "peak_memory",
    "seconds",
    "wall_seconds",
    "silenced",
    "units",
];

/// Whether a case is a course in time or a whole machine; if so, adds its result.
pub fn note(record: &mut Record, case: &Case) -> Result<bool, String> {
    let text = |error: &dyn std::fmt::Display| error.to_string();
    if case.transient.is_some() {
        let found = transient::solve(case, &mut NoObserver);
        if let Some(failure) = &found.failure {
            return Err(failure.to_string());
        }
        let document = transient_json(&case.echo(), &found).map_err(|error| text(&error))?;
        note_document(record, "course", document);
        return Ok(true);
    }
    if case.contacts.is_none() {
        return Ok(false);
    }
    let solved = solve_in_balance(case, &mut NoObserver).map_err(|error| text(&error))?;
    let solved = solved.ok_or("no contacts")?;
    let figures = figures(&solved.case, &solved.solution);
    let document = machine_json(&solved.case.echo(), &solved.solution, &figures)
        .map_err(|error| text(&error))?;
    note_document(record, "whole", document);
    Ok(true)
}

fn note_document(record: &mut Record, section: &str, mut document: Value) {
    remove(&mut document);
    if let Some(instants) = document["instants"].as_array_mut() {
        for (i, instant) in instants.iter_mut().enumerate() {
            note_figures(record, &format!("instant {i} figures"), instant);
        }
    }
    note_figures(record, &format!("{section} figures"), &mut document);
    record.document(section, "", &document);
}

/// Takes the figures out of a document into a section that is compared within bars on other machines.
fn note_figures(record: &mut Record, section: &str, document: &mut Value) {
    let figures = (document.as_object_mut()).and_then(|entries| entries.remove("figures"));
    let Some(Value::Object(figures)) = figures else {
        return;
    };
    for (name, figure) in figures {
        if let Some(value) = figure["value"].as_f64() {
            record.float(section, &name, value);
        }
        if let Some(bar) = figure["error"].as_f64() {
            record.float(section, format!("{name} bar"), bar);
        }
        for key in ["place", "resolved", "marks"] {
            if let Some(value) = figure.get(key) {
                record.document(section, &format!("{name} {key}"), value);
            }
        }
    }
}

/// Numbers of a list that are recorded one by one; longer lists are recorded by their length and their sum.
const MOST_NUMBERS: usize = 16;

/// Removes what is not recorded, and shortens long lists of numbers, at any depth.
fn remove(value: &mut Value) {
    match value {
        Value::Array(values)
            if values.len() > MOST_NUMBERS && values.iter().all(Value::is_number) =>
        {
            let sum: f64 = values.iter().filter_map(Value::as_f64).sum();
            *value = json!({ "numbers": values.len(), "sum": sum });
        }
        Value::Object(entries) => {
            entries.retain(|key, _| !NOT_RECORDED.contains(&key.as_str()));
            entries.values_mut().for_each(remove);
        }
        Value::Array(values) => values.iter_mut().for_each(remove),
        _ => {}
    }
}
