//! The head of a data file, and where each of its numbers comes from.

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::provenance::{Datum, Status};
use ertel_input::{InputError, Table};

/// Required part of the head of a data file.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Head {
    /// All of it: files of the database.
    Whole,
    /// Nothing: files of users.
    AsFarAsGiven,
}

/// Keys that are about the entry, not data.
const HEADER: [&str; 6] = [
    "title",
    "source",
    "locator",
    "status",
    "notes",
    "provenance",
];

/// The head of a data file.
pub(super) struct Entry {
    pub title: String,
    pub notes: Vec<String>,
    origin: Origin,
    /// By key path.
    exceptions: Vec<(String, Origin)>,
}

/// Origin of a number; missing fields of an exception are those of the entry.
#[derive(Default)]
struct Origin {
    source: Option<String>,
    locator: Option<String>,
    status: Option<Status>,
    note: Option<String>,
}

impl Entry {
    pub fn read(table: &mut Table<'_>, head: Head, name: &str) -> Result<Self, InputError> {
        if head == Head::Whole {
            for key in ["title", "source", "locator", "status"] {
                if !table.contains(key) {
                    return Err(table.missing(key));
                }
            }
        }
        let text = |text: Option<&str>| text.map(str::to_owned);
        let title = text(table.optional_str("title")?).unwrap_or_else(|| name.to_owned());
        let notes = table.optional_strs("notes")?.unwrap_or_default();
        let origin = Origin {
            source: text(table.optional_str("source")?).or(Some(name.to_owned())),
            locator: text(table.optional_str("locator")?),
            status: table.optional_choice("status", &Status::NAMES)?,
            note: None,
        };
        let mut exceptions = Vec::new();
        if let Some(mut provenance) = table.optional_table("provenance")? {
            let keys: Vec<&str> = provenance.keys().collect();
            for key in keys {
                let mut of_key = provenance.required_table(key)?;
                let origin = Origin {
                    source: text(of_key.optional_str("source")?),
                    locator: text(of_key.optional_str("locator")?),
                    status: of_key.optional_choice("status", &Status::NAMES)?,
                    note: text(of_key.optional_str("note")?),
                };
                of_key.finish()?;
                exceptions.push((key.to_owned(), origin));
            }
        }
        Ok(Self {
            title,
            notes: notes.into_iter().map(str::to_owned).collect(),
            origin,
            exceptions,
        })
    }

    /// Every datum of the file with its origin, in the order of the file. `text` has been parsed before.
    pub fn provenance(&self, text: &str) -> Vec<Datum> {
        let mut leaves = Vec::new();
        if let Ok(root) = DeTable::parse(text) {
            collect("", root.get_ref(), &mut leaves);
        }
        leaves.sort_by_key(|leaf| leaf.0);
        leaves
            .into_iter()
            .map(|(_, key, value)| self.datum(key, &value))
            .collect()
    }

    fn datum(&self, key: String, written: &str) -> Datum {
        let none = Origin::default();
        let exception = self
            .exceptions
            .iter()
            .find(|(path, _)| *path == key)
            .map_or(&none, |(_, origin)| origin);
        let (source, locator) = match (&exception.source, &exception.locator) {
            // Another source: the locator of the entry does not belong to it.
            (Some(source), locator) => (Some(source), locator.as_ref()),
            (None, locator) => (
                self.origin.source.as_ref(),
                locator.as_ref().or(self.origin.locator.as_ref()),
            ),
        };
        let source: Vec<&str> = [source, locator]
            .into_iter()
            .flatten()
            .map(String::as_str)
            .collect();
        let (value, unit) = split_unit(written);
        Datum {
            key,
            value,
            unit,
            source: source.join(", "),
            status: exception
                .status
                .or(self.origin.status)
                .unwrap_or(Status::User),
            note: exception.note.clone(),
        }
    }
}

/// Position, key path and text of every value that is data.
fn collect(path: &str, table: &DeTable<'_>, leaves: &mut Vec<(usize, String, String)>) {
    for (key, value) in table {
        let key = key.get_ref().as_ref();
        if path.is_empty() && HEADER.contains(&key) || path == "validity" && key == "source" {
            continue;
        }
        let path = if path.is_empty() {
            key.to_owned()
        } else {
            format!("{path}.{key}")
        };
        match value.get_ref() {
            DeValue::Table(table) => collect(&path, table, leaves),
            leaf => leaves.push((value.span().start, path, written(leaf))),
        }
    }
}

/// A value as a person wrote it.
fn written(value: &DeValue<'_>) -> String {
    match value {
        DeValue::String(text) => text.to_string(),
        DeValue::Integer(digits) => digits.as_str().to_owned(),
        DeValue::Float(digits) => digits.as_str().to_owned(),
        DeValue::Array(values) => {
            let values: Vec<String> = values.iter().map(Spanned::get_ref).map(written).collect();
            values.join(" to ")
        }
        DeValue::Boolean(value) => value.to_string(),
        DeValue::Datetime(value) => value.to_string(),
        DeValue::Table(_) => String::new(),
    }
}

/// Splits `40 mPa.s` into value and unit; `1` is the unit of a bare number, a name has none.
fn split_unit(written: &str) -> (String, String) {
    let number = |text: &str| text.parse::<f64>().is_ok();
    match written.split_once(' ') {
        Some((_, rest)) if rest.contains(" to ") => (
            written.to_owned(),
            rest.rsplit(' ').next().unwrap_or("").to_owned(),
        ),
        Some((value, unit)) if number(value) => (value.to_owned(), unit.to_owned()),
        _ if number(written) => (written.to_owned(), "1".to_owned()),
        _ => (written.to_owned(), String::new()),
    }
}
