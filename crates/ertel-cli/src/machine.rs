//! `ertel solve` of a whole machine: its results and failures.

use std::path::Path;
use std::sync::atomic::Ordering;

use ertel::case::MachineContacts;
use ertel::machine::{MachineFigures, SolvedMachine};
use ertel::output;
use serde_json::json;

use crate::args::SolveArgs;
use crate::events::{Events, path_text};
use crate::failure::Failure;
use crate::interrupt::WRITING;
use crate::print;
use crate::results::{RESOLVE, not_shown, place_of};

/// Help for totals that are not resolved.
const TOTALS: &str = "where friction is beyond what lubricants transmit, give [lubricant] `shear_thinning`; else a finer [mesh], or more `points` along a path \
    and over a turn; --accept-unresolved accepts such figures";

/// Settings that select the governing contact of a machine alone: `machine.element=0 and machine.ring=inner`.
pub fn choice(contacts: &MachineContacts) -> String {
    let machine = &contacts.machine;
    let name = &machine.contacts[machine.governing].name;
    let points = &contacts.study.points;
    let point = points.iter().find(|point| point.label == *name);
    let values = point.or(points.first()).map(|point| &point.values[..]);
    let keys = contacts.study.columns.iter().zip(values.unwrap_or(&[]));
    let set = keys.map(|(column, value)| {
        let value = value.to_string();
        match value.contains(' ') {
            true => format!("{}=\"{value}\"", column.key),
            false => format!("{}={value}", column.key),
        }
    });
    set.collect::<Vec<_>>().join(" and ")
}

/// Writes the solved contacts of a machine; returns a summary in words.
///
/// # Errors
///
/// Results that cannot be written, contacts that failed or are not resolved, an interruption.
pub fn write(
    (solved, figures): (&SolvedMachine, &MachineFigures),
    folder: &Path,
    arguments: &SolveArgs,
    events: &Events,
) -> Result<String, Failure> {
    let SolvedMachine { case, solution, .. } = solved;
    if solution.solved().next().is_none() {
        return Err(Failure::Interrupted);
    }
    let place = place_of(folder, solution.is_partial());
    let folder = place.as_path();
    let echo = case.echo();
    WRITING.store(true, Ordering::SeqCst);
    output::write_machine(&echo, solution, figures, folder, &case.output)?;
    WRITING.store(false, Ordering::SeqCst);
    let shown = if events.is_on() {
        let mut result = output::machine_json(&echo, solution, figures).map_err(not_shown)?;
        // Each contact was reported when it was solved.
        if let Some(keys) = result.as_object_mut() {
            keys.remove("contacts");
            keys.remove("case");
        }
        events.emit(
            "result",
            json!({ "folder": path_text(folder), "result": result }),
        );
        Ok(())
    } else if arguments.report.quiet {
        Ok(())
    } else {
        let text = output::machine_report(&echo, solution, figures, Some(folder));
        print::stdout(&text)
    };
    check((solved, figures), folder, arguments)?;
    shown?;
    Ok(format!("{} different contacts", solution.n_contacts()))
}

/// Whether all contacts are solved, balanced and resolved.
///
/// # Errors
///
/// The first of these that is not so.
fn check(
    (solved, figures): (&SolvedMachine, &MachineFigures),
    folder: &Path,
    arguments: &SolveArgs,
) -> Result<(), Failure> {
    let SolvedMachine {
        solution, balance, ..
    } = solved;
    let (all, failed) = (solution.n_contacts(), solution.n_failed());
    if solution.is_partial() {
        let solved = solution.n_solved();
        return Err(Failure::InterruptedCurve(format!(
            "interrupted after {solved} of {all} contacts; these are in {}",
            folder.display()
        )));
    }
    let table = folder.join("machine.csv");
    if failed > 0 {
        return Err(Failure::NotConverged(format!(
            "{failed} of {all} contacts failed, and no sums are given; the reasons are in {}",
            folder.join("report.txt").display()
        )));
    }
    if let Some(balance) = balance.filter(|balance| !balance.is_found()) {
        return Err(Failure::NotConverged(format!(
            "{}; results of the last round are in {}\n  = help: start nearer to it with the temperature of the lubricant, or check \
             `thermal_resistance`",
            balance.words(),
            folder.display()
        )));
    }
    let solutions = solution.solved().filter_map(|(_, p)| p.outcome.solution());
    let unresolved = solutions.filter(|s| !s.unresolved.is_empty()).count();
    if unresolved > 0 && !arguments.report.accept_unresolved {
        return Err(Failure::Unresolved(format!(
            "{unresolved} of {all} contacts are not resolved: the error bar of a figure exceeds half its value, or is missing; see the column \
             `unresolved` of {}\n  = help: {RESOLVE}",
            table.display()
        )));
    }
    let unresolved: Vec<&str> = figures.unresolved().map(|row| row.figure.words).collect();
    if !unresolved.is_empty() && !arguments.report.accept_unresolved {
        return Err(Failure::Unresolved(format!(
            "not resolved: {}; see {}\n  = help: {TOTALS}",
            unresolved.join(", "),
            folder.join("report.txt").display()
        )));
    }
    Ok(())
}
