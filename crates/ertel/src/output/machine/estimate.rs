//! A whole machine by closed forms: figures and contacts, as text and as JSON.

use serde_json::{Map, Value, json};

use super::super::lines::{Lines, Table};
use super::super::rows::{rows_json, shown};
use super::json::{contact_figures_json, contact_json, rows_of};
use super::report::write_figures;
use crate::case::{CaseEcho, MachineAxis, Mechanics, WholeMachine};
use crate::figures::at_contacts::{ContactFigure, Place};
use crate::figures::{Definition, bearing, cam, element, gears, machine, path, turn};
use crate::machine::MachineEstimate;
use crate::words::{digits, length, pressure};

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

/// Figures of the table of contacts, with their heads.
const BEARING: &[(Definition, &str)] = &[
    (element::ELEMENT_LOAD, "load"),
    (element::CONTACT_ANGLE, "angle"),
];
const GEARS: &[(Definition, &str)] = &[
    (path::LOAD_SHARE, "share"),
    (path::SLIDING_SPEED, "sliding"),
    (path::FLASH_TEMPERATURE, "flash"),
    (path::SPECIFIC_FILM, "λ_GF"),
];
const CAM: &[(Definition, &str)] = &[
    (turn::FOLLOWER_FORCE, "force"),
    (turn::PRESSURE_ANGLE, "angle φ"),
    (turn::ENTRAINMENT_SPEED, "u_m"),
];

/// The figures by section and the contacts.
pub(in crate::output) fn write_estimate(out: &mut Lines, estimate: &MachineEstimate) {
    write_figures(out, &estimate.figures, &estimate.absent);
    out.heading("Contacts by formulas");
    let whole = &estimate.machine;
    let at_contacts = &estimate.figures.at_contacts;
    let figures = match &whole.mechanics {
        Mechanics::Bearing(_) => BEARING,
        Mechanics::Gears(_) => GEARS,
        Mechanics::Cam(_) => CAM,
    };
    let figures: Vec<(&ContactFigure, &str)> = (figures.iter())
        .filter_map(|(figure, head)| Some((at_contacts.find(*figure)?, *head)))
        .collect();
    let films = (estimate.films.iter().zip(["h_c", "h_min"]))
        .filter(|(films, _)| films.iter().any(Option::is_some));
    let films: Vec<_> = films.collect();
    let heads = figures.iter().map(|(_, head)| *head);
    let of_films = films.iter().map(|(_, head)| *head);
    let head = ["contact", "p_h"].into_iter().chain(heads).chain(of_films);
    let row = |i: usize| -> Vec<String> {
        let contact = &whole.contacts[i];
        let is_it = |place: &Place| place.contact == i && place.beyond.is_none();
        let place = at_contacts.places.iter().position(is_it);
        let own = figures.iter().map(|(of, _)| {
            let value = place.and_then(|place| of.values[place]);
            value.map(|value| shown(&of.figure.row(value, "")))
        });
        let films = films.iter().map(|(of, _)| Some(length(of[i]?.value)));
        let cells = own.chain(films);
        let cells = cells.map(|cell| cell.unwrap_or_else(|| "-".to_owned()));
        let first = [name(whole, i), pressure(contact.hertz_pressure)];
        first.into_iter().chain(cells).collect()
    };
    let shown = shown_contacts(estimate);
    let n = (whole.contacts.iter().enumerate())
        .filter(|(i, contact)| contact.like == Some(*i))
        .count();
    let rows = shown.iter().map(|i| row(*i)).collect();
    out.table(Table::fitted(head.map(str::to_owned).collect(), rows));
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

/// A contact in a table; of a path its letter and its distance from the pitch point, else with the number of contacts that are like it.
fn name(whole: &WholeMachine, i: usize) -> String {
    let contact = &whole.contacts[i];
    match (contact.name.split_once(", "), whole.count(i)) {
        (Some((letter, _)), _) if whole.axis == MachineAxis::LineOfAction => {
            format!("{letter} ({} mm)", digits(1e3 * contact.place, 3))
        }
        (_, 0 | 1) => contact.name.clone(),
        (_, n) => format!("{} ×{n}", contact.name),
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
        for (films, name) in estimate.films.iter().zip(["film_central", "film_minimum"]) {
            value[name] = json!(films[i].map(|film| film.value));
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
        "contact_figures": contact_figures_json(whole.axis, &estimate.figures.at_contacts),
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
    let whole = &estimate.machine;
    let load = match whole.is_line {
        true => "N/m",
        false => "N",
    };
    [
        (whole.axis.name(), whole.axis.unit()),
        ("load", load),
        ("entrainment_reversals", "rad"),
        ("film_central", "m"),
        ("film_minimum", "m"),
    ]
    .map(|(name, unit)| (name.to_owned(), json!(unit)))
    .into_iter()
    .collect()
}
