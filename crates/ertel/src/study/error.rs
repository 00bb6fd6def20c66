//! Why the files of a study cannot be used.

use std::io;
use std::path::{Path, PathBuf};

/// Why the journal or the list of points of a study cannot be read or written.
#[derive(Debug, thiserror::Error)]
pub enum StudyError {
    /// The system refused, or the file is damaged.
    #[error("{}: {source}", path.display())]
    Io {
        /// Which file.
        path: PathBuf,
        /// The reason.
        source: io::Error,
    },
    /// Another run is at work.
    #[error("another run is writing to {}; wait for it, or choose another folder", folder.display())]
    Locked {
        /// The folder.
        folder: PathBuf,
    },
}

impl StudyError {
    pub(crate) fn io(path: &Path, source: io::Error) -> StudyError {
        StudyError::Io {
            path: path.to_owned(),
            source,
        }
    }
}
