//! The keywords of JSON Schema, draft 7, that `ertel schema` uses; any other one panics. The crate `jsonschema` as a dependency of the
//! tests would change features of `num-rational` and `serde_json`, and so compile the whole solver again; it, taplo and Python's
//! `jsonschema` agree on the shipped files.

use serde_json::Value;

/// Quantities: the one pattern there is.
const PATTERN: &str = r"^\s*(\[\s*)?[+-]?(\d|\.\d)";

/// Mismatches, each with the place in the value; empty for a value that fits.
pub fn errors(schema: &Value, value: &Value) -> Vec<String> {
    let mut found = Vec::new();
    validate(schema, value, "", &mut found);
    found
}

fn validate(schema: &Value, value: &Value, at: &str, found: &mut Vec<String>) {
    let fits = |schema: &Value, value: &Value| errors(schema, value).is_empty();
    let keywords = schema
        .as_object()
        .unwrap_or_else(|| panic!("{schema} is no schema"));
    for (keyword, wanted) in keywords {
        let list = || {
            wanted
                .as_array()
                .unwrap_or_else(|| panic!("{keyword} needs a list"))
        };
        let object = value.as_object();
        let ok = match keyword.as_str() {
            "$schema" | "title" | "description" | "default" | "then" => true,
            "type" => match wanted.as_str().unwrap() {
                "object" => value.is_object(),
                "array" => value.is_array(),
                "string" => value.is_string(),
                "boolean" => value.is_boolean(),
                "number" => value.is_number(),
                "integer" => value.is_i64(),
                other => panic!("type {other}"),
            },
            "enum" => list().contains(value),
            "pattern" => {
                assert_eq!(wanted, PATTERN);
                value.as_str().is_none_or(is_quantity)
            }
            "required" => object.is_none_or(|o| {
                list()
                    .iter()
                    .all(|key| o.contains_key(key.as_str().unwrap()))
            }),
            "anyOf" => list().iter().any(|schema| fits(schema, value)),
            "allOf" => {
                list()
                    .iter()
                    .for_each(|schema| validate(schema, value, at, found));
                true
            }
            "if" => {
                if fits(wanted, value) {
                    validate(&keywords["then"], value, at, found);
                }
                true
            }
            "properties" => {
                for (key, value) in object.into_iter().flatten() {
                    if let Some(schema) = wanted.get(key) {
                        validate(schema, value, &format!("{at}/{key}"), found);
                    }
                }
                true
            }
            "additionalProperties" => {
                let known = keywords.get("properties").and_then(Value::as_object);
                let is_known = |key: &str| known.is_some_and(|known| known.contains_key(key));
                let mut others = object
                    .into_iter()
                    .flatten()
                    .filter(|(key, _)| !is_known(key));
                match wanted {
                    Value::Bool(false) => others.next().is_none(),
                    schema => others.all(|(_, value)| fits(schema, value)),
                }
            }
            "propertyNames" => {
                let fit = |key: &String| fits(wanted, &Value::String(key.clone()));
                object.is_none_or(|o| o.keys().all(fit))
            }
            "items" => {
                for (i, value) in value.as_array().into_iter().flatten().enumerate() {
                    validate(wanted, value, &format!("{at}/{i}"), found);
                }
                true
            }
            "minimum" => value.as_f64().is_none_or(|v| v >= wanted.as_f64().unwrap()),
            "maximum" => value.as_f64().is_none_or(|v| v <= wanted.as_f64().unwrap()),
            "minItems" => value
                .as_array()
                .is_none_or(|v| v.len() as u64 >= wanted.as_u64().unwrap()),
            "maxItems" => value
                .as_array()
                .is_none_or(|v| v.len() as u64 <= wanted.as_u64().unwrap()),
            other => panic!("the keyword {other} is not known here"),
        };
        if !ok {
            found.push(format!("{at}: {keyword}"));
        }
    }
}

/// [`PATTERN`] by hand: a digit after blanks, a bracket and a sign, which may be left out.
fn is_quantity(text: &str) -> bool {
    let text = text.trim_start();
    let text = text.strip_prefix('[').unwrap_or(text).trim_start();
    let text = text.strip_prefix(['+', '-']).unwrap_or(text);
    let text = text.strip_prefix('.').unwrap_or(text);
    text.starts_with(|c: char| c.is_ascii_digit())
}
