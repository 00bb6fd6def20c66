//! `points = "points.csv"`: a table whose headers are input keys with their units.

use std::ops::Range;
use std::path::Path;

use ertel_rheology::input::csv::{CsvTable, Row};
use ertel_rheology::input::file::{LARGEST_TABLE, read_text};
use ertel_rheology::input::tree::{Node, Value};
use ertel_rheology::input::{Document, InputError};
use ertel_rheology::quantity::Unit;

use super::axis::{Axis, Group};
use super::values::AxisValue;

/// A column: its key, where it stands, and the unit of its cells.
struct Header {
    key: String,
    span: Range<usize>,
    unit: String,
}

/// Reads the table as a group of axes side by side; returns the case with the table beside it.
pub(super) fn read(
    case: Document,
    path: &Path,
    study: &Document,
) -> Result<(Document, Group), InputError> {
    let file = path.display().to_string();
    let text = read_text(path, LARGEST_TABLE)
        .map_err(|error| study.root().error("points", format!("{file} {error}")))?;
    let (case, offset) = case.beside(&file, &text);
    let moved = |span: Range<usize>| span.start + offset..span.end + offset;
    let table = CsvTable::parse(&file, &text).map_err(|error| {
        let at = moved(line_span(&text, error.line));
        let message = format!("column {}: {}", error.column, error.problem);
        case.error_at(at, "", message)
    })?;
    let span_of = |row: &Row, index| moved(table.cell_span(&text, row, index));
    let titles = table.header().cells().iter().enumerate();
    let headers: Vec<Header> = titles
        .map(|(index, title)| {
            let span = span_of(table.header(), index);
            let (key, unit) = split_title(&case, title).ok_or_else(|| {
                case.error_at(span.clone(), "", format!("`{title}` is no key with a unit"))
                    .with_help("name the column as in `contact.load_N` or `contact.load [N]`")
            })?;
            Ok(Header { key, span, unit })
        })
        .collect::<Result<_, InputError>>()?;
    let mut axes: Vec<Axis> = headers
        .iter()
        .map(|header| Axis {
            key: header.key.clone(),
            key_span: header.span.clone(),
            values: Vec::new(),
        })
        .collect();
    for row in table.rows() {
        for (index, (header, axis)) in headers.iter().zip(&mut axes).enumerate() {
            let cell = table.with_point(row.cell(index));
            if cell.is_empty() {
                let message = format!("column {}: `{}` is left out", index + 1, header.key);
                return Err(case.error_at(moved(row.span.clone()), &header.key, message));
            }
            let node = Node {
                span: span_of(row, index),
                value: value_of(&cell, &header.unit),
            };
            let value = AxisValue::of(&node);
            axis.values.push((node, value));
        }
    }
    if axes[0].values.is_empty() {
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

/// The value that a cell puts into the case.
pub(super) fn value_of(cell: &str, unit: &str) -> Value {
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

/// Key and unit of `contact.load_N`, `contact.load [N]`, `lubricant.name`.
pub(crate) fn split_title(case: &Document, title: &str) -> Option<(String, String)> {
    let is_key = |key: &str| {
        let part = |p: &str| {
            !p.is_empty()
                && p.chars()
                    .all(|c| c.is_ascii_alphanumeric() || "_-".contains(c))
        };
        key.split('.').all(part)
    };
    if let Some((key, rest)) = title.split_once(['[', '(']) {
        let unit = rest.trim_end().trim_end_matches([']', ')']);
        let key = key.trim_end();
        Unit::parse(unit).ok()?;
        return is_key(key).then(|| (key.to_owned(), unit.to_owned()));
    }
    if !is_key(title) {
        return None;
    }
    if case.tree().entry(title).is_none() {
        let start = title.rfind('.').map_or(0, |i| i + 1);
        // The longest unit: `_m_per_s` before `_s`.
        for (i, _) in title.match_indices('_').filter(|(i, _)| *i > start) {
            let unit = title[i + 1..].replace("_per_", "/").replace('_', ".");
            if Unit::parse(&unit).is_ok() && !unit.is_empty() {
                return Some((title[..i].to_owned(), unit));
            }
        }
    }
    Some((title.to_owned(), String::new()))
}
