//! `ertel schema`: the keys of cases and studies for editors.

use clap::{Args, ValueEnum};
use ertel_input::keys::{self, Kind, Laws, Row, plain};
use ertel_rheology::database::{fluid_names, solid_names};
use serde_json::{Map, Value, json};

use crate::failure::Failure;
use crate::print;

/// The draft with the best support in editors for TOML, taplo among them.
const DRAFT: &str = "http://json-schema.org/draft-07/schema#";

/// `ertel schema`.
#[derive(Debug, Args)]
#[command(after_help = "\
ertel schema case > case.schema.json
In a case file the first line `#:schema ./case.schema.json` selects it in editors: docs/guide/editors.md")]
pub struct SchemaArgs {
    /// Kind of file
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
    let mut schema = Map::new();
    schema.insert("$schema".to_owned(), json!(DRAFT));
    schema.insert(
        "title".to_owned(),
        json!("Case of ertel: an elastohydrodynamic contact"),
    );
    extend(&mut schema, table(keys::CASE));
    schema.insert("required".to_owned(), json!(["bodies", "lubricant"]));
    schema.insert(
        "anyOf".to_owned(),
        json!([{ "required": ["contact", "motion"] }, { "required": ["machine"] }]),
    );
    Value::Object(schema)
}

fn study() -> Value {
    let mut schema = Map::new();
    schema.insert("$schema".to_owned(), json!(DRAFT));
    schema.insert(
        "title".to_owned(),
        json!("Study of ertel: a base case and what varies"),
    );
    extend(&mut schema, table(keys::STUDY));
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
fn table(rows: &[Row]) -> Value {
    table_of(Map::new(), [rows])
}

/// A table with the properties that are there and these keys.
fn table_of<'a>(
    mut properties: Map<String, Value>,
    tables: impl IntoIterator<Item = &'a [Row]>,
) -> Value {
    (tables.into_iter()).for_each(|rows| add(&mut properties, rows));
    json!({ "type": "object", "properties": properties, "additionalProperties": false })
}

/// Adds the keys that are not there.
fn add(properties: &mut Map<String, Value>, rows: &[Row]) {
    for row in rows {
        let mut schema = of_kind(row);
        schema["description"] = json!(description(row));
        if let Some(default) = default(row) {
            schema["default"] = default;
        }
        for key in row.keys {
            (properties.entry(*key)).or_insert_with(|| schema.clone());
        }
    }
}

/// Meaning of a key, its usual range, and the units of a quantity.
fn description(row: &Row) -> String {
    let mut sentences = vec![plain(&row.description())];
    for usual in row.usual.iter().filter(|usual| usual.is_questioned) {
        let [low, high] = usual.range;
        sentences.push(format!("Usually {low} to {high} {}", usual.unit));
    }
    if let Kind::Quantity(dimensions) | Kind::Quantities(dimensions) = row.kind {
        let units: Vec<String> = dimensions.iter().map(|d| d.examples()).collect();
        sentences.push(format!("Units: {}", units.join(", ")));
    }
    sentences.join(". ")
}

/// Default of the key, as JSON.
fn default(row: &Row) -> Option<Value> {
    let text = row.default?;
    match row.kind {
        Kind::Choice(_) | Kind::AnyCase(_) | Kind::Share => Some(json!(text)),
        _ => serde_json::from_str(text).ok(),
    }
}

/// A number with a unit, with an uncertainty perhaps.
fn quantity() -> Value {
    json!({ "type": "string", "pattern": r"^\s*(\[\s*)?[+-]?(\d|\.\d)" })
}

/// A number between the bounds of the row, or a text: in per cent, or with an uncertainty.
fn number(row: &Row) -> Value {
    json!({ "anyOf": [within(row, "number"), quantity()] })
}

fn within(row: &Row, kind: &str) -> Value {
    let mut schema = json!({ "type": kind });
    if let Some([low, high]) = row.bounds.and_then(|bounds| bounds.ends()) {
        let number = |end: f64| match row.kind {
            Kind::Count => json!(end as i64),
            _ => json!(end),
        };
        schema["minimum"] = number(low);
        schema["maximum"] = number(high);
    }
    schema
}

fn of_kind(row: &Row) -> Value {
    match row.kind {
        Kind::Text => json!({ "type": "string" }),
        Kind::Switch => json!({ "type": "boolean" }),
        Kind::Count => within(row, "integer"),
        Kind::Number | Kind::Share => number(row),
        Kind::Numbers => json!({ "type": "array", "items": number(row) }),
        Kind::Quantity(_) => quantity(),
        Kind::Quantities(_) => json!({ "type": "array", "items": quantity() }),
        Kind::QuantityOr(words) => json!({ "anyOf": [{ "enum": words }, quantity()] }),
        Kind::Points => json!({
            "type": "array",
            "items": { "type": "array", "items": number(row), "minItems": 2, "maxItems": 2 },
        }),
        Kind::Choice(words) => json!({ "enum": words }),
        Kind::AnyCase(words) => names(words),
        Kind::Choices(words) => json!({ "type": "array", "items": { "enum": words } }),
        Kind::Table(rows) => table(rows),
        Kind::Tables(rows) => json!({ "type": "array", "items": table(rows) }),
        Kind::Law(laws) => law(laws),
        Kind::LawOr(laws, _) => json!({ "anyOf": [quantity(), law(laws)] }),
        Kind::Fluid => names(&fluid_names()),
        Kind::FluidOrTable(rows) => json!({ "anyOf": [names(&fluid_names()), table(rows)] }),
        Kind::Solid => names(&solid_names()),
        Kind::SolidOrTable(rows) => json!({ "anyOf": [names(&solid_names()), table(rows)] }),
        Kind::Machine(machines) => machine(machines),
        Kind::Scalar => json!({ "anyOf": [{ "type": "number" }, quantity()] }),
        Kind::Texts => json!({ "type": "object", "additionalProperties": { "type": "string" } }),
        Kind::List => json!({ "type": "array" }),
    }
}

/// Names of the database, offered by editors; files and names of own data are also valid.
fn names(names: &[&str]) -> Value {
    json!({ "anyOf": [{ "enum": names }, { "type": "string" }] })
}

/// A table with the key `law`, each law with its own keys.
fn law(laws: &Laws) -> Value {
    let keys: Vec<_> = (laws.laws.iter())
        .map(|law| (vec![law.name.to_owned()], laws.keys_of(law)))
        .collect();
    let mut schema = variants(table_of(Map::new(), laws.tables()), "law", &keys);
    schema["required"] = json!(["law"]);
    schema
}

/// A table with the key `kind`, each kind with its own keys. A designation also gives the kind: that of a bearing.
fn machine(machines: &[(&str, &[Row])]) -> Value {
    let properties = Map::from_iter([("kind".to_owned(), json!({}))]);
    let of = |rows: &[Row]| -> Vec<&'static str> {
        rows.iter()
            .flat_map(|row| row.keys.iter().copied())
            .collect()
    };
    // Underscores may stand for hyphens.
    let spellings = |kind: &str| match kind.contains('-') {
        true => vec![kind.to_owned(), kind.replace('-', "_")],
        false => vec![kind.to_owned()],
    };
    let keys: Vec<_> = machines
        .iter()
        .map(|(kind, rows)| (spellings(kind), of(rows)))
        .collect();
    let table = table_of(properties, machines.iter().map(|(_, rows)| *rows));
    let mut schema = variants(table, "kind", &keys);
    schema["anyOf"] = json!([{ "required": ["kind"] }, { "required": ["designation"] }]);
    schema
}

/// Lets a key of a table select the other keys, each choice with its spellings.
fn variants(mut schema: Value, key: &str, variants: &[(Vec<String>, Vec<&str>)]) -> Value {
    let names: Vec<&String> = variants.iter().flat_map(|(names, _)| names).collect();
    let one = |(names, keys): &(Vec<String>, Vec<&str>)| {
        let keys: Vec<&str> = std::iter::once(key).chain(keys.iter().copied()).collect();
        json!({
            "if": { "properties": { key: { "enum": names } }, "required": [key] },
            "then": { "propertyNames": { "enum": keys } },
        })
    };
    schema["properties"][key]["enum"] = json!(names);
    if let Some(property) = schema["properties"][key].as_object_mut() {
        property.shift_remove("type");
    }
    schema["allOf"] = variants.iter().map(one).collect();
    schema
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_have_words_units_and_defaults() {
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
        assert!(
            radius.ends_with("Usually 0.5 to 1000 mm. Units: m, mm, um, nm"),
            "{radius}"
        );
        let speed = of("/properties/machine/properties/inner_ring_speed/description");
        assert!(
            speed.contains("ω_i") && speed.ends_with("Units: rad/s, rpm"),
            "{speed}"
        );
        let linear = of("/properties/solver/properties/linear/description");
        assert!(linear.contains("\"condensed\" (default)"), "{linear}");
        let order = &schema["properties"]["thermal"]["properties"]["film_order"];
        assert_eq!(
            (&order["maximum"], &order["default"]),
            (&json!(10), &json!(8))
        );
        let study = study();
        let zip = study.pointer("/properties/axis/items/properties/zip/description");
        assert!(
            zip.and_then(Value::as_str)
                .unwrap_or_default()
                .contains("same name here vary together")
        );
    }
}
