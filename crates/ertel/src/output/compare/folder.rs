//! The folder of a comparison: whether it may be used, and the files written there.

use std::fs;
use std::io;
use std::path::Path;

use super::{
    COMPARISON_FORMAT, comparison_json, comparison_picture, comparison_report, comparison_table,
};
use crate::compare::Comparison;
use crate::files::{TEMPORARY, write_whole};
use crate::output::html::comparison_page;
use crate::output::target::{REPORT_PAGE, has_format};
use crate::output::{OutputError, picture_files, put_picture};
use crate::params::PictureFormats;
use crate::study::journal::LOCK;
use crate::study::{POINTS, STUDY_FORMAT};

/// Subfolder with the study of the points.
pub const COMPARISON_STUDY: &str = "study";

/// Every file that a comparison writes into its folder.
pub const COMPARISON_FILES: [&str; 8] = [
    TABLE,
    JSON,
    "comparison.svg",
    "comparison.pdf",
    "comparison.png",
    REPORT,
    REPORT_PAGE,
    CASE,
];

const TABLE: &str = "comparison.csv";
const JSON: &str = "comparison.json";
const PICTURE: &str = "comparison";
const ALL_FORMATS: PictureFormats = PictureFormats {
    svg: true,
    pdf: true,
    png: true,
};
const REPORT: &str = "report.txt";
const CASE: &str = "case.toml";

/// Whether a comparison may be written here: the path does not exist, is an empty folder, or holds a former comparison, finished or not.
///
/// # Errors
/// [`OutputError::NotAFolder`] and [`OutputError::ForeignFolder`] for other contents; [`OutputError::Io`].
pub fn check_comparison_folder(target: &Path) -> Result<(), OutputError> {
    let failed = |e| OutputError::io(target, e);
    let foreign = |reason: String| OutputError::ForeignFolder {
        path: target.to_owned(),
        reason,
    };
    match fs::symlink_metadata(target) {
        Err(e) if e.kind() == io::ErrorKind::NotFound && !target.as_os_str().is_empty() => {
            return Ok(());
        }
        Err(e) => return Err(failed(e)),
        Ok(_) if !target.is_dir() => {
            return Err(OutputError::NotAFolder {
                path: target.to_owned(),
            });
        }
        Ok(_) => {}
    }
    let mut has_files = false;
    let mut has_study = false;
    for entry in fs::read_dir(target).map_err(failed)? {
        let entry = entry.map_err(failed)?;
        let (name, kind) = (entry.file_name(), entry.file_type().map_err(failed)?);
        let name = name.to_string_lossy().into_owned();
        if name == COMPARISON_STUDY && kind.is_dir() {
            has_study = true;
        } else if kind.is_file() && COMPARISON_FILES.contains(&name.as_str()) {
            has_files = true;
        } else if !(kind.is_file() && name.starts_with(TEMPORARY)) {
            return Err(foreign(format!(
                "it holds {name}, which is not a comparison file"
            )));
        }
    }
    // The study is written first and the JSON file before all others: an unfinished comparison has only a study.
    if has_files && !has_format(&target.join(JSON), COMPARISON_FORMAT) {
        return Err(foreign(
            "it holds files, but no comparison of ertel".to_owned(),
        ));
    }
    let study = target.join(COMPARISON_STUDY);
    let is_study = || has_format(&study.join(POINTS), STUDY_FORMAT);
    if has_study && !has_files && !is_study() && !is_begun(&study) {
        return Err(foreign(format!(
            "its folder {COMPARISON_STUDY} is not a study of ertel"
        )));
    }
    Ok(())
}

/// Whether a study folder holds only the traces of a run that stopped, or met a full disk, before it wrote its list of
/// points: its lock and temporary files, all still empty.
fn is_begun(study: &Path) -> bool {
    let is_of_the_beginning = |entry: io::Result<fs::DirEntry>| {
        let entry = entry?;
        let (name, kind) = (entry.file_name(), entry.file_type()?);
        let is_ours = match name == LOCK {
            true => entry.metadata()?.len() == 0,
            false => name.to_string_lossy().starts_with(TEMPORARY),
        };
        io::Result::Ok(is_ours && kind.is_file())
    };
    fs::read_dir(study)
        .is_ok_and(|mut entries| entries.all(|e| is_of_the_beginning(e).unwrap_or(false)))
}

/// Writes the files of a comparison into its folder, each atomically; `case` is the text of the base case.
///
/// # Errors
/// [`OutputError`].
pub fn write_comparison(
    comparison: &Comparison,
    case: &str,
    target: &Path,
    formats: PictureFormats,
) -> Result<(), OutputError> {
    check_comparison_folder(target)?;
    fs::create_dir_all(target).map_err(|e| OutputError::io(target, e))?;
    let write = |name: &str, content: &[u8]| {
        let path = target.join(name);
        write_whole(&path, content).map_err(|e| OutputError::io(&path, e))
    };
    let json = serde_json::to_string_pretty(&comparison_json(comparison))
        .map_err(|e| OutputError::io(&target.join(JSON), e.into()))?;
    // Steps that may fail for a reason other than the disk come first.
    let picture = picture_files(comparison_picture(comparison).as_ref(), formats)?;
    // Written first: a folder with other comparison files but without this one is treated as foreign.
    write(JSON, format!("{json}\n").as_bytes())?;
    put_picture(target, PICTURE, &picture, ALL_FORMATS)?;
    write(TABLE, comparison_table(comparison).as_bytes())?;
    write(REPORT, comparison_report(comparison, None).as_bytes())?;
    let page = comparison_page(comparison, case);
    write(REPORT_PAGE, page.as_bytes())?;
    write(CASE, case.as_bytes())?;
    Ok(())
}
