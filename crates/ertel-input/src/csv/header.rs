//! Which line names the columns: lines of an instrument may come before it, a line of units behind it.

use std::cell::RefCell;
use std::collections::HashMap;
use std::ops::Range;

use super::number::{is_missing, is_number};
use super::split::{Record, Records, Separator, cells, is_comment};
use super::title::{readings, unit_of};
use super::{CsvParams, Row, Vocabulary};
use ertel_quantity::Dimension;

/// Lines among which the header is looked for.
const SEARCHED: usize = 300;

/// The header of a table.
pub(super) struct Head {
    pub row: Row,
    pub separator: Separator,
    /// Where the lines behind it begin, and the number of the first, from 1.
    pub rest: (usize, usize),
}

/// Why there is none.
pub(super) enum NoHead {
    /// There is no line but comments.
    Empty,
    /// Two lines may be it, by their numbers.
    Two(usize, usize),
    /// A quote in a line, from 1, and a cell of it, from 0, is not closed.
    Quote(usize, usize),
}

/// A line that may be the header.
struct Candidate {
    head: Head,
    /// Titles that are known, and whether numbers follow below one of them.
    score: (usize, bool),
}

/// The separator declared in the first line, as in `sep=;`, and the start of the next line.
fn declared_separator(text: &str, start: usize) -> Option<(Separator, usize)> {
    let line = text[start..].lines().next()?;
    let declared = line.trim_matches('"').trim_end_matches('\r');
    let mark = declared
        .get(..4)
        .filter(|head| head.eq_ignore_ascii_case("sep="))
        .map(|_| &declared[4..])?;
    let mut marks = mark.trim_matches('"').chars();
    let mark = marks.next().filter(|_| marks.next().is_none())?;
    let end = start + line.len();
    let next = text[end..].find('\n').map_or(text.len(), |i| end + i + 1);
    Some((Separator::Char(mark), next))
}

/// Finds the header from a byte of the text on.
pub(super) fn find(
    text: &str,
    start: usize,
    vocabulary: &Vocabulary<'_>,
    params: &CsvParams,
) -> Result<Head, NoHead> {
    let declared = declared_separator(text, start);
    let (start, line) = declared.map_or((start, 1), |(_, next)| (next, 2));
    let separators: Vec<Separator> = match declared {
        Some((separator, _)) => vec![separator],
        None => Separator::ALL.to_vec(),
    };
    // Looked up once: lines that may be the header are often alike.
    let known: RefCell<HashMap<String, bool>> = RefCell::default();
    let is_known = |cell: &str| {
        let mut known = known.borrow_mut();
        if let Some(is_known) = known.get(cell) {
            return *is_known;
        }
        let is_mapped = params.columns.iter().any(|map| map.title == cell);
        let is_known = is_mapped || vocabulary.knows(cell);
        known.insert(cell.to_owned(), is_known);
        is_known
    };
    let mut best: Vec<Candidate> = Vec::new();
    for separator in &separators {
        // Titles of several words are known by parts of them, too: blanks separate only where nothing else does.
        let is_blank = !matches!(separator, Separator::Char(_));
        let is_parted = |best: &Candidate| best.score.1 && best.head.row.cells.len() > 1;
        if is_blank && best.first().is_some_and(is_parted) {
            break;
        }
        for candidate in candidates(text, (start, line), *separator, &is_known) {
            // A column alone: a comma in its numbers would be a decimal comma or a second cell.
            let is_alone = candidate.head.row.cells.len() == 1;
            if is_alone && declared.is_none() && *separator != Separator::Char(',') {
                continue;
            }
            let is_better = best.first().is_none_or(|best| candidate.score > best.score);
            let is_equal = best.first().is_some_and(|best| {
                candidate.score == best.score && candidate.head.separator == best.head.separator
            });
            if is_better {
                best = vec![candidate];
            } else if is_equal {
                best.push(candidate);
            }
        }
    }
    let mut best = best.into_iter();
    match (best.next(), best.next()) {
        (Some(first), Some(second)) if first.head.row.cells != second.head.row.cells => {
            Err(NoHead::Two(first.head.row.line, second.head.row.line))
        }
        (Some(first), _) => Ok(first.head),
        (None, _) => guess(
            text,
            (start, line),
            declared.map(|(separator, _)| separator),
        ),
    }
}

/// Lines with titles that are known.
fn candidates(
    text: &str,
    (start, line): (usize, usize),
    separator: Separator,
    is_known: &dyn Fn(&str) -> bool,
) -> Vec<Candidate> {
    let records: Vec<Record<'_>> = Records::new(text, start, line, separator)
        .take(SEARCHED)
        .collect();
    let mut found = Vec::new();
    for (i, record) in records.iter().enumerate() {
        let Some(row) = row_of(text, record, separator) else {
            continue;
        };
        if row.cells.iter().any(|cell| is_number(cell)) {
            continue;
        }
        let known: Vec<usize> = (0..row.cells.len())
            .filter(|c| is_known(&row.cells[*c]))
            .collect();
        // A comment is a header only where it is no sentence.
        let least = if is_comment(&text[record.span.clone()]) {
            2
        } else {
            1
        };
        if known.len() < least {
            continue;
        }
        let mut below = records[i + 1..]
            .iter()
            .filter(|r| !is_comment(&text[r.span.clone()]))
            .take(2);
        let has_number = |record: &Record<'_>| {
            let cells = record.cells.as_ref().map_or(&[][..], Vec::as_slice);
            known
                .iter()
                .any(|c| cells.get(*c).is_some_and(|(_, cell)| is_number(cell)))
        };
        found.push(Candidate {
            score: (known.len(), below.any(has_number)),
            head: head(text, row, separator),
        });
    }
    found
}

/// A line as a header; a comment without its mark.
fn row_of(text: &str, record: &Record<'_>, separator: Separator) -> Option<Row> {
    let own = &text[record.span.clone()];
    let owned = |cells: &[super::split::Cell<'_>]| {
        cells
            .iter()
            .map(|(_, cell)| cell.replace(['\n', '\r'], " "))
            .collect()
    };
    let cells = match is_comment(own) {
        true => {
            let body = own
                .trim_start()
                .trim_start_matches(['#', '%', '!', '/'])
                .trim();
            owned(&cells(body, separator).ok()?)
        }
        false => owned(record.cells.as_ref().ok()?),
    };
    Some(Row {
        line: record.line,
        span: record.span.clone(),
        cells,
    })
}

/// The header with what comes behind it.
fn head(text: &str, row: Row, separator: Separator) -> Head {
    let end = row.span.end;
    let next = text[end..].find('\n').map_or(text.len(), |i| end + i + 1);
    let lines = text[row.span.clone()].matches('\n').count();
    Head {
        rest: (next, row.line + lines + 1),
        row,
        separator,
    }
}

/// The header of a table of which no title is known: the first line, or the first one above numbers.
fn guess(
    text: &str,
    (start, line): (usize, usize),
    declared: Option<Separator>,
) -> Result<Head, NoHead> {
    let mut lines = text[start..].lines();
    let first = lines.find(|line| !line.trim().is_empty() && !is_comment(line));
    let first = first.ok_or(NoHead::Empty)?;
    let outside: String = first.split('"').step_by(2).collect();
    let separators = [';', '\t', ','];
    let separator = declared.unwrap_or_else(|| {
        let found = separators.into_iter().find(|c| outside.contains(*c));
        Separator::Char(found.unwrap_or(','))
    });
    let records = Records::new(text, start, line, separator).take(SEARCHED);
    let records: Vec<Record<'_>> = records
        .filter(|r| !is_comment(&text[r.span.clone()]))
        .collect();
    let numbers = |record: &Record<'_>| {
        let cells = record.cells.as_ref().map_or(&[][..], Vec::as_slice);
        cells.iter().filter(|(_, cell)| is_number(cell)).count()
    };
    let above = records.windows(2).find(|pair| {
        let n = |record: &Record<'_>| record.cells.as_ref().map_or(0, Vec::len);
        numbers(&pair[0]) == 0 && numbers(&pair[1]) > 0 && n(&pair[0]) > 1
    });
    let record = above
        .map(|pair| &pair[0])
        .or(records.first())
        .ok_or(NoHead::Empty)?;
    match &record.cells {
        Err(place) => Err(NoHead::Quote(record.line, *place)),
        Ok(_) => {
            let row = row_of(text, record, separator).ok_or(NoHead::Empty)?;
            Ok(head(text, row, separator))
        }
    }
}

/// The titles with the units of a line below the header, if that line is one of units.
pub(super) fn with_units(titles: &[String], row: &Row, below: Option<&Row>) -> Option<Vec<String>> {
    let mut is_unit_row = false;
    let mut joined = titles.to_vec();
    for (i, cell) in row.cells.iter().enumerate() {
        let inner = cell.trim_matches(['[', ']', '(', ')']).trim();
        if cell.is_empty() {
            continue;
        }
        let unit = unit_of(cell).or_else(|| unit_of(inner))?;
        if is_number(cell) || i >= titles.len() {
            return None;
        }
        // A title with a unit is not followed by another unit.
        let has_unit = readings(&titles[i])
            .iter()
            .any(|r| r.is_exact && !r.unit.is_empty() && unit_of(&r.unit).is_some());
        if has_unit || titles[i].is_empty() {
            return None;
        }
        let is_dimensionless = unit
            .unit
            .dimension()
            .same_exponents(Dimension::DIMENSIONLESS);
        is_unit_row |= !is_dimensionless || cell == "%";
        let below = below.map_or("", |row| row.cell(i));
        if !is_dimensionless && !is_number(below) && !is_missing(below) {
            return None;
        }
        // Without `[unit]` where there is none, as of pure numbers.
        joined[i] = match inner {
            "-" | "–" | "" => titles[i].clone(),
            _ => format!("{} [{inner}]", titles[i]),
        };
    }
    is_unit_row.then_some(joined)
}

/// Bytes of the first line of a text that may begin with marks of the byte order.
pub(super) fn start_of(text: &str) -> usize {
    text.len() - text.trim_start_matches('\u{feff}').len()
}

/// Bytes of a cell in the text; those of the line where it is not found.
pub(super) fn cell_span(text: &str, row: &Row, index: usize, separator: Separator) -> Range<usize> {
    let line = &text[row.span.clone()];
    let found = match cells(line, separator) {
        Ok(cells) => cells.get(index).map(|(span, _)| span.clone()),
        Err(_) => None,
    };
    found.map_or_else(
        || row.span.clone(),
        |span| row.span.start + span.start..row.span.start + span.end,
    )
}
