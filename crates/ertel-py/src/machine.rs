//! Results of whole machines.

use std::path::PathBuf;

use ertel::case::{Case, CaseEcho};
use ertel::machine::{MachineFigures, figures};
use ertel::output;
use ertel::params::OutputParams;
use ertel::study::MachineSolution;
use pyo3::prelude::*;

use crate::case::{json, unwritable};
use crate::errors;

/// The contacts of a machine, and the figures of the whole.
#[pyclass(frozen, module = "ertel._ertel")]
pub struct NativeMachine {
    machine: MachineSolution,
    figures: MachineFigures,
    echo: CaseEcho,
    output: OutputParams,
    document: String,
}

impl NativeMachine {
    /// # Errors
    /// Documents that JSON cannot hold.
    pub fn new(case: &Case, machine: MachineSolution) -> PyResult<Self> {
        let figures = figures(case, &machine);
        let echo = case.echo();
        let document = output::machine_json(&echo, &machine, &figures).map_err(unwritable)?;
        Ok(Self {
            document: json(&document)?,
            machine,
            figures,
            echo,
            output: case.output.clone(),
        })
    }
}

#[pymethods]
impl NativeMachine {
    /// `machine.json`.
    fn document(&self) -> &str {
        &self.document
    }

    /// `report.txt`.
    fn report(&self) -> String {
        output::machine_report(&self.echo, &self.machine, &self.figures, None)
    }

    /// `machine.csv`.
    fn table(&self) -> String {
        output::machine_table(&self.machine, &self.figures.at_contacts)
    }

    /// Writes the files that `ertel solve` writes.
    fn save(&self, py: Python<'_>, folder: PathBuf) -> PyResult<()> {
        crate::pool::detached(py, || {
            output::check_target(&folder)?;
            output::write_machine(
                &self.echo,
                &self.machine,
                &self.figures,
                &folder,
                &self.output,
            )
        })?
        .map_err(errors::output)
    }
}
