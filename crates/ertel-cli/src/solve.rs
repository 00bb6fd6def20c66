//! `ertel solve`.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use ertel::case::{Case, Curve};
use ertel::output;
use ertel::run::Session;
use ertel::solve::{DiscretisationError, SolveError};
use ertel::study::{CurveSolution, solve_curve};
use ertel_rheology::input::escaped;

use crate::args::SolveArgs;
use crate::cache::user_cache;
use crate::failure::Failure;
use crate::print;
use crate::progress::Progress;

/// Set by Ctrl-C; the solver looks at it before each iteration.
pub static CANCELLED: AtomicBool = AtomicBool::new(false);
/// While results are written a second Ctrl-C waits for the moment this takes.
static WRITING: AtomicBool = AtomicBool::new(false);

/// What to try when the iterations do not converge.
const HELP: &str = "  = help: nothing was written. A finer mesh ([mesh] preset = \"fine\"), another \
    formulation ([solver]\n    formulation = \"supg\") or a smaller load to begin with often help";

/// Runs the command.
///
/// # Errors
///
/// A bad case, results that cannot be written, no convergence, an interruption.
pub fn run(arguments: &SolveArgs) -> Result<(), Failure> {
    let mut case = Case::read(&arguments.case)?;
    case.output.png |= arguments.png;
    let folder = folder(arguments, &case);
    if arguments.check || arguments.quiet {
        warn(&input_warnings(&case));
    }
    if case.output.png {
        output::check_png().map_err(|error| Failure::Argument(error.to_string()))?;
    }
    if arguments.check {
        return Ok(());
    }
    let session = Session {
        cache: match arguments.no_cache {
            true => None,
            false => user_cache()?,
        },
    };
    // A long solve whose results have no place to go would be in vain.
    output::check_target(&folder)?;
    check_writable(&folder)?;
    listen_for_interrupts();

    let mut progress = Progress::new(arguments.quiet, &CANCELLED);
    if let Some(curve) = &case.curve {
        let solution = solve_curve(&session, curve, &mut progress);
        drop(progress);
        return write_curve(&case, curve, &solution, &folder, arguments.quiet);
    }
    let solution = session.solve(&case, &mut progress);
    drop(progress);
    let solution = solution?;
    WRITING.store(true, Ordering::SeqCst);
    if CANCELLED.load(Ordering::SeqCst) {
        return Err(Failure::Interrupted);
    }
    let echo = case.echo();
    output::write(&echo, &solution, &folder, &case.output)?;
    WRITING.store(false, Ordering::SeqCst);
    if arguments.quiet {
        let known = |warning: &&String| !case.warnings.contains(warning);
        warn(solution.warnings.iter().filter(known));
        return Ok(());
    }
    print::stdout(&output::report(&echo, &solution, Some(&folder)))
}

/// Writes what was solved of a curve; says what was not.
fn write_curve(
    case: &Case,
    curve: &Curve,
    solution: &CurveSolution,
    folder: &Path,
    quiet: bool,
) -> Result<(), Failure> {
    if solution.points.is_empty() {
        return Err(Failure::Interrupted);
    }
    WRITING.store(true, Ordering::SeqCst);
    let echo = case.echo();
    output::write_curve(&echo, solution, folder, &case.output, curve.folders)?;
    WRITING.store(false, Ordering::SeqCst);
    if !quiet {
        print::stdout(&output::curve_report(&echo, solution, Some(folder)))?;
    }
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
            "{failed} of {all} points failed; the reasons stand in {}",
            folder.join("curve.csv").display()
        )));
    }
    Ok(())
}

/// What to know about the input: of a case, or of the points of its curve.
fn input_warnings(case: &Case) -> Vec<String> {
    let Some(curve) = &case.curve else {
        return case.warnings.clone();
    };
    let mut warnings: Vec<String> = Vec::new();
    for warning in curve.points.iter().flat_map(|p| &p.case.warnings) {
        if !warnings.contains(warning) {
            warnings.push(warning.clone());
        }
    }
    warnings
}

fn warn<'a>(warnings: impl IntoIterator<Item = &'a String>) {
    for warning in warnings {
        eprintln!("warning: {}", escaped(warning));
    }
}

/// Where the results go: the command line, the case, or `results/<name of the case file>`.
fn folder(arguments: &SolveArgs, case: &Case) -> PathBuf {
    let name = || arguments.case.file_stem().unwrap_or("case".as_ref());
    arguments
        .output
        .clone()
        .or_else(|| case.output.folder.clone())
        .unwrap_or_else(|| Path::new("results").join(name()))
}

/// Tries to make a folder beside the target, or where the first folder on the way to it will be made.
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

/// The first Ctrl-C asks the solver to stop; the second ends the program where nothing can be left half-written.
pub fn listen_for_interrupts() {
    let handler = || {
        if CANCELLED.swap(true, Ordering::SeqCst) {
            if !WRITING.load(Ordering::SeqCst) {
                std::process::exit(130);
            }
        } else {
            eprintln!("stopping after this iteration; press Ctrl-C again to stop at once");
        }
    };
    if let Err(error) = ctrlc::set_handler(handler) {
        eprintln!("warning: Ctrl-C will stop the program at once ({error})");
    }
}

impl From<SolveError> for Failure {
    fn from(error: SolveError) -> Self {
        match error {
            SolveError::Interrupted => Self::Interrupted,
            SolveError::Discretisation(DiscretisationError::Mesh(error)) => {
                Self::Argument(format!(
                    "the mesh of this case cannot be built: {error}\n  = help: see [mesh] in the case file"
                ))
            }
            SolveError::MissingHeatData(error) => {
                Self::Argument(format!("{error}\n  = help: {}", error.advice()))
            }
            SolveError::TooThin { help, .. } => {
                Self::Argument(format!("{error}\n  = help: {help}"))
            }
            SolveError::Discretisation(error) => Self::Other(error.to_string()),
            SolveError::NotConverged { .. }
            | SolveError::NotCoupled { .. }
            | SolveError::Heat(_)
            | SolveError::Krylov(_)
            | SolveError::Factorisation(_) => Self::NotConverged(format!("{error}\n{HELP}")),
        }
    }
}
