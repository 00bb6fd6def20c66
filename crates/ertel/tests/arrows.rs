//! Modules use only those below them, in the solver and in the crate of cases; and in no crate files use each other in a circle.

mod circles;
mod files;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use circles::CIRCLES;
use files::{arrows, circles};

/// The modules of the solver, each above those that it may use.
pub const SOLVER: [&str; 18] = [
    "words",
    "warning",
    "contact",
    "interference",
    "params",
    "film",
    "layers",
    "forms",
    "elastic",
    "stress",
    "solution",
    "mixed",
    "engine",
    "post",
    "solve",
    "volumes",
    "wear",
    "transient",
];

/// Modules of the solver and others that they do not use, wherever these are in the order: the numerical methods know nothing of each other.
const APART: [[&str; 2]; 3] = [
    ["solve", "volumes"],
    ["volumes", "solve"],
    ["transient", "solve"],
];

/// The modules of the crate `ertel`, likewise; those of the solver are below them all.
pub const CASES: [&str; 18] = [
    "files",
    "case",
    "reference",
    "problem",
    "sensitivity",
    "plausible",
    "mark",
    "figures",
    "run",
    "cross_check",
    "estimate",
    "point",
    "machine",
    "study",
    "compare",
    "fit",
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

/// The folder that the files of a circle have in common, and their names there as the list has them.
fn row(circle: &BTreeSet<String>) -> [String; 2] {
    let parts = |file: &str| -> Vec<String> { file.split('/').map(str::to_owned).collect() };
    let files: Vec<Vec<String>> = circle.iter().map(|file| parts(file)).collect();
    let common = (0..files[0].len() - 1)
        .take_while(|k| {
            files
                .iter()
                .all(|file| file.len() > k + 1 && file[*k] == files[0][*k])
        })
        .count();
    let name = |file: &Vec<String>| file[common..].join("/").replace(".rs", "");
    let names: Vec<String> = files.iter().map(name).collect();
    [files[0][..common].join("/"), names.join(" ")]
}

#[test]
fn files_use_each_other_in_no_new_circle() {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut found = BTreeSet::new();
    for entry in std::fs::read_dir(crates).unwrap() {
        let root = entry.unwrap().path().join("src");
        if root.is_dir() {
            found.extend(circles(&arrows(&root)).iter().map(row));
        }
    }
    let listed: BTreeSet<[String; 2]> = CIRCLES
        .into_iter()
        .map(|row| row.map(str::to_owned))
        .collect();
    let new: Vec<_> = found.difference(&listed).collect();
    let gone: Vec<_> = listed.difference(&found).collect();
    assert!(
        new.is_empty() && gone.is_empty(),
        "files that use each other in a circle, but are not in `arrows/circles.rs`: {new:#?}\nno longer a circle, to be removed \
         from there: {gone:#?}"
    );
}

/// Arrows go where an item is defined: through re-exports, groups and renamed imports, but not from tests.
#[test]
fn arrows_of_a_small_crate() {
    let folder = tempfile::tempdir().unwrap();
    let root = folder.path().join("small/src");
    std::fs::create_dir_all(root.join("shape")).unwrap();
    for (name, text) in [
        ("lib.rs", "pub mod shape; mod size; pub use shape::Circle;"),
        (
            "shape/mod.rs",
            "mod circle; pub use circle::Circle; pub struct Line; // crate::size::Size",
        ),
        (
            "shape/circle.rs",
            "use super::{Line}; use super::super::size::{self as sizes, Size}; pub struct Circle(Line, Size);",
        ),
        (
            "size.rs",
            "pub struct Size; #[cfg(test)] mod tests { use crate::shape::Line; }",
        ),
    ] {
        std::fs::write(root.join(name), text).unwrap();
    }
    let arrows = arrows(&root);
    let used = |name: &str| -> Vec<&str> {
        let file = format!("small/src/{name}");
        arrows[&file].iter().map(String::as_str).collect()
    };
    assert_eq!(used("lib.rs"), ["small/src/shape/circle.rs"]);
    assert_eq!(used("shape/mod.rs"), ["small/src/shape/circle.rs"]);
    assert_eq!(used("size.rs"), [""; 0]);
    assert_eq!(
        used("shape/circle.rs"),
        ["small/src/shape/mod.rs", "small/src/size.rs"]
    );
    let rows: Vec<[String; 2]> = circles(&arrows).iter().map(row).collect();
    assert_eq!(rows, [["small/src/shape", "circle mod"].map(str::to_owned)]);
}
