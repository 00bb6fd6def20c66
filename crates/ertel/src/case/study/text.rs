//! Values as TOML text.

use ertel_input::tree::{Entry, Node, Value};

/// A document: scalars and arrays first, then tables.
pub(in crate::case) fn to_toml(root: &Node) -> String {
    let mut text = String::new();
    table(root, "", &mut text);
    text
}

fn table(node: &Node, path: &str, text: &mut String) {
    let Value::Table(entries) = &node.value else {
        return;
    };
    let is_table = |entry: &&Entry| matches!(entry.node.value, Value::Table(_));
    let plain = entries.iter().filter(|entry| !is_table(entry));
    if !path.is_empty() && (plain.clone().next().is_some() || entries.is_empty()) {
        text.push_str(&format!("\n[{path}]\n"));
    }
    for entry in plain {
        text.push_str(&format!("{} = {}\n", key(&entry.key), inline(&entry.node)));
    }
    for entry in entries.iter().filter(is_table) {
        let own = key(&entry.key);
        let path = match path {
            "" => own,
            path => format!("{path}.{own}"),
        };
        table(&entry.node, &path, text);
    }
}

fn key(key: &str) -> String {
    let bare = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    if !key.is_empty() && key.chars().all(bare) {
        key.to_owned()
    } else {
        quoted(key)
    }
}

pub(in crate::case) fn quoted(text: &str) -> String {
    let mut result = String::from("\"");
    for c in text.chars() {
        match c {
            '"' => result.push_str("\\\""),
            '\\' => result.push_str("\\\\"),
            c if c.is_control() => result.push_str(&format!("\\u{:04X}", u32::from(c))),
            c => result.push(c),
        }
    }
    result.push('"');
    result
}

/// A value on one line.
pub(in crate::case) fn inline(node: &Node) -> String {
    match &node.value {
        Value::Str(text) => quoted(text),
        Value::Integer(number) => number.map_or_else(|| "0".to_owned(), |n| n.to_string()),
        Value::Float(number) if number.is_finite() => format!("{number:?}"),
        Value::Float(number) if number.is_nan() => "nan".to_owned(),
        Value::Float(number) => if *number > 0.0 { "inf" } else { "-inf" }.to_owned(),
        Value::Bool(switch) => switch.to_string(),
        Value::Datetime => "\"a date\"".to_owned(),
        Value::Array(nodes) => {
            let parts: Vec<String> = nodes.iter().map(inline).collect();
            format!("[{}]", parts.join(", "))
        }
        Value::Table(entries) => {
            let pair = |entry: &Entry| format!("{} = {}", key(&entry.key), inline(&entry.node));
            let parts: Vec<String> = entries.iter().map(pair).collect();
            format!("{{ {} }}", parts.join(", "))
        }
    }
}
