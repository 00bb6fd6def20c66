//! A record: values by section and key, in the order in which they are written.

use std::collections::BTreeMap;
use std::fmt::Write;

use serde_json::Value;

/// The section that says where the record was written.
pub const MACHINE: &str = "machine";

/// All that is recorded of a case.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Record(Vec<Entry>);

/// A value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Its section: `figures`, or `point 2 figures` of a curve.
    pub section: String,
    /// Its name.
    pub key: String,
    /// The value as text; of floats the fewest decimals that read back as the same bits.
    pub value: String,
}

/// A float as text that reads back as the same bits.
pub fn exact(value: f64) -> String {
    format!("{value:?}")
}

impl Record {
    /// Adds a value.
    pub fn put(&mut self, section: &str, key: impl Into<String>, value: impl ToString) {
        self.0.push(Entry {
            section: section.to_owned(),
            key: key.into(),
            value: value.to_string(),
        });
    }

    /// Adds a float.
    pub fn float(&mut self, section: &str, key: impl Into<String>, value: f64) {
        self.put(section, key, exact(value));
    }

    /// Adds every value of a document, by the names on the way to it.
    pub fn document(&mut self, section: &str, key: &str, value: &Value) {
        let below = |name: &str| match key {
            "" => name.to_owned(),
            key => format!("{key} {name}"),
        };
        match value {
            Value::Object(entries) => {
                for (name, value) in entries {
                    self.document(section, &below(name), value);
                }
            }
            Value::Array(values) => {
                for (i, value) in values.iter().enumerate() {
                    self.document(section, &below(&i.to_string()), value);
                }
            }
            Value::Number(number) => match number.as_f64().filter(|_| number.is_f64()) {
                Some(float) => self.float(section, key, float),
                None => self.put(section, key, number),
            },
            Value::String(text) => self.put(section, key, text),
            Value::Bool(_) | Value::Null => self.put(section, key, value),
        }
    }

    /// Adds another record, its sections behind a word.
    pub fn append(&mut self, prefix: &str, other: Record) {
        self.0.extend(other.0.into_iter().map(|entry| Entry {
            section: format!("{prefix} {}", entry.section),
            ..entry
        }));
    }

    /// A value.
    pub fn get(&self, section: &str, key: &str) -> Option<&str> {
        let entry = self
            .0
            .iter()
            .find(|e| e.section == section && e.key == key)?;
        Some(&entry.value)
    }

    /// All values but where they were found, by section and key.
    pub fn values(&self) -> impl Iterator<Item = &Entry> {
        self.0.iter().filter(|entry| entry.section != MACHINE)
    }

    /// All values but where they were found, for look-ups.
    pub fn by_key(&self) -> BTreeMap<(&str, &str), &str> {
        self.values()
            .map(|e| ((e.section.as_str(), e.key.as_str()), e.value.as_str()))
            .collect()
    }

    /// The keys of the sections whose last word is `word`.
    pub fn keys_in(&self, word: &str) -> Vec<String> {
        self.0
            .iter()
            .filter(|e| e.section.rsplit(' ').next() == Some(word))
            .map(|e| e.key.clone())
            .collect()
    }

    /// Number of values.
    pub fn len(&self) -> usize {
        self.values().count()
    }

    /// As a file, one value on a line.
    pub fn text(&self, name: &str) -> String {
        let mut text =
            format!("# Results of the case {name}; written by --update, docs/golden.md.\n");
        let mut section = None;
        for entry in &self.0 {
            if section != Some(&entry.section) {
                let _ = write!(text, "\n[{}]\n", entry.section);
                section = Some(&entry.section);
            }
            let _ = writeln!(text, "{} = {}", entry.key, entry.value);
        }
        text
    }

    /// From a file.
    pub fn read(text: &str) -> Result<Record, String> {
        let mut record = Record::default();
        let mut section = String::new();
        for (i, line) in text.lines().enumerate() {
            if line.is_empty() || line.starts_with('#') {
                continue;
            }
            if let Some(name) = line.strip_prefix('[').and_then(|l| l.strip_suffix(']')) {
                section = name.to_owned();
                continue;
            }
            let (key, value) = (line.split_once(" = "))
                .ok_or_else(|| format!("line {}: neither a section nor `key = value`", i + 1))?;
            if record.get(&section, key).is_some() {
                return Err(format!("line {}: `{key}` occurs twice", i + 1));
            }
            record.put(&section, key, value);
        }
        Ok(record)
    }
}
