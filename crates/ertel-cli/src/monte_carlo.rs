//! `ertel solve --monte-carlo`: samples of the uncertain inputs in addition to the solve.

use std::path::{Path, PathBuf};

use ertel::case::{Case, Study};
use ertel::figures::Row;
use ertel::output;
use ertel::solution::Solution;
use ertel::study::monte_carlo::{MonteCarlo, MonteCarloParams, study_of};
use ertel::sweep::{SweepParams, finished_points, sweep};

use crate::args::SolveArgs;
use crate::failure::Failure;
use crate::inputs;
use crate::interrupt::CANCELLED;
use crate::print;
use crate::sweep_progress::Progress;

/// Samples to solve, and where.
pub struct Samples {
    study: Study,
    folder: PathBuf,
}

/// The requested samples, made before anything is solved.
///
/// # Errors
/// A case with a curve, one without uncertain inputs, samples that no contact can have.
pub fn samples(
    arguments: &SolveArgs,
    file: &str,
    case: &Case,
    folder: &Path,
) -> Result<Option<Samples>, Failure> {
    let Some(n) = arguments.monte_carlo else {
        return Ok(None);
    };
    if case.curve.is_some() {
        return Err(Failure::Argument(format!(
            "{file}: --monte-carlo samples the inputs of one contact, but this case has a [curve]"
        )));
    }
    let params = MonteCarloParams {
        n,
        seed: arguments.seed,
    };
    let study =
        study_of(case, &params).map_err(|error| Failure::Argument(format!("{file}: {error}")))?;
    let mut name = folder.file_name().unwrap_or("results".as_ref()).to_owned();
    name.push("-monte-carlo");
    let samples = folder.with_file_name(name);
    if inputs::overlap(&samples, folder) {
        return Err(Failure::Argument(format!(
            "the results would go to {} and the samples to {}, and these folders overlap; choose another folder with --output",
            folder.display(),
            samples.display()
        )));
    }
    // Before the solve, not after it: whether it is the folder of a study, or none yet.
    finished_points(&study, &samples)?;
    Ok(Some(Samples {
        study,
        folder: samples,
    }))
}

/// Solution with the values of the case, in addition to the samples.
pub enum Solved<'a> {
    /// A contact.
    Contact(&'a Solution),
    /// The figures of a whole machine or of a case in time.
    Rows(&'a [Row]),
}

/// Solves the remaining samples and writes their statistics.
///
/// # Errors
/// A folder that cannot be written, an interruption, samples that were not solved.
pub fn run(samples: &Samples, solved: &Solved<'_>, arguments: &SolveArgs) -> Result<(), Failure> {
    let Samples { study, folder } = samples;
    let params = SweepParams {
        threads: Some(1),
        ..SweepParams::default()
    };
    let progress = Progress::new(arguments.report.quiet, &CANCELLED);
    let summary = sweep(study, folder, &params, &progress);
    drop(progress);
    let summary = summary?;
    if summary.interrupted {
        return Err(Failure::InterruptedCurve(format!(
            "interrupted; the samples solved so far are in {}; the same command continues there",
            folder.display()
        )));
    }
    let records = finished_points(study, folder)?;
    let (found, first_order) = match solved {
        Solved::Contact(solution) => {
            let found = MonteCarlo::of(study, &records);
            (found, solution.uncertainty.as_ref())
        }
        Solved::Rows(rows) => (MonteCarlo::of_rows(study, &records, rows), None),
    };
    let pictures = study.points[0].case.output.pictures;
    output::write_monte_carlo(&found, first_order, folder, pictures)?;
    if !arguments.report.quiet {
        print::stdout(&output::monte_carlo_report(&found, first_order))?;
        print::stdout(&format!("\n  {}\n", folder.display()))?;
    }
    match summary.failures.len() {
        0 => Ok(()),
        n => Err(Failure::NotConverged(format!(
            "{n} of {} samples failed and are ignored; the reasons are in {}",
            study.points.len(),
            folder.join(ertel::study::TABLE).display()
        ))),
    }
}
