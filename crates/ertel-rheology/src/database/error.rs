//! Why there is no such fluid or solid.

use ertel_input::InputError;
use thiserror::Error;

/// A name that is not in the database, or a data file at fault.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum DatabaseError {
    /// There is no such fluid or solid.
    #[error(
        "there is no {kind} `{name}` in the database{}; {}the choices are {}",
        .near.map(|near| format!(" (did you mean `{near}`?)")).unwrap_or_default(),
        .help.as_ref().map(|help| format!("{help}; ")).unwrap_or_default(), .choices.join(", ")
    )]
    Unknown {
        /// `fluid` or `solid`.
        kind: &'static str,
        /// The name requested.
        name: String,
        /// The name most like it.
        near: Option<&'static str>,
        /// Advice to use another key instead of a name, if that is more likely meant.
        help: Option<String>,
        /// All names.
        choices: Vec<&'static str>,
    },
    /// A file of the database, or of the user, is wrong.
    #[error(transparent)]
    Data(#[from] InputError),
    /// An invalid folder of own data.
    #[error("the folder of own data {path} {reason}")]
    Folder {
        /// The folder.
        path: String,
        /// The reason.
        reason: String,
    },
    /// A file of the user cannot be read.
    #[error("{path} {reason}")]
    File {
        /// The file.
        path: String,
        /// Why not.
        reason: String,
    },
}
