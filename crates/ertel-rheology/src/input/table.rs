//! A table whose keys are read by name, and which knows the keys nobody read.

use std::ops::{Range, RangeInclusive};

use super::tree::{Entry, Node, Value};
use super::{Bounds, InputError, Source};
use crate::quantity::{self, Dimension, QuantityError};

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
        }
    }

    /// The key path of this table, `bodies.ball`; empty for the top level.
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

    // ---- quantities and numbers

    /// A number with a unit, in SI; a pure number may be written without quotes.
    ///
    /// # Errors
    ///
    /// A missing key, a text that is no such quantity, a value that is not finite or out of `bounds` (SI).
    pub fn required_quantity(
        &mut self,
        key: &str,
        dimension: Dimension,
        bounds: Bounds,
    ) -> Result<f64, InputError> {
        self.optional_quantity(key, dimension, bounds)?
            .ok_or_else(|| self.missing(key))
    }

    /// Like [`Table::required_quantity`], `None` if the key is absent.
    ///
    /// # Errors
    ///
    /// Those of [`Table::required_quantity`] but for the missing key.
    pub fn optional_quantity(
        &mut self,
        key: &str,
        dimension: Dimension,
        bounds: Bounds,
    ) -> Result<Option<f64>, InputError> {
        let Some(entry) = self.entry(key) else {
            return Ok(None);
        };
        self.quantity_of(&entry.node, key, dimension, bounds)
            .map(Some)
    }

    /// A pure number: `0.3`, or a text such as `"30 %"`.
    ///
    /// # Errors
    ///
    /// As [`Table::required_quantity`].
    pub fn required_number(&mut self, key: &str, bounds: Bounds) -> Result<f64, InputError> {
        self.required_quantity(key, Dimension::DIMENSIONLESS, bounds)
    }

    /// Like [`Table::required_number`], `None` if the key is absent.
    ///
    /// # Errors
    ///
    /// As [`Table::optional_quantity`].
    pub fn optional_number(
        &mut self,
        key: &str,
        bounds: Bounds,
    ) -> Result<Option<f64>, InputError> {
        self.optional_quantity(key, Dimension::DIMENSIONLESS, bounds)
    }

    /// An array of quantities in SI: `["1 MPa", "2 MPa"]`, or pure numbers.
    ///
    /// # Errors
    ///
    /// As [`Table::required_quantity`] for each of the values.
    pub fn required_quantities(
        &mut self,
        key: &str,
        dimension: Dimension,
        bounds: Bounds,
    ) -> Result<Vec<f64>, InputError> {
        self.optional_quantities(key, dimension, bounds)?
            .ok_or_else(|| self.missing(key))
    }

    /// Like [`Table::required_quantities`], `None` if the key is absent.
    ///
    /// # Errors
    ///
    /// As [`Table::optional_quantity`] for each of the values.
    pub fn optional_quantities(
        &mut self,
        key: &str,
        dimension: Dimension,
        bounds: Bounds,
    ) -> Result<Option<Vec<f64>>, InputError> {
        let Some(entry) = self.entry(key) else {
            return Ok(None);
        };
        let Value::Array(nodes) = &entry.node.value else {
            return Err(self.wrong_kind(entry, "an array"));
        };
        nodes
            .iter()
            .map(|node| self.quantity_of(node, key, dimension, bounds))
            .collect::<Result<_, _>>()
            .map(Some)
    }

    /// An array of pure numbers.
    ///
    /// # Errors
    ///
    /// As [`Table::required_quantity`] for each of the values.
    pub fn required_numbers(&mut self, key: &str, bounds: Bounds) -> Result<Vec<f64>, InputError> {
        self.required_quantities(key, Dimension::DIMENSIONLESS, bounds)
    }

    /// Like [`Table::required_numbers`], `None` if the key is absent.
    ///
    /// # Errors
    ///
    /// As [`Table::optional_quantity`] for each of the values.
    pub fn optional_numbers(
        &mut self,
        key: &str,
        bounds: Bounds,
    ) -> Result<Option<Vec<f64>>, InputError> {
        self.optional_quantities(key, Dimension::DIMENSIONLESS, bounds)
    }

    /// An array of points of two pure numbers each, `[[-1, 0], [0.5, 0]]`; `None` if the key is absent.
    ///
    /// # Errors
    ///
    /// A value that is no such array, and numbers out of `bounds`.
    pub fn optional_points(
        &mut self,
        key: &str,
        bounds: Bounds,
    ) -> Result<Option<Vec<[f64; 2]>>, InputError> {
        let Some(entry) = self.entry(key) else {
            return Ok(None);
        };
        let Value::Array(nodes) = &entry.node.value else {
            return Err(self.wrong_kind(entry, "an array of points [x, y]"));
        };
        let number = |node| self.quantity_of(node, key, Dimension::DIMENSIONLESS, bounds);
        nodes
            .iter()
            .map(|node| match &node.value {
                Value::Array(pair) if pair.len() == 2 => Ok([number(&pair[0])?, number(&pair[1])?]),
                _ => Err(self.at_node(
                    node,
                    key,
                    format!("`{key}` needs points of two numbers, [x, y]"),
                )),
            })
            .collect::<Result<_, _>>()
            .map(Some)
    }

    /// A whole number in `range`.
    ///
    /// # Errors
    ///
    /// A missing key, a value that is no whole number or out of range.
    pub fn required_integer(
        &mut self,
        key: &str,
        range: RangeInclusive<i64>,
    ) -> Result<i64, InputError> {
        self.optional_integer(key, range)?
            .ok_or_else(|| self.missing(key))
    }

    /// Like [`Table::required_integer`], `None` if the key is absent.
    ///
    /// # Errors
    ///
    /// A value that is no whole number or out of range.
    pub fn optional_integer(
        &mut self,
        key: &str,
        range: RangeInclusive<i64>,
    ) -> Result<Option<i64>, InputError> {
        let Some(entry) = self.entry(key) else {
            return Ok(None);
        };
        let Value::Integer(value) = entry.node.value else {
            return Err(self.wrong_kind(entry, "a whole number"));
        };
        match value {
            Some(value) if range.contains(&value) => Ok(Some(value)),
            _ => Err(self.error(
                key,
                format!(
                    "`{key}` must be a whole number from {} to {}",
                    range.start(),
                    range.end()
                ),
            )),
        }
    }

    // ---- text, choices, switches

    /// A string.
    ///
    /// # Errors
    ///
    /// A missing key or a value that is no string.
    pub fn required_str(&mut self, key: &str) -> Result<&'a str, InputError> {
        self.optional_str(key)?.ok_or_else(|| self.missing(key))
    }

    /// Like [`Table::required_str`], `None` if the key is absent.
    ///
    /// # Errors
    ///
    /// A value that is no string.
    pub fn optional_str(&mut self, key: &str) -> Result<Option<&'a str>, InputError> {
        match self.entry(key) {
            None => Ok(None),
            Some(entry) => match &entry.node.value {
                Value::Str(text) => Ok(Some(text)),
                _ => Err(self.wrong_kind(entry, "a string")),
            },
        }
    }

    /// An array of strings, `None` if the key is absent.
    ///
    /// # Errors
    ///
    /// A value that is no array, or has an element that is no string.
    pub fn optional_strs(&mut self, key: &str) -> Result<Option<Vec<&'a str>>, InputError> {
        let Some(entry) = self.entry(key) else {
            return Ok(None);
        };
        let Value::Array(nodes) = &entry.node.value else {
            return Err(self.wrong_kind(entry, "an array of strings"));
        };
        nodes
            .iter()
            .map(|node| match &node.value {
                Value::Str(text) => Ok(text.as_str()),
                _ => Err(self.at_node(
                    node,
                    key,
                    format!("`{key}` needs strings, but this is {}", node.kind()),
                )),
            })
            .collect::<Result<_, _>>()
            .map(Some)
    }

    /// One of the named options.
    ///
    /// # Errors
    ///
    /// A missing key, or a name that is not among the options; the error lists them.
    pub fn required_choice<T: Clone>(
        &mut self,
        key: &str,
        options: &[(&str, T)],
    ) -> Result<T, InputError> {
        self.optional_choice(key, options)?.ok_or_else(|| {
            let names: Vec<&str> = options.iter().map(|(name, _)| *name).collect();
            self.missing(key)
                .with_help(format!("`{key}` is one of: {}", names.join(", ")))
        })
    }

    /// Like [`Table::required_choice`], `None` if the key is absent.
    ///
    /// # Errors
    ///
    /// A value that is no string or not among the options; the error lists them.
    pub fn optional_choice<T: Clone>(
        &mut self,
        key: &str,
        options: &[(&str, T)],
    ) -> Result<Option<T>, InputError> {
        let Some(text) = self.optional_str(key)? else {
            return Ok(None);
        };
        match options.iter().find(|(name, _)| *name == text) {
            Some((_, value)) => Ok(Some(value.clone())),
            None => Err(self.unknown_name(key, options.iter().map(|(name, _)| *name))),
        }
    }

    /// `true` or `false`, `None` if the key is absent.
    ///
    /// # Errors
    ///
    /// Any other value.
    pub fn optional_bool(&mut self, key: &str) -> Result<Option<bool>, InputError> {
        match self.entry(key) {
            None => Ok(None),
            Some(entry) => match entry.node.value {
                Value::Bool(value) => Ok(Some(value)),
                _ => Err(self.wrong_kind(entry, "true or false")),
            },
        }
    }

    // ---- tables

    /// A table.
    ///
    /// # Errors
    ///
    /// A missing key or a value that is no table.
    pub fn required_table(&mut self, key: &str) -> Result<Table<'a>, InputError> {
        self.optional_table(key)?.ok_or_else(|| self.missing(key))
    }

    /// Like [`Table::required_table`], `None` if the key is absent.
    ///
    /// # Errors
    ///
    /// A value that is no table.
    pub fn optional_table(&mut self, key: &str) -> Result<Option<Table<'a>>, InputError> {
        match self.entry(key) {
            None => Ok(None),
            Some(entry) => match &entry.node.value {
                Value::Table(_) => Ok(Some(self.child(&entry.node, key))),
                _ => Err(self.wrong_kind(entry, "a table")),
            },
        }
    }

    /// A name or a table.
    ///
    /// # Errors
    ///
    /// A missing key or a value that is neither.
    pub fn required_str_or_table(&mut self, key: &str) -> Result<StrOrTable<'a>, InputError> {
        self.optional_str_or_table(key)?
            .ok_or_else(|| self.missing(key))
    }

    /// Like [`Table::required_str_or_table`], `None` if the key is absent.
    ///
    /// # Errors
    ///
    /// A value that is neither a string nor a table.
    pub fn optional_str_or_table(
        &mut self,
        key: &str,
    ) -> Result<Option<StrOrTable<'a>>, InputError> {
        match self.entry(key) {
            None => Ok(None),
            Some(entry) => match &entry.node.value {
                Value::Str(text) => Ok(Some(StrOrTable::Str(text))),
                Value::Table(_) => Ok(Some(StrOrTable::Table(self.child(&entry.node, key)))),
                _ => Err(self.wrong_kind(entry, "a name or a table")),
            },
        }
    }

    /// An array of tables; empty if the key is absent.
    ///
    /// # Errors
    ///
    /// A value that is no array, or has an element that is no table.
    pub fn tables(&mut self, key: &str) -> Result<Vec<Table<'a>>, InputError> {
        let Some(entry) = self.entry(key) else {
            return Ok(Vec::new());
        };
        let Value::Array(nodes) = &entry.node.value else {
            return Err(self.wrong_kind(entry, "an array of tables"));
        };
        nodes
            .iter()
            .map(|node| match &node.value {
                Value::Table(_) => Ok(self.child(node, key)),
                _ => Err(self.at_node(
                    node,
                    key,
                    format!("`{key}` needs tables, but this is {}", node.kind()),
                )),
            })
            .collect()
    }

    /// Refuses the keys that nobody asked for.
    ///
    /// # Errors
    ///
    /// The first unknown key, with the nearest known one and the list of all.
    pub fn finish(self) -> Result<(), InputError> {
        let Some(entry) = self
            .entries
            .iter()
            .find(|entry| !self.known.contains(&entry.key))
        else {
            return Ok(());
        };
        let mut error = InputError::at(
            self.source,
            entry.key_span.clone(),
            self.path_of(&entry.key),
            format!("unknown key `{}` {}", entry.key, self.place()),
        );
        if let Some(near) = nearest(&entry.key, self.known.iter().map(String::as_str)) {
            error = error.with_label(format!("did you mean `{near}`?"));
        }
        Err(if self.known.is_empty() {
            error.with_help("no keys are expected here")
        } else {
            error.with_help(format!("the keys here are {}", self.known.join(", ")))
        })
    }

    // ---- errors for checks made by the caller

    /// An error at the value of `key`, or at this table if the key is absent.
    #[must_use]
    pub fn error(&self, key: &str, message: impl Into<String>) -> InputError {
        match self.entries.iter().find(|entry| entry.key == key) {
            Some(entry) => self.at_node(&entry.node, key, message),
            None => self.error_here(message),
        }
    }

    /// An error at this table.
    #[must_use]
    pub fn error_here(&self, message: impl Into<String>) -> InputError {
        InputError::at(self.source, self.span.clone(), self.path.clone(), message)
    }

    /// An error for a name at `key` that is none of `choices`; it lists them.
    #[must_use]
    pub fn unknown_name<'n>(
        &self,
        key: &str,
        choices: impl IntoIterator<Item = &'n str>,
    ) -> InputError {
        let choices: Vec<&str> = choices.into_iter().collect();
        let found = self.entries.iter().find(|entry| entry.key == key);
        let text = match found.map(|entry| &entry.node.value) {
            Some(Value::Str(text)) => text.as_str(),
            _ => "",
        };
        let mut error = self.error(key, format!("`{text}` is not a known `{key}`"));
        if let Some(near) = nearest(text, choices.iter().copied()) {
            error = error.with_label(format!("did you mean `{near}`?"));
        }
        error.with_help(format!("`{key}` is one of: {}", choices.join(", ")))
    }

    /// An error for the required key that is not there.
    #[must_use]
    pub fn missing(&self, key: &str) -> InputError {
        let message = format!("missing key `{key}` {}", self.place());
        let unread = self
            .entries
            .iter()
            .filter(|entry| !self.known.contains(&entry.key));
        let suspect = unread
            .filter(|entry| nearest(&entry.key, [key]).is_some())
            .min_by_key(|entry| strsim::osa_distance(&entry.key, key));
        match suspect {
            Some(entry) => InputError::at(
                self.source,
                entry.key_span.clone(),
                self.path_of(&entry.key),
                message,
            )
            .with_label(format!("did you mean `{key}`?")),
            None => InputError::at(self.source, self.span.clone(), self.path_of(key), message),
        }
    }

    // ---- internals

    fn entry(&mut self, key: &str) -> Option<&'a Entry> {
        if !self.known.iter().any(|known| known == key) {
            self.known.push(key.to_owned());
        }
        self.entries.iter().find(|entry| entry.key == key)
    }

    fn child(&self, node: &'a Node, key: &str) -> Table<'a> {
        Table::new(self.source, node, self.path_of(key))
    }

    fn path_of(&self, key: &str) -> String {
        if self.path.is_empty() {
            key.to_owned()
        } else {
            format!("{}.{key}", self.path)
        }
    }

    fn place(&self) -> String {
        if self.path.is_empty() {
            "at the top level".to_owned()
        } else {
            format!("in [{}]", self.path)
        }
    }

    fn at_node(&self, node: &Node, key: &str, message: impl Into<String>) -> InputError {
        InputError::at(self.source, node.span.clone(), self.path_of(key), message)
    }

    fn wrong_kind(&self, entry: &Entry, expected: &str) -> InputError {
        self.at_node(
            &entry.node,
            &entry.key,
            format!(
                "`{}` must be {expected}, not {}",
                entry.key,
                entry.node.kind()
            ),
        )
    }

    fn quantity_of(
        &self,
        node: &Node,
        key: &str,
        dimension: Dimension,
        bounds: Bounds,
    ) -> Result<f64, InputError> {
        let bare = |value: f64| {
            if dimension == Dimension::DIMENSIONLESS {
                Ok(value)
            } else {
                let number = self.source.slice(node.span.clone());
                let unit = dimension.si_unit();
                Err(self
                    .at_node(node, key, format!("`{key}` has no unit"))
                    .with_label(format!("{} is needed", dimension.name()))
                    .with_help(format!(
                        "write it as a text, `{key} = \"{number} {unit}\"`; units: {}",
                        dimension.examples()
                    )))
            }
        };
        let value = match &node.value {
            Value::Float(value) if !value.is_finite() => {
                return Err(self.at_node(node, key, format!("`{key}` must be a finite number")));
            }
            Value::Float(value) => bare(*value)?,
            // Exact for every integer a person writes.
            Value::Integer(Some(value)) => bare(*value as f64)?,
            Value::Str(text) => quantity::parse(text, dimension)
                .map_err(|error| self.at_node(node, key, describe(&error, key)))?,
            _ => {
                let example = dimension.si_unit();
                let message = if example.is_empty() {
                    format!("`{key}` must be a number, not {}", node.kind())
                } else {
                    format!(
                        "`{key}` must be a number with a unit, such as \"1.5 {example}\", not {}",
                        node.kind()
                    )
                };
                return Err(self.at_node(node, key, message));
            }
        };
        if bounds.contains(value) {
            Ok(value)
        } else {
            let must = bounds.describe(&dimension.si_unit());
            Err(self.at_node(node, key, format!("`{key}` must be {must}")))
        }
    }
}

/// The message of a quantity error, in terms of the key.
fn describe(error: &QuantityError, key: &str) -> String {
    match error {
        QuantityError::WrongDimension {
            text,
            found,
            expected,
        } => format!(
            "`{text}` is {}, but `{key}` needs {} ({})",
            found.name(),
            expected.name(),
            expected.examples()
        ),
        QuantityError::MissingUnit { text, expected } => format!(
            "`{text}` has no unit, but `{key}` needs {} ({})",
            expected.name(),
            expected.examples()
        ),
        QuantityError::NotFinite { .. } => format!("`{key}` must be a finite number"),
        other => other.to_string(),
    }
}

/// The choice most like `name`, if any is like it.
fn nearest<'n>(name: &str, choices: impl IntoIterator<Item = &'n str>) -> Option<&'n str> {
    let name = name.to_lowercase();
    choices
        .into_iter()
        .map(|choice| (strsim::osa_distance(&name, &choice.to_lowercase()), choice))
        .filter(|(distance, choice)| {
            // A third of the letters may differ (`raduis`, `visosity`), more after a common start (`circle`).
            3 * distance <= choice.chars().count().max(3)
                || strsim::jaro_winkler(&name, choice) > 0.87
        })
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, choice)| choice)
}
