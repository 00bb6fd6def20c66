//! Folders of results, as `ertel.read` of the Python package opens them: its case, its fields on a grid, the table of a study.

use std::path::Path;

use ertel::case::Case;
use ertel::study::StudyEcho;
use ertel::study::journal::Entries;
use serde_json::Value;

use super::grid::{fields, on_grid};
use super::{Verdict, check_place, journal};
use crate::finding::Defect;
use crate::input::{Input, Target};

/// The folder of a study; those of contacts are in the corpus.
pub fn seed(journal: &Input) -> Input {
    Input {
        target: Target::Read,
        ..journal.clone()
    }
}

/// Opens the folder; nothing in it changes.
pub fn run(input: &Input, folder: &Path) -> Result<Verdict, Defect> {
    let text = |name: &str| std::str::from_utf8(input.file(name)).ok();
    let mut verdict = Verdict::Refused;
    if let Some(text) = text("case.toml").filter(|text| !text.is_empty()) {
        let name = folder.join("case.toml").display().to_string();
        match Case::from_text(&name, text, folder) {
            Ok(case) => drop(case.echo()),
            Err(error) => drop(check_place(&error, folder)?),
        }
    }
    let about = serde_json::from_slice::<Value>(input.file("result.json"));
    if let (Ok(about), Some(points), Some(cells)) = (about, text("surface.csv"), text("cells.csv"))
        && let Some(fields) = fields(about["kind"] == "line", points, cells)
    {
        on_grid(&about, &fields)?;
        verdict = Verdict::Taken;
    }
    match StudyEcho::read(folder).and_then(|echo| Ok((echo, Entries::read(folder)?))) {
        Ok((Some(echo), entries)) if !entries.is_foreign() => {
            if !echo.table(&entries.records).starts_with("point") {
                return Err(Defect::wrong("a table without its columns", ""));
            }
            verdict = Verdict::Taken;
        }
        Ok(_) => {}
        Err(error) => drop(journal::check_sweep(&error.to_string(), folder)?),
    }
    let is_same = |(name, content): &(String, Vec<u8>)| {
        std::fs::read(folder.join(name)).is_ok_and(|now| now == *content)
    };
    let n_files = std::fs::read_dir(folder).map_or(0, Iterator::count);
    match n_files == input.files.len() && input.files.iter().all(is_same) {
        true => Ok(verdict),
        false => Err(Defect::wrong("looking at a folder changes it", "")),
    }
}
