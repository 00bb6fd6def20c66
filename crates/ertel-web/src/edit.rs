//! Puts the values of a form into a case file; comments and what the form does not know stay.

use serde_json::Value;
use toml_edit::{DocumentMut, InlineTable, Item, Table, TableLike, value};

/// A value does not fit into the case file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum EditError {
    /// The text is no TOML.
    #[error("the case file is not valid TOML: {0}")]
    Toml(String),
    /// The list of changes is none.
    #[error("the changes are not a list of pairs of key path and value: {0}")]
    Changes(String),
    /// A value that a form does not have.
    #[error("`{key}` cannot be set to {value}")]
    Value {
        /// Key path.
        key: String,
        /// The value, as JSON.
        value: String,
    },
}

/// The case file with other values at some key paths.
///
/// `changes` is a JSON list of pairs such as `["contact.radius", "16 mm"]`, made one after the other: strings, numbers and switches are set,
/// `null` removes a key, and `{}` makes an empty table. Tables on the way are made; a value on the way that is no table gives way to one.
///
/// # Errors
/// [`EditError`].
pub fn edit(text: &str, changes: &str) -> Result<String, EditError> {
    let mut document: DocumentMut = text
        .parse()
        .map_err(|error: toml_edit::TomlError| EditError::Toml(error.message().to_owned()))?;
    let changes: Vec<(String, Value)> =
        serde_json::from_str(changes).map_err(|error| EditError::Changes(error.to_string()))?;
    for (key, new) in &changes {
        let path: Vec<&str> = key.split('.').collect();
        let item = item(new).ok_or_else(|| EditError::Value {
            key: key.clone(),
            value: new.to_string(),
        })?;
        match item {
            Some(item) => set(document.as_table_mut(), &path, item, true),
            None => remove(document.as_table_mut(), &path),
        }
    }
    Ok(document.to_string())
}

/// The item of a value, `Some(None)` for one to be removed; `None` for what no form has.
fn item(new: &Value) -> Option<Option<Item>> {
    Some(match new {
        Value::Null => None,
        Value::String(text) => Some(value(text.as_str())),
        Value::Bool(switch) => Some(value(*switch)),
        Value::Number(number) => Some(match number.as_i64() {
            Some(whole) => value(whole),
            None => value(number.as_f64().filter(|number| number.is_finite())?),
        }),
        Value::Object(entries) if entries.is_empty() => Some(Item::Table(Table::new())),
        Value::Object(_) | Value::Array(_) => return None,
    })
}

/// Sets the item at a path; `root` says whether the table is that of the whole file, where new tables get their own header.
fn set(table: &mut dyn TableLike, path: &[&str], mut item: Item, root: bool) {
    let [key, rest @ ..] = path else { return };
    if rest.is_empty() {
        if !root && item.is_table() {
            item = value(InlineTable::new());
        }
        // The comment behind a value stays.
        if let (Some(old), Some(new)) =
            (table.get(key).and_then(Item::as_value), item.as_value_mut())
        {
            *new.decor_mut() = old.decor().clone();
        }
        table.insert(key, item);
        return;
    }
    if table.get(key).is_none_or(|item| !item.is_table_like()) {
        // A value that becomes a table with a header leaves its place among the values.
        table.remove(key);
        let new = match root {
            true => Item::Table(Table::new()),
            false => value(InlineTable::new()),
        };
        table.insert(key, new);
    }
    if let Some(inner) = table.get_mut(key).and_then(Item::as_table_like_mut) {
        set(inner, rest, item, false);
    }
}

fn remove(table: &mut dyn TableLike, path: &[&str]) {
    match path {
        [] => {}
        [key] => {
            table.remove(key);
        }
        [key, rest @ ..] => {
            if let Some(inner) = table.get_mut(key).and_then(Item::as_table_like_mut) {
                remove(inner, rest);
            }
        }
    }
}
