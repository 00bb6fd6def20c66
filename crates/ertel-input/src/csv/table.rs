//! A table of text, its lines and columns, and the error at a cell.

use std::ops::Range;

use super::number::Marks;
use super::split::Separator;
use crate::excerpt;
use crate::shown::message;
use ertel_quantity::Unit;

/// Error in a table, with its place.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{}:{line}:{column}: {}", excerpt(file), message(problem))]
pub struct CsvError {
    /// Name of the file.
    pub file: String,
    /// Line, from 1.
    pub line: usize,
    /// Column of the table, from 1.
    pub column: usize,
    /// The problem, with the choices.
    pub problem: String,
}

/// A table of text.
#[derive(Clone, Debug)]
pub struct CsvTable {
    pub(super) file: String,
    pub(super) separator: Separator,
    pub(super) header: Row,
    /// The titles as they are read: with the units of a line of units, and as the user maps them.
    pub(super) titles: Vec<String>,
    /// Ignored columns.
    pub(super) is_ignored: Vec<bool>,
    pub(super) rows: Vec<Row>,
    pub(super) marks: Marks,
    pub(super) notes: Vec<String>,
}

/// A line of a table.
#[derive(Clone, Debug)]
pub struct Row {
    /// Its number, from 1.
    pub line: usize,
    /// Its bytes in the text, without the end of the line.
    pub span: Range<usize>,
    pub(super) cells: Vec<String>,
}

/// A column of numbers with a unit.
#[derive(Clone, Debug)]
pub struct Column {
    /// Its place, from 0.
    pub index: usize,
    /// Its name, without the unit.
    pub name: &'static str,
    /// Its unit.
    pub unit: Unit,
    /// Its unit as a quantity in a case has it; empty for a plain number.
    pub unit_text: String,
    /// Whether its title leaves open which quantity of its kind it is, as `film` does.
    pub is_open: bool,
}

impl Row {
    /// The cells, without spaces and quotes around them.
    #[must_use]
    pub fn cells(&self) -> &[String] {
        &self.cells
    }

    /// A cell; empty where the line ends before it.
    #[must_use]
    pub fn cell(&self, index: usize) -> &str {
        self.cells.get(index).map_or("", String::as_str)
    }
}
