//! The report of a machine.

use std::fmt::Write;
use std::path::Path;

use super::super::figure::{estimate, in_unit, number, percent, temperature};
use super::super::lines::{Lines, Table};
use super::super::report::write_case;
use super::super::rows::shown;
use crate::case::CaseEcho;
use crate::figures::{Definition, Row, Section};
use crate::machine::MachineFigures;
use crate::mark::{Marks, of_figure};
use crate::solution::{Estimate, Figure, Solution};
use crate::study::{MachineSolution, Outcome};
use crate::warning::{Warning, WarningKind, by_kind};
use crate::words::{digits, force, pressure};

/// The machine, its figures, its contacts as a table, failures, warnings.
pub fn machine_report(
    case: &CaseEcho,
    machine: &MachineSolution,
    figures: &MachineFigures,
    folder: Option<&Path>,
) -> String {
    let mut out = Lines::default();
    out.title(&case.title);
    write_case(&mut out, case);
    write_figures(&mut out, figures, &[]);
    write_contacts(&mut out, machine);
    out.warnings(&warnings(machine, figures));
    let mut text = out.text();
    let _ = writeln!(
        text,
        "\n{}{} of {} different contacts solved in {} s",
        if machine.is_partial() {
            "Interrupted: "
        } else {
            ""
        },
        machine.n_solved(),
        machine.n_contacts(),
        digits(machine.wall_seconds, 3)
    );
    if let Some(folder) = folder {
        let _ = writeln!(text, "Results in {}", folder.display());
    }
    text
}

/// Figures of the machine by section; those that are `absent` with what they need.
pub(in crate::output) fn write_figures(
    out: &mut Lines,
    figures: &MachineFigures,
    absent: &[(Definition, &str)],
) {
    for section in Section::OF_MACHINES {
        let rows = figures
            .all
            .iter()
            .filter(|row| row.figure.section == section);
        let rows: Vec<&Row> = rows.collect();
        let absent = absent
            .iter()
            .filter(|(figure, _)| figure.section == section);
        let absent: Vec<&(Definition, &str)> = absent.collect();
        if rows.is_empty() && absent.is_empty() {
            continue;
        }
        out.heading(section.heading());
        for row in &rows {
            out.row(row.figure.words, shown(row));
        }
        for (figure, needs) in absent {
            out.row(figure.words, needs);
        }
        let marks: Marks = rows.iter().map(|row| row.estimate.marks).sum();
        for mark in marks.iter().filter(|mark| !mark.symbol().is_empty()) {
            out.note(mark.words());
        }
        let mut noted: Vec<&str> = Vec::new();
        for source in rows.iter().map(|row| row.source).filter(|s| !s.is_empty()) {
            if !noted.contains(&source) {
                noted.push(source);
                out.note(source);
            }
        }
    }
}

/// A row per contact; equal contacts share one.
pub(in crate::output) fn write_contacts(out: &mut Lines, machine: &MachineSolution) {
    let whole = &machine.machine;
    out.heading("Contacts");
    let solutions = || (0..whole.contacts.len()).filter_map(|i| machine.solution(i));
    let is_rough = solutions().any(|s| s.mixed.is_some());
    let is_hot = solutions().any(|s| s.thermal.is_some());
    let bears = |s: &Solution| s.figure(Figure::AsperityLoadShare).is_some();
    let has_asperities = solutions().any(bears);
    let slides = machine.solved().any(|(_, p)| p.case.motion.slides());
    let is_across = solutions().any(|s| s.traction.across.is_some());
    let load = if whole.is_line {
        "load per length"
    } else {
        "load"
    };
    let columns = [
        (true, "contact"),
        (true, load),
        (true, "Hertz pressure"),
        (true, "entrainment"),
        (slides, "slide-to-roll"),
        (true, "central film"),
        (true, "minimum film"),
        (is_rough, "lambda"),
        (has_asperities, "load on asperities"),
        (
            slides,
            match has_asperities {
                true => "friction coefficient",
                false => "traction coefficient",
            },
        ),
        (is_across, "across"),
        (true, "friction power"),
        (is_hot, "hottest film"),
    ];
    let keep = |cells: [String; 13]| -> Vec<String> {
        let cells = cells.into_iter().zip(&columns);
        cells
            .filter_map(|(cell, (shown, _))| shown.then_some(cell))
            .collect()
    };
    let none = || "-".to_owned();
    let mut rows = Vec::new();
    for (i, contact) in whole.contacts.iter().enumerate() {
        if contact.like != Some(i) {
            continue;
        }
        let name = match whole.count(i) {
            0 | 1 => contact.name.clone(),
            n => format!("{} and {} more", contact.name, n - 1),
        };
        let load = force(contact.load, whole.is_line, 4);
        let hertz = match contact.load > 0.0 {
            true => pressure(contact.hertz_pressure),
            false => none(),
        };
        let motion = machine.of(i).map(|point| point.case.motion);
        let speed = motion.map_or_else(none, |m| format!("{} m/s", digits(m.entrainment_speed, 4)));
        let ratio = motion.map_or_else(none, |m| digits(m.slide_to_roll_ratio, 3));
        let Some(point) = machine.of(i) else {
            let mut cells = std::array::from_fn(|_| none());
            [cells[0], cells[1], cells[2]] = [name, load, hertz];
            cells[5] = "not begun".to_owned();
            rows.push(keep(cells));
            continue;
        };
        let cells = match &point.outcome {
            Outcome::Solved(s) => [
                name,
                load,
                hertz,
                speed,
                ratio,
                estimate(&s.summary.film_central),
                estimate(&s.summary.film_minimum),
                (s.mixed.as_ref()).map_or_else(none, |m| number(m.lambda_minimum)),
                (s.figure(Figure::AsperityLoadShare)).map_or_else(none, |l| percent(l.estimate())),
                marked(number(friction(s)), s, Figure::TractionCoefficient),
                (s.traction.across.as_ref()).map_or_else(none, |a| number(a.coefficient)),
                marked(power(s, whole.is_line), s, Figure::FrictionPower),
                (s.thermal.as_ref())
                    .map_or_else(none, |t| temperature(t.film_maximum.estimate(), None)),
            ],
            Outcome::InTime(_) | Outcome::Failed(_) => {
                let mut cells = std::array::from_fn(|_| none());
                [cells[0], cells[1], cells[2], cells[3], cells[4]] =
                    [name, load, hertz, speed, ratio];
                cells[5] = "failed".to_owned();
                cells
            }
        };
        rows.push(keep(cells));
    }
    let head: Vec<String> = (columns.iter())
        .filter(|(shown, _)| *shown)
        .map(|(_, title)| (*title).to_owned())
        .collect();
    out.table(Table::fitted(head, rows));
    let marks: Marks = solutions()
        .map(|s| of_figure(s, Figure::FrictionPower))
        .sum();
    for mark in marks.iter() {
        out.note(mark.words());
    }
    write_idle(out, machine);
}

/// Friction coefficient of a contact: of film and asperities where they share the load.
fn friction(solution: &Solution) -> Estimate {
    let both = solution.figure(Figure::FrictionTotal);
    both.map_or(solution.traction.coefficient, |both| both.estimate())
}

/// The text of a contact figure with the symbols of its marks.
fn marked(text: String, solution: &Solution, figure: Figure) -> String {
    text + &of_figure(solution, figure).symbols()
}

/// The number of contacts without films, and the reason.
pub(in crate::output) fn write_idle(out: &mut Lines, machine: &MachineSolution) {
    let whole = &machine.machine;
    let n = whole.contacts.iter().filter(|c| c.like.is_none()).count();
    match n {
        0 => {}
        // Both contacts of a rolling element.
        n if whole.has_sides() && n % 2 == 0 => out.note(&format!(
            "{} rolling elements are outside the load zone",
            n / 2
        )),
        n => out.note(&format!(
            "{n} of {} contacts carry no load and are not solved",
            whole.contacts.len()
        )),
    }
}

/// Friction power of a contact.
fn power(solution: &Solution, is_line: bool) -> String {
    let found = solution.figure(Figure::FrictionPower);
    let Some(found) = found else {
        return "-".to_owned();
    };
    let e: Estimate = found.estimate();
    let unit = if is_line { "/m" } else { "" };
    match e.value.abs() < 1.0 {
        true => in_unit(e, 1e3, &format!("mW{unit}")),
        false => in_unit(e, 1.0, &format!("W{unit}")),
    }
}

/// An interruption, failures, and the warnings of the contacts, grouped by kind.
pub(in crate::output) fn warnings(
    machine: &MachineSolution,
    figures: &MachineFigures,
) -> Vec<Warning> {
    let interruption = machine.interruption().map(|text| {
        Warning::new(
            WarningKind::NotSolved,
            format!("{text}; sums and extremes over all contacts are omitted"),
        )
    });
    let mut failures: Vec<Warning> = interruption.into_iter().collect();
    failures.extend(figures.warnings.iter().cloned());
    let mut of_contacts = Vec::new();
    let n = machine.n_contacts();
    for (place, point) in machine.solved() {
        match &point.outcome {
            Outcome::Failed(reason) => failures.push(Warning::new(
                WarningKind::NotSolved,
                format!("{} failed: {reason}", machine.machine.contacts[place].name),
            )),
            Outcome::Solved(s) => of_contacts.extend(s.warnings.iter().map(|w| (place, w))),
            // Contacts of a machine are steady.
            Outcome::InTime(_) => {}
        }
    }
    let merged = by_kind(of_contacts);
    let name = |place: usize| machine.machine.contacts[place].name.as_str();
    failures.extend((merged.iter()).map(|m| m.with_text(m.line_of(n, name))));
    failures
}
