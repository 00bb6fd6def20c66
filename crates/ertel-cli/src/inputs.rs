//! What a command reads, it does not write.

use std::fs;
use std::path::{Path, PathBuf};

use crate::failure::Failure;

/// Refuses files to be written that are among those being read, whatever their names; `what` is how messages call an
/// output, such as `--output`.
///
/// # Errors
///
/// [`Failure::Argument`] that names both.
pub fn keep(inputs: &[PathBuf], outputs: &[(&str, &Path)]) -> Result<(), Failure> {
    for (what, output) in outputs {
        if let Some(input) = inputs.iter().find(|input| is_same(input, output)) {
            return Err(Failure::Argument(format!(
                "{what} {} would overwrite {}, which this command reads; choose another place",
                output.display(),
                input.display()
            )));
        }
    }
    Ok(())
}

/// Refuses a folder to be replaced that holds a file being read.
///
/// # Errors
///
/// [`Failure::Argument`] that names both.
pub fn keep_within(inputs: &[PathBuf], folder: &Path) -> Result<(), Failure> {
    let Ok(place) = fs::canonicalize(folder) else {
        return Ok(()); // Nothing there yet.
    };
    let within = |input: &&PathBuf| fs::canonicalize(input).is_ok_and(|p| p.starts_with(&place));
    match inputs.iter().find(within) {
        Some(input) => Err(Failure::Argument(format!(
            "will not replace the folder {}: it holds {}, which this command reads. Choose another folder with --output",
            folder.display(),
            input.display()
        ))),
        None => Ok(()),
    }
}

/// Whether two files to be written would be one.
pub fn is_one_place(a: &Path, b: &Path) -> bool {
    let place = |path: &Path| {
        let folder = match path.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        };
        Some((fs::canonicalize(folder).ok()?, path.file_name()?.to_owned()))
    };
    a == b || is_same(a, b) || place(a).is_some_and(|p| Some(p) == place(b))
}

/// Whether two names are those of one file: links of both kinds count.
fn is_same(a: &Path, b: &Path) -> bool {
    // Opening a pipe to look at it could wait for ever.
    let is_file = |path: &Path| fs::metadata(path).is_ok_and(|m| m.is_file());
    is_file(a) && is_file(b) && same_file::is_same_file(a, b).unwrap_or(false)
}
