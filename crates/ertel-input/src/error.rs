//! The error of all input files, displayed with the offending line.

use std::fmt;
use std::ops::Range;

use super::shown::{LONGEST_EXCERPT, escaped, excerpt, message};
use super::source::Source;

/// Something wrong in an input file: what, where, and what would be right.
///
/// Displays like a compiler message:
///
/// ```text
/// unknown key `raduis` in [contact]
///   --> steel.toml:4:1
///    |
///  4 | raduis = "16 mm"
///    | ^^^^^^ did you mean `radius`?
///    = help: the keys here are kind, radius, load
/// ```
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct InputError(Box<Report>);

#[derive(Debug, Clone, PartialEq, Eq)]
struct Report {
    file: String,
    key: String,
    message: String,
    place: Option<Place>,
    label: String,
    help: Vec<String>,
    is_missing: bool,
}

/// A stretch of one line; counted from 1, columns in characters.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Place {
    line: usize,
    column: usize,
    /// The line, or a part of it around the column, without control characters.
    text: String,
    /// Characters of the text before the caret, and below it.
    indent: usize,
    width: usize,
}

impl InputError {
    /// An error at the bytes `span` of `source`, about the key path `key`.
    pub(super) fn at(
        source: &Source,
        span: Range<usize>,
        key: impl Into<String>,
        message: impl Into<String>,
    ) -> Self {
        let (source, span) = source.resolve(span);
        Self(Box::new(Report {
            file: source.file.clone(),
            key: key.into(),
            message: message.into(),
            place: Some(Place::of(&source.text, span)),
            label: String::new(),
            help: Vec::new(),
            is_missing: false,
        }))
    }

    /// An error about a file as a whole.
    pub(super) fn of_file(file: &str, message: impl Into<String>) -> Self {
        Self(Box::new(Report {
            file: file.to_owned(),
            key: String::new(),
            message: message.into(),
            place: None,
            label: String::new(),
            help: Vec::new(),
            is_missing: false,
        }))
    }

    /// Marks it as one about a key that is not there.
    pub(super) fn of_missing(mut self) -> Self {
        self.0.is_missing = true;
        self
    }

    /// Whether it is about a key that is not there.
    pub(super) fn is_missing(&self) -> bool {
        self.0.is_missing
    }

    /// Adds words after the caret.
    #[must_use]
    pub fn with_label(mut self, label: impl Into<String>) -> Self {
        self.0.label = label.into();
        self
    }

    /// Adds a help line.
    #[must_use]
    pub fn with_help(mut self, help: impl Into<String>) -> Self {
        self.0.help.push(help.into());
        self
    }

    /// The file's name.
    #[must_use]
    pub fn file(&self) -> &str {
        &self.0.file
    }

    /// The line, counted from 1, if the error has a place in the file.
    #[must_use]
    pub fn line(&self) -> Option<usize> {
        self.0.place.as_ref().map(|place| place.line)
    }

    /// The column in characters, counted from 1, if the error has a place in the file.
    #[must_use]
    pub fn column(&self) -> Option<usize> {
        self.0.place.as_ref().map(|place| place.column)
    }

    /// The key path, `contact.radius`; empty for syntax errors.
    #[must_use]
    pub fn key(&self) -> &str {
        &self.0.key
    }

    /// The problem in one sentence, without the place.
    #[must_use]
    pub fn message(&self) -> &str {
        &self.0.message
    }

    /// Help lines.
    #[must_use]
    pub fn help(&self) -> &[String] {
        &self.0.help
    }
}

impl Place {
    fn of(text: &str, span: Range<usize>) -> Self {
        let floor = |mut at: usize| {
            at = at.min(text.len());
            while !text.is_char_boundary(at) {
                at -= 1;
            }
            at
        };
        let (start, end) = (floor(span.start), floor(span.end));
        let line_start = text[..start].rfind('\n').map_or(0, |at| at + 1);
        let line_end = text[start..].find('\n').map_or(text.len(), |at| start + at);
        // A tab would shift the caret; both lines show one blank for it.
        let shown =
            |part: &str| escaped(&part.trim_end_matches('\r').replace('\t', " ")).into_owned();
        let (before, after) = (&text[line_start..start], &text[start..line_end]);
        let marked = &after[..end.max(start).min(line_end) - start];
        // Of a long line half the excerpt before the caret at most.
        let half = LONGEST_EXCERPT / 2;
        let n_before = before.chars().count();
        let n_cut = n_before.saturating_sub(half);
        let mut lead: String = shown(&before.chars().skip(n_cut).collect::<String>());
        let room = LONGEST_EXCERPT - (n_before - n_cut);
        let mut tail = shown(&after.chars().take(room).collect::<String>());
        if n_cut > 0 {
            lead.insert(0, '…');
        }
        if after.chars().nth(room).is_some() {
            tail.push('…');
        }
        let width = shown(&marked.chars().take(room).collect::<String>());
        Self {
            line: 1 + text[..start].matches('\n').count(),
            column: 1 + n_before,
            indent: lead.chars().count(),
            width: width.chars().count().max(1),
            text: lead + &tail,
        }
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = message(&self.message);
        let Some(place) = &self.place else {
            write!(f, "{} {}", excerpt(&self.file), text)?;
            for help in &self.help {
                write!(f, "\n  = help: {}", message(help))?;
            }
            return Ok(());
        };
        let gutter = place.line.to_string().len().max(2);
        let blank = " ".repeat(gutter);
        writeln!(f, "{text}")?;
        writeln!(
            f,
            "{blank}--> {}:{}:{}",
            excerpt(&self.file),
            place.line,
            place.column
        )?;
        writeln!(f, "{blank} |")?;
        writeln!(f, "{:>gutter$} | {}", place.line, place.text)?;
        let indent = " ".repeat(place.indent);
        write!(f, "{blank} | {indent}{}", "^".repeat(place.width))?;
        if !self.label.is_empty() {
            write!(f, " {}", message(&self.label))?;
        }
        for help in &self.help {
            write!(f, "\n{blank} = help: {}", message(help))?;
        }
        Ok(())
    }
}
