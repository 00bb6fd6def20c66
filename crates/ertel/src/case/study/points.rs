//! `points = "points.csv"`: a table whose headers are input keys with their units.

use std::ops::Range;
use std::path::Path;

use ertel_input::csv::{CsvParams, CsvTable, Row, Vocabulary, key_titles};
use ertel_input::file::read_table;
use ertel_input::tree::{Node, Value};
use ertel_input::{Document, InputError};

use super::axis::{Axis, Group};
use super::values::{AxisValue, is_text_key};

/// A column: its index, its key, the position of its header, and the unit of its cells.
struct Header {
    index: usize,
    key: String,
    span: Range<usize>,
    unit: String,
}

/// Reads the table as a group of axes that vary together; returns the case with the table added.
pub(super) fn read(
    case: Document,
    path: &Path,
    study: &Document,
) -> Result<(Document, Group), InputError> {
    let file = path.display().to_string();
    let text = read_table(path)
        .map_err(|error| study.root().error("points", format!("{file} {error}")))?;
    let (case, offset) = case.with_file(&file, &text);
    let moved = |span: Range<usize>| span.start + offset..span.end + offset;
    let vocabulary = Vocabulary {
        names: &[],
        is_key: &|title| {
            let key = split_title(&case, title);
            key.is_some_and(|(key, _)| {
                let is_path = key.contains('.') && key.starts_with(char::is_alphabetic);
                is_path || key == "title" || case.tree().entry(&key).is_some()
            })
        },
    };
    let table = CsvTable::parse_for(&file, &text, &vocabulary, &CsvParams::default());
    let table = table.map_err(|error| {
        let at = moved(line_span(&text, error.line));
        let message = format!("column {}: {}", error.column, error.problem);
        case.error_at(at, "", message)
    })?;
    let span_of = |row: &Row, index| moved(table.cell_span(&text, row, index));
    let columns = (0..table.header().cells().len()).filter(|index| !table.is_ignored(*index));
    let headers: Vec<Header> = columns
        .map(|index| {
            let title = table.title(index);
            let span = span_of(table.header(), index);
            let (key, unit) = split_title(&case, title).ok_or_else(|| {
                case.error_at(span.clone(), "", format!("`{title}` is no key with a unit"))
                    .with_help("name the column as in `contact.load_N` or `contact.load [N]`")
            })?;
            Ok(Header {
                index,
                key,
                span,
                unit,
            })
        })
        .collect::<Result<_, InputError>>()?;
    let axis = |header: &Header| Axis {
        key: header.key.clone(),
        key_span: header.span.clone(),
        values: Vec::new(),
    };
    let mut axes: Vec<Axis> = headers.iter().map(axis).collect();
    for row in table.rows() {
        for (header, axis) in headers.iter().zip(&mut axes) {
            let index = header.index;
            let cell = match is_text_key(&header.key) {
                true => row.cell(index).into(),
                false => table.with_point(row.cell(index)),
            };
            if cell.is_empty() {
                let message = format!(
                    "column {}: the cell of `{}` is empty",
                    index + 1,
                    header.key
                );
                return Err(case.error_at(moved(row.span.clone()), &header.key, message));
            }
            let node = Node {
                span: span_of(row, index),
                value: value_of(&header.key, &cell, &header.unit),
            };
            let value = AxisValue::of(&header.key, &node);
            axis.values.push((node, value));
        }
    }
    if axes.first().is_none_or(|axis| axis.values.is_empty()) {
        let head = moved(table.header().span.clone());
        return Err(case.error_at(head, "", "there are no points below the header"));
    }
    let name = None;
    Ok((case, Group { name, axes }))
}

/// The bytes of a line, from 1.
fn line_span(text: &str, line: usize) -> Range<usize> {
    let mut lines = text.split('\n');
    let start: usize = lines.by_ref().take(line - 1).map(|l| l.len() + 1).sum();
    start..start + lines.next().map_or(0, |l| l.trim_end().len())
}

/// The value that a cell puts at a key of the case.
pub(super) fn value_of(key: &str, cell: &str, unit: &str) -> Value {
    if is_text_key(key) {
        return Value::Str(cell.to_owned());
    }
    if !unit.is_empty() {
        return Value::Str(format!("{cell} {unit}"));
    }
    if let Ok(number) = cell.parse::<i64>() {
        return Value::Integer(Some(number));
    }
    match cell {
        "true" => Value::Bool(true),
        "false" => Value::Bool(false),
        _ => match cell.parse::<f64>() {
            Ok(number) => Value::Float(number),
            Err(_) => Value::Str(cell.to_owned()),
        },
    }
}

/// Key and unit of `contact.load_N`, `contact.load [N]`, `contact.load / N`, `lubricant.name`; the unit is empty where there is none.
pub(crate) fn split_title(case: &Document, title: &str) -> Option<(String, String)> {
    let title = title.trim();
    let is_key = |key: &str| {
        let part = |p: &str| {
            !p.is_empty()
                && p.chars()
                    .all(|c| c.is_ascii_alphanumeric() || "_-".contains(c))
        };
        key.split('.').all(part)
    };
    if is_key(title) && (is_text_key(title) || case.tree().entry(title).is_some()) {
        return Some((title.to_owned(), String::new()));
    }
    // A unit in words follows the last point: `motion.slide_to_roll_ratio` has none.
    let points = |text: &str| text.matches('.').count();
    let fits = |(key, _): &(String, String)| {
        is_key(key) && (key == title || !is_key(title) || points(key) == points(title))
    };
    let titles = key_titles(title);
    let with_unit = titles.iter().find(|own| fits(own) && !own.1.is_empty());
    let found = with_unit.or_else(|| titles.iter().find(|own| fits(own)));
    found.cloned()
}
