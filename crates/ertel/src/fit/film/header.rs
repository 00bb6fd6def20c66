//! The columns of a table of films, and the numbers below them.

use ertel_input::csv::{Column, CsvTable, Row};
use ertel_quantity::Dimension;

use crate::fit::DataError;

/// Numbers beyond which no film and no condition of one lies, in SI; their powers stay within floating point.
const LARGEST: f64 = 1e30;
const SMALLEST: f64 = 1e-30;

/// The first of the columns `names` that is there.
///
/// # Errors
///
/// None of them, with `help`; two of one name.
pub(super) fn need(
    table: &CsvTable,
    names: &[&'static str],
    dimension: Dimension,
    help: &str,
) -> Result<Column, DataError> {
    for name in names {
        if let Some(column) = table.find(name, dimension)? {
            return Ok(column);
        }
    }
    let problem = format!(
        "there is no column `{}`{help}; the columns are {}",
        names[0].replace(' ', "_"),
        table.header().cells().join(", ")
    );
    Err(table.error(table.header(), 0, problem))
}

/// A number above zero, or one of zero where that is `allowed`.
///
/// # Errors
///
/// No number, one of zero or below, and one far from anything measured.
pub(super) fn positive(
    table: &CsvTable,
    row: &Row,
    column: &Column,
    allowed: bool,
) -> Result<f64, DataError> {
    let value = table.required_number(row, column)?;
    let problem = if allowed && value == 0.0 {
        return Ok(value);
    } else if value <= 0.0 {
        format!(
            "{}: {value} has no logarithm: it must be above zero",
            column.name
        )
    } else if !(SMALLEST..=LARGEST).contains(&value) {
        format!(
            "{}: {value:e} is far from any film: it must be between {SMALLEST:e} and {LARGEST:e} (SI)",
            column.name
        )
    } else {
        return Ok(value);
    };
    Err(table.error(row, column.index, problem))
}
