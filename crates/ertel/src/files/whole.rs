//! Files that reach the disk whole.

#[cfg(unix)]
use std::fs::File;
use std::io::{self, Write};
use std::path::Path;

use super::place::place;

/// How the names of files in the making begin.
pub(crate) const TEMPORARY: &str = ".ertel-";

/// Writes a file so that it is whole, or as before. Through a link the file that it leads to is written.
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
    let mut builder = tempfile::Builder::new();
    builder.prefix(TEMPORARY);
    #[cfg(unix)]
    {
        // The usual rights of a new file; the umask is taken off.
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    }
    let mut file = builder.tempfile_in(folder)?;
    file.write_all(content)?;
    file.as_file().sync_all()?;
    file.persist(path)?;
    Ok(())
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
