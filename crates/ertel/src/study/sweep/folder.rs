//! The folder of a study: what makes it one, and what is written there.

use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};

use super::SweepError;
use crate::case::Study;
use crate::output;
use crate::study::journal::{Entries, JOURNAL, Journal, LOCK, PointKey, Record};
use crate::study::table::{POINTS, StudyEcho, TABLE};

/// Every file that a study writes into its folder.
pub const FILES: [&str; 6] = [LOCK, JOURNAL, POINTS, TABLE, FILMS, TRACTIONS];
/// Folder within that of a study, with the results of its points where these are asked for.
pub const FOLDERS: &str = "points";
/// Name of the picture of its films, and of that of its tractions.
const FILMS: &str = "film.svg";
const TRACTIONS: &str = "traction.svg";

/// Makes the folder of a study, or opens a former one.
pub(super) fn open(folder: &Path) -> Result<(Journal, Entries), SweepError> {
    fs::create_dir_all(folder).map_err(|e| SweepError::io(folder, e))?;
    let names = fs::read_dir(folder).map_err(|e| SweepError::io(folder, e))?;
    let mut names = names.filter_map(|e| Some(e.ok()?.file_name()));
    let known = StudyEcho::read(folder)?.is_some() || folder.join(JOURNAL).exists();
    if !known && names.any(|name| !name.to_string_lossy().starts_with('.') && name != "shards") {
        return Err(SweepError::Foreign {
            folder: folder.to_owned(),
        });
    }
    Journal::open(folder)
}

/// The table and the pictures that it makes.
pub(super) fn write_results(
    folder: &Path,
    echo: &StudyEcho,
    records: &HashMap<PointKey, Record>,
) -> Result<(), SweepError> {
    let write = |name: &str, text: String| {
        let path = folder.join(name);
        output::write_whole(&path, text.as_bytes()).map_err(|e| SweepError::io(&path, e))
    };
    write(TABLE, echo.table(records))?;
    for (name, chart) in [
        (FILMS, output::study_films(echo, records)),
        (TRACTIONS, output::study_tractions(echo, records)),
    ] {
        if let Some(chart) = chart {
            write(name, chart.svg())?;
        }
    }
    Ok(())
}

/// Folder of a point's results: its number with as many digits as the last one has.
pub(super) fn point_folder(folder: &Path, index: usize, n_points: usize) -> PathBuf {
    let width = n_points.to_string().len();
    folder.join(FOLDERS).join(format!("{:0width$}", index + 1))
}

pub(super) fn has_folder(
    folder: &Path,
    index: usize,
    study: &Study,
    record: Option<&Record>,
) -> bool {
    record.is_some_and(|r| !r.converged)
        || point_folder(folder, index, study.points.len())
            .join("result.json")
            .exists()
}
