//! Several cases in one command.

use std::path::{Path, PathBuf};

use ertel::case::Case;
use ertel::params::SensitivityDemand;
use ertel::warning::{Warning, by_kind};
use serde_json::json;

use crate::args::SolveArgs;
use crate::events::Events;
use crate::failure::Failure;
use crate::given::Given;
use crate::inputs::overlap;
use crate::print;
use crate::table::columns;

/// Reads all cases before anything is solved, and finds a folder for each.
///
/// # Errors
///
/// Bad cases, each of them reported; two cases with one folder; `--monte-carlo` of several.
pub fn read(arguments: &SolveArgs, events: &Events) -> Result<Vec<Job>, Failure> {
    let n_cases = arguments.cases.len();
    if n_cases > 1 && arguments.monte_carlo.is_some() {
        return Err(Failure::Argument(
            "--monte-carlo takes one case at a time".into(),
        ));
    }
    let n_stdin = arguments
        .cases
        .iter()
        .filter(|c| c.as_os_str() == "-")
        .count();
    if n_stdin > 1 {
        return Err(Failure::Argument(
            "`-`, standard input, can be read once only".into(),
        ));
    }
    let mut jobs: Vec<Job> = Vec::new();
    let mut failures = Vec::new();
    for path in &arguments.cases {
        let mut given = match Given::read(path, &arguments.set) {
            Ok(given) => given,
            Err(failure) => {
                failures.push((path.display().to_string(), failure));
                continue;
            }
        };
        complete(&mut given.case, arguments);
        let folder = folder(arguments, &given);
        jobs.push(Job { given, folder });
    }
    if n_cases == 1 {
        return match failures.pop() {
            Some((_, failure)) => Err(failure),
            None => Ok(jobs),
        };
    }
    if !failures.is_empty() {
        let n = failures.len();
        for (name, failure) in &failures {
            events.set_case(Some(name));
            events.fail(failure);
            print::stderr(&format!("error: {failure}"));
        }
        return Err(Failure::Cases {
            message: format!("{n} of {n_cases} cases are bad; nothing was solved"),
            code: worst(failures.iter().map(|(_, failure)| failure.code())),
        });
    }
    for (i, job) in jobs.iter().enumerate() {
        let is_taken = |other: &&Job| overlap(&job.folder, &other.folder);
        if let Some(other) = jobs[..i].iter().find(is_taken) {
            return Err(Failure::Argument(format!(
                "the results of {} and {} would go into the same folder, {}; rename one of the files, or solve them one by one with --output",
                other.given.name,
                job.given.name,
                job.folder.display()
            )));
        }
    }
    Ok(jobs)
}

/// Folder of the results of a case: the command line, the case, or `results/<name of the case file>`.
fn folder(arguments: &SolveArgs, given: &Given) -> PathBuf {
    match (&arguments.output, arguments.cases.len()) {
        (Some(folder), 1) => folder.clone(),
        (Some(parent), _) => parent.join(given.stem()),
        (None, _) => (given.case.output.folder.clone())
            .unwrap_or_else(|| Path::new("results").join(given.stem())),
    }
}

/// Runs `work` for each case, also after failures of others.
///
/// # Errors
///
/// For one case its own failure; for several the worst exit code, each failure reported.
pub fn each(
    jobs: &[Job],
    events: &Events,
    action: impl Fn(&Job) -> Result<(), Failure>,
) -> Result<(), Failure> {
    let mut codes = Vec::new();
    for job in jobs {
        events.set_case(Some(&job.given.name));
        match action(job) {
            Ok(()) => {}
            Err(failure) if jobs.len() == 1 => return Err(failure),
            Err(failure) => {
                events.fail(&failure);
                print::stderr(&format!("error: {failure}"));
                codes.push(failure.code());
            }
        }
    }
    all(jobs.len(), codes)
}

fn all(n_cases: usize, codes: Vec<u8>) -> Result<(), Failure> {
    match codes.len() {
        0 => Ok(()),
        n => Err(Failure::Cases {
            message: format!("{n} of {n_cases} cases did not succeed"),
            code: worst(codes),
        }),
    }
}

/// Solves one case after the other and reports the outcome of each.
///
/// # Errors
///
/// As [`each`]; after an interruption no further case begins.
pub fn solve_all(
    jobs: &[Job],
    arguments: &SolveArgs,
    events: &Events,
    solve: &dyn Fn(&Job) -> Result<String, Failure>,
) -> Result<(), Failure> {
    let mut rows = vec![
        ["case", "outcome", "films", "folder"]
            .map(str::to_owned)
            .to_vec(),
    ];
    let mut codes: Vec<u8> = Vec::new();
    let is_talking = !arguments.report.quiet && !arguments.json;
    for (i, job) in jobs.iter().enumerate() {
        let mut row = |outcome: &str, films: &str, folder: &str| {
            rows.push(
                [job.given.name.as_str(), outcome, films, folder]
                    .map(str::to_owned)
                    .to_vec(),
            );
        };
        if codes.last() == Some(&INTERRUPTED) {
            row("not begun", "-", "-");
            codes.push(INTERRUPTED);
            continue;
        }
        events.set_case(Some(&job.given.name));
        if is_talking {
            print::stderr(&format!(
                "case {}/{}: {}",
                i + 1,
                jobs.len(),
                job.given.name
            ));
        }
        let folder = job.folder.display().to_string();
        match solve(job) {
            Ok(films) => row("solved", &films, &folder),
            Err(failure) => {
                events.fail(&failure);
                print::stderr(&format!("error: {}: {failure}", job.given.name));
                match &failure {
                    Failure::Unresolved(_) => row("not resolved", "-", &folder),
                    Failure::NotConverged(_) => row("not converged", "-", "-"),
                    Failure::Interrupted | Failure::InterruptedCurve(_) => {
                        row("interrupted", "-", "-")
                    }
                    Failure::Argument(_) | Failure::Input(_) => row("bad case", "-", "-"),
                    _ => row("failed", "-", "-"),
                }
                codes.push(failure.code());
            }
        }
    }
    events.set_case(None);
    let outcomes = rows
        .iter()
        .skip(1)
        .map(|row| json!({ "case": row[0], "outcome": row[1] }));
    events.emit("summary", json!({ "cases": outcomes.collect::<Vec<_>>() }));
    let shown = match is_talking {
        true => print::stdout(&format!("\n{}", columns(&rows))),
        false => Ok(()),
    };
    all(jobs.len(), codes).and(shown)
}

/// Exit code of an interruption.
const INTERRUPTED: u8 = 130;

/// The worst exit code: interruption, bad input, unwritable results, no convergence.
fn worst(codes: impl IntoIterator<Item = u8>) -> u8 {
    const ORDER: [u8; 4] = [3, 1, 2, INTERRUPTED];
    let rank = |code: &u8| ORDER.iter().position(|c| c == code).unwrap_or(0);
    codes.into_iter().max_by_key(rank).unwrap_or(1)
}

/// A case to be solved, and the folder of its results.
pub struct Job {
    /// The case.
    pub given: Given,
    /// Folder of its results.
    pub folder: PathBuf,
}

/// Settings of the command line that are those of the case as well.
pub fn complete(case: &mut Case, arguments: &SolveArgs) {
    case.output.pictures.png |= arguments.png;
    case.output.pictures.pdf |= arguments.pdf;
    if case.curve.is_none() && case.output.sensitivities == SensitivityDemand::WhereUncertain {
        case.output.sensitivities = SensitivityDemand::WhereCheap;
    }
}

/// Contacts of a case: those of a curve or a machine, or one.
pub fn n_points(case: &Case) -> usize {
    match (&case.curve, &case.contacts) {
        (Some(curve), _) => curve.points.len(),
        (None, Some(contacts)) => contacts.study.points.len(),
        (None, None) => 1,
    }
}

/// Warnings about the input of a case, or of the points of its curve.
pub fn input_warnings(case: &Case) -> Vec<Warning> {
    let Some(curve) = &case.curve else {
        return case.warnings.clone();
    };
    let points = curve.points.iter().enumerate();
    let warnings = points.flat_map(|(i, p)| {
        let shown = p.case.warnings.iter().filter(|w| w.is_shown());
        shown.map(move |w| (i, w))
    });
    (by_kind(warnings).iter())
        .map(|merged| merged.with_text(merged.line(curve.points.len())))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_worst_code_counts() {
        assert_eq!(worst([3, 1]), 1);
        assert_eq!(worst([2, 3, 1]), 2);
        assert_eq!(worst([3, INTERRUPTED, 2]), INTERRUPTED);
        assert_eq!(worst([3, 3]), 3);
    }
}
