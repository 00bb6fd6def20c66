//! Pictures in files that the user names.

use std::path::Path;

use ertel::output::{OutputError, picture_format, write_drawing};
use ertel_plot::Drawing;

use crate::failure::Failure;

/// Whether the name says in which format.
///
/// # Errors
/// A suffix of no format, exit code 2.
pub fn check(path: &Path) -> Result<(), Failure> {
    picture_format(path).map_err(failure).map(drop)
}

/// Writes a picture in the format that the name says.
///
/// # Errors
/// As [`check`], and files that cannot be written.
pub fn write(path: &Path, drawing: &Drawing) -> Result<(), Failure> {
    write_drawing(path, drawing).map_err(failure)
}

fn failure(error: OutputError) -> Failure {
    match error {
        OutputError::Suffix { .. } => Failure::Argument(error.to_string()),
        error => error.into(),
    }
}
