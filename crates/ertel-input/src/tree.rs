//! TOML text to an owned tree with byte spans, tables in the order of the file.

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::InputError;
use super::source::Source;

/// A value and its place.
#[derive(Clone, Debug)]
pub struct Node {
    /// Bytes of the text it takes.
    pub span: Range<usize>,
    /// The value.
    pub value: Value,
}

/// The TOML types.
#[derive(Clone, Debug)]
pub enum Value {
    /// A string.
    Str(String),
    /// An integer; `None` if it does not fit 64 bits.
    Integer(Option<i64>),
    /// A float, which TOML allows to be NaN or infinite.
    Float(f64),
    /// A boolean.
    Bool(bool),
    /// A date or time, which no input uses.
    Datetime,
    /// An array.
    Array(Vec<Node>),
    /// A table, in the order of the file.
    Table(Vec<Entry>),
}

/// A key with its value.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The key, quotes removed.
    pub key: String,
    /// Bytes of the key.
    pub key_span: Range<usize>,
    /// The value.
    pub node: Node,
}

/// The place of an entry of an array whose number, from 1, is in a key path: `surface.2.depth`.
pub(crate) fn place_of(key: &str) -> Option<usize> {
    key.parse::<usize>().ok()?.checked_sub(1)
}

impl Node {
    /// The same with all spans moved on by `offset` bytes, those of keys too.
    #[must_use]
    pub fn shifted(mut self, offset: usize) -> Self {
        let move_on = |span: &Range<usize>| span.start + offset..span.end + offset;
        self.span = move_on(&self.span);
        match &mut self.value {
            Value::Array(nodes) => {
                for node in nodes {
                    *node = node.clone().shifted(offset);
                }
            }
            Value::Table(entries) => {
                for entry in entries {
                    entry.key_span = move_on(&entry.key_span);
                    entry.node = entry.node.clone().shifted(offset);
                }
            }
            _ => {}
        }
        self
    }

    /// The entry at a key path such as `contact.load`, if it is there.
    #[must_use]
    pub fn entry(&self, path: &str) -> Option<&Entry> {
        let (key, rest) = path.split_once('.').unwrap_or((path, ""));
        let entries = match &self.value {
            Value::Table(entries) => entries,
            Value::Array(nodes) => return nodes.get(place_of(key)?)?.entry(rest),
            _ => return None,
        };
        let entry = entries.iter().find(|entry| entry.key == key)?;
        if rest.is_empty() {
            Some(entry)
        } else {
            entry.node.entry(rest)
        }
    }

    /// The kind of value with its article, for messages.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        match self.value {
            Value::Str(_) => "a string",
            Value::Integer(_) => "an integer",
            Value::Float(_) => "a number",
            Value::Bool(_) => "a boolean",
            Value::Datetime => "a date or time",
            Value::Array(_) => "an array",
            Value::Table(_) => "a table",
        }
    }
}

pub(super) fn parse(source: &Source) -> Result<Node, InputError> {
    let table = DeTable::parse(&source.text).map_err(|error| {
        let end = source.text.len();
        let span = error.span().unwrap_or(end..end);
        let problem = error.message();
        // Words of the parser where it stops before its stack ends.
        let message = if problem.contains("recurs") {
            "nested too deeply: tables and arrays go into each other 80 times at most".to_owned()
        } else {
            format!("not valid TOML: {problem}")
        };
        InputError::at(source, span, "", message)
    })?;
    let span = table.span();
    Ok(Node {
        span,
        value: of_table(table.into_inner()),
    })
}

fn of_table(table: DeTable<'_>) -> Value {
    let mut entries: Vec<Entry> = table
        .into_iter()
        .map(|(key, value)| Entry {
            key_span: key.span(),
            key: key.into_inner().into_owned(),
            node: of_value(value),
        })
        .collect();
    entries.sort_by_key(|entry| entry.key_span.start);
    Value::Table(entries)
}

fn of_value(spanned: Spanned<DeValue<'_>>) -> Node {
    let span = spanned.span();
    let value = match spanned.into_inner() {
        DeValue::String(text) => Value::Str(text.into_owned()),
        DeValue::Integer(digits) => {
            Value::Integer(i64::from_str_radix(digits.as_str(), digits.radix()).ok())
        }
        // The digits are valid TOML, so the only failure left would be a bug; NaN is refused by every reader.
        DeValue::Float(digits) => Value::Float(digits.as_str().parse().unwrap_or(f64::NAN)),
        DeValue::Boolean(value) => Value::Bool(value),
        DeValue::Datetime(_) => Value::Datetime,
        DeValue::Array(array) => Value::Array(array.into_iter().map(of_value).collect()),
        DeValue::Table(table) => of_table(table),
    };
    Node { span, value }
}
