//! Measured films and tractions: comparison with computed ones, and fits of rough surfaces to them.

use std::path::{Path, PathBuf};

use ertel::compare::{Comparison, Measured, ReadParams};
use ertel::fit::{
    FitObserver, StribeckError, SurfaceConstant, SurfaceEstimate, fit_stribeck as run_fit,
};
use ertel::output::compare::{COMPARISON_STUDY, check_comparison_folder};
use ertel::output::{comparison_report, write_comparison};
use ertel::params::PictureFormats;
use ertel::sweep::{SweepParams, finished_points, sweep as run_sweep};
use ertel_input::csv::{ColumnMap, CsvParams, Decimal};
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;

use crate::errors;
use crate::pool::detached;
use crate::solve::{Cancel, without_gil};
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
    let params = read_params(ignored, columns, decimal.as_deref())?;
    let measured = measured_by(py, &case, &measured, &params)?;
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

/// How a table is read.
fn read_params(
    ignored: Vec<String>,
    columns: Vec<(String, String)>,
    decimal: Option<&str>,
) -> PyResult<ReadParams> {
    let decimal = match decimal {
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
    Ok(ReadParams {
        table: CsvParams {
            columns,
            ignored,
            decimal,
        },
        ..ReadParams::default()
    })
}

/// The case at the points of a table.
fn measured_by(
    py: Python<'_>,
    case: &Path,
    table: &Path,
    params: &ReadParams,
) -> PyResult<Measured> {
    let read = detached(py, || Measured::read(case, table, params))?;
    read.map_err(|error| errors::CaseError::new_err(error.to_string()))
}

/// Stops a fit with Ctrl-C.
struct Stop(Cancel);

impl FitObserver for Stop {
    fn cancelled(&self) -> bool {
        self.0.is_set()
    }
}

/// A constant: name, value, standard uncertainty; the last two are `None` where the readings do not determine it.
type Constant = (&'static str, Option<f64>, Option<f64>);

/// A reading: line, operating point, friction as measured and fitted, and the part of the asperities.
type Point = (usize, String, [f64; 3]);

/// Fits boundary friction and roughness of a case to measured friction; returns the constants, the correlations of pairs, the readings, the scatter, warnings and
/// the section of a case file.
#[pyfunction]
#[pyo3(signature = (case, measured, *, asperity_group, ignored, columns, decimal=None))]
#[allow(clippy::type_complexity)]
pub fn fit_stribeck(
    py: Python<'_>,
    case: PathBuf,
    measured: PathBuf,
    asperity_group: bool,
    ignored: Vec<String>,
    columns: Vec<(String, String)>,
    decimal: Option<String>,
) -> PyResult<(
    Vec<Constant>,
    Vec<([&'static str; 2], f64)>,
    Vec<Point>,
    f64,
    Vec<String>,
    String,
)> {
    let params = read_params(ignored, columns, decimal.as_deref())?;
    let read = measured_by(py, &case, &measured, &params)?;
    let fit = without_gil(py, None, |_, cancel| {
        run_fit(&read, asperity_group, &Stop(cancel))
    })?;
    let fit = fit.map_err(|error| {
        let text = format!("{}: {error}", measured.display());
        match error {
            StribeckError::Interrupted => PyKeyboardInterrupt::new_err("the fit was interrupted"),
            StribeckError::NotConverged(..) | StribeckError::NoMinimum(_) => {
                errors::ConvergenceError::new_err(text)
            }
            _ => errors::CaseError::new_err(text),
        }
    })?;
    let constant = |own: &SurfaceEstimate| {
        let standard = own.standard.filter(|_| own.is_resolved());
        (own.constant.name(), standard.map(|_| own.value), standard)
    };
    let correlation = |(one, other, value): &(SurfaceConstant, SurfaceConstant, f64)| {
        ([one.name(), other.name()], *value)
    };
    let section = fit.section();
    Ok((
        fit.constants.iter().map(constant).collect(),
        fit.correlations.iter().map(correlation).collect(),
        (fit.points.into_iter())
            .map(|own| {
                (
                    own.line,
                    own.label,
                    [own.measured, own.fitted, own.asperities],
                )
            })
            .collect(),
        fit.scatter,
        fit.warnings,
        section,
    ))
}
