//! The report of a case check.

use super::lines::Lines;
use super::machine::write_summary;
use super::report::{write_case, write_hertz};
use crate::case::CaseEcho;
use crate::estimate::CaseEstimate;
use crate::machine::MachineEstimate;
use crate::words::length;

/// The case as read, its dry contact and its formula films, and the main figures of a whole machine. The caller adds remarks on the solve.
pub fn check_report(
    case: &CaseEcho,
    estimate: &CaseEstimate,
    machine: Option<&MachineEstimate>,
) -> String {
    let mut out = Lines::default();
    out.title(&case.title);
    write_case(&mut out, case);
    out.heading("By formulas");
    write_hertz(
        &mut out,
        &case.contact,
        &estimate.hertz,
        estimate.reduced_modulus,
    );
    let film = &estimate.film;
    let by = |name: &str, h: f64| format!("{} ({name})", length(h));
    out.row("central film", by(film.central_formula, film.central));
    if let (Some(h), Some(name)) = (film.minimum, film.minimum_formula) {
        out.row("minimum film", by(name, h));
    }
    if let Some(machine) = machine {
        out.heading("Whole machine by formulas (all: `ertel estimate`)");
        write_summary(&mut out, machine);
    }
    out.text()
}
