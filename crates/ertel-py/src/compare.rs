//! Measured films and tractions compared with computed ones.

use std::path::PathBuf;

use ertel::compare::{Comparison, Measured, ReadParams};
use ertel::output::compare::{COMPARISON_STUDY, check_comparison_folder};
use ertel::output::{comparison_report, write_comparison};
use ertel::params::PictureFormats;
use ertel::sweep::{SweepParams, finished_points, sweep as run_sweep};
use ertel_input::csv::{ColumnMap, CsvParams, Decimal};
use pyo3::prelude::*;

use crate::errors;
use crate::pool::detached;
use crate::solve::without_gil;
use crate::study::{Messages, described};

/// Solves a case at the points of a table of measurements in `folder`; returns the report and a summary of the study as JSON. The table is
/// `comparison.csv` there.
#[pyfunction]
#[pyo3(signature = (case, measured, folder, *, ignored, columns, decimal=None, jobs=None, progress=None))]
#[allow(clippy::too_many_arguments)]
pub fn compare(
    py: Python<'_>,
    case: PathBuf,
    measured: PathBuf,
    folder: PathBuf,
    ignored: Vec<String>,
    columns: Vec<(String, String)>,
    decimal: Option<String>,
    jobs: Option<usize>,
    progress: Option<Py<PyAny>>,
) -> PyResult<(String, String)> {
    if jobs == Some(0) {
        return Err(errors::CaseError::new_err("jobs = 0: one at least"));
    }
    let decimal = match decimal.as_deref() {
        None => None,
        Some("point") => Some(Decimal::Point),
        Some("comma") => Some(Decimal::Comma),
        Some(other) => {
            let text = format!("decimal = {other:?}: \"point\" or \"comma\"");
            return Err(errors::CaseError::new_err(text));
        }
    };
    let columns = (columns.into_iter())
        .map(|(name, title)| ColumnMap { name, title })
        .collect();
    let params = ReadParams {
        table: CsvParams {
            columns,
            ignored,
            decimal,
        },
        ..ReadParams::default()
    };
    let measured = detached(py, || Measured::read(&case, &measured, &params))?;
    let measured = measured.map_err(|error| errors::CaseError::new_err(error.to_string()))?;
    check_comparison_folder(&folder).map_err(errors::output)?;
    let points = folder.join(COMPARISON_STUDY);
    let params = SweepParams {
        jobs,
        threads: Some(1),
        ..SweepParams::default()
    };
    let wanted = progress.is_some();
    let study = &measured.study;
    let summary = without_gil(py, progress.as_ref(), |sender, cancel| {
        let messages = Messages::new(sender, wanted, cancel);
        run_sweep(study, &points, &params, &messages)
    })?;
    let summary = summary.map_err(errors::sweep)?;
    let records = finished_points(study, &points).map_err(errors::sweep)?;
    let comparison = Comparison::new(&measured, &records);
    let formats = PictureFormats::default();
    write_comparison(&comparison, &measured.case_text, &folder, formats).map_err(errors::output)?;
    Ok((comparison_report(&comparison, None), described(&summary)?))
}
