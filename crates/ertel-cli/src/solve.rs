//! `ertel solve`.

use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;

use ertel::case::{Case, CaseEcho, Curve};
use ertel::cross_check::Verdict;
use ertel::elastic::FiniteBodyError;
use ertel::engine::SolveError;
use ertel::machine::figures;
use ertel::output;
use ertel::run;
use ertel::run::over_time::over_time;
use ertel::solution::Solution;
use ertel::study::{CurveSolution, solve_curve, solve_in_balance};
use ertel::warning::{Warning, by_kind};
use serde_json::{Value, json};

use crate::args::SolveArgs;
use crate::cases::{Job, input_warnings, n_points};
use crate::checkpoint::Checkpoints;
use crate::events::{Events, path_text};
use crate::failure::Failure;
use crate::inputs;
use crate::interrupt::{CANCELLED, WRITING, listen_for_interrupts};
use crate::machine;
use crate::monte_carlo::{self, Samples, Solved};
use crate::print::{self, warn};
use crate::progress::Progress;
use crate::results::{not_resolved, not_shown, place_of, points_not_resolved};
use crate::transient;
use crate::{cases, check};

/// Runs the command.
///
/// # Errors
///
/// A bad case, results that cannot be written, no convergence, an interruption.
pub fn run(arguments: &SolveArgs) -> Result<(), Failure> {
    let events = Events::new(arguments.json);
    events.finish(run_all(arguments, &events))
}

fn run_all(arguments: &SolveArgs, events: &Events) -> Result<(), Failure> {
    let jobs = cases::read(arguments, events)?;
    for Job { given, .. } in &jobs {
        if arguments.check || arguments.report.quiet {
            let warnings = input_warnings(&given.case);
            warn(
                (warnings.iter()).filter(|w| w.is_shown() || arguments.check && w.is_shown_note()),
            );
        }
    }
    if arguments.check {
        return cases::each(&jobs, events, |job| check::run(job, arguments, events));
    }
    let read: Vec<PathBuf> = jobs.iter().flat_map(|job| job.given.files()).collect();
    for Job { folder, .. } in &jobs {
        inputs::keep_within(&read, folder)?;
        // Folder of the results of a run that ends early.
        let partial = output::place_of_partial(folder);
        inputs::keep_within(&read, &partial)?;
        // Before a long solve: check that its results can be written.
        output::clear_leftovers(folder);
        output::check_target(folder)?;
        output::check_target(&partial)?;
        check_writable(folder)?;
    }
    listen_for_interrupts();
    let solve = |job: &Job| solve(job, arguments, events);
    match &jobs[..] {
        [job] => {
            events.set_case(Some(&job.given.name));
            solve(job).map(drop)
        }
        jobs => cases::solve_all(jobs, arguments, events, &solve),
    }
}

/// Solves a case, or the points of its curve; returns the films in words.
fn solve(job: &Job, arguments: &SolveArgs, events: &Events) -> Result<String, Failure> {
    let Job { given, folder } = job;
    let case = &given.case;
    let samples = monte_carlo::samples(arguments, &given.name, case, folder)?;
    if arguments.cross_check {
        may_cross_check(case)?;
    }
    let n_points = n_points(case);
    events.emit(
        "started",
        json!({
            "command": "solve",
            "version": env!("CARGO_PKG_VERSION"),
            "title": case.title,
            "folder": path_text(folder),
            "points": n_points,
        }),
    );
    if arguments.verbose {
        check::announce(job)?;
    }
    let mut progress = match (events.is_on(), arguments.verbose) {
        (true, _) => Progress::as_events(events, &CANCELLED),
        (false, true) => Progress::in_lines(&CANCELLED),
        (false, false) => Progress::new(arguments.report.quiet, &CANCELLED),
    };
    if case.transient.is_some() && case.curve.is_none() {
        return solve_in_time(job, arguments, events, progress, samples.as_ref());
    }
    if arguments.checkpoint.is_some() || arguments.resume {
        return Err(Failure::Argument(format!(
            "{}: --checkpoint and --resume are for cases with [transient], without a [curve]",
            given.name
        )));
    }
    if let Some(curve) = &case.curve {
        let solution = solve_curve(curve, &mut progress);
        drop(progress);
        return write_curve(case, curve, &solution, folder, arguments, events);
    }
    if case.contacts.is_some() {
        events.warn(&case.warnings);
        if let Some(solved) = solve_in_balance(case, &mut progress)? {
            drop(progress);
            let figures = figures(&solved.case, &solved.solution);
            let written = machine::write((&solved, &figures), folder, arguments, events);
            if let (Some(samples), Ok(_) | Err(Failure::Unresolved(_))) = (&samples, &written) {
                monte_carlo::run(samples, &Solved::Rows(&figures.all), arguments)?;
            }
            return written;
        }
    }
    events.warn(&case.warnings);
    let solution = run::solve(case, &mut progress);
    drop(progress);
    let solution = solution?;
    WRITING.store(true, Ordering::SeqCst);
    if CANCELLED.load(Ordering::SeqCst) {
        return Err(Failure::Interrupted);
    }
    let echo = case.echo();
    output::write(&echo, &solution, folder, &case.output)?;
    WRITING.store(false, Ordering::SeqCst);
    let shown = show(job, &echo, &solution, arguments, events);
    if let Some(samples) = &samples {
        monte_carlo::run(samples, &Solved::Contact(&solution), arguments)?;
    }
    if arguments.cross_check {
        cross_check(case, &solution, folder, arguments, events)?;
    }
    match &solution.unresolved[..] {
        [] => shown,
        _ if arguments.report.accept_unresolved => shown,
        unresolved => Err(not_resolved(unresolved, folder)),
    }?;
    Ok(films(&solution))
}

/// Solves a case in time, with checkpoints; returns a summary in words.
fn solve_in_time(
    Job { given, folder }: &Job,
    arguments: &SolveArgs,
    events: &Events,
    mut progress: Progress<'_>,
    samples: Option<&Samples>,
) -> Result<String, Failure> {
    let case = &given.case;
    events.warn(&case.warnings);
    let (file, from) = Checkpoints::open(case, folder, arguments)?;
    progress.keep(file);
    let found = run::transient::solve_from(case, from, &mut progress);
    let file = progress.kept();
    drop(progress);
    let written = transient::write(case, &found, folder, arguments, events);
    // Keep the file if the results could not be written; a film that is not resolved would not change by further steps.
    let is_written = matches!(written, Ok(_) | Err(Failure::Unresolved(_)));
    file.close(found.failure.is_none() && is_written)?;
    if let (Some(samples), true) = (samples, is_written) {
        let rows = over_time(&found, case.contact.kind.is_line());
        monte_carlo::run(samples, &Solved::Rows(&rows), arguments)?;
    }
    written
}

/// Shows the solution of a contact: as an event, in the report, or its warnings alone.
fn show(
    Job { given, folder }: &Job,
    echo: &CaseEcho,
    solution: &Solution,
    arguments: &SolveArgs,
    events: &Events,
) -> Result<(), Failure> {
    let case = &given.case;
    let known = |warning: &&Warning| !case.warnings.contains(warning);
    if events.is_on() {
        events.warn(solution.warnings.iter().filter(known));
        let result = output::result_json(echo, solution).map_err(not_shown)?;
        events.emit(
            "result",
            json!({ "folder": path_text(folder), "result": short(result) }),
        );
        Ok(())
    } else if arguments.report.quiet {
        let known = solution.warnings.iter().filter(known);
        warn(known.filter(|warning| warning.is_shown()));
        Ok(())
    } else {
        let text = output::report(echo, solution, Some(folder));
        let more = match arguments.verbose {
            true => check::effort(solution, folder),
            false => String::new(),
        };
        print::report(&(text + &more))
    }
}

/// Refuses a cross-check of a case that only one method solves.
fn may_cross_check(case: &Case) -> Result<(), Failure> {
    if let Some(contacts) = &case.contacts {
        return Err(Failure::Argument(format!(
            "--cross-check takes one contact, and the case is a whole machine: choose one of its contacts with --set, such as {}",
            machine::choice(contacts)
        )));
    }
    if case.transient.is_some() {
        let text = "--cross-check takes a steady contact: only finite volumes solve [transient]";
        return Err(Failure::Argument(text.to_owned()));
    }
    if case.curve.is_some() {
        let text = "--cross-check takes one contact, but the case has a [curve]: remove [curve] to check a single point";
        return Err(Failure::Argument(text.to_owned()));
    }
    match ertel::cross_check::why_not(case) {
        Some(reason) => Err(Failure::Argument(format!(
            "--cross-check needs a case that both methods solve, but {reason}"
        ))),
        None => Ok(()),
    }
}

/// Solves a case by the other method as well, and reports differences of the figures.
fn cross_check(
    case: &Case,
    solution: &Solution,
    folder: &Path,
    arguments: &SolveArgs,
    events: &Events,
) -> Result<(), Failure> {
    let mut progress = match events.is_on() {
        true => Progress::as_events(events, &CANCELLED),
        false => Progress::new(arguments.report.quiet, &CANCELLED),
    };
    let found = ertel::cross_check::cross_check(case, solution, &mut progress);
    drop(progress);
    let found = found?;
    output::write_cross_check(solution, &found, folder)?;
    if !(arguments.report.quiet || events.is_on()) {
        print::stdout(&output::cross_check_report(solution, &found))?;
    }
    match found.count(Verdict::Differs) {
        0 => Ok(()),
        n => Err(Failure::Unresolved(format!(
            "{n} of {} figures differ by more than the sum of both error bars: see {}",
            found.figures.len(),
            folder.join("cross-check.csv").display()
        ))),
    }
}

fn films(solution: &Solution) -> String {
    let [central, minimum] = [
        solution.summary.film_central.value,
        solution.summary.film_minimum.value,
    ]
    .map(ertel::words::length);
    format!("central film {central}, minimum {minimum}")
}

/// Result in events: without the iterations, which had their own events, and without the case.
fn short(mut result: Value) -> Value {
    if let Value::Object(keys) = &mut result {
        keys.remove("history");
        keys.remove("case");
    }
    result
}

/// Writes the solved points of a curve; reports the others.
fn write_curve(
    case: &Case,
    curve: &Curve,
    solution: &CurveSolution,
    folder: &Path,
    arguments: &SolveArgs,
    events: &Events,
) -> Result<String, Failure> {
    let (quiet, accept_unresolved) = (arguments.report.quiet, arguments.report.accept_unresolved);
    if solution.points.is_empty() {
        return Err(Failure::Interrupted);
    }
    let place = place_of(folder, solution.is_partial());
    let folder = place.as_path();
    WRITING.store(true, Ordering::SeqCst);
    let echo = case.echo();
    output::write_curve(&echo, solution, folder, &case.output, curve.folders)?;
    WRITING.store(false, Ordering::SeqCst);
    emit_curve(&echo, solution, folder, events)?;
    let shown = match quiet || events.is_on() {
        true => Ok(()),
        false => print::stdout(&output::curve_report(&echo, solution, Some(folder))),
    };
    let (n, all, failed) = (
        solution.points.len(),
        solution.n_points,
        solution.n_failed(),
    );
    if solution.is_partial() {
        return Err(Failure::InterruptedCurve(format!(
            "interrupted after {n} of {all} points; these are in {}",
            folder.display()
        )));
    }
    if failed > 0 {
        return Err(Failure::NotConverged(format!(
            "{failed} of {all} points failed; the reasons are in {}",
            folder.join("curve.csv").display()
        )));
    }
    let unresolved = solution.points.iter().filter(|p| p.is_unresolved());
    let n_unresolved = unresolved.count();
    if n_unresolved > 0 && !accept_unresolved {
        return Err(points_not_resolved(
            n_unresolved,
            all,
            &folder.join("curve.csv"),
        ));
    }
    shown?;
    Ok(format!("{all} points"))
}

/// The last events of a curve: warnings of its points, and the result.
fn emit_curve(
    echo: &CaseEcho,
    solution: &CurveSolution,
    folder: &Path,
    events: &Events,
) -> Result<(), Failure> {
    if !events.is_on() {
        return Ok(());
    }
    let mut curve = output::curve_json(echo, solution).map_err(not_shown)?;
    // Each point was reported when it was solved.
    if let Some(keys) = curve.as_object_mut() {
        keys.remove("points");
    }
    let all: Vec<_> = (solution.points.iter())
        .map(ertel::study::PointSolution::warnings)
        .collect();
    let warnings = all.iter().enumerate();
    let warnings = warnings.flat_map(|(i, of)| of.iter().map(move |w| (i, w)));
    events.warn_of_points(&by_kind(warnings));
    events.emit(
        "result",
        json!({ "folder": path_text(folder), "result": curve }),
    );
    Ok(())
}

/// Tries to make a folder next to the target, or next to its first missing parent.
fn check_writable(target: &Path) -> Result<(), Failure> {
    let failed = |path: &Path, error: std::io::Error| {
        Failure::Other(format!(
            "cannot write results to {}: {error}",
            path.display()
        ))
    };
    let absolute = std::path::absolute(target).map_err(|error| failed(target, error))?;
    let existing = absolute.ancestors().skip(1).find(|path| path.exists());
    let parent = existing.unwrap_or(Path::new("/"));
    tempfile::Builder::new()
        .prefix(".ertel-")
        .tempdir_in(parent)
        .map(drop)
        .map_err(|error| failed(target, error))
}

impl From<SolveError> for Failure {
    fn from(error: SolveError) -> Self {
        match error {
            SolveError::Interrupted => Self::Interrupted,
            SolveError::Discretisation(FiniteBodyError::Mesh(error)) => Self::Argument(format!(
                "the mesh of this case cannot be built: {error}\n  = help: see [mesh] in the case file"
            )),
            SolveError::MissingHeatData(error) => {
                Self::Argument(format!("{error}\n  = help: {}", error.advice()))
            }
            SolveError::TooThin { help, .. } => {
                Self::Argument(format!("{error}\n  = help: {help}"))
            }
            SolveError::Discretisation(error) => Self::Other(error.to_string()),
            SolveError::NotConverged { .. }
            | SolveError::GridNotConverged { .. }
            | SolveError::EndCarries { .. }
            | SolveError::ReliefNotResolved { .. }
            | SolveError::NotCoupled { .. }
            | SolveError::Thinned { .. }
            | SolveError::Worn { .. }
            | SolveError::BothFailed { .. }
            | SolveError::Heat(_)
            | SolveError::Krylov(_)
            | SolveError::Factorisation(_) => {
                let advice = error
                    .advice()
                    .map_or(String::new(), |a| format!(". Try {a}"));
                Self::NotConverged(format!("{error}\n  = help: nothing was written{advice}"))
            }
        }
    }
}
