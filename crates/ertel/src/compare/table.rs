//! Plain tables: a column for each quantity that was set, one for each figure that was measured.

use ertel_input::csv::{Column, CsvError, CsvTable, Row, Vocabulary, key_titles, line_list};
use ertel_input::{Document, excerpt};
use ertel_quantity::Dimension;

use super::columns::{
    MEASURED, MeasuredColumns, OPERATING, Operating, find, names, open_name, uncertainty,
};
use super::measured::{Content, column};
use super::turned::{self, Turned};
use super::{Measurand, Measurement, N_MEASURANDS, ReadParams};
use crate::case::study::{PointColumn, split_title};

/// Columns about a row that say nothing about its operating point, in small letters and without their unit.
const WORDS: [&str; 23] = [
    "comment",
    "comments",
    "note",
    "notes",
    "remark",
    "remarks",
    "kommentar",
    "bemerkung",
    "no",
    "no.",
    "nr",
    "nr.",
    "#",
    "id",
    "index",
    "time",
    "date",
    "zeit",
    "datum",
    "uhrzeit",
    "operator",
    "file",
    "datei",
];

/// Permitted columns of a table, for messages.
const CHOICES: &str = "quantities are `entrainment_speed`, `slide_to_roll_ratio`, `load`, `temperature`, and any key of the case, \
    such as `contact.radius`; measured are `film_central`, `film_minimum`, `traction_coefficient`, and of whole \
    machines `friction_torque`, `friction_power`, `mesh_loss`, each with `_uncertainty` if known; all with their units, as in `film_central_nm` or `film_central [nm]`; a `comment` is skipped; \
    assign other titles as in `--column film=\"Film (nm)\"` or `--column film=Film:nm`";

/// Largest accepted film thickness, m: beyond it the unit is assumed to be wrong.
const THICKEST_FILM: f64 = 1e-2;
/// Largest accepted traction coefficient.
const LARGEST_TRACTION: f64 = 10.0;

/// Vocabulary of the columns of a table of measurements.
pub(super) fn parse(
    case: &Document,
    file: &str,
    text: &str,
    params: &ReadParams,
) -> Result<CsvTable, CsvError> {
    let names = names();
    let vocabulary = Vocabulary {
        names: &names,
        is_key: &|title| {
            let key = split_title(case, title);
            key.is_some_and(|(key, _)| key.contains('.') && key.starts_with(char::is_alphabetic))
        },
    };
    CsvTable::parse_for(file, text, &vocabulary, &params.table)
}

/// Reads a table.
pub(super) fn read(
    case: &Document,
    file: &str,
    text: &str,
    params: &ReadParams,
) -> Result<Content, CsvError> {
    let table = parse(case, file, text, params).map_err(|mut error| {
        if error.problem.contains("empty") {
            error.problem += &format!("; {CHOICES}");
        }
        error
    })?;
    let header = table.header();
    let mut known: Vec<usize> = Vec::new();
    let mut notes = table.notes().to_vec();
    let mut operating: Vec<Set> = Vec::new();
    for (quantity, name, dimensions) in OPERATING {
        if let Some(found) = find(&table, name, dimensions, &known)? {
            let key = quantity.key(case).map_err(|why| {
                let problem = format!("the case cannot take {name} from a table: {why}");
                table.error(header, found.index, problem)
            })?;
            known.push(found.index);
            notes.extend(open_name(&table, &found));
            let span = table.cell_span(text, header, found.index);
            operating.push(Set {
                quantity,
                point: column(key, span),
                column: found,
            });
        }
    }
    let mut measured = Vec::new();
    for (figure, (name, bar, dimension)) in Measurand::ALL.into_iter().zip(MEASURED) {
        let uncertainty = uncertainty(&table, bar, dimension, &known)?;
        known.extend(uncertainty.iter().map(|u| u.column.index));
        match (find(&table, name, &[dimension], &known)?, uncertainty) {
            (Some(value), uncertainty) => {
                known.push(value.index);
                notes.extend(open_name(&table, &value));
                measured.push(MeasuredColumns {
                    figure,
                    value,
                    uncertainty,
                });
            }
            (None, Some(uncertainty)) => {
                let problem = format!(
                    "there is an uncertainty of `{}` but no column of its values",
                    figure.name()
                );
                return Err(table.error(header, uncertainty.column.index, problem));
            }
            (None, None) => {}
        }
    }
    let keys = keys(case, &table, text, &mut known, &operating)?;
    if measured.is_empty() {
        let problem = format!(
            "no column is a measured figure; the columns are {}; {CHOICES}",
            header.cells().join(", ")
        );
        return Err(table.error(header, 0, problem));
    }
    if operating.is_empty() && keys.is_empty() {
        let problem = format!("no column says what was varied; {CHOICES}");
        return Err(table.error(header, 0, problem));
    }
    let mut content = rows(case, &table, text, operating, keys, &measured)?;
    notes.append(&mut content.notes);
    content.notes = notes;
    Ok(content)
}

/// A column that sets an operating quantity.
struct Set {
    quantity: Operating,
    point: PointColumn,
    column: Column,
}

/// A column that is a key of the case: its index and its unit.
type KeyColumn = (PointColumn, usize, String);

/// The columns that are keys of the case; all others must be known.
fn keys(
    case: &Document,
    table: &CsvTable,
    text: &str,
    known: &mut Vec<usize>,
    operating: &[Set],
) -> Result<Vec<KeyColumn>, CsvError> {
    let header = table.header();
    let mut keys: Vec<KeyColumn> = Vec::new();
    for (index, cell) in header.cells().iter().enumerate() {
        let is_word = |title: &str| WORDS.contains(&title.trim().to_lowercase().as_str());
        let words = key_titles(cell);
        if known.contains(&index)
            || table.is_ignored(index)
            || is_word(cell)
            || words.iter().any(|(name, _)| is_word(name))
        {
            continue;
        }
        let title = table.title(index);
        let split = split_title(case, title).filter(|(key, _)| key.contains('.'));
        let Some((key, unit)) = split else {
            let problem = format!(
                "unknown column `{}`; {CHOICES}; or omit it with --ignore",
                excerpt(cell)
            );
            return Err(table.error(header, index, problem));
        };
        let mut others = operating.iter().map(|set| &set.point.key);
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
    case: &Document,
    table: &CsvTable,
    text: &str,
    mut operating: Vec<Set>,
    mut keys: Vec<KeyColumn>,
    measured: &[MeasuredColumns],
) -> Result<Content, CsvError> {
    let mut rows = Vec::new();
    let mut empty = Vec::new();
    let mut turned = turned::Rows::of(case);
    for row in table.rows() {
        let mut figures = [None; N_MEASURANDS];
        for columns in measured {
            figures[columns.figure as usize] = measurement(table, row, columns)?;
        }
        if figures == [None; N_MEASURANDS] {
            empty.push(row.line);
            continue;
        }
        let speed = operating
            .iter()
            .find(|set| set.quantity == Operating::Speed);
        let speed = speed.map(|set| table.required_number(row, &set.column));
        let turn = turned.take(row.line, speed.transpose()?);
        if turn == Turned::LeftOut {
            continue;
        }
        for set in &mut operating {
            let value = table.required_number(row, &set.column)?;
            let span = table.cell_span(text, row, set.column.index);
            let dimension = set.column.unit.dimension();
            if dimension.same_exponents(Dimension::DIMENSIONLESS) {
                set.point.push_number(span, value);
            } else {
                let cell = table.with_point(row.cell(set.column.index));
                let cell = match set.quantity == Operating::Speed {
                    true => turn.speed(&cell),
                    false => &cell,
                };
                set.point.push(span, cell, &set.column.unit_text);
            }
        }
        for (point, index, unit) in &mut keys {
            let cell = table.with_point(row.cell(*index));
            if table.is_missing(row, *index) {
                let problem = format!("{}: the cell is empty", point.key);
                return Err(table.error(row, *index, problem));
            }
            point.push(table.cell_span(text, row, *index), &cell, unit);
        }
        rows.push((row.line, figures));
    }
    let mut notes = turned.notes();
    if rows.is_empty() {
        return Err(without_rows(table, measured, &empty, &notes));
    }
    if !empty.is_empty() {
        notes.push(format!("nothing was measured in {}", line_list(&empty)));
    }
    let columns = operating.into_iter().map(|set| set.point);
    Ok(Content {
        measured: described(table, measured),
        columns: columns
            .chain(keys.into_iter().map(|(point, ..)| point))
            .collect(),
        rows,
        notes,
    })
}

/// Why no row of a table is left.
fn without_rows(
    table: &CsvTable,
    measured: &[MeasuredColumns],
    empty: &[usize],
    notes: &[String],
) -> CsvError {
    let problem = match (empty.first(), notes.is_empty()) {
        (Some(line), true) => {
            let row = table.rows().iter().find(|row| row.line == *line);
            let index = measured[0].value.index;
            let problem = "nothing was measured in this line, nor in any other";
            return table.error(row.unwrap_or(table.header()), index, problem);
        }
        (None, true) => "there are no measurements below the header".to_owned(),
        (_, false) => format!("no row remains: {}", notes.join("; ")),
    };
    table.error(table.header(), 0, problem)
}

/// Titles of the measured columns, and their meaning.
fn described(table: &CsvTable, measured: &[MeasuredColumns]) -> Vec<(String, String)> {
    let title = |index: usize| excerpt(table.header().cell(index)).to_string();
    let columns = measured.iter().flat_map(|own| {
        let words = own.figure.words();
        let value = (title(own.value.index), format!("measured {words}"));
        let bar = own.uncertainty.as_ref();
        let bar = bar.map(|bar| {
            let words = format!("uncertainty of the {words}");
            (title(bar.column.index), words)
        });
        std::iter::once(value).chain(bar)
    });
    columns.collect()
}

/// Measured value of a figure in one line; `None` where its cell is empty.
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
                    "an uncertainty of `{}` without its value",
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
pub(super) fn impossible(figure: Measurand, value: f64, cell: &str) -> Option<String> {
    let name = figure.name();
    if figure.is_film() && value <= 0.0 {
        return Some(format!(
            "{name}: {cell} is impossible: a film is thicker than zero"
        ));
    }
    if figure.is_film() && value > THICKEST_FILM {
        return Some(format!(
            "{name}: {cell} is far beyond any film; the largest accepted value is 10 mm"
        ));
    }
    (value.abs() > LARGEST_TRACTION && figure == Measurand::Traction).then(|| {
        format!("{name}: {cell} is far beyond any traction; the largest accepted value is {LARGEST_TRACTION}")
    })
}
