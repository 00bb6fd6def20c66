//! Input quantities of a case, and the same case with other values.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use nalgebra::DMatrix;

use ertel_input::{Document, Input, InputError, Inputs};
use ertel_quantity::Correlation;

use super::{Case, finite_volumes_refuse};
use crate::params::{Method, SensitivityDemand};

/// Sections of numerical settings.
const NUMERICS: [&str; 5] = ["mesh", "solver", "output", "curve", "stress"];

/// Numerical settings of `[thermal]`.
const NUMERICS_OF_HEAT: [&str; 2] = ["thermal.tolerance", "thermal.depth"];

/// Where the quantities of a case come from.
#[derive(Clone, Debug)]
pub struct Origin {
    document: Document,
    folder: PathBuf,
    inputs: Vec<Input>,
    correlations: Vec<Correlation>,
}

impl Origin {
    pub(super) fn new(
        document: &Document,
        folder: &Path,
        inputs: Inputs,
    ) -> Result<Self, InputError> {
        let (mut inputs, correlations) = inputs.into_noted();
        let is_numeric = |input: &Input| {
            let section = input.key.split('.').next().unwrap_or_default();
            NUMERICS.contains(&section) || NUMERICS_OF_HEAT.contains(&input.key.as_str())
        };
        if let Some(input) = (inputs.iter()).find(|i| is_numeric(i) && i.uncertainty.is_some()) {
            let at = document.tree().entry(&input.key);
            let span = at.map_or(0..0, |entry| entry.node.span.clone());
            return Err(document.error_at(
                span,
                &input.key,
                format!(
                    "`{}` is a numerical setting: it has no uncertainty",
                    input.key
                ),
            ));
        }
        inputs.retain(|input| !is_numeric(input));
        if !is_possible(&correlations) {
            let at = document.tree().entry("correlation");
            let span = at.map_or(0..0, |entry| entry.node.span.clone());
            let message = "these correlations are impossible: some combination of the quantities would have a negative variance";
            return Err(document.error_at(span, "correlation", message));
        }
        Ok(Self {
            document: document.clone(),
            folder: folder.to_owned(),
            inputs,
            correlations,
        })
    }
}

impl super::Case {
    /// The same case with its lubricant at another temperature, K.
    ///
    /// # Errors
    /// Laws of the lubricant that do not reach there; a case made in code.
    pub(crate) fn at_temperature(&self, temperature: f64) -> Result<Self, InputError> {
        let folder = (self.origin.as_ref()).map_or(Path::new(""), |origin| &origin.folder);
        let key = match self.given.get("temperature") {
            Some(_) => "temperature",
            None => "lubricant.temperature",
        };
        let setting = format!("{key}={temperature} K");
        let case = Self::from_text_with("case", &self.source, folder, &[setting])?;
        Ok(Self {
            output: self.output.clone(),
            ..case
        })
    }
}

/// Whether the correlation matrix is positive semidefinite.
fn is_possible(correlations: &[Correlation]) -> bool {
    let mut keys: Vec<&String> = correlations.iter().flat_map(|c| &c.keys).collect();
    if keys.is_empty() {
        return true;
    }
    keys.sort();
    keys.dedup();
    let mut matrix = DMatrix::<f64>::identity(keys.len(), keys.len());
    for correlation in correlations {
        let at = |key: &String| keys.binary_search(&key).unwrap_or(0);
        let [i, j] = [at(&correlation.keys[0]), at(&correlation.keys[1])];
        matrix[(i, j)] = correlation.coefficient;
        matrix[(j, i)] = correlation.coefficient;
    }
    let values = matrix.symmetric_eigenvalues();
    values.iter().all(|value| *value > -LEAST_EIGENVALUE)
}

/// Eigenvalues down to this are zero within the rounding of the given correlations.
const LEAST_EIGENVALUE: f64 = 1e-3;

impl Case {
    /// The physical quantities that the case was read from, in the order in which they were read; those that a lubricant or a material
    /// of the database or in a file brings along are listed under its key. None for a case made in code.
    pub fn inputs(&self) -> &[Input] {
        self.origin.as_ref().map_or(&[], |origin| &origin.inputs)
    }

    /// Correlations of inputs with an uncertainty.
    pub fn correlations(&self) -> &[Correlation] {
        (self.origin.as_ref()).map_or(&[], |origin| &origin.correlations)
    }

    /// Whether derivatives by its inputs are to be computed.
    pub fn wants_sensitivities(&self) -> bool {
        let uncertain = |or_estimated: bool| {
            (self.inputs().iter())
                .any(|input| input.uncertainty.is_some() && (or_estimated || !input.estimated))
        };
        // With heat and by finite elements, each input takes two solves: estimates alone do not request them.
        let is_cheap = self.thermal().is_none()
            && self.solver.method != Some(Method::FiniteElements)
            && !self.has_key_of_elements()
            && finite_volumes_refuse(self).is_none();
        match self.output.sensitivities {
            // The load changes a relief measured in half-widths, and so the problem.
            _ if !self.reliefs.is_empty() => false,
            // Derivatives at a given shape are not those of the contact that wears.
            _ if self.wear.is_some() => false,
            SensitivityDemand::Off => false,
            SensitivityDemand::WhereUncertain => uncertain(is_cheap),
            SensitivityDemand::WhereCheap => {
                (is_cheap && !self.inputs().is_empty()) || uncertain(is_cheap)
            }
            SensitivityDemand::All => !self.inputs().is_empty(),
        }
    }

    /// The same case with other values, SI, of some of its inputs, named by their key paths; without its curve.
    ///
    /// # Errors
    ///
    /// Values that no contact can have.
    pub fn with_values(&self, values: BTreeMap<String, f64>) -> Result<Self, InputError> {
        let Some(origin) = &self.origin else {
            return Ok(self.clone());
        };
        let mut case = Self::without_curve(&origin.document, &origin.folder, values.clone())?;
        case.read_contacts(&origin.document, &origin.folder, &values)?;
        // A contact of a bearing whose spin follows from the law of friction.
        let by_law = self.friction_by_law && self.motion.spin == [0.0; 2];
        if by_law && !values.keys().any(|key| key.ends_with("_spin")) {
            case.motion.spin = [0.0; 2];
        }
        Ok(case)
    }
}
