//! Reads a case and reports its errors.

use std::path::Path;

use ertel::case::Case;
use ertel::run;
use ertel::words::digits;
use ertel_input::file::{FileError, LARGEST_DOCUMENT};
use serde_json::{Value, json};

use crate::CASE;
use crate::failure::{Failure, answer};

/// Whether a solve of the case would begin: `{"ok": true, "warnings": [...], "points": n}` with the points of a curve, or null, or the
/// error. Takes milliseconds.
pub fn check(text: &str) -> Value {
    answer(checked(text).map(|case| {
        let warnings: Vec<String> = (case.warnings.iter())
            .filter(|w| !w.is_silenced)
            .map(ToString::to_string)
            .collect();
        let points = case.curve.as_ref().map(|curve| curve.points.len());
        json!({ "warnings": warnings, "points": points })
    }))
}

/// The case, if a solve of it may begin.
pub(crate) fn checked(text: &str) -> Result<Case, Failure> {
    let case = read(text)?;
    let Some(curve) = &case.curve else {
        run::check(&case)?;
        return Ok(case);
    };
    for (i, point) in curve.points.iter().enumerate() {
        run::check(&point.case).map_err(|error| match Failure::from(error) {
            Failure::Refused(reason) => {
                let value = format!("{} {}", digits(point.value(), 6), curve.quantity.unit());
                let value = value.trim_end();
                Failure::Refused(format!("point {} of the curve ({value}): {reason}", i + 1))
            }
            other => other,
        })?;
    }
    Ok(case)
}

/// The case as its file has it. There are no other files: those it names are refused.
fn read(text: &str) -> Result<Case, Failure> {
    let size = text.len() as u64;
    if size > LARGEST_DOCUMENT {
        let limit = LARGEST_DOCUMENT;
        return Err(FileError::TooLarge { size, limit }.into());
    }
    Ok(Case::from_text(CASE, text, Path::new(""))?)
}
