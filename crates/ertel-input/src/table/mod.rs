//! A table whose keys are read by name, and which reports unread keys.

mod correlations;
mod errors;
mod numbers;
mod tables;
mod text;

use std::ops::Range;

use super::InputError;
use super::inputs::Recorder;
use super::source::Source;
use super::tree::{Entry, Node, Value};

/// A TOML table being read.
///
/// `required_*` readers fail on a missing key; `optional_*` readers return `None`. All of them fail on a
/// value of the wrong kind, dimension or size. Call [`Table::finish`] at the end.
#[derive(Debug, Clone)]
pub struct Table<'a> {
    source: &'a Source,
    path: String,
    span: Range<usize>,
    entries: &'a [Entry],
    /// Keys asked for so far, in that order.
    known: Vec<String>,
    /// Where its quantities are noted, if anywhere.
    inputs: Option<Recorder<'a>>,
}

/// A value that is a name or a table: `steel` or `{ youngs_modulus = "210 GPa", ... }`.
#[derive(Debug, Clone)]
pub enum StrOrTable<'a> {
    /// A string.
    Str(&'a str),
    /// A table.
    Table(Table<'a>),
}

impl<'a> Table<'a> {
    /// `node` must be a table; anything else reads as an empty one.
    pub(super) fn new(source: &'a Source, node: &'a Node, path: String) -> Self {
        let entries: &[Entry] = match &node.value {
            Value::Table(entries) => entries,
            _ => &[],
        };
        Self {
            source,
            path,
            span: node.span.clone(),
            entries,
            known: Vec::new(),
            inputs: None,
        }
    }

    /// The same with its quantities noted, those of tables in it, too.
    pub(super) fn noted_by(self, inputs: Option<Recorder<'a>>) -> Self {
        Self { inputs, ..self }
    }

    /// Recorder of the quantities for the key `key` of this table, if any.
    #[must_use]
    pub fn recorder(&self, key: &str) -> Option<Recorder<'a>> {
        let inputs = self.inputs.as_ref()?;
        Some(inputs.within(&self.path_of(key)))
    }

    /// The same for this table itself.
    #[must_use]
    pub fn own_recorder(&self) -> Option<Recorder<'a>> {
        let inputs = self.inputs.as_ref()?;
        Some(inputs.within(&self.path))
    }

    /// The same without noting its quantities, for numbers that are names: a grade has no derivative.
    #[must_use]
    pub fn unnoted(&self) -> Table<'a> {
        self.clone().noted_by(None)
    }

    /// The key path of this table, `bodies.body_2`; empty for the top level.
    #[must_use]
    pub fn path(&self) -> &str {
        &self.path
    }

    /// The keys present, in the order of the file.
    pub fn keys(&self) -> impl Iterator<Item = &'a str> + use<'a> {
        self.entries.iter().map(|entry| entry.key.as_str())
    }

    /// Whether `key` is present. Counts as asking for it.
    pub fn contains(&mut self, key: &str) -> bool {
        self.entry(key).is_some()
    }

    /// Whether the value of `key` is a table. Counts as asking for it.
    pub fn is_table(&mut self, key: &str) -> bool {
        let entry = self.entry(key);
        entry.is_some_and(|entry| matches!(entry.node.value, Value::Table(_)))
    }

    fn entry(&mut self, key: &str) -> Option<&'a Entry> {
        if !self.known.iter().any(|known| known == key) {
            self.known.push(key.to_owned());
        }
        self.entries.iter().find(|entry| entry.key == key)
    }

    /// The elements of an array; `wanted` describes it.
    fn optional_array(
        &mut self,
        key: &str,
        wanted: &str,
    ) -> Result<Option<&'a [Node]>, InputError> {
        match self.entry(key) {
            None => Ok(None),
            Some(entry) => match &entry.node.value {
                Value::Array(nodes) => Ok(Some(nodes)),
                _ => Err(self.wrong_kind(entry, wanted)),
            },
        }
    }

    fn child(&self, node: &'a Node, key: &str) -> Table<'a> {
        Table::new(self.source, node, self.path_of(key)).noted_by(self.inputs.clone())
    }

    fn path_of(&self, key: &str) -> String {
        if self.path.is_empty() {
            key.to_owned()
        } else {
            format!("{}.{key}", self.path)
        }
    }
}
