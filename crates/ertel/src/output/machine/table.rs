//! `machine.csv`: one line per contact.

use std::f64::consts::{PI, TAU};
use std::fmt::Write;

use crate::case::{MachineAxis, MachineContact, RINGS};
use crate::files::text_field;
use crate::study::{Column, MachineSolution, columns};

/// The columns of studies, except the Hertz pressure, which the mechanics give for every contact.
fn figures() -> impl Iterator<Item = Column> {
    columns().filter(|column| column.name != "hertz_pressure")
}

/// The table as text, SI. Equal contacts repeat the figures of the solved one; unloaded contacts have none.
pub fn machine_table(machine: &MachineSolution) -> String {
    table_of(machine, |_| true, |place| place)
}

/// The table of loaded contacts; angles around a bearing from −π to π, which keeps the loaded zone contiguous.
pub(in crate::output) fn table_of_pressed(machine: &MachineSolution) -> String {
    let is_around = machine.machine.axis == MachineAxis::Around;
    let shown = |place: f64| match is_around && place > PI {
        true => place - TAU,
        false => place,
    };
    table_of(machine, |contact| contact.like.is_some(), shown)
}

/// The table of the kept contacts, with their displayed places.
fn table_of(
    machine: &MachineSolution,
    keeps: impl Fn(&MachineContact) -> bool,
    shown: impl Fn(f64) -> f64,
) -> String {
    let whole = &machine.machine;
    let is_line = whole.is_line;
    let unit = if is_line { "N_per_m" } else { "N" };
    let axis = format!("{}_{}", whole.axis.name(), whole.axis.unit());
    let ring = if whole.has_sides() { "ring," } else { "" };
    let mut text = format!("contact,{axis},{ring}name,load_{unit},hertz_pressure_Pa,solved_as");
    text.push_str(",entrainment_speed_m_per_s,slide_to_roll_ratio");
    for column in figures() {
        for title in std::iter::once(column.title(is_line)).chain(column.error_title(is_line)) {
            let _ = write!(text, ",{title}");
        }
    }
    text.push('\n');
    let width = text
        .lines()
        .next()
        .map_or(0, |head| head.split(',').count());
    let contacts = whole.contacts.iter().enumerate();
    for (i, contact) in contacts.filter(|(_, contact)| keeps(contact)) {
        let like = contact
            .like
            .map_or(String::new(), |like| (like + 1).to_string());
        let mut row = vec![(i + 1).to_string(), format!("{:e}", shown(contact.place))];
        if whole.has_sides() {
            row.push(RINGS[contact.side].to_owned());
        }
        row.extend([
            contact.name.clone(),
            format!("{:e}", contact.load),
            format!("{:e}", contact.hertz_pressure),
            like,
        ]);
        if let Some(point) = machine.of(i) {
            let motion = &point.case.motion;
            let speeds = [motion.entrainment_speed, motion.slide_to_roll_ratio];
            row.extend(speeds.map(|value| format!("{value:e}")));
            let cells = figures().flat_map(|column| column.fields(point, is_line));
            row.extend(cells.map(|(_, cell)| cell.to_string()));
        }
        row.resize(width, String::new());
        let fields: Vec<_> = row.iter().map(|field| text_field(field)).collect();
        text.push_str(&fields.join(","));
        text.push('\n');
    }
    text
}
