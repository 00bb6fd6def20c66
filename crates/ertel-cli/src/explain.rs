//! `ertel explain`.

use ertel::warning::{Severity, WarningKind};

use crate::args::ExplainArgs;
use crate::failure::Failure;
use crate::print;
use crate::table::paragraph;

/// Runs the command.
///
/// # Errors
///
/// An unknown code, or stdout that cannot be written.
pub fn run(arguments: &ExplainArgs) -> Result<(), Failure> {
    let text = match &arguments.code {
        None => list(),
        Some(code) => explained(known(code)?),
    };
    print::report(&text)
}

/// All codes with their meaning.
fn list() -> String {
    let text =
        "Codes of warnings and notes (`ertel explain CODE` for meaning, limit and remedy):\n\n";
    WarningKind::ALL.iter().fold(text.to_owned(), |text, kind| {
        text + &paragraph(
            &format!("  {:<22}", kind.code()),
            kind.explanation().meaning,
        )
    })
}

fn known(code: &str) -> Result<WarningKind, Failure> {
    // As messages show it.
    let bare = code.trim_matches(|c| c == '[' || c == ']');
    WarningKind::with_code(bare).ok_or_else(|| {
        let all: Vec<&str> = WarningKind::ALL.iter().map(|kind| kind.code()).collect();
        Failure::Argument(format!(
            "`{code}` is not a code of warnings\n  = help: the codes are {}",
            all.join(", ")
        ))
    })
}

fn explained(kind: WarningKind) -> String {
    let what = match kind.severity() {
        Severity::Note => "a note",
        Severity::Caution => "a warning",
        Severity::Unusable => "a warning of figures that are not to be used",
    };
    let silence = match kind.may_be_silenced() {
        true => format!("`silence = [\"{kind}\"]` in [output]"),
        false => "not possible".to_owned(),
    };
    let e = kind.explanation();
    let row = |name: &str, text: &str| paragraph(&format!("  {name:<12}"), text);
    format!(
        "{kind}: {what}\n\n{}{}{}{}",
        row("meaning", e.meaning),
        row("limit", e.limit),
        row("what to do", e.remedy),
        row("silence", &silence)
    )
}
