//! The module `ertel._ertel`: what the Python package `ertel` asks of the solver. Its users see `ertel` alone.

mod case;
mod compare;
mod data;
mod errors;
mod machine;
mod pool;
mod read;
mod solution;
mod solve;
mod study;

use ertel::case::{LEAST_MAP_POINTS, MOST_MAP_POINTS};
use pyo3::prelude::*;

/// The functions and classes behind the package `ertel`.
#[pymodule]
fn _ertel(module: &Bound<'_, PyModule>) -> PyResult<()> {
    let py = module.py();
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add("MAP_POINTS", (LEAST_MAP_POINTS, MOST_MAP_POINTS))?;
    module.add("CaseError", py.get_type::<errors::CaseError>())?;
    module.add(
        "ConvergenceError",
        py.get_type::<errors::ConvergenceError>(),
    )?;
    module.add("OutputError", py.get_type::<errors::OutputError>())?;
    module.add_class::<case::NativeCase>()?;
    module.add_class::<solution::NativeSolution>()?;
    module.add_class::<solution::NativeCurve>()?;
    module.add_class::<solution::NativeTransient>()?;
    module.add_class::<machine::NativeMachine>()?;
    module.add_class::<study::NativeStudy>()?;
    module.add_function(wrap_pyfunction!(solve::solve, module)?)?;
    module.add_function(wrap_pyfunction!(solve::solve_curve, module)?)?;
    module.add_function(wrap_pyfunction!(solve::solve_transient, module)?)?;
    module.add_function(wrap_pyfunction!(solve::solve_machine, module)?)?;
    module.add_function(wrap_pyfunction!(study::solve_part, module)?)?;
    module.add_function(wrap_pyfunction!(study::sweep, module)?)?;
    module.add_function(wrap_pyfunction!(study::merge, module)?)?;
    module.add_function(wrap_pyfunction!(compare::compare, module)?)?;
    module.add_function(wrap_pyfunction!(compare::fit_stribeck, module)?)?;
    module.add_function(wrap_pyfunction!(data::explanation, module)?)?;
    module.add_function(wrap_pyfunction!(data::names, module)?)?;
    module.add_function(wrap_pyfunction!(data::viscosity, module)?)?;
    module.add_function(wrap_pyfunction!(data::interpolated, module)?)?;
    module.add_function(wrap_pyfunction!(data::use_own_data, module)?)?;
    module.add_function(wrap_pyfunction!(data::table_text, module)?)?;
    module.add_function(wrap_pyfunction!(data::fit_law, module)?)?;
    module.add_function(wrap_pyfunction!(data::fit_film, module)?)?;
    module.add_function(wrap_pyfunction!(data::fluid, module)?)?;
    module.add_function(wrap_pyfunction!(data::field_names, module)?)?;
    module.add_function(wrap_pyfunction!(data::figure_names, module)?)?;
    module.add_function(wrap_pyfunction!(read::fields_on_grid, module)?)?;
    module.add_function(wrap_pyfunction!(read::contact_grid, module)?)?;
    module.add_function(wrap_pyfunction!(read::netcdf_bytes, module)?)?;
    module.add_function(wrap_pyfunction!(read::study_table, module)?)?;
    module.add_function(wrap_pyfunction!(read::palette, module)?)?;
    Ok(())
}
