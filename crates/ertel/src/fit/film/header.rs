//! The header of a table of films, and the numbers below it.

use ertel_rheology::quantity::{Dimension, Unit};

use crate::fit::DataError;
use crate::fit::data::{Column, unit_text};

/// The header of a table.
pub(super) struct Header<'a> {
    pub(super) file: &'a str,
    pub(super) line: usize,
    pub(super) cells: Vec<&'a str>,
}

impl Header<'_> {
    pub(super) fn error(&self, line: usize, column: usize, problem: String) -> DataError {
        DataError {
            file: self.file.to_owned(),
            line,
            column,
            problem,
        }
    }

    pub(super) fn find(&self, name: &'static str, dimension: Dimension) -> Option<Column> {
        self.cells.iter().enumerate().find_map(|(index, cell)| {
            let unit = Unit::parse(&unit_text(cell, name)?).ok()?;
            let fits = unit.dimension().same_exponents(dimension);
            fits.then_some(Column { index, name, unit })
        })
    }

    pub(super) fn need(
        &self,
        names: &[&'static str],
        dimension: Dimension,
        help: &str,
    ) -> Result<Column, DataError> {
        let found = names.iter().find_map(|name| self.find(name, dimension));
        found.ok_or_else(|| {
            let problem = format!(
                "there is no column `{}`{help}; the columns are {}",
                names[0].replace(' ', "_"),
                self.cells.join(", ")
            );
            self.error(self.line, 1, problem)
        })
    }

    /// A number above zero, or one of zero where that is `allowed`.
    pub(super) fn positive(
        &self,
        line: usize,
        cells: &[&str],
        column: &Column,
        allowed: bool,
    ) -> Result<f64, DataError> {
        let value = column
            .number(cells)
            .map_err(|(column, problem)| self.error(line, column, problem))?;
        if value > 0.0 || (allowed && value == 0.0) {
            return Ok(value);
        }
        let problem = format!(
            "{}: {value} has no logarithm: it must be above zero",
            column.name
        );
        Err(self.error(line, column.index + 1, problem))
    }
}
