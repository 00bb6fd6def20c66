//! Results of a machine: `machine.json`, `machine.csv`, pictures, a report, and contact folders.

mod along;
mod estimate;
mod json;
mod picture;
mod report;
mod table;
mod values;

pub(super) use estimate::{estimate_units, estimate_values, write_estimate, write_summary};
pub use json::{MACHINE_FORMAT, machine_json};
pub(super) use picture::machine_pictures;
pub use report::machine_report;
pub(super) use report::{warnings, write_figures, write_idle};
pub use table::machine_table;
use table::shaft_table;
pub(super) use table::table_of_pressed;

use std::path::Path;

use super::folder::{NewFolder, Part};
use super::html::machine_page;
use super::target::REPORT_PAGE;
use super::{OutputError, finite, write_files, write_picture};
use crate::case::{CaseEcho, Mechanics};
use crate::figures::Row;
use crate::machine::MachineFigures;
use crate::mark::Marked;
use crate::params::OutputParams;
use crate::study::MachineSolution;

/// Writes the results of a machine into one folder, as [`super::write`] does; if the machine asks for folders, each contact also has a
/// separate folder: `points/01`, numbered by contact.
///
/// # Errors
/// [`OutputError`]; the target is then unchanged.
pub fn write_machine(
    case: &CaseEcho,
    machine: &MachineSolution,
    figures: &MachineFigures,
    target: &Path,
    params: &OutputParams,
) -> Result<(), OutputError> {
    check(machine, figures)?;
    let folder = NewFolder::next_to(target)?;
    write_files_of_machine(folder.root(), case, machine, figures, params)?;
    if machine.machine.folders {
        let width = machine.machine.contacts.len().to_string().len();
        for (i, point) in machine.solved() {
            if let Some(solution) = point.outcome.solution() {
                let part = folder.point(&format!("{:0width$}", i + 1))?;
                write_files(&part, &point.case, solution, params)?;
            }
        }
    }
    folder.finish()
}

/// Rejects non-finite numbers.
pub(super) fn check(
    machine: &MachineSolution,
    figures: &MachineFigures,
) -> Result<(), OutputError> {
    for (i, point) in machine.solved() {
        let found =
            (point.outcome.solution()).and_then(|s| finite::first_not_finite(&point.case, s));
        if let Some(what) = found {
            let what = format!("{what}, of {}", machine.machine.contacts[i].name);
            return Err(OutputError::NotFinite { what });
        }
    }
    let is_bad = |row: &&Row| {
        let Marked { value, error, .. } = row.estimate;
        !value.is_finite() || error.is_some_and(|error| !error.is_finite())
    };
    match figures.all.iter().find(is_bad) {
        Some(row) => Err(OutputError::NotFinite {
            what: row.figure.words.to_owned(),
        }),
        None => Ok(()),
    }
}

pub(super) fn write_files_of_machine(
    root: &Part,
    case: &CaseEcho,
    machine: &MachineSolution,
    figures: &MachineFigures,
    params: &OutputParams,
) -> Result<(), OutputError> {
    root.json("machine.json", machine_json(case, machine, figures))?;
    root.bytes("machine.csv", machine_table(machine, &figures.at_contacts))?;
    if let Mechanics::Bearing(bearing) = &machine.machine.mechanics {
        root.bytes("shaft.csv", shaft_table(bearing))?;
    }
    root.bytes("report.txt", machine_report(case, machine, figures, None))?;
    root.bytes(REPORT_PAGE, machine_page(case, machine, figures))?;
    if let Some(text) = &case.case_file {
        root.bytes("case.toml", text)?;
    }
    for picture in machine_pictures(&case.title, machine, &figures.at_contacts) {
        write_picture(root, &picture, params.pictures)?;
    }
    Ok(())
}
