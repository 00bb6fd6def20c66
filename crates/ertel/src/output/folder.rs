//! Result folders that appear as a whole or not at all.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::OutputError;
use super::target::{OWN_FILES, POINTS, check_target};
use super::workplace::{Workplace, clear, exchange};

/// A folder in the making beside its target; dropped unfinished, it vanishes.
pub(super) struct NewFolder {
    target: PathBuf,
    parent: PathBuf,
    workplace: Workplace,
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
        clear_leftovers(target);
        check_target(target)?;
        let (target, parent) = place(target);
        fs::create_dir_all(&parent).map_err(|e| OutputError::io(&parent, e))?;
        let workplace = Workplace::beside(&parent).map_err(|e| OutputError::io(&parent, e))?;
        let root = Part {
            path: workplace.new_folder(),
            target: target.clone(),
        };
        Ok(NewFolder {
            target,
            parent,
            workplace,
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
        // Somebody may have put something there meanwhile
        check_target(&self.target)?;
        self.workplace.put(&self.target, &self.parent, exchange)
    }
}

/// Clears what killed runs left beside a result folder, and brings back a former result that one of them had moved away.
/// What cannot be cleared is left to the next run.
pub fn clear_leftovers(target: &Path) {
    clear(&place(target).1);
}

/// Where a folder is or will be, and the folder around it. A link to a former result stays; what it points to is replaced.
fn place(asked: &Path) -> (PathBuf, PathBuf) {
    let linked = || {
        let to = fs::read_link(asked).ok()?;
        Some(asked.parent()?.join(to))
    };
    let target = fs::canonicalize(asked).ok().or_else(linked);
    let target = target.unwrap_or_else(|| asked.to_owned());
    let parent = match target.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent.to_owned(),
        _ => PathBuf::from("."),
    };
    (target, parent)
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
