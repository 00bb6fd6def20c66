//! `ertel solve` of a case in time.

use std::path::Path;
use std::sync::atomic::Ordering;

use ertel::case::Case;
use ertel::output;
use ertel::run::transient::TransientSolution;
use ertel::solution::Figure;
use ertel::transient::TransientError;
use ertel::words::length;
use serde_json::{Value, json};

use crate::args::SolveArgs;
use crate::events::{Events, path_text};
use crate::failure::Failure;
use crate::interrupt::WRITING;
use crate::print;
use crate::results::{RESOLVE, not_shown, place_of};

/// Writes the solved instants, also of an interrupted run; returns the films in words.
pub fn write(
    case: &Case,
    found: &TransientSolution,
    folder: &Path,
    arguments: &SolveArgs,
    events: &Events,
) -> Result<String, Failure> {
    let is_interrupted = matches!(found.failure, Some(TransientError::Interrupted));
    let Some(last) = found.instants.last() else {
        return Err(match &found.failure {
            Some(_) if is_interrupted => Failure::Interrupted,
            Some(failure) => {
                let advice = (failure.advice()).map_or(String::new(), |a| format!(". Try {a}"));
                Failure::NotConverged(format!("{failure}\n  = help: nothing was written{advice}"))
            }
            None => Failure::NotConverged("no instant was solved".to_owned()),
        });
    };
    let place = place_of(folder, found.failure.is_some());
    let folder = place.as_path();
    WRITING.store(true, Ordering::SeqCst);
    let echo = case.echo();
    output::write_transient(&echo, found, folder, &case.output)?;
    WRITING.store(false, Ordering::SeqCst);
    if events.is_on() {
        let known = |warning: &&ertel::warning::Warning| !case.warnings.contains(warning);
        events.warn(found.warnings.iter().filter(known));
        let mut result = output::transient_json(&echo, found).map_err(not_shown)?;
        if let Value::Object(keys) = &mut result {
            keys.remove("case");
            keys.remove("profiles");
        }
        events.emit(
            "result",
            json!({ "folder": path_text(folder), "result": result }),
        );
    } else if !arguments.report.quiet {
        print::stdout(&output::transient_report(&echo, found, Some(folder)))?;
    }
    if is_interrupted {
        return Err(Failure::InterruptedCurve(format!(
            "interrupted at {:e} s after {} steps; these are in {}",
            last.time,
            found.instants.len() - 1,
            folder.display()
        )));
    }
    if let Some(failure) = &found.failure {
        let advice = (failure.advice()).map_or(String::new(), |a| format!("\n  = help: try {a}"));
        return Err(Failure::NotConverged(format!(
            "{failure}; the instants until then are in {}{advice}",
            folder.display()
        )));
    }
    let films = [Figure::FilmCentral, Figure::FilmMinimum];
    let unresolved = (found.instants.iter())
        .filter(|instant| !films.iter().all(|film| instant.measured.is_resolved(*film)))
        .count();
    if unresolved > 0 && !arguments.report.accept_unresolved {
        return Err(Failure::Unresolved(format!(
            "films are not resolved at {unresolved} of {} instants: see the column `unresolved` of {}\n  = help: {RESOLVE}",
            found.instants.len(),
            folder.join("transient.csv").display()
        )));
    }
    let [central, minimum] = films.map(|film| length(last.measured.estimate(film).value));
    Ok(format!(
        "at the end central film {central}, minimum {minimum}"
    ))
}
