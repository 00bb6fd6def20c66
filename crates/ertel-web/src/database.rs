//! Choices that the page offers.

use std::path::Path;

use ertel_input::keys::{self, Kind, Row, plain};
use ertel_rheology::database::{fluid_names, fluid_or_file, solid_names, solid_or_file};
use serde_json::{Map, Value, json};

/// Case files of the repository to begin with: name and text.
const EXAMPLES: [(&str, &str); 6] = [
    (
        "Ball on disc (circular)",
        include_str!("../../../cases/ball-on-disc.toml"),
    ),
    (
        "Roller on raceway (line)",
        include_str!("../../../cases/roller.toml"),
    ),
    (
        "Ball in a groove (elliptical)",
        include_str!("../../../cases/ball-in-groove.toml"),
    ),
    (
        "Roller of finite length",
        include_str!("../../../cases/cylindrical-roller.toml"),
    ),
    (
        "Squalane between steel and glass",
        include_str!("../../../cases/squalane-on-glass.toml"),
    ),
    (
        "The same with heat",
        include_str!("../../../cases/squalane-thermal.toml"),
    ),
];

/// Sections whose keys the form shows.
const SECTIONS: [&str; 6] = [
    "contact",
    "motion",
    "bodies",
    "lubricant",
    "temperature",
    "thermal",
];

/// Descriptions of keys for the form, by their key paths: `{"words": "...", "number": false, "choices": [...]}`, the choices of a choice
/// alone.
fn described() -> Map<String, Value> {
    let is_shown = |path: &str| SECTIONS.contains(&path.split('.').next().unwrap_or_default());
    let describe = |row: &Row| {
        let mut key = json!({
            "words": plain(&row.description()),
            "number": matches!(row.kind, Kind::Number | Kind::Share | Kind::Count),
        });
        if let Kind::Choice(choices) | Kind::AnyCase(choices) = row.kind {
            key["choices"] = json!(choices);
        }
        key
    };
    let near = keys::all()
        .iter()
        .filter(|(path, _)| path.matches('.').count() < 3);
    let shown = near.filter(|(path, _)| is_shown(path));
    shown
        .map(|(path, row)| (path.clone(), describe(row)))
        .collect()
}

/// `{"ok": true, "version": "...", "fluids": [...], "solids": [...], "examples": [...]}`: lubricants and solids of the database with `name`
/// and `title`, those of solids with `youngs_modulus` in Pa and `poissons_ratio`, of lubricants with `reference_temperature` in K or null;
/// examples with `name` and `text`; `keys` as `described` gives them.
pub fn database() -> Value {
    let folder = Path::new("");
    let fluids = fluid_names().into_iter().filter_map(|name| {
        let fluid = fluid_or_file(name, folder, None).ok()?;
        Some(json!({
            "name": name,
            "title": fluid.title,
            "reference_temperature": fluid.reference_temperature,
            "has_density": fluid.density.is_some(),
        }))
    });
    let solids = solid_names().into_iter().filter_map(|name| {
        let solid = solid_or_file(name, folder, None).ok()?;
        Some(json!({
            "name": name,
            "title": solid.title,
            "youngs_modulus": solid.youngs_modulus,
            "poissons_ratio": solid.poissons_ratio,
        }))
    });
    let examples = EXAMPLES.map(|(name, text)| json!({ "name": name, "text": text }));
    json!({
        "ok": true,
        "version": env!("CARGO_PKG_VERSION"),
        "fluids": fluids.collect::<Vec<_>>(),
        "solids": solids.collect::<Vec<_>>(),
        "examples": examples,
        "keys": described(),
    })
}
