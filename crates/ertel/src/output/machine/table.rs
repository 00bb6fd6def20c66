//! `machine.csv`: one line per contact, and one more for the other side of each jump of the load. `shaft.csv`: shifts, loads and stiffness of a bearing.

use std::f64::consts::{PI, TAU};
use std::fmt::Write;

use crate::case::{BearingMechanics, MachineAxis, MachineContact, RINGS};
use crate::figures::at_contacts::{ContactFigure, ContactFigures, Place};
use crate::figures::path::{HERTZ_PRESSURE, LOAD};
use crate::figures::turn::ENTRAINMENT_SPEED;
use crate::files::text_field;
use crate::study::{Cell, Column, MachineSolution, columns, titled};

/// Coordinates of the inner ring of a bearing against the outer one: shifts along and tilts about the axes, x along the radial load and z along the bearing.
pub(super) const COORDINATES: [&str; 5] = ["x", "y", "z", "tilt_x", "tilt_y"];

/// The columns of studies, except the Hertz pressure, which the mechanics give for every contact.
fn figures() -> impl Iterator<Item = Column> {
    columns().filter(|column| column.name != HERTZ_PRESSURE.name)
}

/// The figures at contacts that are no columns of every machine.
fn own_figures(at_contacts: &ContactFigures) -> impl Iterator<Item = &ContactFigure> {
    let common = [LOAD, HERTZ_PRESSURE, ENTRAINMENT_SPEED];
    at_contacts.all.iter().filter(move |entry| {
        let name = entry.figure.name;
        !common.iter().any(|figure| figure.name == name) && !figures().any(|c| c.name == name)
    })
}

/// The table as text, SI. Equal contacts repeat the figures of the solved one; unloaded contacts have none of films.
pub fn machine_table(machine: &MachineSolution, at_contacts: &ContactFigures) -> String {
    table_of(machine, at_contacts, |_| true, |place| place)
}

/// The table of loaded contacts; angles around a bearing from −π to π, which keeps the loaded zone contiguous.
pub(in crate::output) fn table_of_pressed(
    machine: &MachineSolution,
    at_contacts: &ContactFigures,
) -> String {
    let is_around = machine.machine.axis == MachineAxis::Around;
    let shown = |place: f64| match is_around && place > PI {
        true => place - TAU,
        false => place,
    };
    table_of(
        machine,
        at_contacts,
        |contact| contact.like.is_some(),
        shown,
    )
}

/// The table of the kept contacts, with their displayed places.
fn table_of(
    machine: &MachineSolution,
    at_contacts: &ContactFigures,
    keeps: impl Fn(&MachineContact) -> bool,
    shown: impl Fn(f64) -> f64,
) -> String {
    let titles = titles(machine, at_contacts);
    let mut text = titles.join(",");
    text.push('\n');
    for (i, place) in at_contacts.places.iter().enumerate() {
        if !keeps(&machine.machine.contacts[place.contact]) {
            continue;
        }
        let mut row = mechanics(machine, at_contacts, (i, place), shown(place.at));
        row.extend(own_figures(at_contacts).flat_map(|entry| cells(entry, i)));
        row.extend(films(machine, at_contacts, (i, place)));
        row.resize(titles.len(), String::new());
        let fields: Vec<_> = row.iter().map(|field| text_field(field)).collect();
        text.push_str(&fields.join(","));
        text.push('\n');
    }
    text
}

fn titles(machine: &MachineSolution, at_contacts: &ContactFigures) -> Vec<String> {
    let whole = &machine.machine;
    let is_line = whole.is_line;
    let unit = if is_line { "N_per_m" } else { "N" };
    let mut titles = vec![
        "contact".to_owned(),
        format!("{}_{}", whole.axis.name(), whole.axis.unit()),
    ];
    if whole.has_sides() {
        titles.push("ring".to_owned());
    }
    titles.extend(["name".to_owned(), format!("load_{unit}")]);
    titles.extend(
        [
            "hertz_pressure_Pa",
            "solved_as",
            "entrainment_speed_m_per_s",
            "slide_to_roll_ratio",
        ]
        .map(str::to_owned),
    );
    for entry in own_figures(at_contacts) {
        titles.push(titled(entry.figure.name, entry.unit));
        if entry.has_bars() {
            titles.push(titled(&format!("{}_error", entry.figure.name), entry.unit));
        }
    }
    for column in figures() {
        titles.push(column.title(is_line));
        titles.extend(column.error_title(is_line));
    }
    titles
}

/// A value of a entry and, where it has bars, its bar.
fn cells(entry: &ContactFigure, place: usize) -> impl Iterator<Item = String> {
    let value = entry.values[place];
    let number = |number: Option<f64>| number.map_or(String::new(), |n| format!("{n:e}"));
    let bar = entry.has_bars().then(|| value.and_then(|v| v.error));
    std::iter::once(number(value.map(|v| v.value))).chain(bar.map(number))
}

/// The cells of place, load and motion.
fn mechanics(
    machine: &MachineSolution,
    at_contacts: &ContactFigures,
    (i, place): (usize, &Place),
    shown: f64,
) -> Vec<String> {
    let contact = &machine.machine.contacts[place.contact];
    let of = |figure| Some(at_contacts.find(figure)?.values[i]?.value);
    let name = match place.beyond {
        Some(side) => format!("{}, {}", contact.name, side.name()),
        None => contact.name.clone(),
    };
    let like = contact.like.filter(|_| place.beyond.is_none());
    let motion = machine.of(place.contact).map(|point| point.case.motion);
    let entrainment = of(ENTRAINMENT_SPEED).or(motion.map(|m| m.entrainment_speed));
    let number = |number: f64| format!("{number:e}");
    let mut row = vec![(place.contact + 1).to_string(), number(shown)];
    if machine.machine.has_sides() {
        row.push(RINGS[contact.side].to_owned());
    }
    row.extend([
        name,
        number(of(LOAD).unwrap_or(contact.load)),
        number(of(HERTZ_PRESSURE).unwrap_or(contact.hertz_pressure)),
        like.map_or(String::new(), |like| (like + 1).to_string()),
        entrainment.map_or(String::new(), number),
        motion.map_or(String::new(), |m| number(m.slide_to_roll_ratio)),
    ]);
    row
}

/// The cells of the solved contact; beyond a jump of the load those that are known there.
fn films(
    machine: &MachineSolution,
    at_contacts: &ContactFigures,
    (i, place): (usize, &Place),
) -> Vec<String> {
    let is_line = machine.machine.is_line;
    let Some(point) = machine.of(place.contact) else {
        return Vec::new();
    };
    let of_column = |column: Column| -> Vec<String> {
        let own = || column.fields(point, is_line).into_iter();
        if place.beyond.is_none() {
            return own().map(|(_, cell)| cell.to_string()).collect();
        }
        let entry = (at_contacts.all.iter()).find(|entry| entry.figure.name == column.name);
        match entry.and_then(|entry| entry.values[i]) {
            None => own().map(|_| String::new()).collect(),
            Some(value) => [Cell::Number(value.value), value.error.into()]
                .map(|cell| cell.to_string())
                .into(),
        }
    };
    figures().flat_map(of_column).collect()
}

/// Shifts (m), tilts (rad), loads (N, N m) and stiffness (change of the load of the row with the shift of the column, N/m, N, N m) of the inner ring of a bearing.
pub(super) fn shaft_table(bearing: &BearingMechanics) -> String {
    let mut text = "coordinate,shift,load".to_owned();
    for name in COORDINATES {
        let _ = write!(text, ",stiffness_{name}");
    }
    text.push('\n');
    let (shifts, loads) = (bearing.displacement(), bearing.distribution.reaction());
    for (i, name) in COORDINATES.iter().enumerate() {
        let _ = write!(text, "{name},{:e},{:e}", shifts[i], loads[i]);
        for stiffness in bearing.distribution.stiffness[i] {
            let _ = write!(text, ",{stiffness:e}");
        }
        text.push('\n');
    }
    text
}
