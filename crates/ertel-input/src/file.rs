//! The one reader of files that users name: regular files of bounded size with text, UTF-8 but for tables.

mod encoding;
mod error;

use std::fs::{File, Metadata};
use std::io::Read;
use std::path::Path;

pub use error::FileError;

/// Largest TOML file, bytes: case, study, equation of state. A hundred times what a long study takes.
pub const LARGEST_DOCUMENT: u64 = 2_000_000;
/// Largest table of numbers (CSV), bytes: more than a million lines.
pub const LARGEST_TABLE: u64 = 100_000_000;

/// Largest file that ertel itself writes and reads again, bytes: results, lists of points, pages.
pub const LARGEST_OWN: u64 = 1_000_000_000;

/// A regular file of at most `limit` bytes, to be read.
///
/// # Errors
///
/// [`FileError`]: a file that cannot be opened, is no regular file, or is larger. None of these waits for another program.
pub fn open(path: &Path, limit: u64) -> Result<(File, Metadata), FileError> {
    // Asked before it is opened: opening a pipe waits for its writer.
    check(&std::fs::metadata(path)?, limit)?;
    let file = File::open(path)?;
    let metadata = file.metadata()?;
    check(&metadata, limit)?;
    Ok((file, metadata))
}

/// The bytes of a regular file of at most `limit` bytes.
///
/// # Errors
///
/// As [`open`], and a file that has more or fewer bytes than it states.
pub fn read_bytes(path: &Path, limit: u64) -> Result<Vec<u8>, FileError> {
    let (file, metadata) = open(path, limit)?;
    let mut bytes = Vec::new();
    file.take(metadata.len() + 1).read_to_end(&mut bytes)?;
    // Files of /proc and /sys call themselves regular, but state no size or another one than they have.
    if bytes.len() as u64 != metadata.len() {
        return Err(FileError::NotRegular);
    }
    Ok(bytes)
}

/// The text of a regular file of at most `limit` bytes.
///
/// # Errors
///
/// [`FileError`]: as [`read_bytes`], and a file that is not UTF-8. None of these waits for another program or reads more than the limit.
pub fn read_text(path: &Path, limit: u64) -> Result<String, FileError> {
    let bytes = read_bytes(path, limit)?;
    String::from_utf8(bytes).map_err(|error| {
        let valid = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        FileError::Encoding {
            line: 1 + valid.iter().filter(|byte| **byte == b'\n').count(),
        }
    })
}

/// The text of a table as spreadsheets and instruments write it: UTF-8 or UTF-16 with or without a mark of the byte order, or
/// Windows-1252, which Latin-1 is a part of. Lines end with a line feed, also those of files that have carriage returns alone.
///
/// # Errors
///
/// [`FileError`], as [`read_text`]; files that are no text, such as workbooks of a spreadsheet.
pub fn read_table(path: &Path) -> Result<String, FileError> {
    encoding::decode(&read_bytes(path, LARGEST_TABLE)?)
}

fn check(metadata: &Metadata, limit: u64) -> Result<(), FileError> {
    let size = metadata.len();
    if metadata.is_dir() {
        Err(FileError::Folder)
    } else if !metadata.is_file() {
        Err(FileError::NotRegular)
    } else if size > limit {
        Err(FileError::TooLarge { size, limit })
    } else {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use std::io::Write;

    use super::*;

    #[test]
    fn files_of_a_bounded_size_are_read() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        let write = |bytes: &[u8]| File::create(&path).unwrap().write_all(bytes).unwrap();
        write(b"");
        assert_eq!(read_text(&path, 4).unwrap(), "");
        write("aµ\n".as_bytes());
        assert_eq!(read_text(&path, 4).unwrap(), "aµ\n");
        write(b"12345");
        let error = read_text(&path, 4).unwrap_err().to_string();
        assert_eq!(error, "is too large: 5 bytes, and at most 4 are read");
        write(b"a\n\xff");
        let error = read_text(&path, 4).unwrap_err().to_string();
        assert_eq!(error, "is not UTF-8 text (line 2)");
        assert!(matches!(
            read_text(folder.path(), 4),
            Err(FileError::Folder)
        ));
        assert!(matches!(
            read_text(&folder.path().join("b"), 4),
            Err(FileError::Io(_))
        ));
    }

    /// A pipe without a writer, devices, and what the kernel makes up: refused at once.
    #[cfg(target_os = "linux")]
    #[test]
    fn what_is_no_regular_file_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let pipe = folder.path().join("pipe");
        let made = std::process::Command::new("mkfifo").arg(&pipe).status();
        assert!(made.unwrap().success());
        let others = ["/dev/zero", "/proc/self/environ", "/proc/self/status"];
        for path in others.map(Path::new).into_iter().chain([pipe.as_path()]) {
            let found = read_text(path, 1000);
            assert!(matches!(found, Err(FileError::NotRegular)), "{path:?}");
        }
    }
}
