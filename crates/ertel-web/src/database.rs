//! What the page offers to choose from.

use std::path::Path;

use ertel_rheology::database::{fluid_names, fluid_or_file, solid_names, solid_or_file};
use serde_json::{Value, json};

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

/// `{"ok": true, "version": "...", "fluids": [...], "solids": [...], "examples": [...]}`: lubricants and solids of the database with `name`
/// and `title`, those of solids with `youngs_modulus` in Pa and `poissons_ratio`, of lubricants with `reference_temperature` in K or null;
/// examples with `name` and `text`.
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
    })
}
