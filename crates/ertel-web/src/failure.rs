//! Errors, in the words of the program.

use ertel::elastic::FiniteBodyError;
use ertel::engine::SolveError;
use ertel::output::OutputError;
use ertel_input::InputError;
use serde_json::{Value, json};

use crate::edit::EditError;

/// Name of the case file in errors.
pub const CASE: &str = "case.toml";

/// A case that is not solved.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// The case file is wrong.
    #[error(transparent)]
    Input(#[from] InputError),
    /// The case file is too long.
    #[error("{CASE} {0}")]
    Size(#[from] ertel_input::file::FileError),
    /// The case cannot be solved as it is.
    #[error("{CASE}: {0}")]
    Refused(String),
    /// The solver gave up.
    #[error("{0}")]
    NotConverged(String),
    /// The solve was stopped.
    #[error("interrupted")]
    Interrupted,
    /// The results cannot be described.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// A field does not fit into the case file.
    #[error(transparent)]
    Edit(#[from] EditError),
}

impl From<SolveError> for Failure {
    fn from(error: SolveError) -> Failure {
        match error {
            SolveError::Interrupted => Failure::Interrupted,
            SolveError::Discretisation(FiniteBodyError::Mesh(error)) => Failure::Refused(format!(
                "the mesh of this case cannot be built: {error}\n  = help: see [mesh] in the case file"
            )),
            SolveError::MissingHeatData(error) => {
                Failure::Refused(format!("{error}\n  = help: {}", error.advice()))
            }
            SolveError::TooThin { help, .. } => {
                Failure::Refused(format!("{error}\n  = help: {help}"))
            }
            error => match error.advice() {
                Some(advice) => Failure::NotConverged(format!("{error}\n  = help: try {advice}")),
                None => Failure::NotConverged(error.to_string()),
            },
        }
    }
}

impl Failure {
    /// `{"ok": false, "error": {...}}`: `text` as the program prints it; of a case file also `message` and `help` on their own, `line` and
    /// `column` from 1, and the `key`.
    pub fn json(&self) -> Value {
        let mut error = json!({ "text": self.to_string() });
        if let Failure::Input(input) = self {
            error["message"] = input.message().into();
            error["help"] = input.help().into();
            error["key"] = input.key().into();
            error["line"] = input.line().into();
            error["column"] = input.column().into();
        }
        json!({ "ok": false, "error": error })
    }
}

/// An answer, or why there is none.
pub(crate) fn answer(result: Result<Value, Failure>) -> Value {
    match result {
        Ok(mut value) => {
            value["ok"] = true.into();
            value
        }
        Err(failure) => failure.json(),
    }
}
