//! Cases.

use std::path::PathBuf;

use ertel::case::Case;
use ertel::params::SensitivityDemand;
use pyo3::prelude::*;

use crate::errors;

/// A case that was read and checked.
#[pyclass(frozen, module = "ertel._ertel")]
pub struct NativeCase {
    pub case: Case,
    folder: PathBuf,
    name: String,
}

#[pymethods]
impl NativeCase {
    /// Reads the text of a case file; files that it names are looked for in `folder`.
    #[new]
    fn new(name: &str, text: &str, folder: PathBuf) -> PyResult<Self> {
        let case = Case::from_text(name, text, &folder).map_err(errors::input)?;
        Ok(Self {
            case,
            folder,
            name: name.to_owned(),
        })
    }

    /// Reads a case file.
    #[staticmethod]
    fn read(path: PathBuf) -> PyResult<Self> {
        let case = Case::read(&path).map_err(errors::input)?;
        Ok(Self {
            case,
            folder: path.parent().map(PathBuf::from).unwrap_or_default(),
            name: path.display().to_string(),
        })
    }

    /// The same case with replaced values, each written `key=value` with a value of TOML.
    fn with_settings(&self, settings: Vec<String>) -> PyResult<Self> {
        let (name, folder) = (self.name.clone(), self.folder.clone());
        let case = Case::from_text_with(&name, &self.case.source, &folder, &settings);
        Ok(Self {
            case: case.map_err(errors::input)?,
            folder,
            name,
        })
    }

    /// Text of the case file.
    #[getter]
    fn text(&self) -> &str {
        &self.case.source
    }

    /// Name of the file.
    #[getter]
    fn name(&self) -> &str {
        &self.name
    }

    /// Folder of the files that it names.
    #[getter]
    fn folder(&self) -> PathBuf {
        self.folder.clone()
    }

    /// Title.
    #[getter]
    fn title(&self) -> &str {
        &self.case.title
    }

    /// Whether it changes in time.
    #[getter]
    fn is_transient(&self) -> bool {
        self.case.transient.is_some() && self.case.curve.is_none()
    }

    /// Whether it asks for a curve.
    #[getter]
    fn is_curve(&self) -> bool {
        self.case.curve.is_some()
    }

    /// Whether it describes a whole machine, whose contacts are all solved.
    #[getter]
    fn is_machine(&self) -> bool {
        self.case.contacts.is_some()
    }

    /// Warnings about the input.
    #[getter]
    fn warnings(&self) -> Vec<String> {
        let shown = self.case.warnings.iter().filter(|w| w.is_shown());
        shown.map(ToString::to_string).collect()
    }

    /// The case in SI, as JSON.
    fn si(&self) -> PyResult<String> {
        json(&self.case.echo())
    }

    /// Keys and values as given, as JSON.
    fn given(&self) -> String {
        self.case.given.to_string()
    }

    /// The input quantities with key path, value in SI and standard deviation, if any.
    fn inputs(&self) -> Vec<(String, f64, Option<f64>)> {
        (self.case.inputs().iter())
            .map(|i| {
                (
                    i.key.clone(),
                    i.value,
                    i.uncertainty.as_ref().map(|u| u.standard()),
                )
            })
            .collect()
    }

    /// Estimates by formulas, as JSON.
    fn estimate(&self) -> PyResult<String> {
        let estimate = ertel::estimate::estimate(&self.case);
        let whole = ertel::machine::estimate(&self.case);
        let document = ertel::output::estimate_json(&self.case.echo(), &estimate, whole.as_ref());
        Ok(document.map_err(unwritable)?.to_string())
    }

    /// The same in words.
    fn estimate_report(&self) -> String {
        let estimate = ertel::estimate::estimate(&self.case);
        let whole = ertel::machine::estimate(&self.case);
        ertel::output::estimate_report(&self.case.echo(), &estimate, whole.as_ref())
    }
}

impl NativeCase {
    /// The case as a single solve takes it: with sensitivities where they are cheap, as the program has it.
    pub fn single(&self) -> Case {
        let mut case = self.case.clone();
        if case.output.sensitivities == SensitivityDemand::WhereUncertain {
            case.output.sensitivities = SensitivityDemand::WhereCheap;
        }
        case
    }
}

/// JSON text of what can be serialised.
pub fn json(value: &impl serde::Serialize) -> PyResult<String> {
    serde_json::to_string(value).map_err(unwritable)
}

/// A document that JSON cannot hold.
pub fn unwritable(error: serde_json::Error) -> PyErr {
    errors::OutputError::new_err(error.to_string())
}
