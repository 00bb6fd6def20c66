//! TOML input with errors that point at the line: file, line, column, caret, and the choices.
//!
//! A [`Document`] is a parsed file. Its [`Table`]s hand out values by key and remember which keys were asked
//! for; [`Table::finish`] then refuses every key nobody asked for. Values are checked as they are read:
//! dimension, finiteness and [`Bounds`].
//!
//! ```
//! use ertel_input::{Bounds, Document};
//! use ertel_quantity::Dimension;
//!
//! let document = Document::parse("case.toml", "[contact]\nradius = \"16 mm\"\n")?;
//! let mut root = document.root();
//! let mut contact = root.required_table("contact")?;
//! let radius = contact.required_quantity("radius", Dimension::LENGTH, Bounds::POSITIVE)?;
//! contact.finish()?;
//! root.finish()?;
//! assert_eq!(radius, 0.016);
//! # Ok::<(), ertel_input::InputError>(())
//! ```

mod bounds;
pub mod csv;
mod error;
pub mod file;
mod inputs;
pub mod keys;
mod nearest;
mod shown;
mod source;
mod table;
pub mod tree;
mod unit_meant;
mod usual;

use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

pub use bounds::Bounds;
pub use error::InputError;
pub use inputs::{Input, Inputs, Recorder};
pub use shown::{LONGEST_EXCERPT, escaped, excerpt};
pub use table::{StrOrTable, Table};
pub use unit_meant::{unit_meant, usual_of};
pub use usual::Usual;

use source::Source;
use tree::{Entry, Node, Value};

/// A parsed TOML file.
#[derive(Clone, Debug)]
pub struct Document {
    source: Arc<Source>,
    root: Node,
}

impl Document {
    /// Parses TOML text; `file` is the name that errors show.
    ///
    /// # Errors
    ///
    /// Syntax errors and duplicate keys, with their place.
    pub fn parse(file: impl Into<String>, text: impl Into<String>) -> Result<Self, InputError> {
        let source = Source {
            file: file.into(),
            text: text.into(),
            others: Vec::new(),
        };
        let root = tree::parse(&source)?;
        Ok(Self {
            source: Arc::new(source),
            root,
        })
    }

    /// Reads and parses a file.
    ///
    /// # Errors
    ///
    /// A file that is no regular file, is larger than [`file::LARGEST_DOCUMENT`], cannot be read or is not UTF-8, and the
    /// errors of [`Document::parse`].
    pub fn read(path: &Path) -> Result<Self, InputError> {
        let file = path.display().to_string();
        let text = file::read_text(path, file::LARGEST_DOCUMENT)
            .map_err(|error| InputError::of_file(&file, error.to_string()))?;
        Self::parse(file, text)
    }

    /// The name that errors show.
    #[must_use]
    pub fn file(&self) -> &str {
        &self.source.file
    }

    /// The text as read.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.source.text
    }

    /// The values as written in the file, for an echo; reading goes through [`Document::root`].
    #[must_use]
    pub fn tree(&self) -> &Node {
        &self.root
    }

    /// Adds another file, whose values can then be inserted; returns the offset to add to the spans of its nodes
    /// ([`Node::shifted`]), so that errors point there.
    #[must_use]
    pub fn with_file(&self, file: &str, text: &str) -> (Self, usize) {
        let mut source = Source::clone(&self.source);
        let lengths = source.others.iter().map(|other| other.text.len() + 1);
        let offset = source.text.len() + 1 + lengths.sum::<usize>();
        source.others.push(Arc::new(Source {
            file: file.to_owned(),
            text: text.to_owned(),
            others: Vec::new(),
        }));
        let document = Self {
            source: Arc::new(source),
            root: self.root.clone(),
        };
        (document, offset)
    }

    /// An error at a span, about the key path `key`.
    #[must_use]
    pub fn error_at(
        &self,
        span: Range<usize>,
        key: &str,
        message: impl Into<String>,
    ) -> InputError {
        InputError::at(&self.source, span, key, message)
    }

    /// Inserts or replaces the value at a key path; missing tables are created. Errors about the key point to
    /// `key_span`.
    ///
    /// # Errors
    ///
    /// A value on the way that is no table.
    pub fn put(
        &mut self,
        path: &str,
        key_span: &Range<usize>,
        node: Node,
    ) -> Result<(), InputError> {
        let mut table = &mut self.root;
        let mut keys = path.split('.').peekable();
        while let Some(key) = keys.next() {
            let kind = table.kind();
            // Tables of an array, such as those of [[surface]], are counted from 1.
            if let Value::Array(nodes) = &table.value {
                let n = nodes.len();
                let place = tree::place_of(key).filter(|place| *place < n);
                let Some(place) = place else {
                    let at = key.as_ptr() as usize - path.as_ptr() as usize;
                    let (list, rest) = path.split_at(at);
                    let list = list.trim_end_matches('.');
                    let problem = match tree::place_of(key) {
                        Some(_) => format!("{list} has {n} entries, counted from 1"),
                        None => format!("{list} is a list: write {list}.1.{rest}"),
                    };
                    return Err(InputError::at(
                        &self.source,
                        key_span.clone(),
                        path,
                        format!("`{path}` cannot be set: {problem}"),
                    ));
                };
                let Value::Array(nodes) = &mut table.value else {
                    unreachable!("it is one");
                };
                table = &mut nodes[place];
                if keys.peek().is_none() {
                    *table = node;
                    return Ok(());
                }
                continue;
            }
            let Value::Table(entries) = &mut table.value else {
                let at = &path[..key.as_ptr() as usize - path.as_ptr() as usize];
                let parent = at.trim_end_matches('.');
                return Err(InputError::at(
                    &self.source,
                    key_span.clone(),
                    path,
                    format!("`{path}` cannot be set: `{parent}` is {kind}, not a table"),
                ));
            };
            let index = match entries.iter().position(|entry| entry.key == key) {
                Some(index) => index,
                None => {
                    entries.push(Entry {
                        key: key.to_owned(),
                        key_span: key_span.clone(),
                        node: Node {
                            span: key_span.clone(),
                            value: Value::Table(Vec::new()),
                        },
                    });
                    entries.len() - 1
                }
            };
            if keys.peek().is_none() {
                entries[index].node = node;
                return Ok(());
            }
            table = &mut entries[index].node;
        }
        Ok(())
    }

    /// Takes the key at a path out, with its value; nothing happens where there is none.
    pub fn remove(&mut self, path: &str) {
        let (tables, key) = path.rsplit_once('.').unwrap_or(("", path));
        let mut table = &mut self.root;
        for name in tables.split('.').filter(|name| !name.is_empty()) {
            let Value::Table(entries) = &mut table.value else {
                return;
            };
            match entries.iter_mut().find(|entry| entry.key == name) {
                Some(entry) => table = &mut entry.node,
                None => return,
            }
        }
        if let Value::Table(entries) = &mut table.value {
            entries.retain(|entry| entry.key != key);
        }
    }

    /// The top-level table.
    #[must_use]
    pub fn root(&self) -> Table<'_> {
        Table::new(&self.source, &self.root, String::new())
    }

    /// The same with its quantities noted as they are read.
    #[must_use]
    pub fn root_noted_by<'a>(&'a self, inputs: Option<Recorder<'a>>) -> Table<'a> {
        self.root().noted_by(inputs)
    }
}

#[cfg(test)]
mod tests;
