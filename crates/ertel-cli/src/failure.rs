//! Failures and their exit codes.

use std::process::ExitCode;

use ertel::output::OutputError;
use ertel_input::InputError;
use ertel_quantity::QuantityError;
use ertel_rheology::database::DatabaseError;

/// A command that did not succeed.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// The case file is wrong.
    #[error(transparent)]
    Input(#[from] InputError),
    /// An argument is wrong.
    #[error("{0}")]
    Argument(String),
    /// The solver gave up.
    #[error("{0}")]
    NotConverged(String),
    /// Results are written, but the mesh does not resolve what was asked for.
    #[error("{0}")]
    Unresolved(String),
    /// Ctrl-C.
    #[error("interrupted; nothing was written")]
    Interrupted,
    /// Ctrl-C in a curve of which some points were solved.
    #[error("{0}")]
    InterruptedCurve(String),
    /// Results cannot be written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// Some of several cases did not succeed.
    #[error("{message}")]
    Cases {
        /// How many, of how many.
        message: String,
        /// The exit code of the worst.
        code: u8,
    },
    /// Anything else, reading and writing above all.
    #[error("{0}")]
    Other(String),
}

impl Failure {
    /// 1 other, 2 bad input, 3 not converged or not resolved, 130 interrupted.
    pub fn code(&self) -> u8 {
        match self {
            Self::Output(_) | Self::Other(_) => 1,
            Self::Input(_) | Self::Argument(_) => 2,
            Self::NotConverged(_) | Self::Unresolved(_) => 3,
            Self::Interrupted | Self::InterruptedCurve(_) => 130,
            Self::Cases { code, .. } => *code,
        }
    }

    /// The same for the end of the program.
    pub fn exit_code(&self) -> ExitCode {
        ExitCode::from(self.code())
    }
}

impl From<QuantityError> for Failure {
    fn from(error: QuantityError) -> Self {
        Self::Argument(error.to_string())
    }
}

impl From<DatabaseError> for Failure {
    fn from(error: DatabaseError) -> Self {
        Self::Argument(error.to_string())
    }
}
