//! Propagation of the uncertainty of the inputs by sampling: a study of any number of points, and its statistics.
//!
//! Where the derivatives at the values of the case suffice, both agree ([`crate::solution::Uncertainties`]).

mod sampling;
mod statistics;

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::case::Case;
use crate::case::study::{AxisValue, Study, StudyColumn, StudyPoint};
use crate::params::SensitivityDemand;
use ertel_input::{Input, excerpt};

pub use sampling::{MOST_SAMPLES, MonteCarloParams, SampleError};
pub use statistics::{Distribution, MonteCarlo, QUANTILES, Sampled};

/// The uncertain inputs of a case.
fn uncertain(case: &Case) -> Vec<&Input> {
    (case.inputs().iter())
        .filter(|input| input.uncertainty.is_some())
        .collect()
}

/// A study whose points are samples of the uncertain inputs of a case (Latin hypercube).
///
/// # Errors
/// A case without uncertain inputs, and samples that no contact can have.
pub fn study_of(case: &Case, params: &MonteCarloParams) -> Result<Study, SampleError> {
    let inputs = uncertain(case);
    let samples = sampling::samples(&inputs, case.correlations(), params)?;
    let columns = (inputs.iter())
        .map(|input| StudyColumn::of(&input.key, input.dimension))
        .collect();
    let points = samples
        .into_iter()
        .enumerate()
        .map(|(i, sample)| point(case, &inputs, i, &sample))
        .collect::<Result<Vec<_>, _>>()?;
    Ok(Study::of_samples(case, columns, points))
}

fn point(
    case: &Case,
    inputs: &[&Input],
    index: usize,
    sample: &[f64],
) -> Result<StudyPoint, SampleError> {
    let values: Vec<AxisValue> = (inputs.iter().zip(sample))
        .map(|(input, value)| AxisValue::Number(*value, input.dimension))
        .collect();
    let label = (inputs.iter().zip(&values))
        .map(|(input, value)| format!("{} = {value}", input.key))
        .collect::<Vec<_>>()
        .join(", ");
    let replaced: BTreeMap<String, f64> = (inputs.iter().zip(sample))
        .map(|(input, value)| (input.key.clone(), *value))
        .collect();
    let mut sampled = case
        .with_values(replaced)
        .map_err(|error| SampleError::Impossible {
            label: label.clone(),
            reason: error.message().to_owned(),
        })?;
    sampled.output.sensitivities = SensitivityDemand::Off;
    if let Some(contacts) = &mut sampled.contacts {
        for point in &mut Arc::make_mut(contacts).study.points {
            point.case.output.sensitivities = SensitivityDemand::Off;
        }
    }
    sampled.source = format!(
        "# Sample {} of the inputs: {}\n{}",
        index + 1,
        excerpt(&label),
        case.source
    );
    Ok(StudyPoint {
        values,
        label,
        case: sampled,
    })
}
