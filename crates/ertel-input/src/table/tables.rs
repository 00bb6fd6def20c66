//! Readers of tables within a table.

use super::{StrOrTable, Table};
use crate::InputError;
use crate::tree::Value;

impl<'a> Table<'a> {
    /// A table.
    ///
    /// # Errors
    ///
    /// A missing key or a value that is no table.
    pub fn required_table(&mut self, key: &str) -> Result<Table<'a>, InputError> {
        self.optional_table(key)?
            .ok_or_else(|| self.missing_table(key))
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
            .ok_or_else(|| self.missing_table(key))
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
        let Some(nodes) = self.optional_array(key, "an array of tables")? else {
            return Ok(Vec::new());
        };
        nodes
            .iter()
            .map(|node| match &node.value {
                // Keys of several tables are not distinguished.
                Value::Table(_) => Ok(self.child(node, key).noted_by(None)),
                _ => Err(self.at_node(
                    node,
                    key,
                    format!("`{key}` needs tables, but this is {}", node.kind()),
                )),
            })
            .collect()
    }
}
