//! `ertel compare`.

use std::path::{Path, PathBuf};

use ertel::compare::{Comparison, Measured, MeasuredError, Probe, ReadParams};
use ertel::output::compare::{
    COMPARISON_FILES, COMPARISON_STUDY, check_comparison_folder, comparison_report,
    write_comparison,
};
use ertel::params::PictureFormats;
use ertel::sweep::{SweepParams, SweepSummary, finished_points, sweep};

use crate::args::CompareArgs;
use crate::failure::Failure;
use crate::inputs;
use crate::interrupt::{CANCELLED, listen_for_interrupts};
use crate::print;
use crate::results::points_not_resolved;
use crate::sweep::remarks;
use crate::sweep_progress::Progress;

/// Runs the command.
///
/// # Errors
///
/// A bad case or table, a folder that cannot be written, points that failed, an interruption.
pub fn run(arguments: &CompareArgs) -> Result<(), Failure> {
    let params = ReadParams {
        steps: arguments.step.clone(),
        probe: match arguments.thermometer.as_str() {
            "pot" => Probe::Pot,
            _ => Probe::Lubricant,
        },
        table: arguments.table.params(&arguments.ignore),
    };
    let measured = Measured::read(&arguments.case, &arguments.measured, &params)?;
    let folder = folder(arguments);
    keep_inputs(&measured, &folder)?;
    check_comparison_folder(&folder)?;
    if arguments.check {
        return check(&measured);
    }
    let params = SweepParams {
        jobs: arguments.workers.jobs.map(usize::from),
        threads: Some(usize::from(arguments.workers.threads)),
        retry: arguments.retry,
        ..SweepParams::default()
    };
    listen_for_interrupts();
    let progress = Progress::new(arguments.report.quiet, &CANCELLED);
    let points = folder.join(COMPARISON_STUDY);
    let summary = sweep(&measured.study, &points, &params, &progress);
    drop(progress);
    let summary = summary?;
    if summary.interrupted {
        return Err(Failure::InterruptedCurve(format!(
            "interrupted after {} of {} points; the same command continues with the others",
            summary.n_kept + summary.n_new,
            summary.n_points
        )));
    }
    let records = finished_points(&measured.study, &points)?;
    let comparison = Comparison::new(&measured, &records);
    let formats = PictureFormats {
        pdf: arguments.pdf,
        png: arguments.png,
        ..PictureFormats::default()
    };
    write_comparison(&comparison, &measured.case_text, &folder, formats)?;
    let shown = match arguments.report.quiet {
        true => Ok(()),
        false => {
            print::stdout(&(remarks(&summary) + &comparison_report(&comparison, Some(&folder))))
        }
    };
    // Failures of points have priority over a report that could not be shown.
    let unresolved = match arguments.report.accept_unresolved {
        true => 0,
        false => comparison.n_unresolved(),
    };
    ended(&summary, &folder, unresolved).and(shown)
}

/// Folder of the comparison: the command line, or `results/<case>-<table>`.
fn folder(arguments: &CompareArgs) -> PathBuf {
    if let Some(folder) = &arguments.output {
        return folder.clone();
    }
    let stem = |path: &Path| path.file_stem().unwrap_or_default().to_owned();
    let mut name = stem(&arguments.case);
    name.push("-");
    name.push(stem(&arguments.measured));
    Path::new("results").join(name)
}

/// Nothing that is read is overwritten.
fn keep_inputs(measured: &Measured, folder: &Path) -> Result<(), Failure> {
    let written = COMPARISON_FILES.map(|name| folder.join(name));
    let outputs = written.each_ref().map(|path| ("the file", path.as_path()));
    inputs::keep(&measured.study.files, &outputs)?;
    inputs::keep_within(&measured.study.files, &folder.join(COMPARISON_STUDY))
}

/// Shows the points to be solved.
fn check(measured: &Measured) -> Result<(), Failure> {
    for point in &measured.study.points {
        ertel::run::check(&point.case).map_err(|error| {
            let error = Failure::from(error);
            Failure::Argument(format!(
                "{}: {}: {error}",
                measured.file.display(),
                point.label
            ))
        })?;
    }
    let notes: String = measured
        .notes
        .iter()
        .map(|note| format!("{note}\n"))
        .collect();
    let used: String = (measured.used.iter())
        .map(|(title, what)| format!("column `{title}`: {what}\n"))
        .collect();
    print::stdout(&format!(
        "{notes}{used}{} rows, {} points\n",
        measured.rows.len(),
        measured.study.points.len()
    ))
}

/// Exit code 3 if a point is omitted or not resolved.
fn ended(summary: &SweepSummary, folder: &Path, n_unresolved: usize) -> Result<(), Failure> {
    let table = folder.join("comparison.csv");
    if !summary.failures.is_empty() {
        return Err(Failure::NotConverged(format!(
            "{} of {} points failed and are omitted; the reasons are in {}",
            summary.failures.len(),
            summary.n_points,
            table.display()
        )));
    }
    match n_unresolved {
        0 => Ok(()),
        n => Err(points_not_resolved(n, summary.n_points, &table)),
    }
}

impl From<MeasuredError> for Failure {
    fn from(error: MeasuredError) -> Self {
        match error {
            MeasuredError::Case(error) => Self::Input(error),
            error => Self::Argument(error.to_string()),
        }
    }
}
