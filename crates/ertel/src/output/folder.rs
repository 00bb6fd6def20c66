//! Result folders that appear as a whole or not at all.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use tempfile::TempDir;

use super::OutputError;
use super::curve::CURVE_FORMAT;
use super::file::sync_folder;
use super::result_json::FORMAT;

/// Files that a result may hold; with any other file in it, a folder is not replaced.
const OWN_FILES: [&str; 32] = [
    "result.json",
    "curve.json",
    "curve.csv",
    "film-curve.svg",
    "film-curve.png",
    "traction-curve.svg",
    "traction-curve.png",
    "report.txt",
    "case.toml",
    "centreline.csv",
    "surface.vtu",
    "body.vtu",
    "centreline.svg",
    "pressure.svg",
    "film.svg",
    "convergence.svg",
    "centreline.png",
    "pressure.png",
    "film.png",
    "convergence.png",
    "cross-film.csv",
    "temperature.vtu",
    "temperature.svg",
    "temperature.png",
    "temperature-mid.svg",
    "temperature-mid.png",
    "temperature-plane.svg",
    "temperature-plane.png",
    "temperature-ball.svg",
    "temperature-ball.png",
    "cross-film.svg",
    "cross-film.png",
];

/// Folder within the results of a curve, with a folder for each of its points.
pub(super) const POINTS: &str = "points";

/// A folder in the making beside its target; dropped unfinished, it vanishes.
pub(super) struct NewFolder {
    target: PathBuf,
    parent: PathBuf,
    temporary: TempDir,
    root: Part,
}

/// The folder in the making or a folder within.
pub(super) struct Part {
    /// Where it is while in the making.
    path: PathBuf,
    /// Where it will be.
    target: PathBuf,
}

impl NewFolder {
    /// Checks that the target may be written and makes the temporary folder beside it.
    pub fn beside(target: &Path) -> Result<NewFolder, OutputError> {
        check_target(target)?;
        // A link to a former result stays; what it points to is replaced
        let target = if target.exists() {
            fs::canonicalize(target).map_err(|e| OutputError::io(target, e))?
        } else {
            target.to_owned()
        };
        let parent = match target.parent() {
            Some(parent) if !parent.as_os_str().is_empty() => parent.to_owned(),
            _ => PathBuf::from("."),
        };
        fs::create_dir_all(&parent).map_err(|e| OutputError::io(&parent, e))?;
        let temporary = tempfile::Builder::new()
            .prefix(".ertel-")
            .tempdir_in(&parent)
            .map_err(|e| OutputError::io(&parent, e))?;
        let root = Part {
            path: temporary.path().to_owned(),
            target: target.clone(),
        };
        Ok(NewFolder {
            target,
            parent,
            temporary,
            root,
        })
    }

    /// The folder itself.
    pub fn root(&self) -> &Part {
        &self.root
    }

    /// Makes the folder of one point within.
    pub fn point(&self, name: &str) -> Result<Part, OutputError> {
        let part = Part {
            path: self.root.path.join(POINTS).join(name),
            target: self.target.join(POINTS).join(name),
        };
        fs::create_dir_all(&part.path).map_err(|e| OutputError::io(&part.target, e))?;
        Ok(part)
    }

    /// Puts the folder in its place, instead of a former result.
    pub fn finish(self) -> Result<(), OutputError> {
        let NewFolder {
            target,
            parent,
            temporary,
            ..
        } = self;
        let failed = |e| OutputError::io(&target, e);
        share(temporary.path()).map_err(failed)?;
        sync_folder(temporary.path()).map_err(failed)?;
        // Somebody may have put something there meanwhile
        check_target(&target)?;
        let former = if target.exists() {
            let aside = tempfile::Builder::new()
                .prefix(".ertel-old-")
                .tempdir_in(&parent)
                .map_err(failed)?;
            fs::rename(&target, aside.path().join("result")).map_err(failed)?;
            Some(aside)
        } else {
            None
        };
        if let Err(error) = fs::rename(temporary.path(), &target) {
            if let Some(aside) = &former {
                // The first failure is the one to tell
                let _ = fs::rename(aside.path().join("result"), &target);
            }
            return Err(failed(error));
        }
        // Moved away: nothing is left to remove under the temporary name
        let _ = temporary.keep();
        sync_folder(&parent).map_err(failed)?;
        match former {
            Some(aside) => aside.close().map_err(failed),
            None => Ok(()),
        }
    }
}

impl Part {
    /// Where a file of this folder will be.
    pub fn shown(&self, name: &str) -> PathBuf {
        self.target.join(name)
    }

    /// Writes one file and brings it to the disk; errors name the file in the target.
    pub fn file(
        &self,
        name: &str,
        write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    ) -> Result<(), OutputError> {
        debug_assert!(OWN_FILES.contains(&name), "{name} is not listed");
        let save = || -> io::Result<()> {
            let mut out = io::BufWriter::new(File::create(self.path.join(name))?);
            write(&mut out)?;
            out.into_inner()?.sync_all()
        };
        save().map_err(|e| OutputError::io(&self.shown(name), e))
    }
}

/// Whether a result may be written here: nothing yet, an empty folder, or a former result.
///
/// # Errors
/// [`OutputError::NotAFolder`] and [`OutputError::ForeignFolder`] for what is somebody else's;
/// [`OutputError::Io`] where it cannot be read.
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
    let names = names(target).map_err(failed)?;
    if names.is_empty() {
        return Ok(());
    }
    let foreign = |reason: String| OutputError::ForeignFolder {
        path: target.to_owned(),
        reason,
    };
    let known = [("result.json", FORMAT), ("curve.json", CURVE_FORMAT)];
    if !(known.iter()).any(|(name, format)| has_format(&target.join(name), format)) {
        return Err(foreign("it holds files, but no result of ertel".into()));
    }
    match stray(target, &names).map_err(failed)? {
        Some(name) => Err(foreign(format!(
            "beside a former result it holds {}",
            name.display()
        ))),
        None => Ok(()),
    }
}

fn names(folder: &Path) -> io::Result<Vec<OsString>> {
    fs::read_dir(folder)?.map(|e| Ok(e?.file_name())).collect()
}

/// The first thing in a result folder, or in those of its points, that no result holds.
fn stray(target: &Path, found: &[OsString]) -> io::Result<Option<PathBuf>> {
    let own = |name: &&OsString| OWN_FILES.iter().any(|own| name == own);
    if let Some(name) = found.iter().find(|n| !own(n) && *n != POINTS) {
        return Ok(Some(name.into()));
    }
    if !found.iter().any(|n| n == POINTS) {
        return Ok(None);
    }
    if !target.join(POINTS).is_dir() {
        return Ok(Some(POINTS.into()));
    }
    for point in names(&target.join(POINTS))? {
        let path = Path::new(POINTS).join(point);
        if !target.join(&path).is_dir() {
            return Ok(Some(path));
        }
        let files = names(&target.join(&path))?;
        if let Some(name) = files.iter().find(|n| !own(n)) {
            return Ok(Some(path.join(name)));
        }
    }
    Ok(None)
}

fn has_format(path: &Path, format: &str) -> bool {
    fs::read(path)
        .ok()
        .and_then(|bytes| serde_json::from_slice::<serde_json::Value>(&bytes).ok())
        .is_some_and(|json| json["format"] == format)
}

/// Temporary folders are private; results have the permissions of any new folder.
#[cfg(unix)]
fn share(folder: &Path) -> io::Result<()> {
    let probe = folder.join(".permissions");
    fs::create_dir(&probe)?;
    let usual = fs::metadata(&probe)?.permissions();
    fs::remove_dir(&probe)?;
    fs::set_permissions(folder, usual)
}

#[cfg(not(unix))]
fn share(_folder: &Path) -> io::Result<()> {
    Ok(())
}
