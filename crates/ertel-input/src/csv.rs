//! The one reader of tables: measured states, tables of laws, points of studies, films, exports of instruments.
//!
//! A table is read as spreadsheets and instruments write it. The line with the most titles that are known names the columns;
//! lines before it are those of an instrument, a line of units may follow it. Empty lines and comments (`#`, `%`, `//`, `!`) are
//! skipped. Cells are separated by semicolons, tabs, commas or blanks, whichever gives the most titles, or as a line `sep=;`
//! says; they may be quoted. Decimal commas and marks between thousands are recognised from the cells.
//!
//! Columns have their unit in the title: `pressure_MPa`, `pressure [MPa]`, `pressure (MPa)`, `pressure / MPa`, `pressure in MPa`,
//! `p, MPa`, with `_per_` for a quotient in the first spelling, `density_kg_per_m3`. Quantities have English and German names and
//! symbols.

mod header;
mod names;
mod number;
mod params;
mod series;
mod split;
mod table;
mod title;

use std::borrow::Cow;
use std::ops::Range;

use super::excerpt;
use ertel_quantity::{Dimension, Unit};
use header::{Head, NoHead};
use names::Match;
use number::Marks;
pub use number::{Decimal, is_missing};
pub use params::{ColumnMap, CsvParams, Vocabulary};
pub use series::Wanted;
use split::{Records, Separator, is_comment};
pub use table::{Column, CsvError, CsvTable, Row};
use title::{NamedUnit, Title};

/// Bytes of a line at most, some thousand columns: the search for the titles keeps the cells of some hundred lines.
const LONGEST_LINE: usize = 32_768;

/// Line, column and words of an error.
type Problem = (usize, usize, String);

const OPEN_QUOTE: &str = "the quote that begins here is not closed on its line";

impl CsvTable {
    /// Reads a table whose first line names the columns; `file` is the name that errors show.
    ///
    /// # Errors
    ///
    /// [`CsvError`]: no header, a quote that is not closed, more cells than columns.
    pub fn parse(file: &str, text: &str) -> Result<Self, CsvError> {
        Self::parse_for(file, text, &Vocabulary::NONE, &CsvParams::default())
    }

    /// Reads a table that is a part of a file and begins with its header, at a line of the file, from 1.
    ///
    /// # Errors
    ///
    /// As [`CsvTable::parse`].
    pub fn parse_part(file: &str, text: &str, line: usize) -> Result<Self, CsvError> {
        let before = line.saturating_sub(1);
        let mut table = Self::parse(file, text).map_err(|mut error| {
            error.line += before;
            error
        })?;
        table.header.line += before;
        table.rows.iter_mut().for_each(|row| row.line += before);
        Ok(table)
    }

    /// Reads a table whose columns may be those of a vocabulary, with the options of the user.
    ///
    /// # Errors
    ///
    /// As [`CsvTable::parse`]; two lines that may both be the header; columns that the user names and that are not there.
    pub fn parse_for(
        file: &str,
        text: &str,
        vocabulary: &Vocabulary<'_>,
        params: &CsvParams,
    ) -> Result<Self, CsvError> {
        let at = |line, column, problem: &str| CsvError {
            file: file.to_owned(),
            line,
            column,
            problem: problem.to_owned(),
        };
        let long = text.split('\n').position(|line| line.len() > LONGEST_LINE);
        if let Some(i) = long {
            let problem = format!(
                "the line has more than {LONGEST_LINE} bytes, the most that a line of a table has: is it one without line breaks?"
            );
            return Err(at(i + 1, 1, &problem));
        }
        let head = header::find(text, header::start_of(text), vocabulary, params).map_err(
            |none| match none {
                NoHead::Empty => at(1, 1, "the file is empty"),
                NoHead::Quote(line, place) => at(line, place + 1, OPEN_QUOTE),
                NoHead::Two(first, second) => {
                    let problem = format!(
                        "lines {first} and {second} may both name the columns; take one of them out"
                    );
                    at(second, 1, &problem)
                }
            },
        )?;
        let (titles, rows) = Self::read_rows(text, &head)
            .map_err(|(line, column, problem)| at(line, column, &problem))?;
        let mut marks = Marks::new(params.decimal);
        for row in &rows {
            row.cells.iter().for_each(|cell| marks.see(cell));
        }
        let mut table = Self {
            file: file.to_owned(),
            separator: head.separator,
            is_ignored: vec![false; head.row.cells.len()],
            header: head.row,
            titles,
            rows,
            marks,
            notes: Vec::new(),
        };
        table.apply(params, vocabulary)?;
        table.check_untitled()?;
        Ok(table)
    }

    /// The titles of the columns, with the units of a separate line, and the rows below.
    fn read_rows(text: &str, head: &Head) -> Result<(Vec<String>, Vec<Row>), Problem> {
        let header = &head.row;
        let n_columns = header.cells.len();
        let mut titles = header.cells.clone();
        let mut rows: Vec<Row> = Vec::new();
        // A line of units is looked at together with the one below it.
        let mut first: Option<Row> = None;
        for record in Records::new(text, head.rest.0, head.rest.1, head.separator) {
            if is_comment(&text[record.span.clone()]) {
                continue;
            }
            let line = record.line;
            let cells = record
                .cells
                .map_err(|place| (line, place + 1, OPEN_QUOTE.to_owned()))?;
            let mut cells: Vec<String> = cells
                .into_iter()
                .map(|(_, cell)| cell.into_owned())
                .collect();
            if cells.iter().all(String::is_empty) || cells == header.cells {
                continue;
            }
            if let Some(extra) = (n_columns..cells.len()).find(|i| !cells[*i].is_empty()) {
                let problem = too_many(&cells, n_columns, head.separator);
                return Err((line, extra + 1, problem));
            }
            cells.truncate(n_columns);
            let row = Row {
                line,
                span: record.span,
                cells,
            };
            if rows.is_empty() && first.is_none() {
                first = Some(row);
                continue;
            }
            if let Some(above) = first.take() {
                match header::with_units(&titles, &above, Some(&row)) {
                    Some(with_units) => titles = with_units,
                    None => rows.push(above),
                }
            }
            rows.push(row);
        }
        rows.extend(first);
        Ok((titles, rows))
    }

    /// Numbers without a title are those of a column that was forgotten, or the decimals of the one before. The first column may
    /// count the lines.
    fn check_untitled(&self) -> Result<(), CsvError> {
        let untitled = (1..self.titles.len())
            .filter(|i| self.header.cells[*i].is_empty() && self.titles[*i].is_empty());
        for index in untitled.filter(|i| !self.is_ignored[*i]) {
            if let Some(row) = self
                .rows
                .iter()
                .find(|row| number::is_number(row.cell(index)))
            {
                let problem = format!(
                    "the column has no title, but holds `{}`; give it one, or quote numbers with a decimal comma where commas separate",
                    excerpt(row.cell(index))
                );
                return Err(self.error(row, index, problem));
            }
        }
        Ok(())
    }

    /// The line with the titles.
    #[must_use]
    pub fn header(&self) -> &Row {
        &self.header
    }

    /// Title of a column as it is read; empty where it has none, and of an ignored column.
    #[must_use]
    pub fn title(&self, index: usize) -> &str {
        self.titles.get(index).map_or("", String::as_str)
    }

    /// Whether a column is ignored: it is empty, it counts the lines, or the user says so.
    #[must_use]
    pub fn is_ignored(&self, index: usize) -> bool {
        self.is_ignored.get(index).is_none_or(|ignored| *ignored)
            || self.header.cell(index).is_empty()
    }

    /// Notes on ignored columns and assumptions.
    #[must_use]
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// Whether a cell marks a missing value: it is empty, `-`, `n/a`, `NaN`.
    #[must_use]
    pub fn is_missing(&self, row: &Row, index: usize) -> bool {
        number::is_missing(row.cell(index))
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

    /// The column `name` whose unit is one of `dimension`, if there is one: by that name, another one or a symbol of the quantity.
    ///
    /// # Errors
    ///
    /// Two such columns.
    pub fn find(
        &self,
        name: &'static str,
        dimension: Dimension,
    ) -> Result<Option<Column>, CsvError> {
        self.find_except(name, dimension, &[])
    }

    /// The same, without some columns.
    ///
    /// # Errors
    ///
    /// Two such columns.
    pub fn find_except(
        &self,
        name: &'static str,
        dimension: Dimension,
        others: &[usize],
    ) -> Result<Option<Column>, CsvError> {
        let mut found: Vec<(usize, NamedUnit, Match)> = Vec::new();
        // Ambiguous columns: without a unit, or with an unknown one.
        let mut alike: Vec<usize> = Vec::new();
        let is_pure = dimension.same_exponents(Dimension::DIMENSIONLESS);
        for index in (0..self.titles.len()).filter(|i| !others.contains(i)) {
            let titles = Title::all(&self.titles[index], name);
            let fit = titles
                .iter()
                .find_map(|t| Some((t.unit_of(dimension)?, t.name)));
            match fit {
                Some((unit, sure)) => found.push((index, unit, sure)),
                None if titles.iter().any(|t| {
                    t.name == Match::Name
                        && t.is_exact
                        && (t.unit.is_none() || (t.is_bare() && !is_pure))
                }) =>
                {
                    alike.push(index);
                }
                None => {}
            }
        }
        if found.iter().any(|(_, _, sure)| *sure != Match::Open) {
            found.retain(|(_, _, sure)| *sure != Match::Open);
        }
        let Some((index, unit, sure)) = found.first() else {
            return Ok(None);
        };
        let places = found.iter().map(|(index, _, _)| *index).chain(alike);
        if let Some(other) = places.filter(|other| other != index).min() {
            return Err(self.second(name, other.min(*index), other.max(*index)));
        }
        Ok(Some(Column {
            index: *index,
            name,
            unit: unit.unit,
            unit_text: unit.text.clone(),
            is_open: *sure == Match::Open,
        }))
    }

    /// The first column with a unit of `dimension` in its title, whatever its name.
    #[must_use]
    pub fn first_with_unit(&self, dimension: Dimension) -> Option<usize> {
        let titles = self.titles.iter().enumerate();
        let mut titles = titles.filter(|(index, _)| !self.is_ignored(*index));
        titles
            .find(|(_, title)| title::unit_with(title, dimension).is_some())
            .map(|(index, _)| index)
    }

    fn second(&self, name: &str, first: usize, index: usize) -> CsvError {
        let problem = format!(
            "`{}` is a second column `{name}`; the first is column {}, `{}`; choose one: `--column \"{name}=#{}\"`",
            excerpt(self.header.cell(index)),
            first + 1,
            excerpt(self.header.cell(first)),
            index + 1
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
            return Ok(Some(column));
        }
        // A longer name may be that of another column.
        let is_near = |title: &Title| title.is_exact || title.name == Match::Name;
        self.without_unit(name, dimension, &[], &is_near)
    }

    /// The column of pressures, and whether they are absolute; `None` if there is none.
    ///
    /// # Errors
    ///
    /// As [`CsvTable::find_with_unit`]; columns of both kinds.
    pub fn find_pressure(&self) -> Result<Option<(Column, bool)>, CsvError> {
        let (gauge, absolute) = ("pressure", "absolute pressure");
        // By its unit first: a pressure without one may be the absolute one.
        let Some(second) = self.find(absolute, Dimension::PRESSURE)? else {
            if let Some(column) = self.find_with_unit(gauge, Dimension::PRESSURE)? {
                return Ok(Some((column, false)));
            }
            let column = self.find_with_unit(absolute, Dimension::PRESSURE)?;
            return Ok(column.map(|column| (column, true)));
        };
        match self.find(gauge, Dimension::PRESSURE)? {
            Some(_) => {
                let problem = "give `pressure` or `absolute pressure`, not both".to_owned();
                Err(self.error(&self.header, second.index, problem))
            }
            None => Ok(Some((second, true))),
        }
    }

    /// The column `name`, without some others; one that has this name and no more, but no unit or another's unit, is an error.
    ///
    /// # Errors
    ///
    /// As [`CsvTable::find_with_unit`].
    pub fn find_with_unit_except(
        &self,
        name: &'static str,
        dimension: Dimension,
        others: &[usize],
    ) -> Result<Option<Column>, CsvError> {
        if let Some(column) = self.find_except(name, dimension, others)? {
            return Ok(Some(column));
        }
        self.without_unit(name, dimension, others, &|title| title.is_exact)
    }

    /// The error about a column of that name without a unit that fits; `None` where there is none.
    fn without_unit(
        &self,
        name: &'static str,
        dimension: Dimension,
        others: &[usize],
        is_near: &dyn Fn(&Title) -> bool,
    ) -> Result<Option<Column>, CsvError> {
        let titles = self.titles.iter().enumerate();
        let titles = titles.filter(|(index, _)| !others.contains(index));
        let named = titles.flat_map(|(i, cell)| {
            let own = Title::all(cell, name).into_iter();
            own.map(move |title| (i, title))
        });
        // A symbol with another's unit is that of another quantity: `t [s]` is a time.
        let is_other =
            |title: &Title| title.name == Match::Symbol && title.unit.is_some() && !title.is_bare();
        let named = named.filter(|(_, title)| is_near(title) && !is_other(title));
        // The nearest to the name: one with brackets rather than a longer name.
        let nearest = named.min_by_key(|(_, title)| {
            (
                !title.is_exact,
                std::cmp::Reverse(title.name),
                title.is_bare(),
            )
        });
        let Some((index, title)) = nearest else {
            return Ok(None);
        };
        let cell = excerpt(self.header.cell(index));
        let units = format!("write one of {}", dimension.examples());
        let problem = if title.is_bare() {
            let si = dimension.si_unit();
            let si = si
                .replace(['.', ' '], "_")
                .replace('/', "_per_")
                .replace('^', "");
            format!(
                "the column `{cell}` has no unit; {units}, as in `{}_{si}`, or specify it: `--column \"{name}={cell}:{}\"`",
                name.replace(' ', "_"),
                dimension.si_unit()
            )
        } else {
            match Unit::parse(&title.given) {
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

    /// The number of a column in a line, in SI; `None` where the cell is empty, says that nothing was measured, or the
    /// line ends before it.
    ///
    /// # Errors
    ///
    /// A cell that is no number, or one too large.
    pub fn number(&self, row: &Row, column: &Column) -> Result<Option<f64>, CsvError> {
        let cell = row.cell(column.index);
        if number::is_missing(cell) {
            return Ok(None);
        }
        let number = self.marks.read(cell).map_err(|problem| {
            self.error(row, column.index, format!("{}: {problem}", column.name))
        })?;
        let number = number.and_then(|number| number.parse::<f64>().ok());
        let value = number.map(|number| column.unit.to_si(number));
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

    /// A cell as a case has it: with a decimal point and nothing between thousands, if it is an unambiguous number.
    #[must_use]
    pub fn with_point<'a>(&self, cell: &'a str) -> Cow<'a, str> {
        match self.marks.read(cell) {
            Ok(Some(number)) => number,
            Ok(None) | Err(_) => Cow::Borrowed(cell),
        }
    }

    /// The bytes of a cell in the text that was read; those of the line where the cell is not found there.
    #[must_use]
    pub fn cell_span(&self, text: &str, row: &Row, index: usize) -> Range<usize> {
        header::cell_span(text, row, index, self.separator)
    }

    /// The same of a number that must be there.
    ///
    /// # Errors
    ///
    /// An empty cell, too.
    pub fn required_number(&self, row: &Row, column: &Column) -> Result<f64, CsvError> {
        self.number(row, column)?.ok_or_else(|| {
            let cell = row.cell(column.index);
            let problem = if !cell.is_empty() {
                format!("{}: `{}` is not a number", column.name, excerpt(cell))
            } else if column.index < row.cells.len() {
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

/// Names and units that a title may consist of, those that are certain first: `contact.load` and `N` of `contact.load [N]`. The
/// unit is written as a quantity has it, and empty where the title is a name alone.
#[must_use]
pub fn key_titles(title: &str) -> Vec<(String, String)> {
    let readings = title::readings(title).into_iter();
    readings
        .filter_map(|reading| {
            let unit = title::unit_of(&reading.unit).filter(|unit| unit.zero.is_none())?;
            let is_alone = reading.unit.is_empty() || !unit.text.is_empty() || reading.is_exact;
            is_alone.then(|| (reading.name.into_owned(), unit.text))
        })
        .collect()
}

/// `line 3`, or `lines 3, 5 and 7`; of many lines the first ones, and how many more there are.
#[must_use]
pub fn line_list(lines: &[usize]) -> String {
    const SHOWN: usize = 8;
    let shown: Vec<String> = lines.iter().take(SHOWN).map(usize::to_string).collect();
    match (shown.split_last(), lines.len().saturating_sub(SHOWN)) {
        (None, _) => "no line".to_owned(),
        (Some((last, [])), 0) => format!("line {last}"),
        (Some((last, first)), 0) => format!("lines {} and {last}", first.join(", ")),
        (Some(_), more) => format!("lines {} and {more} more", shown.join(", ")),
    }
}

/// Why a line has more cells than the header.
fn too_many(cells: &[String], n_columns: usize, separator: Separator) -> String {
    let problem = format!(
        "this line has {} cells, but the header has {n_columns}",
        cells.len()
    );
    match separator {
        Separator::Char(',') if cells.iter().all(|cell| number::is_number(cell)) => {
            format!(
                "{problem}; where commas separate cells, numbers with a decimal comma must be quoted"
            )
        }
        Separator::Char(_) | Separator::WideBlanks | Separator::Blanks => problem,
    }
}

#[cfg(test)]
mod tests;
