//! Readers of strings, choices and switches.

use super::Table;
use crate::InputError;
use crate::tree::Value;

impl<'a> Table<'a> {
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
        let Some(nodes) = self.optional_array(key, "an array of strings")? else {
            return Ok(None);
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
}
