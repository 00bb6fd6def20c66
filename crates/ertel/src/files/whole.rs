//! Atomic writing of files.

use std::fs::{File, TryLockError};
use std::io::{self, Write};
use std::path::Path;

use tempfile::NamedTempFile;

use super::place::place;

/// How the names of files and folders in the making begin.
pub(crate) const TEMPORARY: &str = ".ertel-";
/// The same of files, before some random letters and digits.
const NEW: &str = ".ertel-new-";
const RANDOM: usize = 6;

/// Number of attempts while other runs remove the file as a leftover.
const TRIES: usize = 10;

/// Writes a file so that it is whole, or as before. Links are followed.
///
/// # Errors
/// The system's reason; [`io::ErrorKind::InvalidInput`] for devices, pipes, folders and all that is no regular file: none of these is
/// replaced.
pub fn write_whole(path: &Path, content: &[u8]) -> io::Result<()> {
    let path = &place(path)?;
    match std::fs::metadata(path) {
        Ok(metadata) if !metadata.is_file() => {
            let reason = match metadata.is_dir() {
                true => "it is a folder",
                false => "it is not a regular file",
            };
            return Err(io::Error::new(io::ErrorKind::InvalidInput, reason));
        }
        _ => {}
    }
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let mut file = new_file(folder)?;
    file.write_all(content)?;
    file.as_file().sync_all()?;
    file.persist(path)?;
    Ok(())
}

/// A file in the making, locked as long as its run lives.
fn new_file(folder: &Path) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(NEW).rand_bytes(RANDOM);
    #[cfg(unix)]
    {
        // The usual rights of a new file; the umask is taken off.
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    }
    for _ in 0..TRIES {
        let file = builder.tempfile_in(folder)?;
        // On file systems without locks, no other run takes it for a leftover, either.
        let is_taken = matches!(file.as_file().try_lock(), Err(TryLockError::WouldBlock));
        if !is_taken && file.path().exists() {
            return Ok(file);
        }
    }
    Err(io::Error::other("other runs clear this place all the time"))
}

/// Removes the files in a folder that killed runs had not finished. One that cannot be removed does no harm.
pub fn clear_unfinished(folder: &Path) {
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        let name = entry.file_name();
        let random = name.to_str().and_then(|name| name.strip_prefix(NEW));
        let is_ours = random.is_some_and(|random| {
            random.len() == RANDOM && random.bytes().all(|b| b.is_ascii_alphanumeric())
        });
        if !is_ours || !entry.file_type().is_ok_and(|kind| kind.is_file()) {
            continue;
        }
        let file = File::options().write(true).open(entry.path());
        if file.is_ok_and(|file| file.try_lock().is_ok()) {
            let _ = std::fs::remove_file(entry.path());
        }
    }
}

/// Brings the names of new files in a folder to the disk.
#[cfg(unix)]
pub(crate) fn sync_folder(folder: &Path) -> io::Result<()> {
    File::open(folder)?.sync_all()
}

#[cfg(not(unix))]
pub(crate) fn sync_folder(_folder: &Path) -> io::Result<()> {
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Leftovers of a killed run are removed; files that another run is writing, and foreign files, stay.
    #[test]
    fn unfinished_files_are_removed_unless_a_run_holds_them() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        let held = new_file(folder).unwrap();
        let left = folder.join(".ertel-new-a1B2c3");
        let others = [".ertel-new-notes.txt", ".ertel-config", "new"].map(|name| folder.join(name));
        for path in others.iter().chain([&left]) {
            std::fs::write(path, "half").unwrap();
        }
        clear_unfinished(folder);
        assert!(!left.exists());
        assert!(held.path().exists() && others.iter().all(|path| path.exists()));
        let path = held.path().to_owned();
        held.keep().unwrap();
        clear_unfinished(folder);
        assert!(!path.exists());
    }
}
