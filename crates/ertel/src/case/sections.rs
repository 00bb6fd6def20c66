//! Sections that a case needs, with examples.

use ertel_input::{InputError, Table};

/// The sections, each with an example that fits a line.
const EXAMPLES: [(&str, &str); 4] = [
    (
        "contact",
        "[contact] and [motion], or [machine] instead of both; [contact] needs kind = \"circular\", radius = \"10 mm\" and \
         load = \"50 N\", for example",
    ),
    (
        "bodies",
        "[bodies] needs body_1 = \"steel\" and body_2 = \"steel\", for example; `ertel solids` lists the names",
    ),
    (
        "motion",
        "[motion] needs entrainment_speed = \"1 m/s\" and slide_to_roll_ratio = 0.0, for example",
    ),
    (
        "lubricant",
        "[lubricant] needs name = \"squalane-pip\" and temperature = \"40 degC\", for example; `ertel fluids` lists the names",
    ),
];

/// Adds to the error about a missing section an example, and which others are missing, too.
pub(super) fn missing(root: &Table<'_>, key: &str, error: InputError) -> InputError {
    let present: Vec<&str> = root.keys().collect();
    if present.contains(&key) {
        return error; // There, but no table.
    }
    let example = EXAMPLES.iter().find(|(name, _)| *name == key);
    let error = example.map_or(error.clone(), |(_, example)| error.with_help(*example));
    let by_machine =
        |name: &str| ["contact", "motion"].contains(&name) && present.contains(&"machine");
    let others: Vec<String> = (EXAMPLES.iter().map(|(name, _)| *name))
        .filter(|name| *name != key && !present.contains(name) && !by_machine(name))
        .map(|name| format!("[{name}]"))
        .collect();
    match others.is_empty() {
        true => error,
        false => error.with_help(format!(
            "also missing: {}; `ertel init` writes a whole case to start from",
            others.join(", ")
        )),
    }
}
