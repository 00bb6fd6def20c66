//! Result folders written as a whole or not at all.

use std::cell::RefCell;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::OutputError;
use super::target::{POINTS, check_target, is_own_name};
use super::workplace::{Workplace, clear, exchange};
use crate::files::clear_unfinished;

/// A temporary folder next to its target; removed if dropped unfinished.
pub(super) struct NewFolder {
    target: PathBuf,
    parent: PathBuf,
    workplace: Workplace,
    path: PathBuf,
    root: Part,
}

/// The temporary folder or a folder inside it.
pub(super) struct Part {
    /// Temporary path.
    place: Place,
    /// Final path.
    target: PathBuf,
}

enum Place {
    Disk(PathBuf),
    Memory(RefCell<Vec<OutputFile>>),
}

/// A file of a result folder in memory.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OutputFile {
    /// Its name.
    pub name: String,
    /// Its bytes.
    pub bytes: Vec<u8>,
}

impl NewFolder {
    /// Checks that the target may be written and makes the temporary folder next to it.
    pub fn next_to(target: &Path) -> Result<NewFolder, OutputError> {
        clear_leftovers(target);
        check_target(target)?;
        let (target, parent) = place(target);
        fs::create_dir_all(&parent).map_err(|e| OutputError::io(&parent, e))?;
        let workplace = Workplace::create_in(&parent).map_err(|e| OutputError::io(&parent, e))?;
        let path = workplace.new_folder();
        let root = Part {
            place: Place::Disk(path.clone()),
            target: target.clone(),
        };
        Ok(NewFolder {
            target,
            parent,
            workplace,
            path,
            root,
        })
    }

    /// The folder itself.
    pub fn root(&self) -> &Part {
        &self.root
    }

    /// Makes the folder of one point.
    pub fn point(&self, name: &str) -> Result<Part, OutputError> {
        let path = self.path.join(POINTS).join(name);
        let target = self.target.join(POINTS).join(name);
        fs::create_dir_all(&path).map_err(|e| OutputError::io(&target, e))?;
        let place = Place::Disk(path);
        Ok(Part { place, target })
    }

    /// Moves the folder to its target, replacing a former result.
    pub fn finish(self) -> Result<(), OutputError> {
        // The target may have changed meanwhile
        check_target(&self.target)?;
        self.workplace.put(&self.target, &self.parent, exchange)
    }
}

/// Clears the remains of killed runs next to a result folder and restores a former result that one of them had moved away.
/// Remains that cannot be removed are kept for the next run.
pub fn clear_leftovers(target: &Path) {
    let (_, parent) = place(target);
    clear(&parent);
    clear_unfinished(&parent);
}

/// The path of a folder and its parent folder. A link to a former result stays; the folder it points to is replaced.
fn place(asked: &Path) -> (PathBuf, PathBuf) {
    let target = crate::files::place(asked).unwrap_or_else(|_| asked.to_owned());
    let parent = match target.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent.to_owned(),
        _ => PathBuf::from("."),
    };
    (target, parent)
}

impl Part {
    /// A folder in memory, for [`Part::into_files`].
    pub fn in_memory() -> Part {
        Part {
            place: Place::Memory(RefCell::default()),
            target: PathBuf::new(),
        }
    }

    /// The files of a folder in memory, in the order of writing; empty for a folder on disk.
    pub fn into_files(self) -> Vec<OutputFile> {
        match self.place {
            Place::Disk(_) => Vec::new(),
            Place::Memory(files) => files.into_inner(),
        }
    }

    /// Final path of a file of this folder.
    fn shown(&self, name: &str) -> PathBuf {
        self.target.join(name)
    }

    /// Writes a JSON document.
    pub fn json(&self, name: &str, document: serde_json::Result<Value>) -> Result<(), OutputError> {
        let text = document.and_then(|json| serde_json::to_string_pretty(&json));
        let text = text.map_err(|e| OutputError::io(&self.shown(name), e.into()))?;
        self.bytes(name, text + "\n")
    }

    /// Writes a file with this content, as [`Part::file`] does.
    pub fn bytes(&self, name: &str, content: impl AsRef<[u8]>) -> Result<(), OutputError> {
        self.file(name, |out| out.write_all(content.as_ref()))
    }

    /// Writes one file and syncs it to disk; errors name the file in the target.
    pub fn file(
        &self,
        name: &str,
        write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    ) -> Result<(), OutputError> {
        // Otherwise the next run would refuse to replace its own result.
        assert!(is_own_name(name), "{name} is not listed");
        let save = || -> io::Result<()> {
            match &self.place {
                Place::Disk(path) => {
                    let mut out = io::BufWriter::new(File::create(path.join(name))?);
                    write(&mut out)?;
                    out.into_inner()?.sync_all()
                }
                Place::Memory(files) => {
                    let mut bytes = Vec::new();
                    write(&mut bytes)?;
                    let name = name.to_owned();
                    files.borrow_mut().push(OutputFile { name, bytes });
                    Ok(())
                }
            }
        };
        save().map_err(|e| OutputError::io(&self.shown(name), e))
    }
}
