//! The one reader of CSV tables: measured states, tables of laws, points of studies, films.
//!
//! The first line that is neither empty nor a comment (`#`) names the columns. Cells are separated by semicolons, tabs or
//! commas, whichever of these the header has first in this order; they may be quoted, directly after the separator. Where
//! commas do not separate, they may be decimal commas. A mark of the byte order at the start is skipped.
//!
//! Columns have their unit in the title: `pressure_MPa`, `pressure [MPa]` or `pressure (MPa)`, with `_per_` for a quotient
//! in the first spelling, `density_kg_per_m3`.

mod title;

use std::borrow::Cow;
use std::ops::Range;

use csv::{ReaderBuilder, StringRecord};

use super::excerpt;
use super::shown::message;
use crate::quantity::{Dimension, Unit};
use title::Title;

/// What is wrong with a table, and where.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{}:{line}:{column}: {}", excerpt(file), message(problem))]
pub struct CsvError {
    /// Name of the file.
    pub file: String,
    /// Line, from 1.
    pub line: usize,
    /// Column of the table, from 1.
    pub column: usize,
    /// What is wrong, with the choices.
    pub problem: String,
}

/// A table of text.
#[derive(Clone, Debug)]
pub struct CsvTable {
    file: String,
    separator: char,
    header: Row,
    rows: Vec<Row>,
}

/// A line of a table.
#[derive(Clone, Debug)]
pub struct Row {
    /// Its number, from 1.
    pub line: usize,
    /// Its bytes in the text, without the end of the line.
    pub span: Range<usize>,
    cells: Vec<String>,
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
}

impl CsvTable {
    /// Reads a table; `file` is the name that errors show.
    ///
    /// # Errors
    ///
    /// [`CsvError`]: no header, a quote that is not closed on its line or stands behind spaces, more cells than columns.
    pub fn parse(file: &str, text: &str) -> Result<Self, CsvError> {
        let at = |line, column, problem: &str| CsvError {
            file: file.to_owned(),
            line,
            column,
            problem: problem.to_owned(),
        };
        let start = text.len() - text.trim_start_matches('\u{feff}').len();
        let Some(head) = (text[start..].lines().map(str::trim)).find(|line| is_data(line)) else {
            return Err(at(1, 1, "the file is empty"));
        };
        let separator = separator(head);
        let mut reader = ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .comment(Some(b'#'))
            .delimiter(separator as u8)
            .from_reader(&text.as_bytes()[start..]);
        let mut rows: Vec<Row> = Vec::new();
        let mut record = StringRecord::new();
        let problem = |error: csv::Error| at(1, 1, &error.to_string());
        // The reader's count takes a line for every record; the text tells how many there are.
        let (mut line, mut counted) = (1, start);
        while reader.read_record(&mut record).map_err(problem)? {
            // Where the record begins, but for empty lines and comments before it, which the reader skips.
            let from = start + record.position().map_or(0, |place| place.byte() as usize);
            let end = start + reader.position().byte() as usize;
            let span = skip_to_data(text, from..end);
            line += text[counted..span.start].matches('\n').count();
            counted = span.start;
            let cells: Vec<String> = record.iter().map(|c| c.trim().to_owned()).collect();
            if !is_data(text[span.clone()].trim()) {
                continue;
            }
            let span = span.start..span.start + text[span].trim_end().len();
            for (i, cell) in cells.iter().enumerate() {
                if record[i].contains('\n') {
                    let problem = "the quote that begins here is not closed on its line";
                    return Err(at(line, i + 1, problem));
                }
                // A quoted cell may begin with a quote of its own, which is doubled in the text.
                let is_quoted = || text[span.clone()].contains(&format!("\"{cell}"));
                if cell.starts_with('"') && !is_quoted() {
                    return Err(at(
                        line,
                        i + 1,
                        "a quote must follow the separator directly",
                    ));
                }
            }
            if let Some(header) = rows.first()
                && let Some(extra) =
                    (header.cells.len()..cells.len()).find(|i| !cells[*i].is_empty())
            {
                let problem = format!(
                    "this line has {} cells, but the header has {}",
                    cells.len(),
                    header.cells.len()
                );
                return Err(at(line, extra + 1, &problem));
            }
            rows.push(Row { line, span, cells });
        }
        let header = rows.remove(0);
        Ok(Self {
            file: file.to_owned(),
            separator,
            header,
            rows,
        })
    }

    /// The line with the titles.
    #[must_use]
    pub fn header(&self) -> &Row {
        &self.header
    }

    /// The lines below the header.
    #[must_use]
    pub fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// An error at a column, from 0, of a line.
    #[must_use]
    pub fn error(&self, row: &Row, index: usize, problem: impl Into<String>) -> CsvError {
        CsvError {
            file: self.file.clone(),
            line: row.line,
            column: index + 1,
            problem: problem.into(),
        }
    }

    /// The column `name` whose unit is one of `dimension`, if there is one.
    ///
    /// # Errors
    ///
    /// Two such columns.
    pub fn find(
        &self,
        name: &'static str,
        dimension: Dimension,
    ) -> Result<Option<Column>, CsvError> {
        let mut found: Option<Column> = None;
        for (index, title) in self.header.cells.iter().enumerate() {
            let Some(title) = Title::of(title, name) else {
                continue;
            };
            let Some(unit) = title.unit_of(dimension) else {
                // Another column whose name begins alike, or one that cannot be told from it.
                if let Some(first) = &found
                    && title.is_exact
                {
                    return Err(self.second(name, first.index, index));
                }
                continue;
            };
            if let Some(first) = &found {
                return Err(self.second(name, first.index, index));
            }
            found = Some(Column { index, name, unit });
        }
        Ok(found)
    }

    fn second(&self, name: &str, first: usize, index: usize) -> CsvError {
        let problem = format!(
            "there is a second column `{name}`; the first is column {}",
            first + 1
        );
        self.error(&self.header, index, problem)
    }

    /// Like [`CsvTable::find`], but a column of that name without a unit, or with another's unit, is an error.
    ///
    /// # Errors
    ///
    /// Two such columns; a unit that is missing, unknown, or measures something else.
    pub fn find_with_unit(
        &self,
        name: &'static str,
        dimension: Dimension,
    ) -> Result<Option<Column>, CsvError> {
        if let Some(column) = self.find(name, dimension)? {
            let exact = |(i, title): (usize, &String)| {
                (i != column.index && Title::of(title, name).is_some_and(|t| t.is_exact))
                    .then_some(i)
            };
            return match self.header.cells.iter().enumerate().find_map(exact) {
                Some(other) => {
                    Err(self.second(name, other.min(column.index), other.max(column.index)))
                }
                None => Ok(Some(column)),
            };
        }
        let titles = self.header.cells.iter().enumerate();
        let named = titles.filter_map(|(i, title)| Some((i, title, Title::of(title, name)?)));
        // The nearest to the name: one with brackets rather than one whose name goes on.
        let Some((index, cell, title)) = named.min_by_key(|(_, _, title)| !title.is_exact) else {
            return Ok(None);
        };
        let units = format!("write one of {}", dimension.examples());
        let problem = if title.unit.is_empty() {
            let si = dimension.si_unit();
            let si = si
                .replace(['.', ' '], "_")
                .replace('/', "_per_")
                .replace('^', "");
            format!(
                "the column `{cell}` has no unit; {units}, as in `{}_{si}`",
                name.replace(' ', "_")
            )
        } else {
            match Unit::parse(&title.unit) {
                Err(error) => format!("the column `{cell}`: {error}; {units}"),
                Ok(unit) => format!(
                    "the column `{cell}` has a unit of {}, but {} is needed; {units}",
                    unit.dimension().name(),
                    dimension.name()
                ),
            }
        };
        Err(self.error(&self.header, index, problem))
    }

    /// The number of a column in a line, in SI; `None` where the cell is empty or the line ends before it.
    ///
    /// # Errors
    ///
    /// A cell that is no number, or one too large.
    pub fn number(&self, row: &Row, column: &Column) -> Result<Option<f64>, CsvError> {
        let cell = row.cell(column.index);
        if cell.is_empty() {
            return Ok(None);
        }
        let number = self.with_point(cell).parse::<f64>();
        let value = number.ok().map(|number| column.unit.to_si(number));
        value
            .filter(|value| value.is_finite())
            .map(Some)
            .ok_or_else(|| {
                let cell = excerpt(cell);
                let problem = format!(
                    "{}: `{cell}` is not a number (write 1.5 or 2e-3)",
                    column.name
                );
                self.error(row, column.index, problem)
            })
    }

    /// A cell with a point in place of a decimal comma, if it is a number with one.
    #[must_use]
    pub fn with_point<'a>(&self, cell: &'a str) -> Cow<'a, str> {
        if self.separator == ',' || cell.contains('.') {
            return Cow::Borrowed(cell);
        }
        let point = cell.replacen(',', ".", 1);
        match point.parse::<f64>() {
            Ok(_) => Cow::Owned(point),
            Err(_) => Cow::Borrowed(cell),
        }
    }

    /// The bytes of a cell in the text that was read; those of the line where it is quoted.
    #[must_use]
    pub fn cell_span(&self, text: &str, row: &Row, index: usize) -> Range<usize> {
        let line = &text[row.span.clone()];
        let Some(cell) = line.split(self.separator).nth(index) else {
            return row.span.clone();
        };
        if line.contains('"') {
            return row.span.clone();
        }
        let start = row.span.start + (cell.as_ptr() as usize - line.as_ptr() as usize);
        let start = start + (cell.len() - cell.trim_start().len());
        start..start + cell.trim().len()
    }

    /// The same of a number that must be there.
    ///
    /// # Errors
    ///
    /// An empty cell, too.
    pub fn required_number(&self, row: &Row, column: &Column) -> Result<f64, CsvError> {
        self.number(row, column)?.ok_or_else(|| {
            let problem = if column.index < row.cells.len() {
                format!("{}: the cell is empty", column.name)
            } else {
                format!(
                    "{}: there are only {} cells in this line",
                    column.name,
                    row.cells.len()
                )
            };
            self.error(row, column.index, problem)
        })
    }
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

/// Whether a line, without spaces around, is neither empty nor a comment.
fn is_data(line: &str) -> bool {
    !line.is_empty() && !line.starts_with('#')
}

/// What separates the cells of a header.
fn separator(head: &str) -> char {
    let outside: String = head.split('"').step_by(2).collect();
    let separators = [';', '\t', ','];
    let found = separators.into_iter().find(|c| outside.contains(*c));
    found.unwrap_or(',')
}

/// The bytes of a record without the empty lines and comments before it.
fn skip_to_data(text: &str, mut span: Range<usize>) -> Range<usize> {
    while let Some(end) = text[span.clone()].find('\n') {
        if is_data(text[span.start..span.start + end].trim()) {
            break;
        }
        span.start += end + 1;
    }
    span
}

#[cfg(test)]
mod tests;
