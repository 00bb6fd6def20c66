//! `machine.json`: figures of the machine and its contacts, each with everything in `result.json` except iterations.

use serde_json::{Value, json};

use super::super::curve::point_json;
use super::super::result_json::{FORMAT_VERSION, units};
use super::super::rows::rows_json;
use super::table::COORDINATES;
use super::warnings;
use crate::case::{
    BearingMechanics, CaseEcho, MachineAxis, MachineContact, Mechanics, RINGS, WholeMachine,
};
use crate::figures::at_contacts::{ContactFigure, ContactFigures};
use crate::machine::MachineFigures;
use crate::mark::{Mark, Marks};
use crate::run::NUMERICS;
use crate::study::MachineSolution;
use crate::warning::{codes, silenced, texts};

/// Value of the key `format` that identifies machine results.
pub const MACHINE_FORMAT: &str = "ertel-machine";

/// The JSON document in SI units.
///
/// # Errors
/// Those of serde.
pub fn machine_json(
    case: &CaseEcho,
    machine: &MachineSolution,
    figures: &MachineFigures,
) -> serde_json::Result<Value> {
    let whole = &machine.machine;
    let warnings = warnings(machine, figures);
    let contacts = (whole.contacts.iter().enumerate())
        .map(|(i, contact)| {
            let mut value = contact_json(whole, i, contact);
            if let Some(point) = &machine.contacts[i] {
                let mut point = point_json(i, point)?;
                if let Some(keys) = point.as_object_mut() {
                    keys.remove("point");
                    keys.remove("value");
                }
                value["solution"] = point;
            }
            Ok(value)
        })
        .collect::<serde_json::Result<Vec<Value>>>()?;
    let mut document = json!({
        "format": MACHINE_FORMAT,
        "format_version": FORMAT_VERSION,
        "ertel_version": env!("CARGO_PKG_VERSION"),
        "numerics_version": NUMERICS,
        "title": case.title,
        "machine": rows_of(case),
        "governing_contact": whole.governing + 1,
        "figures": rows_json(&figures.all),
        "n_contacts": whole.contacts.len(),
        "n_solved": machine.n_solved(),
        "n_failed": machine.n_failed(),
        "complete": !machine.is_partial(),
        "wall_seconds": machine.wall_seconds,
        "warnings": texts(&warnings),
        "warning_codes": codes(&warnings),
        "silenced": silenced(&warnings),
        "contacts": contacts,
        "contact_figures": contact_figures_json(whole.axis, &figures.at_contacts),
        "case": { "given": case.given, "si": serde_json::to_value(case)? },
        "units": units(whole.is_line),
    });
    if let Mechanics::Bearing(bearing) = &whole.mechanics {
        document["shaft"] = shaft_json(bearing);
    }
    Ok(document)
}

/// Figures at each contact as arrays, and their places; two at a jump of the load.
pub(super) fn contact_figures_json(axis: MachineAxis, at_contacts: &ContactFigures) -> Value {
    let places = &at_contacts.places;
    let mut document = json!({
        "contact": places.iter().map(|place| place.contact + 1).collect::<Vec<_>>(),
        (axis.name()): places.iter().map(|place| place.at).collect::<Vec<_>>(),
    });
    if axis == MachineAxis::LineOfAction {
        document["label"] = places.iter().map(|place| place.label.clone()).collect();
        let beyond = places
            .iter()
            .map(|place| place.beyond.map(|side| side.name()));
        document["beyond"] = beyond.collect();
    }
    let of = |entry: &ContactFigure| {
        let values = || entry.values.iter();
        let marks: Marks = values().flatten().map(|value| value.marks).sum();
        let known = || values().map(|value| value.filter(|v| !v.marks.has(Mark::Unresolved)));
        let value = json!({
            "value": known().map(|value| Some(value?.value)).collect::<Vec<_>>(),
            "error": known().map(|value| value?.error).collect::<Vec<_>>(),
            "marks": marks.iter().map(Mark::name).collect::<Vec<_>>(),
            "unit": entry.unit,
            "words": entry.figure.words,
        });
        (entry.figure.name.to_owned(), value)
    };
    document["figures"] = Value::Object(at_contacts.all.iter().map(of).collect());
    document
}

/// Shifts, loads and stiffness of the inner ring of a bearing.
fn shaft_json(bearing: &BearingMechanics) -> Value {
    let found = &bearing.distribution;
    json!({
        "coordinates": COORDINATES,
        "displacement": bearing.displacement(),
        "load": found.reaction(),
        "stiffness": found.stiffness,
    })
}

/// The rows of the machine in its report.
pub(in crate::output) fn rows_of(case: &CaseEcho) -> Vec<Value> {
    let rows = case.machine.iter().flat_map(|machine| &machine.rows);
    rows.map(|(name, value)| json!([name, value])).collect()
}

/// A contact by the mechanics of the machine.
pub(in crate::output) fn contact_json(
    whole: &WholeMachine,
    i: usize,
    contact: &MachineContact,
) -> Value {
    let mut value = json!({
        "contact": i + 1,
        "name": contact.name,
        (whole.axis.name()): contact.place,
        "load": contact.load,
        "hertz_pressure": contact.hertz_pressure,
        "solved_as": contact.like.map(|like| like + 1),
    });
    if whole.has_sides() {
        value["ring"] = json!(RINGS[contact.side]);
    }
    value
}
