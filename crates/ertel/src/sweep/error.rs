//! Why a study was not run.

use std::path::PathBuf;

use crate::output::OutputError;
use crate::study::StudyError;

/// Why a study was not run.
#[derive(Debug, thiserror::Error)]
pub enum SweepError {
    /// Its files cannot be used.
    #[error(transparent)]
    Study(#[from] StudyError),
    /// The folder is foreign.
    #[error("cannot use the folder {} for a study: {reason}. Choose another folder", folder.display())]
    Foreign {
        /// The folder.
        folder: PathBuf,
        /// Its foreign content.
        reason: String,
    },
    /// Two points are one.
    #[error("points {first} and {second} are the same case ({label})")]
    Twice {
        /// Number of the first, from 1.
        first: usize,
        /// Number of the second.
        second: usize,
        /// Values of the second.
        label: String,
    },
    /// A part to be joined is no part of the others' study.
    #[error("{} belongs to another study than {}", folder.display(), other.display())]
    Mixed {
        /// Folder of the part.
        folder: PathBuf,
        /// Folder of the first part.
        other: PathBuf,
    },
    /// A part to be joined is no study.
    #[error("{} is not a study of ertel", folder.display())]
    NoStudy {
        /// Folder of the part.
        folder: PathBuf,
    },
    /// Nothing to be joined.
    #[error("no parts to join: name the folders of the parts of a study")]
    NoParts,
    /// Results of a point cannot be written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// Threads cannot be made.
    #[error("cannot start threads: {0}")]
    Threads(String),
}
