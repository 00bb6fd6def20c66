//! Where results go, and failures for figures that are not resolved.

use std::path::{Path, PathBuf};

use ertel::output;
use ertel::solution::{Unresolved, Why};

use crate::failure::Failure;
use crate::print;

/// Folder of a result: a partial one goes next to an existing complete one, with a note.
pub fn place_of(folder: &Path, is_partial: bool) -> PathBuf {
    if !is_partial {
        return folder.to_owned();
    }
    let place = output::place_of_partial(folder);
    if place != folder {
        print::stderr(&format!(
            "note: {} keeps its complete result; the partial result of this run goes to {}",
            folder.display(),
            place.display()
        ));
    }
    place
}

pub fn not_shown(error: serde_json::Error) -> Failure {
    Failure::Other(format!("cannot show the result: {error}"))
}

/// Failure for figures that are not resolved.
pub fn not_resolved(unresolved: &[Unresolved], folder: &Path) -> Failure {
    let figures: Vec<String> = unresolved.iter().map(output::unresolved).collect();
    // No mesh corrects a law outside its range.
    let help = match unresolved.iter().all(|u| u.why == Why::BeyondPhysics) {
        true => POSSIBLE,
        false => RESOLVE,
    };
    Failure::Unresolved(format!(
        "not resolved: {}; the results are in {}, where result.json says \"unresolved\"\n  = help: {help}",
        figures.join("; "),
        folder.display()
    ))
}

/// The same for points; their table lists them.
pub fn points_not_resolved(n: usize, all: usize, table: &Path) -> Failure {
    Failure::Unresolved(format!(
        "{n} of {all} points are not resolved: the error bar of a figure exceeds half its value, or is missing; see the column \
         `unresolved` of {}\n  = help: {RESOLVE}",
        table.display()
    ))
}

/// Help for figures that are not resolved.
pub const RESOLVE: &str = "the warnings give the reason: raise [mesh] max_unknowns if the mesh is too coarse; give the lubricant shear \
    thinning, `[thermal]` or a limiting shear stress if the friction is too large; --accept-unresolved accepts such figures";

/// Help for figures beyond physical limits.
const POSSIBLE: &str = "look at the constants of the laws, and add what the case neglects (see the warnings): [lubricant] shear_thinning \
    with its `limit`, or [thermal]; --accept-unresolved accepts the other figures";
