//! `ertel solve`.

use std::path::{Path, PathBuf};

use ertel::case::Case;

use crate::args::SolveArgs;
use crate::failure::Failure;

/// Runs the command.
///
/// # Errors
///
/// A bad case, results that cannot be written, no convergence, an interruption.
pub fn run(arguments: &SolveArgs) -> Result<(), Failure> {
    let case = Case::read(&arguments.case)?;
    for warning in &case.warnings {
        eprintln!("warning: {warning}");
    }
    let folder = folder(arguments, &case);
    if arguments.check {
        return Ok(());
    }
    let _ = folder;
    Err(Failure::Other("this build has no solver".to_owned()))
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
