//! Keys that no case or study has, found without its readers: these ask for some keys only once others are right.

use std::ops::Range;

use super::{CASE, Kind, Row};
use crate::nearest::nearest;
use crate::tree::{Entry, Node, Value, place_of};
use crate::{Document, InputError};

/// The error to report where a reader refused a document: a key that the rows do not know comes before one that is missing, for it
/// is the missing one by another name as a rule. Other errors stay, and those about unknown keys that name the choices of their place.
#[must_use]
pub fn unknown_first(document: &Document, rows: &'static [Row], error: InputError) -> InputError {
    match error.is_missing() {
        true => in_table(document, document.tree(), (&[rows], ""), "").unwrap_or(error),
        false => error,
    }
}

/// The error about a key path that no case has, such as that of an axis; `span` is its place.
#[must_use]
pub fn unknown_path(document: &Document, path: &str, span: Range<usize>) -> Option<InputError> {
    let mut tables: Vec<&'static [Row]> = vec![CASE];
    let mut above = String::new();
    for key in path.split('.') {
        // The place of a table in an array.
        if place_of(key).is_some() {
            continue;
        }
        let found: Vec<&Row> = rows_of(&tables, key).collect();
        let is_law = key == "law" || key == "kind";
        if found.is_empty() && !is_law {
            return Some(unknown(document, span, key, &above, &tables));
        }
        tables = found.iter().flat_map(|row| row.kind.tables()).collect();
        if tables.is_empty() {
            return None;
        }
        join(&mut above, key);
    }
    None
}

fn join(path: &mut String, key: &str) {
    if !path.is_empty() {
        path.push('.');
    }
    path.push_str(key);
}

fn rows_of<'t>(
    tables: &'t [&'static [Row]],
    key: &'t str,
) -> impl Iterator<Item = &'static Row> + use<'t> {
    let rows = tables.iter().flat_map(|rows| rows.iter());
    rows.filter(move |row| row.keys.contains(&key))
}

/// The first unknown key of a table, or of those in it.
fn in_table(
    document: &Document,
    node: &Node,
    (tables, choice): (&[&'static [Row]], &str),
    path: &str,
) -> Option<InputError> {
    let Value::Table(entries) = &node.value else {
        return None;
    };
    let mut others = entries.iter().filter(|entry| entry.key != choice);
    others.find_map(|entry| {
        let found: Vec<&Row> = rows_of(tables, &entry.key).collect();
        if found.is_empty() {
            let span = entry.key_span.clone();
            return Some(unknown(document, span, &entry.key, path, tables));
        }
        let mut path = path.to_owned();
        join(&mut path, &entry.key);
        (found.iter()).find_map(|row| in_value(document, entry, row.kind, &path))
    })
}

fn in_value(document: &Document, entry: &Entry, kind: Kind, path: &str) -> Option<InputError> {
    // The key that selects the rows of a table is in none of them.
    let (tables, choice) = match kind {
        Kind::Machine(machines) => (of_machine(machines, &entry.node), "kind"),
        Kind::Law(_) | Kind::LawOr(..) => (kind.tables(), "law"),
        kind => (kind.tables(), ""),
    };
    if tables.is_empty() {
        return None;
    }
    match &entry.node.value {
        Value::Array(nodes) => {
            (nodes.iter()).find_map(|node| in_table(document, node, (&tables, choice), path))
        }
        _ => in_table(document, &entry.node, (&tables, choice), path),
    }
}

/// The rows of the kind of a machine; of all kinds where it has none.
fn of_machine(
    machines: &'static [(&'static str, &'static [Row])],
    node: &Node,
) -> Vec<&'static [Row]> {
    let kind = match node.entry("kind").map(|entry| &entry.node.value) {
        Some(Value::Str(kind)) => kind.replace('_', "-"),
        _ => String::new(),
    };
    match machines.iter().find(|(name, _)| *name == kind) {
        Some((_, rows)) => vec![rows],
        None => machines.iter().map(|(_, rows)| *rows).collect(),
    }
}

fn unknown(
    document: &Document,
    span: Range<usize>,
    key: &str,
    path: &str,
    tables: &[&'static [Row]],
) -> InputError {
    let place = match path {
        "" => "at the top level".to_owned(),
        path => format!("in [{path}]"),
    };
    let mut own = path.to_owned();
    join(&mut own, key);
    let error = document.error_at(span, &own, format!("unknown key `{key}` {place}"));
    let mut keys: Vec<&str> = Vec::new();
    for row in tables.iter().flat_map(|rows| rows.iter()) {
        let new = row.keys.iter().filter(|key| !keys.contains(key));
        let new: Vec<&str> = new.copied().collect();
        keys.extend(new);
    }
    let synonym = || {
        let (_, meant) = SYNONYMS.iter().find(|(name, _)| *name == key)?;
        keys.iter().find(|own| *own == meant).copied()
    };
    let near = synonym()
        .or_else(|| nearest(key, keys.iter().copied()))
        .or_else(|| with_its_words(key, &keys));
    match near {
        Some(near) => error.with_label(format!("did you mean `{near}`?")),
        None => error.with_help(format!("the keys here are {}", keys.join(", "))),
    }
}

/// Words by which people call what a key means.
const SYNONYMS: [(&str, &str); 3] = [
    ("bearing", "designation"),
    ("oil", "name"),
    ("material", "name"),
];

/// The first key that has all words of a name: `inner_ring_speed` for `speed`.
fn with_its_words<'k>(name: &str, keys: &[&'k str]) -> Option<&'k str> {
    let has = |key: &&&str| {
        name.split('_')
            .all(|word| key.split('_').any(|own| own == word))
    };
    keys.iter().find(has).copied()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn first(text: &str) -> Option<String> {
        let document = Document::parse("case.toml", text).unwrap();
        let error = in_table(&document, document.tree(), (&[CASE], ""), "");
        error.map(|error| error.to_string())
    }

    #[test]
    fn unknown_keys_are_found_with_the_one_that_is_meant() {
        for (text, key, meant) in [
            (
                "[machine]\nkind = \"ball-bearing\"\nspeed = \"3000 rpm\"\n",
                "`speed` in [machine]",
                "`inner_ring_speed`",
            ),
            (
                "[lubricant]\nviscosity = { law = \"barus\", mu0 = 1 }\n",
                "`mu0` in [lubricant.viscosity]",
                "`mu_0`",
            ),
            (
                "[[surface]]\nkind = \"dent\"\n[[surface]]\ndeph = 1\n",
                "`deph` in [surface]",
                "`depth`",
            ),
            (
                "[lubricant]\nshear_thinning = { law = \"estimate\" }\noil = \"VG 46\"\n",
                "`oil` in [lubricant]",
                "`name`",
            ),
            (
                "[lubricant]\nkinematic_viscosity_70 = 1\n",
                "`kinematic_viscosity_70` in [lubricant]",
                "did you mean `kinematic_viscosity`?",
            ),
            ("[contcat]\n", "`contcat` at the top level", "`contact`"),
            (
                "[machine]\nkind = \"spur_gear\"\nroughness = \"1 um\"\n",
                "`roughness` in [machine]",
                "pinion_ra",
            ),
        ] {
            let said = first(text).unwrap();
            assert!(said.contains(&format!("unknown key {key}")), "{said}");
            assert!(said.contains(meant), "{said}");
        }
        for text in [
            "lubricant = \"squalane\"\n",
            "[machine]\ndesignation = \"6206\"\nradial_load = 1\n",
            "[compare]\ncolumns = { any = \"thing\" }\n",
            "[bodies]\nbody_1 = { name = \"steel\", youngs_modulus = 1 }\n",
        ] {
            assert_eq!(first(text), None);
        }
    }

    #[test]
    fn paths_are_those_of_cases() {
        let document = Document::parse("study.toml", "").unwrap();
        let of = |path: &str| unknown_path(&document, path, 0..0).map(|e| e.message().to_owned());
        for path in [
            "contact.load",
            "surface.1.amplitude",
            "lubricant.viscosity.mu_0",
            "lubricant.viscosity.law",
            "machine.kind",
            "bodies.body_1",
            "bodies.body_1.youngs_modulus",
            "transient.load.to",
            "lubricant.blend.1.share",
        ] {
            assert_eq!(of(path), None, "{path}");
        }
        assert_eq!(
            of("mo_speed").unwrap(),
            "unknown key `mo_speed` at the top level"
        );
        assert_eq!(
            of("contact.laod").unwrap(),
            "unknown key `laod` in [contact]"
        );
    }
}
