//! Where a folder is made, how it comes into its place, and what killed runs left there.
//!
//! Beside the target there is a hidden folder with
//!
//! | entry | what |
//! |---|---|
//! | `lock` | locked as long as the run lives |
//! | `new` | the folder in the making; once both have changed places, the former one |
//! | `former/NAME` | the former folder `NAME` on its way out, where two names cannot be exchanged at once |
//!
//! Where the system can exchange two names, one of both folders is in place at every moment. Elsewhere a kill between two
//! renames leaves the former one in `former`, from which the next run brings it back.

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
/// How often another run may be quicker to clear what seems left over.
const TRIES: usize = 10;

/// The hidden folder; dropped, it vanishes with all that it holds.
pub(super) struct Workplace {
    folder: PathBuf,
    /// Whether it stays, since it holds what is nowhere else.
    is_kept: bool,
    /// Held as long as the value.
    _lock: File,
}

impl Drop for Workplace {
    fn drop(&mut self) {
        if !self.is_kept {
            // What is left, the next run clears.
            let _ = remove(&self.folder);
        }
    }
}

/// Exchanges two names at once; `false` where that cannot be done.
pub(super) type Exchange = fn(&Path, &Path) -> io::Result<bool>;

impl Workplace {
    /// Makes it in `parent`.
    pub fn beside(parent: &Path) -> io::Result<Workplace> {
        for _ in 0..TRIES {
            let folder = tempfile::Builder::new().prefix(PREFIX).tempdir_in(parent)?;
            let path = folder.path().join(LOCK);
            let lock = match File::create(&path) {
                Err(e) if e.kind() == io::ErrorKind::NotFound => continue,
                lock => lock?,
            };
            // On file systems without locks nobody can take it for left over, either.
            let is_taken = matches!(lock.try_lock(), Err(TryLockError::WouldBlock));
            if is_taken || !path.exists() {
                continue; // Another run took it for left over just before it was locked.
            }
            let workplace = Workplace {
                folder: folder.keep(),
                is_kept: false,
                _lock: lock,
            };
            fs::create_dir(workplace.new_folder())?;
            return Ok(workplace);
        }
        Err(io::Error::other("other runs clear this place all the time"))
    }

    /// The folder in the making.
    pub fn new_folder(&self) -> PathBuf {
        self.folder.join(NEW)
    }

    /// Puts the folder in its place, instead of a former result.
    ///
    /// # Errors
    /// [`OutputError`]; what was in its place is there again.
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
            // What came between the check and now would be lost.
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

/// Exchanges two names as one step, where system and file system can.
#[cfg(any(target_os = "linux", target_os = "android", target_vendor = "apple"))]
pub(super) fn exchange(a: &Path, b: &Path) -> io::Result<bool> {
    use rustix::fs::{CWD, RenameFlags, renameat_with};
    use rustix::io::Errno;
    // Of file systems of a network, among others, and of old kernels.
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

/// Whether the former folder, moved out of `target`, may go.
fn check_former(former: &Path, target: &Path) -> Result<(), OutputError> {
    match foreign(former).map_err(|e| OutputError::io(target, e))? {
        Some(reason) => Err(OutputError::ForeignFolder {
            path: target.to_owned(),
            reason,
        }),
        None => Ok(()),
    }
}

/// Clears what killed runs left in a folder, and brings back a former result that one of them had moved away. What cannot
/// be cleared now is left to the next run.
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
        // Only if it is empty; a run that is about to lock it makes another one.
        return fs::remove_dir(left);
    }
    for entry in fs::read_dir(left)? {
        if ![LOCK, NEW, FORMER]
            .iter()
            .any(|own| entry.as_ref().is_ok_and(|e| e.file_name() == *own))
        {
            return Ok(()); // Somebody else's.
        }
    }
    let lock = File::options().write(true).open(&path)?;
    if lock.try_lock().is_err() {
        return Ok(()); // At work, or no locks here.
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
    // Locked until it is gone: a run that has just made it would take it for its own.
    let removed = remove(left);
    drop(lock);
    removed
}

/// Removes a workplace, the lock last: without it, the rest would not be taken for one.
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
