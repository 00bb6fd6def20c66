//! Plain tables: a column for each quantity that was set, one for each figure that was measured.

use ertel_rheology::input::Document;
use ertel_rheology::input::csv::{Column, CsvError, CsvTable, Row};
use ertel_rheology::quantity::Dimension;

use super::columns::{MEASURED, MeasuredColumns, OPERATING, TEMPERATURE, find, uncertainty};
use super::{Content, Figure, Measurement, ReadParams, column, temperature_key};
use crate::case::study::{PointColumn, split_title};

/// Columns of words about a row.
const WORDS: [&str; 2] = ["comment", "note"];

/// What a table may have, for messages.
const CHOICES: &str = "quantities are `entrainment_speed`, `slide_to_roll_ratio`, `load`, `temperature`, and any key of the case, \
    such as `contact.radius`; measured are `film_central`, `film_minimum`, `traction_coefficient`, each with \
    `_uncertainty` if known; all with their units, as in `film_central_nm` or `film_central [nm]`; a `comment` is skipped";

/// Thickest film that is believed, m: beyond it the unit was mistaken.
const THICKEST_FILM: f64 = 1e-2;
/// Largest traction coefficient that is believed.
const LARGEST_TRACTION: f64 = 10.0;

/// Reads a table.
pub(super) fn read(
    case: &Document,
    file: &str,
    text: &str,
    params: &ReadParams,
) -> Result<Content, CsvError> {
    let table = CsvTable::parse(file, text).map_err(|mut error| {
        if error.problem.contains("empty") {
            error.problem += &format!("; {CHOICES}");
        }
        error
    })?;
    let header = table.header();
    let mut known: Vec<usize> = Vec::new();
    for name in &params.ignored {
        let titles = header.cells().iter().enumerate();
        let found = titles.filter(|(_, title)| *title == name).map(|(i, _)| i);
        let before = known.len();
        known.extend(found);
        if known.len() == before {
            let problem = format!(
                "there is no column `{name}` to be ignored; the columns are {}",
                header.cells().join(", ")
            );
            return Err(table.error(header, 0, problem));
        }
    }
    let mut operating: Vec<(PointColumn, Column)> = Vec::new();
    for (names, key, dimensions) in OPERATING {
        let key = if key == TEMPERATURE {
            temperature_key(case)
        } else {
            key
        };
        if let Some(found) = find(&table, names, dimensions, &known)? {
            known.push(found.index);
            let span = table.cell_span(text, header, found.index);
            operating.push((column(key, span), found));
        }
    }
    let mut measured = Vec::new();
    for (figure, (names, uncertainties, dimension)) in Figure::ALL.into_iter().zip(MEASURED) {
        let uncertainty = uncertainty(&table, uncertainties, dimension, &known)?;
        known.extend(uncertainty.iter().map(|u| u.column.index));
        match (find(&table, names, &[dimension], &known)?, uncertainty) {
            (Some(value), uncertainty) => {
                known.push(value.index);
                measured.push(MeasuredColumns {
                    figure,
                    value,
                    uncertainty,
                });
            }
            (None, Some(uncertainty)) => {
                let problem = format!("the uncertainty of `{}` stands without it", figure.name());
                return Err(table.error(header, uncertainty.column.index, problem));
            }
            (None, None) => {}
        }
    }
    let keys = keys(case, &table, text, &mut known, &operating)?;
    if measured.is_empty() {
        let problem = format!("no column is a measured figure; {CHOICES}");
        return Err(table.error(header, 0, problem));
    }
    if operating.is_empty() && keys.is_empty() {
        let problem = format!("no column says what was varied; {CHOICES}");
        return Err(table.error(header, 0, problem));
    }
    rows(&table, text, operating, keys, &measured)
}

/// A column that is a key of the case: where it stands, and its unit.
type KeyColumn = (PointColumn, usize, String);

/// The columns that are keys of the case; all others must be known.
fn keys(
    case: &Document,
    table: &CsvTable,
    text: &str,
    known: &mut Vec<usize>,
    operating: &[(PointColumn, Column)],
) -> Result<Vec<KeyColumn>, CsvError> {
    let header = table.header();
    let mut keys: Vec<KeyColumn> = Vec::new();
    for (index, title) in header.cells().iter().enumerate() {
        if known.contains(&index) || WORDS.contains(&title.to_ascii_lowercase().as_str()) {
            continue;
        }
        let name = title.split(['[', '(']).next().unwrap_or_default();
        let split = name
            .contains('.')
            .then(|| split_title(case, title))
            .flatten();
        let Some((key, unit)) = split else {
            let problem = match title.is_empty() {
                true => format!("the column has no title; {CHOICES}"),
                false => {
                    format!("unknown column `{title}`; {CHOICES}; or leave it out with --ignore")
                }
            };
            return Err(table.error(header, index, problem));
        };
        let mut others = operating.iter().map(|(column, _)| &column.key);
        if others.any(|other| *other == key) || keys.iter().any(|(column, _, _)| column.key == key)
        {
            let problem = format!("there is a second column for `{key}`");
            return Err(table.error(header, index, problem));
        }
        let span = table.cell_span(text, header, index);
        keys.push((column(&key, span), index, unit));
        known.push(index);
    }
    Ok(keys)
}

fn rows(
    table: &CsvTable,
    text: &str,
    mut operating: Vec<(PointColumn, Column)>,
    mut keys: Vec<KeyColumn>,
    measured: &[MeasuredColumns],
) -> Result<Content, CsvError> {
    let mut rows = Vec::new();
    for row in table.rows() {
        for (point, column) in &mut operating {
            let value = table.required_number(row, column)?;
            let span = table.cell_span(text, row, column.index);
            if column
                .unit
                .dimension()
                .same_exponents(Dimension::DIMENSIONLESS)
            {
                point.push_number(span, value);
            } else {
                let cell = table.with_point(row.cell(column.index));
                point.push(span, &cell, &unit_of(table, column));
            }
        }
        for (point, index, unit) in &mut keys {
            let cell = table.with_point(row.cell(*index));
            if cell.is_empty() {
                let problem = format!("{}: the cell is empty", point.key);
                return Err(table.error(row, *index, problem));
            }
            point.push(table.cell_span(text, row, *index), &cell, unit);
        }
        let mut figures = [None; 3];
        for columns in measured {
            figures[columns.figure as usize] = measurement(table, row, columns)?;
        }
        if figures == [None; 3] {
            let index = measured[0].value.index;
            return Err(table.error(row, index, "nothing was measured in this line"));
        }
        rows.push((row.line, figures));
    }
    if rows.is_empty() {
        let problem = "there are no measurements below the header";
        return Err(table.error(table.header(), 0, problem));
    }
    let columns = operating.into_iter().map(|(point, _)| point);
    Ok(Content {
        columns: columns
            .chain(keys.into_iter().map(|(point, ..)| point))
            .collect(),
        rows,
        notes: Vec::new(),
    })
}

/// The unit of a column as its title writes it; empty for a plain number.
fn unit_of(table: &CsvTable, column: &Column) -> String {
    let title = table.header().cell(column.index);
    let after = title.get(column.name.len()..).unwrap_or_default().trim();
    match after.strip_prefix(['[', '(']) {
        Some(unit) => unit.trim_end_matches([']', ')']).trim().to_owned(),
        None => after
            .trim_start_matches(['_', ' '])
            .replace("_per_", "/")
            .replace('_', " "),
    }
}

/// What one line measured of a figure; `None` where its cell is empty.
fn measurement(
    table: &CsvTable,
    row: &Row,
    columns: &MeasuredColumns,
) -> Result<Option<Measurement>, CsvError> {
    let index = columns.value.index;
    let uncertainty = match &columns.uncertainty {
        Some(own) => table.number(row, &own.column)?.map(|number| (own, number)),
        None => None,
    };
    let Some(value) = table.number(row, &columns.value)? else {
        return match uncertainty {
            None => Ok(None),
            Some((own, _)) => Err(table.error(
                row,
                own.column.index,
                format!(
                    "an uncertainty of `{}`, which is not there",
                    columns.figure.name()
                ),
            )),
        };
    };
    if let Some(problem) = impossible(columns.figure, value, row.cell(index)) {
        return Err(table.error(row, index, problem));
    }
    let uncertainty = uncertainty
        .map(|(own, number)| {
            if number < 0.0 {
                let problem = format!(
                    "{}: {} is negative",
                    own.column.name,
                    row.cell(own.column.index)
                );
                return Err(table.error(row, own.column.index, problem));
            }
            Ok(if own.is_relative {
                number * value.abs()
            } else {
                number
            })
        })
        .transpose()?;
    Ok(Some(Measurement { value, uncertainty }))
}

/// Why a figure cannot have been measured.
pub(super) fn impossible(figure: Figure, value: f64, cell: &str) -> Option<String> {
    let name = figure.name();
    if figure.is_film() && value <= 0.0 {
        return Some(format!(
            "{name}: {cell} is impossible: a film is thicker than zero"
        ));
    }
    if figure.is_film() && value > THICKEST_FILM {
        return Some(format!(
            "{name}: {cell} is far beyond any film; at most 10 mm are believed"
        ));
    }
    (value.abs() > LARGEST_TRACTION && !figure.is_film()).then(|| {
        format!("{name}: {cell} is far beyond any traction; at most {LARGEST_TRACTION} is believed")
    })
}
