//! `points = "points.csv"`: a table whose headers are input keys with their units.

use std::ops::Range;
use std::path::Path;

use ertel_rheology::input::tree::{Node, Value};
use ertel_rheology::input::{Document, InputError};
use ertel_rheology::quantity::Unit;

use super::axis::{Axis, AxisValue, Group};
use crate::fit::csv::{cells, rows};

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
    let text = std::fs::read_to_string(path).map_err(|error| {
        study
            .root()
            .error("points", format!("{file} cannot be read: {error}"))
    })?;
    let (case, offset) = case.beside(&file, &text);
    let span_of = |part: &str| {
        let start = part.as_ptr() as usize - text.as_ptr() as usize + offset;
        start..start + part.len()
    };
    let mut lines = rows(&text);
    let Some((_, head, separator)) = lines.next() else {
        return Err(case.error_at(offset..offset, "", "the table of points is empty"));
    };
    let headers: Vec<Header> = cells(head, separator)
        .into_iter()
        .map(|title| {
            let span = span_of(title);
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
    for (_, line, _) in lines {
        let row = cells(line, separator);
        if row.len() != headers.len() {
            let message = format!(
                "this line has {} cells, but the header has {}",
                row.len(),
                headers.len()
            );
            return Err(case.error_at(span_of(line), "", message));
        }
        for ((cell, header), axis) in row.into_iter().zip(&headers).zip(&mut axes) {
            if cell.is_empty() {
                let message = format!("`{}` is left out", header.key);
                return Err(case.error_at(span_of(line), &header.key, message));
            }
            let node = Node {
                span: span_of(cell),
                value: value_of(cell, &header.unit),
            };
            let value = AxisValue::of(&node);
            axis.values.push((node, value));
        }
    }
    if axes[0].values.is_empty() {
        return Err(case.error_at(span_of(head), "", "there are no points below the header"));
    }
    let name = None;
    Ok((case, Group { name, axes }))
}

/// The value that a cell puts into the case.
fn value_of(cell: &str, unit: &str) -> Value {
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
fn split_title(case: &Document, title: &str) -> Option<(String, String)> {
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
