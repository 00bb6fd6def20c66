//! The values of a case file by their key paths, for the fields of a form.

use ertel_input::Document;
use ertel_input::tree::{Node, Value as Toml};
use serde_json::{Map, Value, json};

use crate::CASE;
use crate::failure::answer;

/// `{"ok": true, "values": {"contact.radius": "16 mm", ...}, "tables": ["contact", ...]}`: strings, numbers, switches and lists of a case
/// file by their key paths, in the order of the file, and the key paths of its tables; or the syntax error.
pub fn form(text: &str) -> Value {
    let document = Document::parse(CASE, text).map_err(Into::into);
    answer(document.map(|document| {
        let mut values = Map::new();
        let mut tables = Vec::new();
        collect(document.tree(), "", &mut values, &mut tables);
        json!({ "values": values, "tables": tables })
    }))
}

fn collect(node: &Node, path: &str, values: &mut Map<String, Value>, tables: &mut Vec<String>) {
    let value = match &node.value {
        Toml::Table(entries) => {
            if !path.is_empty() {
                tables.push(path.to_owned());
            }
            for entry in entries {
                let path = match path {
                    "" => entry.key.clone(),
                    parent => format!("{parent}.{}", entry.key),
                };
                collect(&entry.node, &path, values, tables);
            }
            return;
        }
        // A list of tables has no field.
        Toml::Array(nodes) => Value::Array(nodes.iter().map(scalar).collect()),
        _ => scalar(node),
    };
    values.insert(path.to_owned(), value);
}

fn scalar(node: &Node) -> Value {
    match &node.value {
        Toml::Str(text) => text.as_str().into(),
        Toml::Integer(number) => (*number).into(),
        Toml::Float(number) => (*number).into(),
        Toml::Bool(switch) => (*switch).into(),
        Toml::Datetime | Toml::Array(_) | Toml::Table(_) => Value::Null,
    }
}
