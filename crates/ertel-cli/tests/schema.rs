//! `ertel schema` against the readers and the shipped files.

use crate::common::{code, root};

#[path = "draft7/mod.rs"]
pub mod draft7;

use std::collections::BTreeSet;
use std::path::PathBuf;
use std::process::Command;

use ertel::case::Case;
use ertel_input::Document;
use ertel_input::tree::{Node, Value as Toml};
use serde_json::{Map, Value, json};

use draft7::errors;

pub fn schema(of: &str) -> Value {
    let output = Command::new(env!("CARGO_BIN_EXE_ertel"))
        .args(["schema", of])
        .output()
        .unwrap();
    code(&output, 0);
    serde_json::from_slice(&output.stdout).unwrap()
}

fn json_of(node: &Node) -> Value {
    match &node.value {
        Toml::Str(text) => json!(text),
        Toml::Integer(number) => json!(number),
        Toml::Float(number) => json!(number),
        Toml::Bool(switch) => json!(switch),
        Toml::Datetime => Value::Null,
        Toml::Array(nodes) => nodes.iter().map(json_of).collect(),
        Toml::Table(entries) => {
            let pairs = entries.iter().map(|e| (e.key.clone(), json_of(&e.node)));
            Value::Object(pairs.collect::<Map<_, _>>())
        }
    }
}

/// All TOML files of the folders.
fn files(folders: &[&str]) -> Vec<(PathBuf, Value)> {
    let mut found = Vec::new();
    let mut open: Vec<PathBuf> = folders.iter().map(|f| root().join(f)).collect();
    while let Some(folder) = open.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                open.push(path);
            } else if path.extension().is_some_and(|e| e == "toml") {
                let document = Document::read(&path).unwrap();
                found.push((path, json_of(document.tree())));
            }
        }
    }
    found
}

fn has(value: &Value, key: &str) -> bool {
    value.get(key).is_some()
}

/// The shipped cases: those that are whole by themselves, not bases of studies that leave keys to the axes.
pub fn cases() -> Vec<(PathBuf, Value)> {
    let mut cases = files(&[
        "cases",
        "validation",
        "studies",
        "benchmark-suite",
        "crates/ertel-cli/tests/good",
        "crates/ertel/tests/golden/cases",
    ]);
    cases.retain(|(path, value)| {
        has(value, "bodies") && has(value, "lubricant") && Case::read(path).is_ok()
    });
    assert!(cases.len() > 50, "{}", cases.len());
    cases
}

#[test]
fn every_shipped_case_fits() {
    let schema = schema("case");
    let mut failures = Vec::new();
    for (path, case) in cases() {
        for error in errors(&schema, &case) {
            failures.push(format!("{}: {error}", path.display()));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn every_shipped_study_fits() {
    let schema = schema("study");
    let mut n_studies = 0;
    for (path, study) in files(&["cases", "studies"]) {
        if !(has(&study, "case") && (has(&study, "axis") || has(&study, "points"))) {
            continue;
        }
        n_studies += 1;
        let errors = errors(&schema, &study);
        assert!(errors.is_empty(), "{}: {errors:?}", path.display());
    }
    assert!(n_studies >= 3, "{n_studies}");
}

/// Key paths of the tables in a case.
fn tables(value: &Value, path: &str, found: &mut Vec<String>) {
    if let Value::Object(entries) = value {
        found.push(path.to_owned());
        for (key, value) in entries {
            let inner = if path.is_empty() {
                key.clone()
            } else {
                format!("{path}.{key}")
            };
            tables(value, &inner, found);
        }
    }
}

/// Properties of the schema at a key path, of tables in its alternatives, too.
fn properties(schema: &Value, path: &str) -> BTreeSet<String> {
    let mut here = vec![schema];
    for key in path.split('.').filter(|key| !key.is_empty()) {
        here = here
            .iter()
            .flat_map(|s| alternatives(s))
            .filter_map(|s| s["properties"].get(key))
            .collect();
    }
    let tables = here.iter().flat_map(|s| alternatives(s));
    tables
        .filter_map(|s| s["properties"].as_object())
        .flat_map(|keys| keys.keys().cloned())
        .collect()
}

fn alternatives(schema: &Value) -> Vec<&Value> {
    let others = schema["anyOf"].as_array().into_iter().flatten();
    std::iter::once(schema).chain(others).collect()
}

/// The readers list the keys of a table where one is unknown: the schema knows them all, and refuses the unknown one.
#[test]
fn the_readers_have_no_other_keys() {
    let schema = schema("case");
    let mut n_tables = 0;
    let mut missing = BTreeSet::new();
    for (path, case) in cases() {
        let text = std::fs::read_to_string(&path).unwrap();
        let mut paths = Vec::new();
        tables(&case, "", &mut paths);
        for table in paths {
            let key = if table.is_empty() {
                "zzzz".to_owned()
            } else {
                format!("{table}.zzzz")
            };
            let folder = path.parent().unwrap();
            let error = Case::from_text_with("case.toml", &text, folder, &[format!("{key}=1")]);
            let error = error.expect_err(&format!("{}: {key}", path.display()));
            let help = error
                .help()
                .iter()
                .find_map(|h| h.strip_prefix("the keys here are "));
            let Some(keys) = help.filter(|_| error.message().starts_with("unknown key `zzzz`"))
            else {
                continue;
            };
            n_tables += 1;
            let known = properties(&schema, &table);
            let unknown = keys.split(", ").filter(|key| !known.contains(*key));
            missing.extend(unknown.map(|key| format!("{table}.{key}")));
            let mut wrong = case.clone();
            let pointer = format!("/{}", table.replace('.', "/"));
            let here = wrong.pointer_mut(if table.is_empty() { "" } else { &pointer });
            here.unwrap()["zzzz"] = json!(1);
            assert!(
                !errors(&schema, &wrong).is_empty(),
                "{}: {key}",
                path.display()
            );
        }
    }
    assert_eq!(
        missing,
        BTreeSet::new(),
        "keys of the readers that the schema lacks"
    );
    assert!(n_tables > 200, "{n_tables}");
}

#[test]
fn mistakes_are_refused() {
    let case_schema = schema("case");
    let good = json!({
        "contact": { "kind": "circular", "radius": "16 mm", "load": "100 N ± 2 %" },
        "bodies": { "body_1": "steel", "body_2": "my-steel.toml" },
        "motion": { "entrainment_speed": "[1, 2] m/s", "slide_to_roll_ratio": 0.0 },
        "lubricant": { "temperature": "40 degC", "density": { "law": "constant", "rho_0": "870 kg/m^3" },
            "viscosity": { "law": "barus", "mu_0": "40 mPa.s", "alpha": "22 1/GPa" } },
    });
    assert!(errors(&case_schema, &good).is_empty());
    // A designation says the kind of a machine, and its words may be joined by underscores.
    for machine in [
        json!({ "designation": "6206", "radial_load": "2 kN", "inner_ring_speed": "3000 rpm" }),
        json!({ "kind": "ball_bearing", "designation": "6206", "radial_load": "2 kN" }),
    ] {
        let mut bearing = good.clone();
        for section in ["contact", "motion"] {
            bearing.as_object_mut().unwrap().remove(section);
        }
        bearing["machine"] = machine;
        assert_eq!(errors(&case_schema, &bearing), Vec::<String>::new());
        bearing["machine"] = json!({ "radial_load": "2 kN" });
        assert!(!errors(&case_schema, &bearing).is_empty(), "no kind");
    }
    for (pointer, value) in [
        ("/contact/kind", json!("round")),
        ("/contact/radius", json!(16)),
        ("/contact/radius", json!("large")),
        ("/lubricant/viscosity/law", json!("baruss")),
        // A key of another law.
        (
            "/lubricant/viscosity",
            json!({ "law": "barus", "mu_0": "40 mPa.s", "alpha": "22 1/GPa", "z": 0.6 }),
        ),
        ("/lubricant/viscosity", json!({ "mu_0": "40 mPa.s" })),
        ("/motion/slide_to_roll_ratio", json!(true)),
        ("/bodies/body_1", json!({ "youngs_modulus": 210e9 })),
    ] {
        let mut wrong = good.clone();
        *wrong.pointer_mut(pointer).unwrap() = value.clone();
        assert!(
            !errors(&case_schema, &wrong).is_empty(),
            "{pointer} = {value}"
        );
    }
    for section in ["bodies", "lubricant", "motion"] {
        let mut wrong = good.clone();
        wrong.as_object_mut().unwrap().remove(section);
        assert!(
            !errors(&case_schema, &wrong).is_empty(),
            "without {section}"
        );
    }
}
