//! `ertel sweep`.

use std::path::{Path, PathBuf};

use ertel::case::Study;
use ertel::study::TABLE;
use ertel::study::plan::Plan;
use ertel::sweep::{
    FOLDERS, SHARDS, SweepError, SweepParams, SweepSummary, files, finished_points, merge, sweep,
};
use ertel::words::digits;

use crate::args::SweepArgs;
use serde_json::{Value, json};

use crate::events::{Events, path_text};
use crate::failure::Failure;
use crate::inputs;
use crate::interrupt::{CANCELLED, listen_for_interrupts};
use crate::print;
use crate::results::points_not_resolved;
use crate::sweep_progress::Progress;
use crate::table::columns;

/// Failures and warnings that the report shows one by one.
const MOST_SHOWN: usize = 10;

/// Runs the command.
///
/// # Errors
///
/// A bad study, a folder that cannot be written, points that failed, an interruption.
pub fn run(arguments: &SweepArgs) -> Result<(), Failure> {
    let events = Events::new(arguments.json);
    events.finish(run_with(arguments, &events))
}

fn run_with(arguments: &SweepArgs, events: &Events) -> Result<(), Failure> {
    if let Some([target, parts @ ..]) = arguments.merge.as_deref() {
        let summary = merge(target, parts)?;
        return merged(&summary, target, arguments, events);
    }
    let Some(path) = &arguments.study else {
        return Err(Failure::Argument("no study is given".into()));
    };
    let study = Study::read_with(path, &arguments.set)?;
    let folder = folder(arguments, path);
    keep_inputs(&study, &folder)?;
    if arguments.dry_run {
        return dry_run(&study, &folder, events);
    }
    let params = SweepParams {
        jobs: arguments.workers.jobs.map(usize::from),
        threads: Some(usize::from(arguments.workers.threads)),
        shard: arguments.shard,
        folders: arguments.folders,
        retry: arguments.retry,
    };
    listen_for_interrupts();
    events.emit(
        "started",
        json!({
            "command": "sweep",
            "version": env!("CARGO_PKG_VERSION"),
            "title": study.title,
            "folder": path_text(&folder),
            "points": study.points.len(),
        }),
    );
    if arguments.verbose {
        for file in &study.files {
            print::stderr(&format!("read {}", file.display()));
        }
        print::stderr(&format!("results will go to {}", folder.display()));
    }
    let progress = match (events.is_on(), arguments.verbose) {
        (true, _) => Progress::as_events(events, &CANCELLED),
        (false, true) => Progress::in_lines(&CANCELLED),
        (false, false) => Progress::new(arguments.report.quiet, &CANCELLED),
    };
    let summary = sweep(&study, &folder, &params, &progress);
    drop(progress);
    report(&summary?, &folder, arguments, events)
}

/// Folder of the study: the command line, or `results/<name of the study file>`.
fn folder(arguments: &SweepArgs, path: &Path) -> PathBuf {
    if let Some(folder) = &arguments.output {
        return folder.clone();
    }
    let folder = Path::new("results").join(path.file_stem().unwrap_or("study".as_ref()));
    match arguments.shard {
        Some(shard) => folder.join(SHARDS).join(shard.name()),
        None => folder,
    }
}

/// Nothing that the study reads is overwritten by what it writes.
fn keep_inputs(study: &Study, folder: &Path) -> Result<(), Failure> {
    let written: Vec<PathBuf> = files().map(|name| folder.join(name)).collect();
    let outputs: Vec<_> = (written.iter().map(|path| ("the file", path.as_path()))).collect();
    inputs::keep(&study.files, &outputs)?;
    inputs::keep_within(&study.files, &folder.join(FOLDERS))
}

fn dry_run(study: &Study, folder: &Path, events: &Events) -> Result<(), Failure> {
    let plan = Plan::new(study);
    let finished = finished_points(study, folder)?;
    let state = |i: usize| match &finished[i] {
        None => "to do",
        Some(record) if record.converged => "finished",
        Some(_) => "failed",
    };
    if events.is_on() {
        for (i, point) in study.points.iter().enumerate() {
            events.emit(
                "planned",
                json!({
                    "point": i + 1,
                    "starts_from": plan.parents[i].map(|p| p + 1),
                    "state": state(i),
                    "values": point.label,
                }),
            );
        }
        return Ok(());
    }
    let mut rows = vec![vec![
        "point".to_owned(),
        "starts from".to_owned(),
        "state".to_owned(),
        "values".to_owned(),
    ]];
    for (i, point) in study.points.iter().enumerate() {
        rows.push(vec![
            (i + 1).to_string(),
            plan.parents[i].map_or("dry contact".to_owned(), |p| (p + 1).to_string()),
            state(i).to_owned(),
            point.label.clone(),
        ]);
    }
    let n_done = finished.iter().flatten().count();
    let n_cold = plan.parents.iter().filter(|p| p.is_none()).count();
    print::stdout(&format!(
        "{}\n{} points, {n_done} finished; {n_cold} from the dry contact, longest chain: {} solves\n",
        columns(&rows),
        study.points.len(),
        plan.depth()
    ))
}

/// The events of a study or of joined parts: warnings of the points, and the result.
fn emit_result(summary: &SweepSummary, folder: &Path, events: &Events) {
    events.warn_of_points(&summary.warnings);
    let failures: Vec<Value> = (summary.failures.iter())
        .map(|(i, values, reason)| json!({ "point": i + 1, "values": values, "reason": reason }))
        .collect();
    events.emit(
        "result",
        json!({
            "folder": path_text(folder),
            "table": path_text(&folder.join(TABLE)),
            "points": summary.n_points,
            "finished": summary.n_kept + summary.n_new,
            "finished_earlier": summary.n_kept,
            "failures": failures,
            "unresolved": summary.n_unresolved,
            "interrupted": summary.interrupted,
        }),
    );
}

fn report(
    summary: &SweepSummary,
    folder: &Path,
    arguments: &SweepArgs,
    events: &Events,
) -> Result<(), Failure> {
    let mut shown = Ok(());
    emit_result(summary, folder, events);
    if summary.n_damaged > 0 {
        print::stderr(&format!(
            "warning: {} lines of the journal are damaged or were changed; their points were solved again",
            summary.n_damaged
        ));
    }
    if !arguments.report.quiet && !events.is_on() {
        let mut text = remarks_up_to(summary, most_shown(arguments));
        let kept = match summary.n_kept {
            0 => String::new(),
            n => format!(", {n} of them earlier"),
        };
        text += &format!(
            "{} of {} points finished{kept}, {} failed; {} new in {} s, {} s each on its own\n",
            summary.n_kept + summary.n_new,
            summary.n_points,
            summary.failures.len(),
            summary.n_new,
            digits(summary.wall_seconds, 3),
            digits(summary.point_seconds / (summary.n_new.max(1) as f64), 3),
        );
        if summary.n_again > 0 {
            text += &format!(
                "{} finished points were recomputed as the starting solutions of new points\n",
                summary.n_again
            );
        }
        if !summary.interrupted {
            text += &format!("Results in {}\n", folder.join(TABLE).display());
        }
        shown = print::stdout(&text);
    }
    if summary.interrupted {
        return Err(Failure::InterruptedCurve(format!(
            "interrupted after {} of {} points; the same command continues with the others",
            summary.n_kept + summary.n_new,
            summary.n_points
        )));
    }
    // Failures of points have priority over a report that could not be shown.
    failed(summary, folder, arguments.report.accept_unresolved).and(shown)
}

fn failed(summary: &SweepSummary, folder: &Path, accept_unresolved: bool) -> Result<(), Failure> {
    let table = folder.join(TABLE);
    if summary.failures.is_empty() {
        return match summary.n_unresolved {
            0 => Ok(()),
            _ if accept_unresolved => Ok(()),
            n => Err(points_not_resolved(n, summary.n_points, &table)),
        };
    }
    Err(Failure::NotConverged(format!(
        "{} of {} points failed; the reasons are in {}",
        summary.failures.len(),
        summary.n_points,
        table.display()
    )))
}

fn merged(
    summary: &SweepSummary,
    target: &Path,
    arguments: &SweepArgs,
    events: &Events,
) -> Result<(), Failure> {
    emit_result(summary, target, events);
    let finished = summary.n_kept + summary.n_new;
    let mut shown = Ok(());
    if !arguments.report.quiet && !events.is_on() {
        let text = remarks_up_to(summary, most_shown(arguments));
        shown = print::stdout(&format!(
            "{text}{finished} of {} points finished, {} failed\nResults in {}\n",
            summary.n_points,
            summary.failures.len(),
            target.join(TABLE).display()
        ));
    }
    if summary.interrupted {
        return Err(Failure::Other(format!(
            "{} of {} points are in none of the parts",
            summary.n_points - finished,
            summary.n_points
        )));
    }
    failed(summary, target, arguments.report.accept_unresolved).and(shown)
}

fn most_shown(arguments: &SweepArgs) -> usize {
    if arguments.verbose {
        usize::MAX
    } else {
        MOST_SHOWN
    }
}

/// Failures and warnings, each with its points.
pub fn remarks(summary: &SweepSummary) -> String {
    remarks_up_to(summary, MOST_SHOWN)
}

fn remarks_up_to(summary: &SweepSummary, most: usize) -> String {
    let mut text = String::new();
    for (index, label, reason) in summary.failures.iter().take(most) {
        text += &format!("  ! point {} ({label}) failed: {reason}\n", index + 1);
    }
    for merged in summary.warnings.iter().take(most) {
        let line = merged.with_text(merged.line(summary.n_points));
        text += &format!("  ! {}\n", line.coded());
    }
    let more =
        summary.failures.len().saturating_sub(most) + summary.warnings.len().saturating_sub(most);
    if more > 0 {
        text += &format!("  ! and {more} more of these\n");
    }
    if let Some(line) = summary.unresolved.line(summary.n_points) {
        text += &format!("  · {line}\n");
    }
    if !text.is_empty() {
        text.push('\n');
    }
    text
}

impl From<SweepError> for Failure {
    fn from(error: SweepError) -> Self {
        match error {
            SweepError::Twice { .. } | SweepError::Mixed { .. } | SweepError::NoStudy { .. } => {
                Self::Argument(error.to_string())
            }
            error => Self::Other(error.to_string()),
        }
    }
}
