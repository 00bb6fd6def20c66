//! A whole machine by closed forms: figures and contacts, as text and as JSON.

use serde_json::{Map, Value, json};

use super::super::lines::{Lines, Table};
use super::super::rows::{rows_json, shown};
use super::json::{contact_json, rows_of};
use super::report::write_figures;
use crate::case::{CaseEcho, MachineAxis, MachineContact, Mechanics};
use crate::figures::{Definition, bearing, cam, gears, machine};
use crate::machine::{ContactColumn, MachineEstimate};
use crate::words::{digits, force, length, pressure};

/// Figures of the summary of a check.
const SUMMARY: [Definition; 19] = [
    machine::FILM_MINIMUM,
    machine::LAMBDA_MINIMUM,
    bearing::STATIC_SAFETY_FACTOR,
    bearing::KAPPA,
    bearing::LIFE_FACTOR,
    bearing::BASIC_RATING_LIFE_TIME,
    bearing::REFERENCE_RATING_LIFE_TIME,
    bearing::MODIFIED_RATING_LIFE_TIME,
    bearing::FRICTION_TORQUE_SKF,
    bearing::FRICTION_TORQUE_PALMGREN,
    gears::TRANSVERSE_CONTACT_RATIO,
    gears::FRICTION_POWER_MODELS,
    gears::FLASH_TEMPERATURE,
    gears::CONTACT_TEMPERATURE,
    gears::SCUFFING_SAFETY,
    gears::SPECIFIC_FILM_MINIMUM,
    gears::MICROPITTING_SAFETY,
    cam::PRESSURE_ANGLE_MAXIMUM,
    cam::TORQUE_MAXIMUM,
];

/// Most rows of contacts over a turn.
const MOST_ROWS: usize = 24;

/// The main figures, without their sources.
pub(in crate::output) fn write_summary(out: &mut Lines, estimate: &MachineEstimate) {
    for figure in SUMMARY {
        if let Some(row) = estimate.figures.find(figure.name) {
            out.row(figure.words, shown(row));
        }
    }
}

/// The figures by section and the contacts.
pub(in crate::output) fn write_estimate(out: &mut Lines, estimate: &MachineEstimate) {
    write_figures(out, &estimate.figures, &estimate.absent);
    out.heading("Contacts by formulas");
    let whole = &estimate.machine;
    let columns: Vec<&ContactColumn> = (estimate.columns.iter())
        .filter(|column| column.head.is_some() && column.values.iter().any(Option::is_some))
        .collect();
    let of_place = match whole.axis {
        MachineAxis::LineOfAction => Some("position"),
        MachineAxis::Around | MachineAxis::CamAngle => None,
    };
    let load = (whole.axis != MachineAxis::LineOfAction).then_some("load");
    let head = [Some("contact"), of_place, load, Some("p_h")];
    let heads = columns.iter().map(|column| column.head);
    let head = head.into_iter().chain(heads).flatten().map(str::to_owned);
    let row = |i: usize| -> Vec<String> {
        let contact = &whole.contacts[i];
        let first = [
            Some(name(contact, whole.count(i))),
            of_place.map(|_| format!("{} mm", digits(1e3 * contact.place, 3))),
            load.map(|_| force(contact.load, whole.is_line, 4)),
            Some(pressure(contact.hertz_pressure)),
        ];
        let cells = (columns.iter()).map(|column| Some(cell(column.values[i], column.unit)));
        first.into_iter().chain(cells).flatten().collect()
    };
    let shown = shown_contacts(estimate);
    let n = (whole.contacts.iter().enumerate())
        .filter(|(i, contact)| contact.like == Some(*i))
        .count();
    let rows = shown.iter().map(|i| row(*i)).collect();
    out.table(Table::fitted(head.collect(), rows));
    if shown.len() < n {
        out.note(&format!(
            "{} of {n} different contacts; --json has all",
            shown.len()
        ));
    }
}

/// The contacts in the table: of a path those with a letter, over a turn at most [`MOST_ROWS`] at even distances, else all that differ.
fn shown_contacts(estimate: &MachineEstimate) -> Vec<usize> {
    let whole = &estimate.machine;
    let own = whole.contacts.iter().enumerate();
    let own: Vec<usize> = own
        .filter(|(i, contact)| contact.like == Some(*i))
        .map(|(i, _)| i)
        .collect();
    match whole.axis {
        MachineAxis::Around => own,
        MachineAxis::LineOfAction => {
            let named = |i: &usize| whole.contacts[*i].name.contains(", ");
            own.into_iter().filter(named).collect()
        }
        MachineAxis::CamAngle => {
            let step = own.len().div_ceil(MOST_ROWS).max(1);
            let at = own.iter().position(|i| *i == whole.governing).unwrap_or(0);
            own.into_iter().skip(at % step).step_by(step).collect()
        }
    }
}

/// A contact in a table; of a path its letter, else with the number of contacts that are like it.
fn name(contact: &MachineContact, n: usize) -> String {
    match (contact.name.split_once(", "), n) {
        (Some((letter, _)), _) if letter.chars().count() == 1 => letter.to_owned(),
        (_, 0 | 1) => contact.name.clone(),
        (_, n) => format!("{} ×{n}", contact.name),
    }
}

/// A value in a table by its SI unit.
fn cell(value: Option<f64>, unit: &str) -> String {
    let Some(value) = value else {
        return "-".to_owned();
    };
    match unit {
        "m" => length(value),
        "rad" => format!("{}°", digits(value.to_degrees(), 4)),
        "" => digits(value, 3),
        unit => format!("{} {unit}", digits(value, 3)),
    }
}

/// The keys of the machine in the document, named as in `machine.json`.
pub(in crate::output) fn estimate_values(
    case: &CaseEcho,
    estimate: &MachineEstimate,
) -> Map<String, Value> {
    let whole = &estimate.machine;
    let contacts = whole.contacts.iter().enumerate().map(|(i, contact)| {
        let mut value = contact_json(whole, i, contact);
        for column in &estimate.columns {
            value[column.name] = json!(column.values[i]);
        }
        value
    });
    let absent = estimate.absent.iter();
    let absent: Map<String, Value> = absent
        .map(|(figure, needs)| (figure.name.to_owned(), json!(needs)))
        .collect();
    let values = json!({
        "machine": rows_of(case),
        "governing_contact": whole.governing + 1,
        "figures": rows_json(&estimate.figures.all),
        "not_estimated": absent,
        "contacts": contacts.collect::<Vec<Value>>(),
    });
    let Value::Object(mut values) = values else {
        return Map::new();
    };
    if let Mechanics::Cam(cam) = &whole.mechanics {
        values.insert("entrainment_reversals".to_owned(), json!(cam.reversals));
    }
    values
}

/// Units of the quantities of contacts.
pub(in crate::output) fn estimate_units(estimate: &MachineEstimate) -> Map<String, Value> {
    let columns = estimate.columns.iter();
    let of_columns = columns.map(|column| (column.name, column.unit));
    let whole = &estimate.machine;
    let load = match whole.is_line {
        true => "N/m",
        false => "N",
    };
    of_columns
        .chain([
            (whole.axis.name(), whole.axis.unit()),
            ("load", load),
            ("entrainment_reversals", "rad"),
        ])
        .filter(|(_, unit)| !unit.is_empty())
        .map(|(name, unit)| (name.to_owned(), json!(unit)))
        .collect()
}
