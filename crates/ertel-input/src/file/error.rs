//! Why a file is not read.

use std::io;

/// Why a file is not read; the message follows the name of the file.
#[derive(Debug, thiserror::Error)]
pub enum FileError {
    /// The operating system does not give it.
    #[error("cannot be read: {0}")]
    Io(#[from] io::Error),
    /// A folder.
    #[error("cannot be read: it is a folder, not a file")]
    Folder,
    /// A device, a pipe, a socket, or a file that the system makes up as it is read.
    #[error("cannot be read: it is not a regular file")]
    NotRegular,
    /// More bytes than a file of its kind may have.
    #[error("is too large: {size} bytes, and at most {limit} are read")]
    TooLarge {
        /// Its size in bytes.
        size: u64,
        /// The most that is read.
        limit: u64,
    },
    /// Not text.
    #[error("is not UTF-8 text (line {line})")]
    Encoding {
        /// The line of the first byte that is no text, from 1.
        line: usize,
    },
    /// A table that is no text, but a file of another kind.
    #[error("is no text: it is {kind}; save the table as CSV, and give that file")]
    Binary {
        /// Kind of the file.
        kind: &'static str,
    },
}

impl FileError {
    /// Whether there is no such file.
    pub fn is_missing(&self) -> bool {
        matches!(self, Self::Io(error) if error.kind() == io::ErrorKind::NotFound)
    }
}

impl From<FileError> for io::Error {
    fn from(error: FileError) -> Self {
        match error {
            FileError::Io(error) => error,
            other => io::Error::new(io::ErrorKind::InvalidInput, other.to_string()),
        }
    }
}
