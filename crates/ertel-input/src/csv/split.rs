//! Lines and cells of a table.

use std::borrow::Cow;
use std::ops::Range;

/// Lines over which a quoted title may go, as spreadsheets write one with a break in it.
const LINES_OF_A_TITLE: usize = 4;

/// Separators of cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Separator {
    /// A character.
    Char(char),
    /// Two blanks or more, or a tab.
    WideBlanks,
    /// Blanks.
    Blanks,
}

impl Separator {
    /// All, in the order in which they are tried.
    pub(super) const ALL: [Separator; 5] = [
        Separator::Char(';'),
        Separator::Char('\t'),
        Separator::Char(','),
        Separator::WideBlanks,
        Separator::Blanks,
    ];
}

/// A cell of a line: its bytes there, without blanks around, and its text without quotes.
pub(super) type Cell<'a> = (Range<usize>, Cow<'a, str>);

/// The cells of a line.
///
/// # Errors
///
/// The place of a cell, from 0, whose quote is not closed.
pub(super) fn cells(line: &str, separator: Separator) -> Result<Vec<Cell<'_>>, usize> {
    match separator {
        Separator::Char(c) => quoted_cells(line, c),
        Separator::WideBlanks => Ok(blank_cells(line, true)),
        Separator::Blanks => Ok(blank_cells(line, false)),
    }
}

/// The bytes of a part without the blanks around it.
fn trimmed(line: &str, part: Range<usize>) -> Range<usize> {
    let text = &line[part.clone()];
    let start = part.start + (text.len() - text.trim_start().len());
    start..start + text.trim().len()
}

fn blank_cells(line: &str, wide: bool) -> Vec<Cell<'_>> {
    let line_span = trimmed(line, 0..line.len());
    let mut cells: Vec<Cell<'_>> = Vec::new();
    let mut start = line_span.start;
    let mut add = |part: Range<usize>| {
        let mut part = trimmed(line, part);
        if part.is_empty() {
            return;
        }
        // The unit in brackets belongs to the title before it.
        if line[part.clone()].starts_with(['[', '('])
            && cells
                .last()
                .is_some_and(|(_, title)| !title.starts_with(['[', '(']))
            && let Some((title, _)) = cells.pop()
        {
            part.start = title.start;
        }
        cells.push((part.clone(), Cow::Borrowed(&line[part])));
    };
    let mut blanks: Option<usize> = None;
    for (i, c) in line[line_span.clone()].char_indices() {
        let i = line_span.start + i;
        if c.is_whitespace() {
            blanks.get_or_insert(i);
        } else if let Some(first) = blanks.take() {
            let gap = &line[first..i];
            if !wide || gap.contains('\t') || gap.chars().count() > 1 {
                add(start..first);
                start = i;
            }
        }
    }
    add(start..line_span.end);
    cells
}

fn quoted_cells(line: &str, separator: char) -> Result<Vec<Cell<'_>>, usize> {
    let mut cells: Vec<Cell<'_>> = Vec::new();
    let mut start = 0;
    loop {
        let rest = &line[start..];
        let lead = rest.len()
            - rest
                .trim_start_matches(|c: char| c != separator && c.is_whitespace())
                .len();
        let (end, cell) = match line[start + lead..].starts_with('"') {
            true => quoted(line, start + lead, separator).ok_or(cells.len())?,
            false => plain(line, start, separator),
        };
        cells.push(cell);
        match line[end..].chars().next() {
            Some(c) => start = end + c.len_utf8(),
            None => return Ok(cells),
        }
    }
}

/// A cell without quotes, and where it ends.
fn plain(line: &str, start: usize, separator: char) -> (usize, Cell<'_>) {
    let end = line[start..]
        .find(separator)
        .map_or(line.len(), |i| start + i);
    let span = trimmed(line, start..end);
    (end, (span.clone(), Cow::Borrowed(&line[span])))
}

/// A cell that begins with a quote; `None` where no quote closes it.
fn quoted(line: &str, start: usize, separator: char) -> Option<(usize, Cell<'_>)> {
    let mut text = String::new();
    let mut at = start + 1;
    loop {
        let close = at + line[at..].find('"')?;
        text.push_str(&line[at..close]);
        at = close + 1;
        if !line[at..].starts_with('"') {
            break;
        }
        text.push('"');
        at += 1;
    }
    let (end, (span, _)) = plain(line, at, separator);
    match span.is_empty() {
        true => Some((end, (start..at, Cow::Owned(text.trim().to_owned())))),
        // Quotes around a part of the cell alone belong to it.
        false => Some(plain(line, start, separator)),
    }
}

/// A line with cells, or a few that a quoted title joins.
pub(super) struct Record<'a> {
    /// Number of its line, from 1.
    pub line: usize,
    /// Its bytes in the text, without the end of the line.
    pub span: Range<usize>,
    /// Its cells, or the place of one whose quote is not closed.
    pub cells: Result<Vec<Cell<'a>>, usize>,
}

/// The lines of a text, from a byte on, that are not empty.
pub(super) struct Records<'a> {
    text: &'a str,
    next: usize,
    line: usize,
    separator: Separator,
}

impl<'a> Records<'a> {
    /// From the beginning of the line with this number, from 1.
    pub(super) fn new(text: &'a str, start: usize, line: usize, separator: Separator) -> Self {
        Self {
            text,
            next: start,
            line,
            separator,
        }
    }

    /// The end of a line that begins at a byte, without its line feed, and the beginning of the next one.
    fn end_of_line(&self, start: usize) -> (usize, usize) {
        match self.text[start..].find('\n') {
            Some(i) => (start + i, start + i + 1),
            None => (self.text.len(), self.text.len()),
        }
    }

    /// Cells of a title with breaks in it: over a few lines, and without a number.
    fn joined(
        &self,
        start: usize,
        mut next: usize,
    ) -> Option<(Range<usize>, usize, Vec<Cell<'a>>)> {
        for _ in 1..LINES_OF_A_TITLE {
            if next >= self.text.len() {
                return None;
            }
            let (end, after) = self.end_of_line(next);
            next = after;
            if let Ok(cells) = cells(&self.text[start..end], self.separator) {
                let is_title = !cells.iter().any(|(_, cell)| super::number::is_number(cell));
                return is_title.then_some((start..end, next, cells));
            }
        }
        None
    }
}

impl<'a> Iterator for Records<'a> {
    type Item = Record<'a>;

    fn next(&mut self) -> Option<Record<'a>> {
        while self.next < self.text.len() {
            let (start, line) = (self.next, self.line);
            let (end, after) = self.end_of_line(start);
            (self.next, self.line) = (after, line + 1);
            let own = &self.text[start..end];
            if own.trim().is_empty() {
                continue;
            }
            let span = start..start + own.trim_end().len();
            // A tab at the end separates an empty cell.
            let own = own.trim_end_matches(['\r', ' ']);
            let (span, cells) = match cells(own, self.separator) {
                Err(_) if !is_comment(own) && self.joined(start, after).is_some() => {
                    let (span, next, cells) = self.joined(start, after)?;
                    self.line += self.text[after..next].matches('\n').count();
                    self.next = next;
                    (span, Ok(cells))
                }
                cells => (span, cells),
            };
            return Some(Record { line, span, cells });
        }
        None
    }
}

/// Whether a line is a comment.
pub(super) fn is_comment(line: &str) -> bool {
    let line = line.trim_start();
    // A unit `%` in the first column is none.
    let after_percent = line.strip_prefix('%');
    let is_percent = after_percent
        .is_some_and(|rest| !rest.trim_start().starts_with([';', ',', '\t']) && !rest.is_empty());
    line.starts_with('#') || line.starts_with("//") || line.starts_with('!') || is_percent
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(line: &str, separator: Separator) -> Vec<String> {
        let cells = cells(line, separator).unwrap();
        cells
            .into_iter()
            .map(|(_, cell)| cell.into_owned())
            .collect()
    }

    #[test]
    fn cells_of_a_line() {
        let comma = Separator::Char(',');
        for (line, separator, expected) in [
            ("a, b ,,c", comma, &["a", "b", "", "c"][..]),
            ("\"a, \"\"b\"\"\", \"c\" ,d", comma, &["a, \"b\"", "c", "d"]),
            ("3/4\" ball,\"x\" y", comma, &["3/4\" ball", "\"x\" y"]),
            ("a;", Separator::Char(';'), &["a", ""]),
            ("\t1\t", Separator::Char('\t'), &["", "1", ""]),
            ("  a b   c \t d ", Separator::WideBlanks, &["a b", "c", "d"]),
            (" 1  2 3", Separator::Blanks, &["1", "2", "3"]),
            ("", comma, &[""]),
        ] {
            assert_eq!(texts(line, separator), expected, "{line:?}");
        }
        assert_eq!(cells("1,\"2", comma), Err(1));
        let (span, _) = cells("1, \"b\"", comma).unwrap()[1].clone();
        assert_eq!(span, 3..6);
    }
}
