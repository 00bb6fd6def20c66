//! `ertel solve`.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use ertel::case::{Case, Curve};
use ertel::output;
use ertel::params::SensitivityDemand;
use ertel::run::{self, Session};
use ertel::solution::Unresolved;
use ertel::solve::{DiscretisationError, SolveError};
use ertel::study::{CurveSolution, solve_curve, value_text};
use ertel::warning::{Warning, by_kind};

use crate::args::SolveArgs;
use crate::cache::user_cache;
use crate::failure::Failure;
use crate::inputs;
use crate::monte_carlo;
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
    case.output.pictures.png |= arguments.png;
    case.output.pictures.pdf |= arguments.pdf;
    if case.curve.is_none() && case.output.sensitivities == SensitivityDemand::WhereUncertain {
        case.output.sensitivities = SensitivityDemand::WhereCheap;
    }
    let folder = folder(arguments, &case);
    if arguments.check || arguments.quiet {
        warn(&input_warnings(&case));
    }
    if arguments.check {
        return check(&case, &arguments.case);
    }
    let session = Session {
        cache: match arguments.no_cache {
            true => None,
            false => user_cache()?,
        },
    };
    let mut read = case.files(arguments.case.parent().unwrap_or(Path::new("")));
    read.push(arguments.case.clone());
    inputs::keep_within(&read, &folder)?;
    // A long solve whose results have no place to go would be in vain.
    output::clear_leftovers(&folder);
    output::check_target(&folder)?;
    check_writable(&folder)?;
    listen_for_interrupts();

    let samples = monte_carlo::samples(arguments, &case, &folder)?;
    let mut progress = Progress::new(arguments.quiet, &CANCELLED);
    if let Some(curve) = &case.curve {
        let solution = solve_curve(&session, curve, &mut progress);
        drop(progress);
        return write_curve(&case, curve, &solution, &folder, arguments);
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
    let shown = if arguments.quiet {
        let known = |warning: &&Warning| !case.warnings.contains(warning);
        warn(solution.warnings.iter().filter(known));
        Ok(())
    } else {
        print::stdout(&output::report(&echo, &solution, Some(&folder)))
    };
    if let Some(samples) = &samples {
        monte_carlo::run(&session, samples, &solution, arguments)?;
    }
    match &solution.unresolved[..] {
        [] => shown,
        _ if arguments.accept_unresolved => shown,
        unresolved => Err(not_resolved(unresolved, &folder)),
    }
}

/// Says of a case, or of the points of its curve, what a solve would refuse before it begins.
fn check(case: &Case, path: &Path) -> Result<(), Failure> {
    let file = path.display();
    let Some(curve) = &case.curve else {
        let refused = |error| Failure::Argument(format!("{file}: {}", Failure::from(error)));
        return run::check(case).map_err(refused);
    };
    for (i, point) in curve.points.iter().enumerate() {
        run::check(&point.case).map_err(|error| {
            Failure::Argument(format!(
                "{file}: point {} of the curve ({}): {}",
                i + 1,
                value_text(&curve.quantity, point.value()),
                Failure::from(error)
            ))
        })?;
    }
    Ok(())
}

/// Error bars so wide that no one should go on with the figures without noticing.
fn not_resolved(unresolved: &[Unresolved], folder: &Path) -> Failure {
    let figures: Vec<String> = unresolved.iter().map(output::unresolved).collect();
    Failure::Unresolved(format!(
        "not resolved: {}, with an error bar wider than half of it; the results are in {}, where result.json says \
         \"unresolved\"\n  = help: {RESOLVE}",
        figures.join("; "),
        folder.display()
    ))
}

/// The same of points; their table says which.
pub fn points_not_resolved(n: usize, all: usize, table: &Path) -> Failure {
    Failure::Unresolved(format!(
        "{n} of {all} points are not resolved: error bars wider than half of the figure; which, stands in the column \
         `unresolved` of {}\n  = help: {RESOLVE}",
        table.display()
    ))
}

/// What to do about figures that are not resolved.
const RESOLVE: &str = "raise [mesh] max_unknowns, or accept such figures with --accept-unresolved; the warnings say \
    what the mesh lacks";

/// Writes what was solved of a curve; says what was not.
fn write_curve(
    case: &Case,
    curve: &Curve,
    solution: &CurveSolution,
    folder: &Path,
    arguments: &SolveArgs,
) -> Result<(), Failure> {
    let (quiet, accept_unresolved) = (arguments.quiet, arguments.accept_unresolved);
    if solution.points.is_empty() {
        return Err(Failure::Interrupted);
    }
    WRITING.store(true, Ordering::SeqCst);
    let echo = case.echo();
    output::write_curve(&echo, solution, folder, &case.output, curve.folders)?;
    WRITING.store(false, Ordering::SeqCst);
    let shown = match quiet {
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
            "{failed} of {all} points failed; the reasons stand in {}",
            folder.join("curve.csv").display()
        )));
    }
    let points = solution.points.iter().filter_map(|p| p.outcome.solution());
    let n_unresolved = points.filter(|s| !s.unresolved.is_empty()).count();
    if n_unresolved > 0 && !accept_unresolved {
        return Err(points_not_resolved(
            n_unresolved,
            all,
            &folder.join("curve.csv"),
        ));
    }
    shown
}

/// What to know about the input: of a case, or of the points of its curve.
fn input_warnings(case: &Case) -> Vec<Warning> {
    let Some(curve) = &case.curve else {
        return case.warnings.clone();
    };
    let points = curve.points.iter().enumerate();
    let warnings = points.flat_map(|(i, p)| p.case.warnings.iter().map(move |w| (i, w)));
    (by_kind(warnings).iter())
        .map(|merged| Warning::from(merged.line(curve.points.len())))
        .collect()
}

fn warn<'a>(warnings: impl IntoIterator<Item = &'a Warning>) {
    for warning in warnings {
        print::stderr(&format!("warning: {warning}"));
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
            print::stderr("stopping after this iteration; press Ctrl-C again to stop at once");
        }
    };
    if let Err(error) = ctrlc::set_handler(handler) {
        print::stderr(&format!(
            "warning: Ctrl-C will stop the program at once ({error})"
        ));
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
