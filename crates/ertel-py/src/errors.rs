//! Errors as Python sees them, with the words of the program.

use ertel::elastic::FiniteBodyError;
use ertel::engine::SolveError;
use ertel::output::OutputError as WriteError;
use ertel::sweep::SweepError;
use ertel_input::InputError;
use ertel_rheology::database::DatabaseError;
use pyo3::exceptions::{PyKeyboardInterrupt, PyOSError, PyRuntimeError, PyValueError};
use pyo3::prelude::*;

pyo3::create_exception!(
    ertel,
    CaseError,
    PyValueError,
    "Bad input: the text names file, line, key and choices."
);
pyo3::create_exception!(
    ertel,
    ConvergenceError,
    PyRuntimeError,
    "A solve did not converge: the text says how far it came and why."
);
pyo3::create_exception!(
    ertel,
    OutputError,
    PyOSError,
    "Results could not be written, of which nothing is left half-written, or read."
);

/// Bad input.
pub fn input(error: InputError) -> PyErr {
    CaseError::new_err(error.to_string())
}

/// A name or a file of the database.
pub fn database(error: DatabaseError) -> PyErr {
    CaseError::new_err(error.to_string())
}

/// A solve that came to no end.
pub fn solve(error: SolveError) -> PyErr {
    match error {
        SolveError::Interrupted => PyKeyboardInterrupt::new_err("the solve was interrupted"),
        SolveError::Discretisation(FiniteBodyError::Mesh(error)) => {
            CaseError::new_err(format!("the mesh of this case cannot be built: {error}"))
        }
        SolveError::MissingHeatData(error) => {
            CaseError::new_err(format!("{error}; {}", error.advice()))
        }
        SolveError::TooThin { help, .. } => {
            CaseError::new_err(format!("{error}\n  = help: {help}"))
        }
        error => ConvergenceError::new_err(match error.advice() {
            Some(advice) => format!(
                "{error}\n  = help: try {advice}; the result of a similar case as `start` helps, too"
            ),
            None => error.to_string(),
        }),
    }
}

/// Files that were not written.
pub fn output(error: WriteError) -> PyErr {
    OutputError::new_err(error.to_string())
}

/// A study that did not run.
pub fn sweep(error: SweepError) -> PyErr {
    match error {
        SweepError::Twice { .. } | SweepError::Mixed { .. } | SweepError::NoStudy { .. } => {
            CaseError::new_err(error.to_string())
        }
        error => OutputError::new_err(error.to_string()),
    }
}
