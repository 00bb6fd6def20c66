//! Results.

use std::path::PathBuf;
use std::sync::Arc;

use ertel::case::CaseEcho;
use ertel::case::{Case, Curve};
use ertel::output::{self};
use ertel::params::OutputParams;
use ertel::run::Start;
use ertel::run::transient::TransientSolution;
use ertel::solution::{ContactFields, Solution};
use ertel::study::CurveSolution;
use numpy::{IntoPyArray, PyArray1, PyArray2, PyArray3, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::errors;

/// Fields by name, each a one-dimensional array.
type Fields<'py> = Vec<(&'static str, Bound<'py, PyArray1<f64>>)>;

/// The solution of a case.
#[pyclass(frozen, module = "ertel._ertel")]
pub struct NativeSolution {
    solution: Solution,
    echo: CaseEcho,
    output: OutputParams,
    start: Option<Arc<Start>>,
}

impl NativeSolution {
    pub fn new(case: &Case, solution: Solution, start: Option<Start>) -> Self {
        Self {
            solution,
            echo: case.echo(),
            output: case.output.clone(),
            start: start.map(Arc::new),
        }
    }

    /// Start of another solve.
    pub fn start(&self) -> Option<Arc<Start>> {
        self.start.clone()
    }

    fn fields(&self) -> ContactFields {
        self.solution.fields()
    }
}

#[pymethods]
impl NativeSolution {
    /// `result.json`.
    fn document(&self) -> PyResult<String> {
        let document = output::result_json(&self.echo, &self.solution);
        Ok(document.map_err(crate::case::unwritable)?.to_string())
    }

    /// `report.txt`.
    fn report(&self) -> String {
        output::report(&self.echo, &self.solution, None)
    }

    /// Points (m, n x 2), cells (corners, m x 3, or m x 2 of a line contact) and the values of each field over the whole contact.
    #[allow(clippy::type_complexity)]
    fn contact<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(
        Bound<'py, PyArray2<f64>>,
        Bound<'py, PyArray2<u32>>,
        Fields<'py>,
    )> {
        let whole = crate::pool::detached(py, || self.fields())?;
        let n_corners = if whole.is_line { 2 } else { 3 };
        let (n_points, n_cells) = (whole.points.len(), whole.cells.len());
        let points = whole.points.into_flattened().into_pyarray(py);
        let cells: Vec<u32> = (whole.cells.iter())
            .flat_map(|cell| cell[..n_corners].iter().copied())
            .collect();
        let cells = cells.into_pyarray(py).reshape([n_cells, n_corners])?;
        let fields = (whole.fields.into_iter())
            .map(|(field, values)| (field.name(), values.into_pyarray(py)))
            .collect();
        Ok((points.reshape([n_points, 2])?, cells, fields))
    }

    /// Profiles along y = 0 by the names of `centreline.csv`.
    fn centreline<'py>(&self, py: Python<'py>) -> Fields<'py> {
        let temperatures = self.solution.thermal.as_ref().map(|t| &t.centreline);
        let half_width = self.solution.hertz.half_width;
        let columns =
            output::centreline::columns(&self.solution.centreline, temperatures, half_width);
        (columns.into_iter())
            .map(|(name, values)| (name, values.into_pyarray(py)))
            .collect()
    }

    /// Places along the motion and depths, m, and the components of the stress in a body (6 x depths x places, Pa) in the plane of motion; `None` without stresses.
    #[allow(clippy::type_complexity)]
    fn stress_section<'py>(
        &self,
        py: Python<'py>,
        body: usize,
    ) -> PyResult<
        Option<(
            Bound<'py, PyArray1<f64>>,
            Bound<'py, PyArray1<f64>>,
            Bound<'py, PyArray3<f64>>,
        )>,
    > {
        let Some(stresses) = &self.solution.stresses else {
            return Ok(None);
        };
        let section = &stresses.bodies[body].section;
        let shape = [6, section.depth.len(), section.x.len()];
        let components = (0..6).flat_map(|i| section.stress.iter().map(move |s| s.0[i]));
        let components: Vec<f64> = components.collect();
        Ok(Some((
            section.x.clone().into_pyarray(py),
            section.depth.clone().into_pyarray(py),
            components.into_pyarray(py).reshape(shape)?,
        )))
    }

    /// Writes the files that `ertel solve` writes.
    fn save(&self, py: Python<'_>, folder: PathBuf) -> PyResult<()> {
        crate::pool::detached(py, || {
            output::check_target(&folder)?;
            output::write(&self.echo, &self.solution, &folder, &self.output)
        })?
        .map_err(errors::output)
    }
}

/// The points of a curve.
#[pyclass(frozen, module = "ertel._ertel")]
pub struct NativeCurve {
    curve: CurveSolution,
    echo: CaseEcho,
    output: OutputParams,
    folders: bool,
    document: String,
}

impl NativeCurve {
    pub fn new(case: &Case, curve: &Curve, solution: CurveSolution, document: String) -> Self {
        Self {
            curve: solution,
            echo: case.echo(),
            output: case.output.clone(),
            folders: curve.folders,
            document,
        }
    }
}

#[pymethods]
impl NativeCurve {
    /// `curve.json`.
    fn document(&self) -> &str {
        &self.document
    }

    /// `report.txt`.
    fn report(&self) -> String {
        output::curve_report(&self.echo, &self.curve, None)
    }

    /// `curve.csv`.
    fn table(&self) -> String {
        output::curve_table(&self.curve)
    }

    /// Index and reason of the points without solution.
    fn failures(&self) -> Vec<(usize, String)> {
        let points = self.curve.points.iter().enumerate();
        points
            .filter_map(|(i, p)| Some((i, p.outcome.reason()?.to_owned())))
            .collect()
    }

    /// Writes the files that `ertel solve` writes.
    fn save(&self, py: Python<'_>, folder: PathBuf) -> PyResult<()> {
        crate::pool::detached(py, || {
            output::check_target(&folder)?;
            output::write_curve(&self.echo, &self.curve, &folder, &self.output, self.folders)
        })?
        .map_err(errors::output)
    }
}

/// A case in time.
#[pyclass(frozen)]
pub struct NativeTransient {
    found: TransientSolution,
    echo: CaseEcho,
    output: OutputParams,
    document: String,
}

impl NativeTransient {
    pub fn new(case: &Case, found: TransientSolution) -> PyResult<Self> {
        let echo = case.echo();
        let document = output::transient_json(&echo, &found).map_err(crate::case::unwritable)?;
        Ok(Self {
            document: crate::case::json(&document)?,
            found,
            echo,
            output: case.output.clone(),
        })
    }
}

#[pymethods]
impl NativeTransient {
    /// `transient.json`.
    fn document(&self) -> &str {
        &self.document
    }

    /// `report.txt`.
    fn report(&self) -> String {
        output::transient_report(&self.echo, &self.found, None)
    }

    /// `transient.csv`.
    fn table(&self) -> String {
        output::transient_table(&self.found, self.echo.contact.kind.is_line())
    }

    /// Output times, places along and across the motion.
    fn grid<'py>(&self, py: Python<'py>) -> [Bound<'py, PyArray1<f64>>; 3] {
        let fields = &self.found.fields;
        [&fields.times, &fields.x, &fields.y].map(|values| values.clone().into_pyarray(py))
    }

    /// Pressure and film at the output time with this number, row by row.
    fn fields<'py>(
        &self,
        py: Python<'py>,
        number: usize,
    ) -> Option<[Bound<'py, PyArray1<f32>>; 2]> {
        let fields = &self.found.fields;
        let own = [fields.pressure.get(number)?, fields.film.get(number)?];
        Some(own.map(|values| values.clone().into_pyarray(py)))
    }

    /// `result.nc`.
    fn netcdf<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        let bytes = crate::pool::detached(py, || {
            output::transient::transient_netcdf(&self.echo, &self.found)
        })?;
        Ok(PyBytes::new(py, &bytes))
    }

    /// `animation.png`, if there are output times.
    fn animation<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyBytes>>> {
        let bytes = crate::pool::detached(py, || {
            output::transient::animation(&self.echo.title, &self.found)
        })?;
        let bytes = bytes.map_err(errors::output)?;
        Ok(bytes.map(|bytes| PyBytes::new(py, &bytes)))
    }

    /// Writes the files that `ertel solve` writes.
    fn save(&self, py: Python<'_>, folder: PathBuf) -> PyResult<()> {
        crate::pool::detached(py, || {
            output::check_target(&folder)?;
            output::write_transient(&self.echo, &self.found, &folder, &self.output)
        })?
        .map_err(errors::output)
    }
}
