//! Measured films and tractions compared with computed ones.
//!
//! A table of measurements ([`Measured`]) says at which speeds, loads, slide-to-roll ratios and temperatures a contact was
//! measured, and what was found. These rows make a [`Study`] of a case; its results make a [`Comparison`].
//!
//! ```text
//! table ─► Measured { rows, study } ─► sweep ─► records ─► Comparison { rows, statistics }
//! ```

mod columns;
mod comparison;
mod measured;
mod rig;
mod speeds;
mod statistics;
mod table;
mod turned;

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use ertel_input::csv::{CsvError, CsvParams};
use ertel_input::file::{FileError, read_table};
use ertel_input::{Document, InputError};

use crate::case::Study;
use crate::case::study::PointColumn;
use crate::study::journal::PointKey;

use measured::Content;

pub use comparison::{ComparedRow, Comparison, Outcome};
pub use measured::{
    Measurand, Measured, MeasuredRow, Measurement, N_MEASURANDS, Probe, ReadParams,
};
pub use statistics::{Compared, Statistics};

/// Why measurements were not read.
#[derive(Debug, thiserror::Error)]
pub enum MeasuredError {
    /// The file cannot be read.
    #[error("{} {source}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// Why.
        source: FileError,
    },
    /// The table is wrong.
    #[error(transparent)]
    Table(#[from] CsvError),
    /// A figure was measured that the case does not have.
    #[error("{}: `{figure}` is a figure of {of}, and the case is {case}", path.display())]
    NoSuchFigure {
        /// The file.
        path: PathBuf,
        /// Name of its column.
        figure: &'static str,
        /// Kind of case that has it.
        of: &'static str,
        /// Kind of the case.
        case: &'static str,
    },
    /// A point is no case that can be solved, or the base case is wrong.
    #[error(transparent)]
    Case(#[from] InputError),
}

impl Measured {
    /// Reads the measurements in the file `path`, a table or an export of a rig, and the case `base` at each of their points.
    ///
    /// # Errors
    ///
    /// [`MeasuredError`] with file, line and column: of the file itself, and of every point that the case refuses.
    pub fn read(base: &Path, path: &Path, params: &ReadParams) -> Result<Self, MeasuredError> {
        let text = read_table(path).map_err(|source| MeasuredError::File {
            path: path.to_owned(),
            source,
        })?;
        // The key of the temperature depends on how the case names its lubricant.
        let case = Document::read(base)?;
        let given = match case.root().optional_table("compare")? {
            Some(table) => CsvParams::of_table(table)?,
            None => CsvParams::default(),
        };
        let params = &ReadParams {
            table: given.with(&params.table),
            ..params.clone()
        };
        let file = path.display().to_string();
        let mut content = match rig::is_export(&text) {
            true => rig::read(&case, &file, &text, params)?,
            false => table::read(&case, &file, &text, params)?,
        };
        let set = content.columns.iter().map(|column| {
            let title = text[column.span.clone()].trim().to_owned();
            (title, format!("sets {}", column.key))
        });
        let used = set.chain(std::mem::take(&mut content.measured)).collect();
        let replaced = speeds::replace(&case, &mut content);
        let Content {
            columns,
            rows,
            notes,
            ..
        } = content;
        // Most rows of a rig repeat others: each case is read once.
        let (columns, written) = distinct_rows(columns);
        let mut study = Study::of_points(base, &replaced, path, &text, columns)?;
        let same = distinct(&mut study);
        let point_of_row = written.into_iter().map(|point| same[point]);
        check_figures(path, &study, &rows)?;
        let row = |((line, figures), point): ((usize, _), usize)| MeasuredRow {
            line,
            point,
            figures,
        };
        Ok(Self {
            file: path.to_owned(),
            rows: rows.into_iter().zip(point_of_row).map(row).collect(),
            study,
            notes,
            used,
            case_text: case.text().to_owned(),
        })
    }

    /// Whether any row has a figure.
    pub fn has(&self, figure: Measurand) -> bool {
        let index = figure as usize;
        self.rows.iter().any(|row| row.figures[index].is_some())
    }
}

/// Rejects figures of whole machines for a single contact, and vice versa.
fn check_figures(
    path: &Path,
    study: &Study,
    rows: &[(usize, [Option<Measurement>; N_MEASURANDS])],
) -> Result<(), MeasuredError> {
    let is_machine = study.points.iter().all(|p| p.case.whole.is_some());
    let (contact, machine) = ("a single contact", "a whole machine");
    for figure in Measurand::ALL {
        let has = match is_machine {
            true => figure.is_of_machines(),
            false => figure.is_of_contacts(),
        };
        let was_measured = |(_, figures): &(usize, [Option<Measurement>; N_MEASURANDS])| {
            figures[figure as usize].is_some()
        };
        if !has && rows.iter().any(was_measured) {
            let [of, case] = if is_machine {
                [contact, machine]
            } else {
                [machine, contact]
            };
            return Err(MeasuredError::NoSuchFigure {
                path: path.to_owned(),
                figure: figure.name(),
                of,
                case,
            });
        }
    }
    Ok(())
}

/// Keeps the first of identical rows; returns the index of the kept row for each.
fn distinct_rows(mut columns: Vec<PointColumn>) -> (Vec<PointColumn>, Vec<usize>) {
    let n_rows = columns.first().map_or(0, |column| column.values.len());
    let mut seen: HashMap<String, usize> = HashMap::new();
    let mut is_first = Vec::with_capacity(n_rows);
    let mut index = Vec::with_capacity(n_rows);
    for i in 0..n_rows {
        let values = columns
            .iter()
            .map(|column| format!("{:?}\n", column.values[i].1));
        let next = seen.len();
        let place = *seen.entry(values.collect()).or_insert(next);
        is_first.push(place == next);
        index.push(place);
    }
    for column in &mut columns {
        let mut first = is_first.iter();
        column.values.retain(|_| first.next() == Some(&true));
    }
    (columns, index)
}

/// Keeps the first of identical points of a study; returns the index of the kept point for each.
fn distinct(study: &mut Study) -> Vec<usize> {
    let mut seen: HashMap<PointKey, usize> = HashMap::new();
    let mut kept = Vec::new();
    let mut index = Vec::new();
    for point in std::mem::take(&mut study.points) {
        let next = kept.len();
        let place = *seen.entry(PointKey::new(&point.case)).or_insert(next);
        if place == next {
            kept.push(point);
        }
        index.push(place);
    }
    study.points = kept;
    index
}

#[cfg(test)]
mod table_tests;
#[cfg(test)]
mod tests;
