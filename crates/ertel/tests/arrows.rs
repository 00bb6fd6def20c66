//! Modules use only those below them, in the solver and in the crate of cases.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// The modules of the solver, each above those that it may use.
pub const SOLVER: [&str; 16] = [
    "words",
    "warning",
    "contact",
    "interference",
    "params",
    "film",
    "forms",
    "elastic",
    "stress",
    "solution",
    "mixed",
    "engine",
    "post",
    "solve",
    "volumes",
    "transient",
];

/// Modules of the solver and others that they do not use, wherever these are in the order: the numerical methods know nothing of each other.
const APART: [[&str; 2]; 3] = [
    ["solve", "volumes"],
    ["volumes", "solve"],
    ["transient", "solve"],
];

/// The modules of the crate `ertel`, likewise; those of the solver are below them all.
pub const CASES: [&str; 17] = [
    "files",
    "case",
    "reference",
    "problem",
    "sensitivity",
    "plausible",
    "run",
    "cross_check",
    "estimate",
    "mark",
    "point",
    "machine",
    "study",
    "fit",
    "compare",
    "output",
    "sweep",
];

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if name.contains("tests") {
            continue;
        }
        if path.is_dir() {
            sources(&path, found);
        } else if name.ends_with(".rs") {
            found.push(path);
        }
    }
}

/// Names of modules behind `crate::` in the code of a file, without comments and tests.
fn used(text: &str) -> BTreeSet<String> {
    let code = text.split("#[cfg(test)]").next().unwrap_or_default();
    let code: Vec<&str> = (code.lines())
        .map(|line| line.split("//").next().unwrap_or_default())
        .collect();
    let mut names = BTreeSet::new();
    for rest in code.join("\n").split("crate::").skip(1) {
        let word = |text: &str| -> String {
            let is_word = |c: &char| c.is_ascii_alphanumeric() || *c == '_';
            text.trim_start().chars().take_while(is_word).collect()
        };
        match rest.strip_prefix('{') {
            Some(list) => names.extend(
                list.split('}')
                    .next()
                    .unwrap_or_default()
                    .split(',')
                    .map(word),
            ),
            None => {
                names.insert(word(rest));
            }
        }
    }
    names
}

#[test]
fn arrows_run_down() {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    check(&crates.join("ertel-ehl/src"), &SOLVER);
    check(&crates.join("ertel/src"), &CASES);
}

fn check(root: &Path, order: &[&str]) {
    let mut files = Vec::new();
    sources(root, &mut files);
    let place = |name: &str| order.iter().position(|own| *own == name);
    let mut seen = BTreeSet::new();
    for file in files {
        let inside = file.strip_prefix(root).unwrap();
        let first = inside.iter().next().unwrap();
        let module = first.to_string_lossy().replace(".rs", "");
        if module == "lib" {
            continue;
        }
        let own = place(&module).unwrap_or_else(|| panic!("`{module}` is missing from the order"));
        seen.insert(own);
        for other in used(&std::fs::read_to_string(&file).unwrap()) {
            assert!(
                place(&other).is_none_or(|other| other <= own),
                "{} uses `{other}`, which is above it",
                inside.display()
            );
            assert!(
                !APART.contains(&[module.as_str(), other.as_str()]),
                "{} uses `{other}`",
                inside.display()
            );
        }
    }
    assert_eq!(
        seen.len(),
        order.len(),
        "a module of the order does not exist"
    );
}
