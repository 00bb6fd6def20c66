//! The folder of a study: how it is recognised, and the files written there.

use std::collections::HashMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::SweepError;
use crate::case::Study;
use crate::output;
use crate::output::REPORT_PAGE;
use crate::output::html::study_page;
use crate::params::PictureFormats;
use crate::study::StudyError;
use crate::study::journal::{Entries, JOURNAL, Journal, LOCK, Lock, PointKey, Record};
use crate::study::table::{POINTS, StudyEcho, TABLE};
use crate::warning::by_kind;

/// Every file that a study writes into its folder.
pub fn files() -> impl Iterator<Item = String> {
    let pictures = output::study_picture_names()
        .flat_map(|name| PictureFormats::NAMES.map(|suffix| format!("{name}.{suffix}")));
    let others = [LOCK, JOURNAL, POINTS, TABLE, REPORT_PAGE].map(str::to_owned);
    others.into_iter().chain(pictures)
}

/// Folder within that of a study, with the results of its points where these are asked for.
pub const FOLDERS: &str = "points";

/// Folder within that of a study, with its parts.
pub const SHARDS: &str = "shards";

/// Makes the folder of a study, or opens a former one, and writes the list of points there.
pub(super) fn open(folder: &Path, echo: &StudyEcho) -> Result<(Journal, Entries), SweepError> {
    // Not even a lock is written into a foreign folder.
    look(folder)?;
    fs::create_dir_all(folder).map_err(|e| StudyError::io(folder, e))?;
    let lock = Lock::new(folder)?;
    let entries = look(folder)?;
    clear_leftovers(folder);
    // Before the journal: a folder without a list of points is no study.
    echo.write(folder)?;
    let journal = Journal::open(folder, lock, &entries)?;
    Ok((journal, entries))
}

/// Reads the journal of a study, of which there may be none yet; touches nothing.
///
/// # Errors
/// [`SweepError::Foreign`] for a folder that is not ertel's, and for links and folders under the names of its files;
/// [`SweepError::Study`].
pub(super) fn look(folder: &Path) -> Result<Entries, SweepError> {
    let foreign = |reason: String| SweepError::Foreign {
        folder: folder.to_owned(),
        reason,
    };
    for name in files().chain([FOLDERS.to_owned()]) {
        let path = folder.join(&name);
        let (is_own, what) = match fs::symlink_metadata(&path) {
            Err(e) if e.kind() == io::ErrorKind::NotFound => continue,
            Err(e) => return Err(StudyError::io(&path, e).into()),
            Ok(meta) if name == FOLDERS => (meta.is_dir(), "a folder"),
            // Nothing is ever written into it.
            Ok(meta) if name == LOCK => (meta.is_file() && meta.len() == 0, "an empty file"),
            Ok(meta) => (meta.is_file(), "a file"),
        };
        if !is_own {
            return Err(foreign(format!(
                "{} is not {what} of ertel",
                path.display()
            )));
        }
    }
    if StudyEcho::read(folder)?.is_none() {
        // The list of points is the first file of a study: any other file is foreign.
        let names = match fs::read_dir(folder) {
            Err(e) if e.kind() == io::ErrorKind::NotFound => return Ok(Entries::default()),
            names => names.map_err(|e| StudyError::io(folder, e))?,
        };
        let mut names = names.filter_map(|e| Some(e.ok()?.file_name()));
        return match names.find(|name| !name.to_string_lossy().starts_with('.') && *name != *SHARDS)
        {
            None => Ok(Entries::default()),
            Some(name) => Err(foreign(format!(
                "it contains {}, but no {POINTS} of ertel",
                name.display()
            ))),
        };
    }
    let entries = Entries::read(folder)?;
    if entries.is_foreign() {
        let path = folder.join(JOURNAL);
        return Err(foreign(format!(
            "{} is no journal of a study",
            path.display()
        )));
    }
    Ok(entries)
}

/// Removes the files that a killed run had not finished; the folder is locked. One that cannot be removed does no harm.
fn clear_leftovers(folder: &Path) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let is_ours = entry
            .file_name()
            .to_string_lossy()
            .starts_with(crate::files::TEMPORARY);
        if is_ours && entry.file_type().is_ok_and(|kind| kind.is_file()) {
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// The table and the pictures that it makes.
pub(super) fn write_results(
    folder: &Path,
    echo: &StudyEcho,
    records: &HashMap<PointKey, Record>,
) -> Result<(), SweepError> {
    let write = |name: &str, text: String| {
        let path = folder.join(name);
        crate::files::write_whole(&path, text.as_bytes()).map_err(|e| StudyError::io(&path, e))
    };
    let table = echo.table(records);
    let finished =
        (echo.points.iter().enumerate()).filter_map(|(i, (key, _))| Some((i, records.get(key)?)));
    let warnings = by_kind(finished.flat_map(|(i, r)| {
        r.warnings
            .iter()
            .filter(|w| w.is_shown_with(&echo.silence))
            .map(move |w| (i, w))
    }));
    let warnings = (warnings.iter())
        .map(|merged| merged.with_text(merged.line(echo.points.len())).coded())
        .collect();
    let page = study_page(&echo.title, &table, echo.columns.len(), warnings);
    write(TABLE, table)?;
    write(REPORT_PAGE, page)?;
    for picture in output::study_pictures(echo, records) {
        output::replace_picture(
            folder,
            picture.name,
            picture.drawing.as_ref(),
            echo.pictures,
            PictureFormats::default(),
        )?;
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
    let case = &study.points[index].case;
    let results = match (&case.whole, &case.transient) {
        (_, Some(_)) => "transient.json",
        (Some(_), None) => "machine.json",
        (None, None) => "result.json",
    };
    let point = point_folder(folder, index, study.points.len());
    record.is_some_and(|r| !r.converged) || point.join(results).exists()
}
