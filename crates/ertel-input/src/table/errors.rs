//! Errors that name the place, the key and the choices.

use super::Table;
use crate::InputError;
use crate::nearest::nearest;
use crate::tree::{Entry, Node, Value};

impl Table<'_> {
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
        let near = nearest(self.text_of(key), choices.iter().copied());
        self.unknown_name_like(key, &choices, near)
    }

    /// The same where it is known which of the choices is meant, if any.
    #[must_use]
    pub fn unknown_name_like(&self, key: &str, choices: &[&str], near: Option<&str>) -> InputError {
        let text = self.text_of(key);
        let mut error = self.error(key, format!("`{text}` is not a known `{key}`"));
        if let Some(near) = near {
            error = error.with_label(format!("did you mean `{near}`?"));
        }
        error.with_help(format!("`{key}` is one of: {}", choices.join(", ")))
    }

    /// The text at `key`; empty of anything else.
    fn text_of(&self, key: &str) -> &str {
        let found = self.entries.iter().find(|entry| entry.key == key);
        match found.map(|entry| &entry.node.value) {
            Some(Value::Str(text)) => text.as_str(),
            _ => "",
        }
    }

    /// An error for the required key that is not there.
    #[must_use]
    pub fn missing(&self, key: &str) -> InputError {
        self.missing_as(key, format!("missing key `{key}` {}", self.place()))
    }

    /// The same of a key whose value is a table, which at the top level is a section of the file.
    #[must_use]
    pub fn missing_table(&self, key: &str) -> InputError {
        match self.path.is_empty() {
            true => self.missing_as(key, format!("the section [{key}] is missing")),
            false => self.missing(key),
        }
    }

    fn missing_as(&self, key: &str, message: String) -> InputError {
        let unread = self
            .entries
            .iter()
            .filter(|entry| !self.known.contains(&entry.key));
        let suspect = unread
            .filter(|entry| nearest(&entry.key, [key]).is_some())
            .min_by_key(|entry| strsim::osa_distance(&entry.key, key));
        let error = match suspect {
            Some(entry) => InputError::at(
                self.source,
                entry.key_span.clone(),
                self.path_of(&entry.key),
                message,
            )
            .with_label(format!("did you mean `{key}`?")),
            None => InputError::at(self.source, self.span.clone(), self.path_of(key), message),
        };
        error.of_missing()
    }

    pub(super) fn at_node(&self, node: &Node, key: &str, message: impl Into<String>) -> InputError {
        InputError::at(self.source, node.span.clone(), self.path_of(key), message)
    }

    pub(super) fn wrong_kind(&self, entry: &Entry, expected: &str) -> InputError {
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

    fn place(&self) -> String {
        if self.path.is_empty() {
            "at the top level".to_owned()
        } else {
            format!("in [{}]", self.path)
        }
    }
}
