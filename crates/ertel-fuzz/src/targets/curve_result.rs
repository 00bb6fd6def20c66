//! Folders that a new result is to replace: what is in them stays.

use std::fs;
use std::path::Path;

use ertel::output::check_target;
use ertel::output::compare::check_comparison_folder;

use super::{Verdict, check_text};
use crate::finding::Defect;

/// Asks whether the folder may be replaced by a result, and whether it may hold a comparison.
pub fn run(folder: &Path) -> Result<Verdict, Defect> {
    let names = || -> Vec<_> {
        let entries = fs::read_dir(folder).into_iter().flatten().flatten();
        entries.map(|entry| entry.file_name()).collect()
    };
    let before = names();
    let mut verdict = Verdict::Refused;
    for found in [check_target(folder), check_comparison_folder(folder)] {
        match found {
            Ok(()) => verdict = Verdict::Taken,
            Err(error) => {
                check_text(&ertel_input::escaped(&error.to_string()))?;
            }
        }
    }
    match names() == before {
        true => Ok(verdict),
        false => Err(Defect::wrong("looking at a folder changes it", "")),
    }
}
