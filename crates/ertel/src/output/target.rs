//! Which folders a result may replace: those that contain only a former result.

use std::ffi::OsStr;
use std::fs;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use ertel_input::file::{LARGEST_OWN, open};

use super::OutputError;
use super::curve::CURVE_FORMAT;
use super::drawn::DRAWN;
use super::machine::MACHINE_FORMAT;
use super::result_json::FORMAT;
use super::transient::TRANSIENT_FORMAT;
use crate::params::PictureFormats;

/// Name of the page in a result folder.
pub const REPORT_PAGE: &str = "report.html";

/// Prefix and suffix of the fields at an output time; its number, from 1, is between them.
pub(super) const FIELDS: [&str; 2] = ["fields-", ".vtu"];

/// Files of a result that are no pictures; a folder with any other file is not replaced.
const FILES: [&str; 25] = [
    "result.json",
    REPORT_PAGE,
    "curve.json",
    "curve.csv",
    "machine.json",
    "machine.csv",
    "report.txt",
    "case.toml",
    "centreline.csv",
    "surface.vtu",
    "body.vtu",
    "result.nc",
    "cross-film.csv",
    "stress.csv",
    "stress.vtu",
    "wear.csv",
    "wear-depth.csv",
    "temperature.vtu",
    "cross-check.csv",
    "shaft.csv",
    "transient.json",
    "transient.csv",
    "profiles.csv",
    "fields.pvd",
    "animation.png",
];

/// Pictures of a result without suffix, in addition to those of [`DRAWN`].
const PICTURES: [&str; 18] = [
    "stribeck",
    "stress",
    "wear",
    "centreline",
    "pressure",
    "film",
    "convergence",
    "temperature",
    "temperature-mid",
    "temperature-body-1",
    "temperature-body-2",
    "interferogram",
    "cross-film",
    "film-time",
    "film-map",
    "around",
    "path",
    "flanks",
];
/// Subfolder with the point folders of a curve.
pub(super) const POINTS: &str = "points";

/// Whether a result may be written here: the path does not exist, is an empty folder, or holds a former result.
///
/// # Errors
/// [`OutputError::NotAFolder`] and [`OutputError::ForeignFolder`] for other contents;
/// [`OutputError::Io`] if it cannot be read.
pub fn check_target(target: &Path) -> Result<(), OutputError> {
    let failed = |e| OutputError::io(target, e);
    if target.as_os_str().is_empty() {
        let error = io::Error::new(io::ErrorKind::InvalidInput, "the name is empty");
        return Err(OutputError::io(Path::new("the result folder"), error));
    }
    match fs::symlink_metadata(target) {
        Err(e) if e.kind() == io::ErrorKind::NotFound => return Ok(()),
        Err(e) => return Err(failed(e)),
        Ok(_) if !target.is_dir() => {
            return Err(OutputError::NotAFolder {
                path: target.to_owned(),
            });
        }
        Ok(_) => {}
    }
    match foreign(target).map_err(failed)? {
        Some(reason) => Err(OutputError::ForeignFolder {
            path: target.to_owned(),
            reason,
        }),
        None => Ok(()),
    }
}

/// Suffix of a folder with a partial result next to a complete one.
const PARTIAL: &str = "-partial";

/// The folder for the result of an interrupted run: the target, or a folder next to it if the target holds a complete result.
pub fn place_of_partial(target: &Path) -> PathBuf {
    if !is_complete(target) {
        return target.to_owned();
    }
    let place = crate::files::place(target).unwrap_or_else(|_| target.to_owned());
    let mut name = place.file_name().unwrap_or_default().to_owned();
    name.push(PARTIAL);
    place.with_file_name(name)
}

/// Whether a folder holds the result of a completed run.
fn is_complete(folder: &Path) -> bool {
    #[derive(serde::Deserialize)]
    struct Ending {
        format: String,
        complete: Option<bool>,
    }
    let all = [
        ("curve.json", CURVE_FORMAT),
        ("machine.json", MACHINE_FORMAT),
        ("transient.json", TRANSIENT_FORMAT),
    ];
    let has_ended = |(name, format): (&str, &str)| {
        let ending: Option<Ending> = read_json(&folder.join(name));
        ending.is_some_and(|ending| ending.format == format && ending.complete != Some(false))
    };
    // Results of one contact are complete or absent.
    has_format(&folder.join("result.json"), FORMAT) || all.into_iter().any(has_ended)
}

/// Why ertel may not replace a folder; `None` for an empty one and for a former result.
pub(super) fn foreign(folder: &Path) -> io::Result<Option<String>> {
    if fs::read_dir(folder)?.next().is_none() {
        return Ok(None);
    }
    let has_points = has_format(&folder.join("curve.json"), CURVE_FORMAT)
        || has_format(&folder.join("machine.json"), MACHINE_FORMAT);
    let is_single = has_format(&folder.join("result.json"), FORMAT)
        || has_format(&folder.join("transient.json"), TRANSIENT_FORMAT);
    if !has_points && !is_single {
        return Ok(Some("it holds files, but no result of ertel".into()));
    }
    let stray = match stray(folder)? {
        // A result of one contact has no points, and each point has its result.
        None if folder.join(POINTS).is_dir() => match has_points {
            true => point_without_result(folder)?,
            false => Some(POINTS.into()),
        },
        found => found,
    };
    Ok(stray.map(|name| format!("it holds a former result, but also {}", name.display())))
}

/// The first entry of a result folder or its point folders that does not belong to a result: a file with another name, or a
/// folder or link with the name of a file.
pub(super) fn stray(folder: &Path) -> io::Result<Option<PathBuf>> {
    let mut has_points = false;
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let (name, kind) = (entry.file_name(), entry.file_type()?);
        if name == POINTS && kind.is_dir() {
            has_points = true;
        } else if !is_own_file(&name, kind) {
            return Ok(Some(name.into()));
        }
    }
    if !has_points {
        return Ok(None);
    }
    for point in fs::read_dir(folder.join(POINTS))? {
        let point = point?;
        let path = Path::new(POINTS).join(point.file_name());
        if !point.file_type()?.is_dir() || !is_number(&point.file_name()) {
            return Ok(Some(path));
        }
        for entry in fs::read_dir(point.path())? {
            let entry = entry?;
            if !is_own_file(&entry.file_name(), entry.file_type()?) {
                return Ok(Some(path.join(entry.file_name())));
            }
        }
    }
    Ok(None)
}

fn is_own_file(name: &OsStr, kind: fs::FileType) -> bool {
    kind.is_file() && name.to_str().is_some_and(is_own_name)
}

/// Whether a result may have a file of this name.
pub(super) fn is_own_name(name: &str) -> bool {
    FILES.contains(&name) || is_picture(name) || is_file_of_instant(name)
}

fn is_picture(name: &str) -> bool {
    let is_own = |(stem, suffix): (&str, &str)| {
        let is_known = PICTURES.contains(&stem) || DRAWN.iter().any(|drawn| drawn.curve == stem);
        is_known && PictureFormats::NAMES.contains(&suffix)
    };
    name.rsplit_once('.').is_some_and(is_own)
}

/// Whether a file has the name of an instant's fields: `fields-001.vtu`.
fn is_file_of_instant(name: &str) -> bool {
    name.strip_prefix(FIELDS[0])
        .and_then(|rest| rest.strip_suffix(FIELDS[1]))
        .is_some_and(|number| !number.is_empty() && number.bytes().all(|b| b.is_ascii_digit()))
}

/// `007`
fn is_number(name: &OsStr) -> bool {
    let name = name.to_string_lossy();
    name.bytes().all(|b| b.is_ascii_digit())
}

/// The first point folder that holds files but no result.
fn point_without_result(folder: &Path) -> io::Result<Option<PathBuf>> {
    for point in fs::read_dir(folder.join(POINTS))? {
        let point = point?;
        let is_empty = fs::read_dir(point.path())?.next().is_none();
        if !is_empty && !has_format(&point.path().join("result.json"), FORMAT) {
            return Ok(Some(Path::new(POINTS).join(point.file_name())));
        }
    }
    Ok(None)
}

/// Whether a JSON file has this value of `format`.
pub(super) fn has_format(path: &Path, format: &str) -> bool {
    #[derive(serde::Deserialize)]
    struct Head {
        format: String,
    }
    read_json(path).is_some_and(|head: Head| head.format == format)
}

/// Keys of a JSON file. Special and large files neither block nor fill the memory.
fn read_json<T: serde::de::DeserializeOwned>(path: &Path) -> Option<T> {
    let (file, metadata) = open(path, LARGEST_OWN).ok()?;
    let text = io::BufReader::new(file.take(metadata.len()));
    serde_json::from_reader(text).ok()
}
