//! Functions of the solver's libraries for folders of results: fields of a file on a grid, tables of studies, colours of pictures.

use std::path::PathBuf;

use ertel::output::netcdf;
use ertel::solution::{ContactFields, Field, Figure};
use ertel::study::journal::{Entries, JOURNAL};
use ertel::study::{STUDY_FORMAT, StudyEcho};
use numpy::{IntoPyArray, PyArray2, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::case::json;
use crate::errors;
use crate::pool::detached;

/// Points of a grid: with some twenty fields these take half a gigabyte.
const MOST_GRID_POINTS: usize = 5_000_000;

/// Fields by name, each a two-dimensional array.
type Grids<'py> = Vec<(&'static str, Bound<'py, PyArray2<f64>>)>;

/// Fields given by their values at points (m, n x 2) of cells (corners, m x 3, or m x 2 of a line contact) at the crossings of `x` and `y`
/// (m), rows along y; not a number outside the cells.
#[pyfunction]
pub fn fields_on_grid<'py>(
    py: Python<'py>,
    points: PyReadonlyArray2<'py, f64>,
    cells: PyReadonlyArray2<'py, u32>,
    fields: Vec<(String, PyReadonlyArray1<'py, f64>)>,
    x: Vec<f64>,
    y: Vec<f64>,
) -> PyResult<Grids<'py>> {
    within(x.len(), y.len())?;
    let whole = contact_fields(&points, &cells, fields)?;
    let grids = detached(py, || whole.on_grid(&x, &y))?;
    let n_rows = if whole.is_line { 1 } else { y.len() };
    (grids.into_iter())
        .map(|grid| {
            let values = grid.values.into_pyarray(py).reshape([n_rows, x.len()])?;
            Ok((grid.field.name(), values))
        })
        .collect()
}

/// Fields over a contact from arrays, checked.
fn contact_fields(
    points: &PyReadonlyArray2<'_, f64>,
    cells: &PyReadonlyArray2<'_, u32>,
    fields: Vec<(String, PyReadonlyArray1<'_, f64>)>,
) -> PyResult<ContactFields> {
    let bad = |text: String| errors::OutputError::new_err(text);
    let (points, cells) = (points.as_array(), cells.as_array());
    let n_corners = cells.ncols();
    if points.ncols() != 2 || !(n_corners == 2 || n_corners == 3) {
        return Err(bad("points of two numbers, cells of two or three".into()));
    }
    let n_points = points.nrows();
    let corner = |cell: &[u32], i: usize| cell.get(i).copied().unwrap_or_default();
    let mut whole = ContactFields {
        points: points.rows().into_iter().map(|p| [p[0], p[1]]).collect(),
        cells: (cells.rows().into_iter())
            .map(|c| {
                let cell = c.to_vec();
                [corner(&cell, 0), corner(&cell, 1), corner(&cell, 2)]
            })
            .collect(),
        fields: Vec::new(),
        is_line: n_corners == 2,
    };
    if whole
        .cells
        .iter()
        .flatten()
        .any(|c| *c as usize >= n_points)
    {
        return Err(bad("a cell has a corner that is no point".into()));
    }
    for (name, values) in fields {
        let field = Field::ALL.into_iter().find(|field| field.name() == name);
        let field = field.ok_or_else(|| bad(format!("no field `{name}`")))?;
        let values = values.as_array().to_vec();
        if values.len() != n_points {
            return Err(bad(format!(
                "`{name}` has another number of values than points"
            )));
        }
        whole.fields.push((field, values));
    }
    Ok(whole)
}

/// Points (m) along both axes of a regular grid over the contact, `n_points` along x; `extent` is (x_low, x_high, y_low, y_high), m, by default
/// the contact and a margin, for which `sizes` are half-width (m) and largest pressure (Pa) of the dry contact.
#[pyfunction]
pub fn contact_grid(
    points: PyReadonlyArray2<'_, f64>,
    pressure: PyReadonlyArray1<'_, f64>,
    sizes: (f64, f64),
    is_line: bool,
    n_points: usize,
    extent: Option<[f64; 4]>,
) -> PyResult<(Vec<f64>, Vec<f64>)> {
    let points = points.as_array();
    let points: Vec<[f64; 2]> = points.rows().into_iter().map(|p| [p[0], p[1]]).collect();
    let extent = match extent {
        Some([x_low, x_high, y_low, y_high]) => netcdf::GridExtent {
            x: [x_low, x_high],
            y: [y_low, y_high],
        },
        None => {
            let pressure = pressure.as_array().to_vec();
            let (half_width, hertz_pressure) = sizes;
            netcdf::extent(&points, &pressure, half_width, hertz_pressure)
        }
    };
    within(n_points, netcdf::n_rows(is_line, n_points, extent))?;
    let [x, y] = netcdf::axes(is_line, n_points, extent);
    Ok((x, y))
}

/// Refuses grids that are too large.
fn within(n: usize, m: usize) -> PyResult<()> {
    match n.saturating_mul(m) > MOST_GRID_POINTS {
        true => Err(errors::CaseError::new_err(format!(
            "a grid of {n} x {m} points is too large: at most {MOST_GRID_POINTS} in all; give fewer n_points"
        ))),
        false => Ok(()),
    }
}

/// Name, value, error, uncertainty, whether resolved, and place of a figure.
type FigureEntry = (
    String,
    f64,
    Option<f64>,
    Option<f64>,
    bool,
    Option<[f64; 2]>,
);

/// `result.nc` of fields given as for [`fields_on_grid`], and of figures; `about` is title, kind and version.
#[pyfunction]
pub fn netcdf_bytes<'py>(
    py: Python<'py>,
    about: (String, String, String),
    points: PyReadonlyArray2<'py, f64>,
    cells: PyReadonlyArray2<'py, u32>,
    fields: Vec<(String, PyReadonlyArray1<'py, f64>)>,
    axes: [Vec<f64>; 2],
    figures: Vec<FigureEntry>,
) -> PyResult<Bound<'py, PyBytes>> {
    let whole = contact_fields(&points, &cells, fields)?;
    let figures: Option<Vec<netcdf::GridFigure>> = (figures.into_iter())
        .map(|(name, value, error, uncertainty, resolved, place)| {
            let figure = Figure::ALL.into_iter().find(|own| own.name() == name)?;
            Some(netcdf::GridFigure {
                figure,
                value,
                error,
                uncertainty,
                resolved,
                place,
            })
        })
        .collect();
    let figures = figures
        .ok_or_else(|| errors::OutputError::new_err("a figure that this version does not know"))?;
    let bytes = detached(py, || {
        let (title, kind, version) = about;
        let about = netcdf::About {
            title: &title,
            kind: &kind,
            version: &version,
        };
        netcdf::netcdf(about, &whole, &axes, &figures)
    })?;
    Ok(PyBytes::new(py, &bytes))
}

/// The study in a folder, be it finished or not: what it is as JSON, and the table of its finished points; touches nothing.
#[pyfunction]
pub fn study_table(py: Python<'_>, folder: PathBuf) -> PyResult<(String, String)> {
    let read = || {
        let echo = StudyEcho::read(&folder)?;
        Ok((echo, Entries::read(&folder)?))
    };
    let read: Result<_, ertel::study::StudyError> = detached(py, read)?;
    let bad = |text: String| errors::OutputError::new_err(text);
    let (echo, entries) = read.map_err(|error| bad(error.to_string()))?;
    let Some(echo) = echo else {
        return Err(bad(format!(
            "{}: no list of points of a study ({STUDY_FORMAT})",
            folder.display()
        )));
    };
    if entries.is_foreign() {
        return Err(bad(format!(
            "{}: the journal of its points is damaged, or that of another program",
            folder.display()
        )));
    }
    if !folder.join(JOURNAL).exists() && folder.join("results.csv").exists() {
        return Err(bad(format!(
            "{}: results.csv is there, but the journal of its points is not",
            folder.display()
        )));
    }
    let records = (echo.points.iter()).map(|(key, _)| entries.records.get(key));
    let failures: Vec<_> = (records.clone().enumerate())
        .filter_map(|(i, record)| {
            let record = record.filter(|record| !record.converged)?;
            let reason = record.field("reason").unwrap_or_default();
            Some((i + 1, reason.to_owned()))
        })
        .collect();
    let about = serde_json::json!({
        "title": echo.title,
        "ertel_version": echo.ertel_version,
        "columns": echo.columns,
        "n_points": echo.points.len(),
        "n_finished": records.flatten().count(),
        "n_damaged": entries.n_damaged,
        "failures": failures,
    });
    Ok((json(&about)?, echo.table(&entries.records)))
}

/// Colours of curves in the program's pictures, as `#0072B2`.
#[pyfunction]
pub fn palette() -> Vec<&'static str> {
    ertel_plot::PALETTE.to_vec()
}
