//! Temporary folders: their creation, their exchange with the target, and the cleanup after killed runs.
//!
//! A hidden folder next to the target holds
//!
//! | entry | content |
//! |---|---|
//! | `lock` | locked as long as the run lives |
//! | `new` | the folder under construction; after the exchange, the former one |
//! | `former/NAME` | the former folder `NAME` before its removal, if two names cannot be exchanged atomically |
//!
//! If the system can exchange two names, one of the two folders is in place at every moment. Otherwise, a kill between the two
//! renames keeps the former one in `former`, from which the next run restores it.

use std::fs::{self, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};

use super::OutputError;
use super::target::{foreign, stray};
use crate::files::sync_folder;

const PREFIX: &str = ".ertel-";
const LOCK: &str = "lock";
const NEW: &str = "new";
const FORMER: &str = "former";
/// Maximum number of attempts if other runs clear the new folder as a remnant.
const TRIES: usize = 10;

/// The hidden folder; dropping the value removes it and its content.
pub(super) struct Workplace {
    folder: PathBuf,
    /// Whether it is kept because it holds the only copy of a result.
    is_kept: bool,
    /// Locked for the lifetime of the value.
    _lock: File,
}

impl Drop for Workplace {
    fn drop(&mut self) {
        if !self.is_kept {
            // The next run clears the remains.
            let _ = remove(&self.folder);
        }
    }
}

/// Exchanges two names atomically; `false` if that is impossible.
pub(super) type Exchange = fn(&Path, &Path) -> io::Result<bool>;

impl Workplace {
    /// Creates it in `parent`.
    pub fn create_in(parent: &Path) -> io::Result<Workplace> {
        for _ in 0..TRIES {
            let folder = tempfile::Builder::new().prefix(PREFIX).tempdir_in(parent)?;
            let path = folder.path().join(LOCK);
            let lock = match File::create(&path) {
                Err(e) if e.kind() == io::ErrorKind::NotFound => continue,
                lock => lock?,
            };
            // On file systems without locks, no run can take it for a remnant either.
            let is_taken = matches!(lock.try_lock(), Err(TryLockError::WouldBlock));
            if is_taken || !path.exists() {
                continue; // Another run removed it as a remnant just before it was locked.
            }
            let workplace = Workplace {
                folder: folder.keep(),
                is_kept: false,
                _lock: lock,
            };
            fs::create_dir(workplace.new_folder())?;
            return Ok(workplace);
        }
        Err(io::Error::other(
            "other runs keep clearing the temporary folder",
        ))
    }

    /// The folder under construction.
    pub fn new_folder(&self) -> PathBuf {
        self.folder.join(NEW)
    }

    /// Moves the folder to its target, replacing a former result.
    ///
    /// # Errors
    /// [`OutputError`]; the former content of the target is restored.
    pub fn put(
        mut self,
        target: &Path,
        parent: &Path,
        exchange: Exchange,
    ) -> Result<(), OutputError> {
        let failed = |e| OutputError::io(target, e);
        let new = self.new_folder();
        sync_folder(&new).map_err(failed)?;
        if !target.exists() {
            fs::rename(&new, target).map_err(failed)?;
        } else if exchange(&new, target).map_err(failed)? {
            // Files added since the check would be lost.
            if let Err(error) = check_former(&new, target) {
                if !exchange(&new, target).unwrap_or(false) {
                    self.is_kept = true;
                }
                return Err(error);
            }
        } else {
            let name = target.file_name().unwrap_or_default();
            let aside = self.folder.join(FORMER);
            fs::create_dir(&aside).map_err(failed)?;
            let former = aside.join(name);
            fs::rename(target, &former).map_err(failed)?;
            let moved = check_former(&former, target)
                .and_then(|()| fs::rename(&new, target).map_err(failed));
            if let Err(error) = moved {
                if fs::rename(&former, target).is_err() {
                    self.is_kept = true;
                }
                return Err(error);
            }
        }
        // Before the former one is removed.
        sync_folder(parent).map_err(failed)
    }
}

/// Exchanges two names atomically, if system and file system support it.
#[cfg(any(target_os = "linux", target_os = "android", target_vendor = "apple"))]
pub(super) fn exchange(a: &Path, b: &Path) -> io::Result<bool> {
    use rustix::fs::{CWD, RenameFlags, renameat_with};
    use rustix::io::Errno;
    // Unsupported by, among others, network file systems and old kernels.
    let unknown = [Errno::INVAL, Errno::NOSYS, Errno::NOTSUP, Errno::OPNOTSUPP];
    match renameat_with(CWD, a, CWD, b, RenameFlags::EXCHANGE) {
        Ok(()) => Ok(true),
        Err(error) if unknown.contains(&error) => Ok(false),
        Err(error) => Err(error.into()),
    }
}

#[cfg(not(any(target_os = "linux", target_os = "android", target_vendor = "apple")))]
pub(super) fn exchange(_a: &Path, _b: &Path) -> io::Result<bool> {
    Ok(false)
}

/// Whether the former folder, moved out of `target`, may be removed.
fn check_former(former: &Path, target: &Path) -> Result<(), OutputError> {
    match foreign(former).map_err(|e| OutputError::io(target, e))? {
        Some(reason) => Err(OutputError::ForeignFolder {
            path: target.to_owned(),
            reason,
        }),
        None => Ok(()),
    }
}

/// Clears the remains of killed runs in a folder, and restores a former result that one of them had moved away. Remains that cannot
/// be cleared now are kept for the next run.
pub(super) fn clear(parent: &Path) {
    for entry in fs::read_dir(parent).into_iter().flatten().flatten() {
        let is_ours = entry.file_name().to_string_lossy().starts_with(PREFIX);
        if is_ours && entry.file_type().is_ok_and(|kind| kind.is_dir()) {
            let _ = clear_one(&entry.path(), parent);
        }
    }
}

fn clear_one(left: &Path, parent: &Path) -> io::Result<()> {
    let path = left.join(LOCK);
    let is_lock = |meta: fs::Metadata| meta.is_file() && meta.len() == 0;
    if !fs::symlink_metadata(&path).is_ok_and(is_lock) {
        // Only if it is empty; a run that is about to lock it creates another one.
        return fs::remove_dir(left);
    }
    for entry in fs::read_dir(left)? {
        if ![LOCK, NEW, FORMER]
            .iter()
            .any(|own| entry.as_ref().is_ok_and(|e| e.file_name() == *own))
        {
            return Ok(()); // Not from ertel.
        }
    }
    let lock = File::options().write(true).open(&path)?;
    if lock.try_lock().is_err() {
        return Ok(()); // In use, or no locks available.
    }
    let formers = match fs::read_dir(left.join(FORMER)) {
        Ok(entries) => entries.collect::<Result<Vec<_>, _>>()?,
        Err(_) => Vec::new(),
    };
    for former in formers {
        let home = parent.join(former.file_name());
        let is_free = |e: &io::Error| e.kind() == io::ErrorKind::NotFound;
        if fs::symlink_metadata(&home).as_ref().is_err_and(is_free) {
            fs::rename(former.path(), home)?;
        } else if stray(&former.path())?.is_some() {
            return Ok(());
        }
    }
    let new = left.join(NEW);
    if new.exists() && stray(&new)?.is_some() {
        return Ok(());
    }
    // Locked until it is removed: a new run would otherwise use it.
    let removed = remove(left);
    drop(lock);
    removed
}

/// Removes a workplace, the lock last: without it, the rest would not be recognised as one.
fn remove(workplace: &Path) -> io::Result<()> {
    for part in [NEW, FORMER] {
        match fs::remove_dir_all(workplace.join(part)) {
            Err(e) if e.kind() != io::ErrorKind::NotFound => return Err(e),
            _ => {}
        }
    }
    fs::remove_file(workplace.join(LOCK))?;
    fs::remove_dir(workplace)
}
