//! Solves a case and describes its results by the files that the program writes.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use ertel::case::Case;
use ertel::output::{self, OutputFile};
use ertel::params::SensitivityDemand;
use ertel::study::solve_curve;
use serde_json::{Value, json};

use crate::check::checked;
use crate::failure::{Failure, answer};
use crate::progress::Progress;

/// Solves the case of a text. `progress` gets objects whose `event` is `stage`, `iteration`, `heat` or `point`.
///
/// `{"ok": true, "files": [...], "unresolved": [...], "failed_points": n}`: the files of the result folder of `ertel solve` with `name` and
/// `text`, or `base64` of a picture that is no text; figures whose error bar is wider than half of them; points of a curve that failed.
pub fn solve(text: &str, progress: impl FnMut(Value) + Send + Sync) -> Value {
    answer(solved(text, progress))
}

fn solved(text: &str, progress: impl FnMut(Value) + Send + Sync) -> Result<Value, Failure> {
    let mut case = checked(text)?;
    let mut progress = Progress::new(progress);
    if case.curve.is_some() {
        return solved_curve(&case, &mut progress);
    }
    if case.transient.is_some() {
        let found = ertel::run::transient::solve(&case, &mut progress);
        if let (Some(failure), true) = (&found.failure, found.instants.is_empty()) {
            return Err(Failure::NotConverged(failure.to_string()));
        }
        let files = output::transient_files(&case.echo(), &found, &case.output)?;
        return Ok(json!({
            "files": json_of(files),
            "unresolved": [],
            "failed_points": usize::from(found.failure.is_some()),
        }));
    }
    // As the program does for a single case.
    if case.output.sensitivities == SensitivityDemand::WhereUncertain {
        case.output.sensitivities = SensitivityDemand::WhereCheap;
    }
    let solution = ertel::run::solve(&case, &mut progress)?;
    let unresolved: Vec<String> = solution.unresolved.iter().map(output::unresolved).collect();
    let files = output::files(&case.echo(), &solution, &case.output)?;
    Ok(json!({ "files": json_of(files), "unresolved": unresolved, "failed_points": 0 }))
}

fn solved_curve(
    case: &Case,
    progress: &mut Progress<impl FnMut(Value) + Send + Sync>,
) -> Result<Value, Failure> {
    let curve = case.curve.as_ref().expect("the caller looked");
    let solution = solve_curve(curve, progress);
    let files = output::curve_files(&case.echo(), &solution, &case.output)?;
    Ok(json!({
        "files": json_of(files),
        "unresolved": [],
        "failed_points": solution.n_failed(),
    }))
}

fn json_of(files: Vec<OutputFile>) -> Vec<Value> {
    let files = files
        .into_iter()
        .map(|file| match String::from_utf8(file.bytes) {
            Ok(text) => json!({ "name": file.name, "text": text }),
            Err(error) => json!({ "name": file.name, "base64": STANDARD.encode(error.as_bytes()) }),
        });
    files.collect()
}
