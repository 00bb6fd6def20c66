//! `ertel schema`: the keys of cases and studies for editors.

mod keys;
mod meaning;

use clap::{Args, ValueEnum};
use ertel_rheology::database::{fluid_names, solid_names};
use serde_json::{Map, Value, json};

use crate::failure::Failure;
use crate::print;
use keys::{Key, Kind, MACHINES};
use meaning::Meanings;

/// The draft that editors for TOML know best: taplo reads it, and so do those that read later ones.
const DRAFT: &str = "http://json-schema.org/draft-07/schema#";

/// `ertel schema`.
#[derive(Debug, Args)]
#[command(after_help = "\
ertel schema case > case.schema.json
In a case file the first line `#:schema ./case.schema.json` tells it to editors: docs/guide/editors.md")]
pub struct SchemaArgs {
    /// Of what
    #[arg(value_name = "FILE", value_enum)]
    pub of: SchemaOf,
}

/// The kinds of files.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum SchemaOf {
    /// A case file
    Case,
    /// A study file
    Study,
}

/// Prints the schema.
///
/// # Errors
///
/// An output that cannot be written.
pub fn run(arguments: &SchemaArgs) -> Result<(), Failure> {
    let schema = match arguments.of {
        SchemaOf::Case => case(),
        SchemaOf::Study => study(),
    };
    print::stdout(&format!("{schema:#}\n"))
}

fn case() -> Value {
    let meanings = Meanings::of_case();
    let mut schema = Map::new();
    schema.insert("$schema".to_owned(), json!(DRAFT));
    schema.insert(
        "title".to_owned(),
        json!("Case of ertel: an elastohydrodynamic contact"),
    );
    let table = table("", keys::CASE, &meanings);
    extend(&mut schema, table);
    schema.insert("required".to_owned(), json!(["bodies", "lubricant"]));
    schema.insert(
        "anyOf".to_owned(),
        json!([{ "required": ["contact", "motion"] }, { "required": ["machine"] }]),
    );
    Value::Object(schema)
}

fn study() -> Value {
    let meanings = Meanings::of_study();
    let mut schema = Map::new();
    schema.insert("$schema".to_owned(), json!(DRAFT));
    schema.insert(
        "title".to_owned(),
        json!("Study of ertel: a base case and what varies"),
    );
    extend(&mut schema, table("", keys::STUDY, &meanings));
    schema.insert("required".to_owned(), json!(["case"]));
    schema.insert(
        "anyOf".to_owned(),
        json!([{ "required": ["axis"] }, { "required": ["points"] }]),
    );
    Value::Object(schema)
}

fn extend(schema: &mut Map<String, Value>, table: Value) {
    if let Value::Object(table) = table {
        schema.extend(table);
    }
}

/// A table with these keys and no others.
fn table(path: &str, keys: &[Key], meanings: &Meanings) -> Value {
    let properties: Map<String, Value> = keys
        .iter()
        .map(|(key, kind)| {
            let inner = match path {
                "" => (*key).to_owned(),
                path => format!("{path}.{key}"),
            };
            let mut schema = of_kind(&inner, *kind, meanings);
            let unit = unit(*kind);
            let meaning = meanings.of(path, key).unwrap_or_default();
            let description = [meaning, unit.as_str()].map(str::trim);
            let description: Vec<&str> =
                description.into_iter().filter(|d| !d.is_empty()).collect();
            if !description.is_empty() {
                schema["description"] = json!(description.join(". "));
            }
            ((*key).to_owned(), schema)
        })
        .collect();
    json!({ "type": "object", "properties": properties, "additionalProperties": false })
}

/// The units that a quantity may be written in, as a sentence.
fn unit(kind: Kind) -> String {
    match kind {
        Kind::Quantity(dimensions) | Kind::Quantities(dimensions) => {
            let units: Vec<String> = dimensions.iter().map(|d| d.examples()).collect();
            format!("Units: {}", units.join(", "))
        }
        _ => String::new(),
    }
}

/// A number with a unit, with an uncertainty perhaps.
fn quantity() -> Value {
    json!({ "type": "string", "pattern": r"^\s*(\[\s*)?[+-]?(\d|\.\d)" })
}

/// A number, which may be a text: in per cent, or with an uncertainty.
fn number() -> Value {
    json!({ "anyOf": [{ "type": "number" }, quantity()] })
}

fn of_kind(path: &str, kind: Kind, meanings: &Meanings) -> Value {
    match kind {
        Kind::Text => json!({ "type": "string" }),
        Kind::Switch => json!({ "type": "boolean" }),
        Kind::Count => json!({ "type": "integer" }),
        Kind::Number => number(),
        Kind::Numbers => json!({ "type": "array", "items": number() }),
        Kind::Quantity(_) => quantity(),
        Kind::Quantities(_) => json!({ "type": "array", "items": quantity() }),
        Kind::QuantityOr(words) => json!({ "anyOf": [{ "enum": words }, quantity()] }),
        Kind::Points => json!({
            "type": "array",
            "items": { "type": "array", "items": number(), "minItems": 2, "maxItems": 2 },
        }),
        Kind::Choice(words) => json!({ "enum": words }),
        Kind::Choices(words) => json!({ "type": "array", "items": { "enum": words } }),
        Kind::Table(keys) => table(path, keys, meanings),
        Kind::Tables(keys) => json!({ "type": "array", "items": table(path, keys, meanings) }),
        Kind::Law { laws, keys, or } => law(path, laws, keys, or, meanings),
        Kind::Fluid => names(&fluid_names()),
        Kind::FluidOrTable(keys) => {
            json!({ "anyOf": [names(&fluid_names()), table(path, keys, meanings)] })
        }
        Kind::Solid => names(&solid_names()),
        Kind::SolidOrTable(keys) => {
            json!({ "anyOf": [names(&solid_names()), table(path, keys, meanings)] })
        }
        Kind::Machine(keys) => machine(path, keys, meanings),
        Kind::Any => json!({}),
        Kind::List => json!({ "type": "array" }),
    }
}

/// Names of the database, offered by editors; files and names of own data are as good.
fn names(names: &[&str]) -> Value {
    json!({ "anyOf": [{ "enum": names }, { "type": "string" }] })
}

/// A table with the key `law`, each law with keys of its own; or a constant in place of it.
fn law(path: &str, laws: &[(&str, &[&str])], keys: &[Key], or: bool, meanings: &Meanings) -> Value {
    let mut schema = table(path, keys, meanings);
    schema["required"] = json!(["law"]);
    let names: Vec<&str> = laws.iter().map(|(law, _)| *law).collect();
    schema["properties"]["law"] = json!({ "enum": names });
    schema["allOf"] = variants("law", laws);
    match or {
        true => json!({ "anyOf": [quantity(), schema] }),
        false => schema,
    }
}

/// The keys that go with each value of a key.
fn variants(key: &str, variants: &[(&str, &[&str])]) -> Value {
    let one = |(name, keys): &(&str, &[&str])| {
        let keys: Vec<&str> = std::iter::once(key).chain(keys.iter().copied()).collect();
        json!({
            "if": { "properties": { key: { "const": name } }, "required": [key] },
            "then": { "propertyNames": { "enum": keys } },
        })
    };
    variants.iter().map(one).collect()
}

fn machine(path: &str, keys: &[Key], meanings: &Meanings) -> Value {
    let mut schema = table(path, keys, meanings);
    let names: Vec<&str> = MACHINES.iter().map(|(kind, _)| *kind).collect();
    schema["properties"]["kind"] = json!({ "enum": names });
    schema["required"] = json!(["kind"]);
    schema["allOf"] = variants("kind", MACHINES);
    schema
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Descriptions come from the reference page: every key that it has in a table is described by it.
    #[test]
    fn keys_have_the_words_of_the_reference() {
        let schema = case();
        let of = |pointer: &str| {
            schema
                .pointer(pointer)
                .and_then(Value::as_str)
                .unwrap_or_default()
        };
        let radius = of("/properties/contact/properties/radius/description");
        assert!(
            radius.starts_with("reduced radius of curvature R, 1 um to 1 km"),
            "{radius}"
        );
        assert!(radius.ends_with("Units: m, mm, um, nm"), "{radius}");
        let speed = of("/properties/machine/properties/inner_ring_speed/description");
        assert!(
            speed.contains("ω_i") && speed.ends_with("Units: rad/s, rpm"),
            "{speed}"
        );
        let linear = of("/properties/solver/properties/linear/description");
        assert!(linear.contains("\"condensed\" (default)"), "{linear}");
        let study = study();
        let zip = study.pointer("/properties/axis/items/properties/zip/description");
        assert!(
            zip.and_then(Value::as_str)
                .unwrap_or_default()
                .contains("same name here vary together")
        );
    }
}
