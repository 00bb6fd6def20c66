//! A report as headings, rows and tables: written as text here and as a page by [`super::html`].

use std::fmt::Write;

use crate::warning::Warning;

/// Width of the name column.
pub(super) const NAME_WIDTH: usize = 34;

/// Width of the value column in rows with a second column.
pub(super) const VALUE_WIDTH: usize = 26;

/// A figure and a second column.
pub(super) fn two_columns(text: &str, other: &str) -> String {
    format!("{text:<VALUE_WIDTH$}  {other}")
        .trim_end()
        .to_owned()
}

/// A block of a report.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Block {
    /// Title of the report.
    Title(String),
    /// Heading of the following blocks.
    Heading(String),
    /// A quantity and its value.
    Row(String, String),
    /// A sentence.
    Line(String),
    /// A note to the table above, such as a source.
    Note(String),
    /// A table.
    Table(Table),
    /// A warning.
    Warnings(Vec<String>),
}

/// A table with a head.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Table {
    /// Titles of the columns.
    pub head: Vec<String>,
    /// Cells.
    pub rows: Vec<Vec<String>>,
    /// Width of each column in text form, and the minimum number of spaces after it.
    pub widths: Vec<(usize, usize)>,
}

/// A report under construction.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Lines {
    /// Its blocks in order.
    pub blocks: Vec<Block>,
}

impl Lines {
    pub fn title(&mut self, title: &str) {
        // Removes control characters from a title
        let mut clean: String = title.chars().filter(|c| !c.is_control()).collect();
        if clean.trim().is_empty() {
            clean = "Elastohydrodynamic contact".to_owned();
        }
        self.blocks.push(Block::Title(clean));
    }

    pub fn heading(&mut self, heading: &str) {
        self.blocks.push(Block::Heading(heading.to_owned()));
    }

    pub fn line(&mut self, text: &str) {
        self.blocks.push(Block::Line(text.to_owned()));
    }

    pub fn note(&mut self, text: &str) {
        self.blocks.push(Block::Note(text.to_owned()));
    }

    pub fn row(&mut self, name: &str, value: impl AsRef<str>) {
        let value = value.as_ref().to_owned();
        self.blocks.push(Block::Row(name.to_owned(), value));
    }

    pub fn table(&mut self, table: Table) {
        self.blocks.push(Block::Table(table));
    }

    /// Warnings under a separate heading, if there are any; then notes.
    pub fn warnings(&mut self, warnings: &[Warning]) {
        let shown = shown_warnings(warnings);
        if !shown.is_empty() {
            self.heading("Warnings");
            self.blocks.push(Block::Warnings(shown));
        }
        let notes: Vec<&Warning> = warnings.iter().filter(|w| w.is_shown_note()).collect();
        if !notes.is_empty() {
            self.heading("Notes");
        }
        for note in notes {
            self.note(&note.coded());
        }
    }

    /// The report as text for a terminal.
    pub fn text(&self) -> String {
        let mut text = String::new();
        for block in &self.blocks {
            // Writing to a string does not fail.
            let _ = block.write(&mut text);
        }
        text
    }
}

/// The sentences of warnings with their codes.
pub(super) fn shown_warnings(warnings: &[Warning]) -> Vec<String> {
    let shown = warnings.iter().filter(|w| w.is_shown());
    shown.map(Warning::coded).collect()
}

impl Block {
    fn write(&self, out: &mut String) -> std::fmt::Result {
        match self {
            Block::Title(title) => {
                let rule = "─".repeat(title.chars().count().max(4));
                writeln!(out, "{title}\n{rule}")
            }
            Block::Heading(heading) => writeln!(out, "\n{heading}"),
            Block::Row(name, value) => {
                let gap = if name.chars().count() < NAME_WIDTH {
                    ""
                } else {
                    "  "
                };
                writeln!(out, "  {name:<NAME_WIDTH$}{gap}{value}")
            }
            Block::Line(text) => writeln!(out, "  {}", text.trim_end()),
            Block::Note(text) => writeln!(out, "  · {text}"),
            Block::Table(table) => out.write_str(&table.text()),
            Block::Warnings(warnings) => warnings
                .iter()
                .try_for_each(|warning| writeln!(out, "  ! {warning}")),
        }
    }
}

/// Characters across a page.
const PAGE: usize = 80;

impl Table {
    /// A table whose columns are as wide as their cells, closer together where it is wider than a page.
    pub fn fitted(head: Vec<String>, rows: Vec<Vec<String>>) -> Table {
        let width = |j: usize| {
            let cells = rows.iter().map(|row: &Vec<String>| row[j].chars().count());
            cells.chain([head[j].chars().count()]).max().unwrap_or(0)
        };
        let widths: Vec<usize> = (0..head.len()).map(width).collect();
        let wide = 2 + widths.iter().sum::<usize>() + 2 * widths.len().saturating_sub(1);
        let gap = if wide > PAGE { 1 } else { 2 };
        let widths = widths.into_iter().map(|width| (width, gap)).collect();
        Table { head, rows, widths }
    }

    /// As text, a line for the head and for each row.
    pub fn text(&self) -> String {
        let rows = std::iter::once(&self.head).chain(&self.rows);
        rows.map(|row| self.line(row) + "\n").collect()
    }

    fn line(&self, row: &[String]) -> String {
        let mut line = "  ".to_owned();
        for (cell, (width, gap)) in row.iter().zip(&self.widths) {
            let _ = write!(line, "{cell:<width$}{:gap$}", "");
        }
        line.trim_end().to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::warning::WarningKind;

    #[test]
    fn blocks_as_text() {
        let mut out = Lines::default();
        out.title("A \u{1b}ball");
        out.heading("Results");
        out.row("film", "1 nm");
        out.table(Table {
            head: ["", "a", "b"].map(str::to_owned).to_vec(),
            rows: vec![["x", "too wide", "2"].map(str::to_owned).to_vec()],
            widths: vec![(3, 0), (4, 1), (4, 0)],
        });
        out.note("source");
        out.warnings(&[Warning::new(WarningKind::NoEffect, "look")]);
        let row = format!("  film{}1 nm\n", " ".repeat(NAME_WIDTH - 4));
        let expected = format!(
            "A ball\n──────\n\nResults\n{row}     a    b\n  x  too wide 2\n  · source\n\nWarnings\n  ! look [no-effect]\n"
        );
        assert_eq!(out.text(), expected);
    }
}
