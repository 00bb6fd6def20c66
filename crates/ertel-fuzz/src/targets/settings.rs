//! Values that replace those of a case, one `key=value` on a line, as `--set` gives them.

use std::path::Path;

use ertel::case::Case;

use super::case::set_up;
use super::{Verdict, check_text};
use crate::finding::Defect;
use crate::input::Input;

/// Reads `case.toml` with the values of `settings.txt`.
pub fn run(input: &Input, folder: &Path) -> Result<Verdict, Defect> {
    // Arguments of a command line that are no text are refused before they come here.
    let texts = ["case.toml", "settings.txt"].map(|name| std::str::from_utf8(input.file(name)));
    let [Ok(case), Ok(settings)] = texts else {
        return Ok(Verdict::Refused);
    };
    let settings: Vec<String> = settings.lines().map(str::to_owned).collect();
    match Case::from_text_with("case.toml", case, folder, &settings) {
        Ok(case) => {
            set_up(&case)?;
            Ok(Verdict::Taken)
        }
        Err(error) => check_text(&error.to_string()),
    }
}
