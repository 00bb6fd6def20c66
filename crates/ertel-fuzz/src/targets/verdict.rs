//! Whether a reader took an input, and whether its errors are as errors should be.

use std::path::Path;

use ertel_input::{InputError, escaped};

use crate::finding::Defect;

/// Whether a reader took an input or refused it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Taken.
    Taken,
    /// Refused, with an error as errors should be.
    Refused,
}

/// Longest error, bytes.
const LONGEST_ERROR: usize = 20_000;

/// Whether an error says where: a file of the folder, and in it a line, unless it is about the file as a whole.
pub(super) fn check_place(error: &InputError, folder: &Path) -> Result<Verdict, Defect> {
    let text = error.to_string();
    let whole = ["cannot be read", "is too large", "is not UTF-8"];
    let is_whole = whole.iter().any(|words| error.message().contains(words));
    if error.line().is_none() && !is_whole {
        return Err(Defect::wrong("an error without line", text));
    }
    let file = Path::new(error.file());
    let name = file.file_name().unwrap_or_default();
    if let Some(line) = error.line()
        && let Ok(content) = std::fs::read(folder.join(name))
        && line > n_lines(&content)
    {
        return Err(Defect::wrong("an error behind the end of its file", text));
    }
    if name.is_empty() {
        return Err(Defect::wrong("an error without file", text));
    }
    check_text(&text)
}

/// Lines of a file, ended by a line feed, a carriage return or both.
pub(super) fn n_lines(content: &[u8]) -> usize {
    let feeds = content.iter().filter(|b| **b == b'\n').count();
    let returns = content.iter().filter(|b| **b == b'\r').count();
    let both = content.windows(2).filter(|two| two == b"\r\n").count();
    1 + feeds + returns - both
}

/// Whether the text of an error can be shown: it says something, not too much, and no terminal obeys it.
pub(super) fn check_text(text: &str) -> Result<Verdict, Defect> {
    if text.trim().is_empty() {
        return Err(Defect::wrong("an error without words", ""));
    }
    if text.len() > LONGEST_ERROR {
        let start: String = text.chars().take(300).collect();
        return Err(Defect::wrong("an error too long to read", start));
    }
    if escaped(text) != text {
        return Err(Defect::wrong(
            "control characters in an error",
            escaped(text),
        ));
    }
    Ok(Verdict::Refused)
}
