//! TOML input with errors that point at the line: file, line, column, caret, and the choices.
//!
//! A [`Document`] is a parsed file. Its [`Table`]s hand out values by key and remember which keys were asked
//! for; [`Table::finish`] then refuses every key nobody asked for. Values are checked as they are read:
//! dimension, finiteness and [`Bounds`].
//!
//! ```
//! use ertel_rheology::input::{Bounds, Document};
//! use ertel_rheology::quantity::Dimension;
//!
//! let document = Document::parse("case.toml", "[contact]\nradius = \"16 mm\"\n")?;
//! let mut root = document.root();
//! let mut contact = root.required_table("contact")?;
//! let radius = contact.required_quantity("radius", Dimension::LENGTH, Bounds::POSITIVE)?;
//! contact.finish()?;
//! root.finish()?;
//! assert_eq!(radius, 0.016);
//! # Ok::<(), ertel_rheology::input::InputError>(())
//! ```

mod bounds;
mod error;
mod table;
pub mod tree;

use std::path::Path;

pub use bounds::Bounds;
pub use error::InputError;
pub use table::{StrOrTable, Table};

use tree::Node;

/// The name and text of a file, kept for error messages.
#[derive(Clone, Debug)]
struct Source {
    file: String,
    text: String,
}

/// A parsed TOML file.
#[derive(Debug)]
pub struct Document {
    source: Source,
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
        };
        let root = tree::parse(&source)?;
        Ok(Self { source, root })
    }

    /// Reads and parses a file.
    ///
    /// # Errors
    ///
    /// A file that cannot be read or is not UTF-8, and the errors of [`Document::parse`].
    pub fn read(path: &Path) -> Result<Self, InputError> {
        let file = path.display().to_string();
        let bytes = std::fs::read(path)
            .map_err(|error| InputError::of_file(&file, format!("cannot be read: {error}")))?;
        let text = String::from_utf8(bytes).map_err(|error| {
            let valid = error.utf8_error().valid_up_to();
            let line = 1 + error.as_bytes()[..valid]
                .iter()
                .filter(|byte| **byte == b'\n')
                .count();
            InputError::of_file(&file, format!("is not UTF-8 text (line {line})"))
        })?;
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

    /// The values as they stand in the file, for an echo; reading goes through [`Document::root`].
    #[must_use]
    pub fn tree(&self) -> &Node {
        &self.root
    }

    /// The document with another value at the key path `path`, such as `contact.load`; `None` if there is no such key.
    /// Errors about the value point to the place of `node`.
    #[must_use]
    pub fn with_value(&self, path: &str, node: Node) -> Option<Self> {
        let mut root = self.root.clone();
        root.entry_mut(path)?.node = node;
        Some(Self {
            source: self.source.clone(),
            root,
        })
    }

    /// The top-level table.
    #[must_use]
    pub fn root(&self) -> Table<'_> {
        Table::new(&self.source, &self.root, String::new())
    }
}

#[cfg(test)]
mod tests;
