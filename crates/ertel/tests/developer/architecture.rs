//! `architecture.md`: crates and modules in the order in which they use one another.

use std::collections::BTreeSet;
use std::fmt::Write;
use std::fs;

use super::super::arrows::{CASES, SOLVER};
use super::pages::{generated, read, root};
use super::source::{file_of, modules, purpose};

const PAGE: &str = "docs/developer/architecture.md";

/// Folders of modules whose parts the page lists, too.
const OPENED: [&str; 10] = [
    "ertel-ehl/src/contact",
    "ertel-ehl/src/film",
    "ertel-ehl/src/forms",
    "ertel-ehl/src/elastic",
    "ertel-ehl/src/engine",
    "ertel-ehl/src/solve",
    "ertel-ehl/src/solve/heat",
    "ertel-ehl/src/solve/results",
    "ertel-ehl/src/solve/sequence",
    "ertel-ehl/src/post",
];

/// Where the crate begins.
fn top(name: &str) -> String {
    let library = format!("crates/{name}/src/lib.rs");
    match root().join(&library).exists() {
        true => library,
        false => format!("crates/{name}/src/main.rs"),
    }
}

/// The crates of the repository that a crate uses.
fn uses(name: &str) -> BTreeSet<String> {
    let manifest = read(&format!("crates/{name}/Cargo.toml"));
    let (_, rest) = manifest.split_once("[dependencies]\n").unwrap();
    let own = rest.split("\n[").next().unwrap();
    let names = own.lines().filter_map(|l| l.split(['.', ' ', '=']).next());
    let names = names.filter(|own| *own == "ertel" || own.starts_with("ertel-"));
    names.map(str::to_owned).collect()
}

/// All crates, each after those that it uses.
fn crates() -> Vec<String> {
    let entries = fs::read_dir(root().join("crates")).unwrap();
    let names = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut left: BTreeSet<String> = names.collect();
    let mut order: Vec<String> = Vec::new();
    while !left.is_empty() {
        let is_ready = |name: &&String| uses(name).iter().all(|other| order.contains(other));
        let next = left
            .iter()
            .find(is_ready)
            .expect("a circle of crates")
            .clone();
        left.remove(&next);
        order.push(next);
    }
    order
}

/// Purpose of a file, from its first doc line.
fn said(path: &str) -> String {
    let text = purpose(&read(path))
        .unwrap_or_else(|| panic!("{path} does not begin with what it is for, `//! ...`"));
    text.replace('|', "\\|")
        .replace("[`", "`")
        .replace("`]", "`")
}

fn table(crate_name: &str, modules: &[String]) -> String {
    let folder = root().join("crates").join(crate_name).join("src");
    let mut text = "| module | for |\n|---|---|\n".to_owned();
    for module in modules {
        let file = file_of(&folder, module);
        let file = file.strip_prefix(root()).unwrap().display().to_string();
        writeln!(text, "| [`{module}`](../../{file}) | {} |", said(&file)).unwrap();
    }
    text
}

#[test]
fn page_of_the_architecture_is_that_of_the_code() {
    let order = crates();
    let mut text = "| crate | uses | for |\n|---|---|---|\n".to_owned();
    for name in &order {
        let used: Vec<String> = uses(name).iter().map(|own| format!("`{own}`")).collect();
        let used = used.join(", ");
        writeln!(
            text,
            "| [`{name}`](#{name}) | {used} | {} |",
            said(&top(name))
        )
        .unwrap();
    }
    generated(PAGE, "crates", &text);

    let mut text = String::new();
    for name in &order {
        let mut declared = modules(&read(&top(name)));
        // Taken from the program by its path.
        declared.retain(|module| (name.as_str(), module.as_str()) != ("ertel-fuzz", "failure"));
        // The order in which they may use one another, where a test holds one.
        let (listed, which) = match name.as_str() {
            "ertel-ehl" => (
                SOLVER.map(str::to_owned).to_vec(),
                "each uses only those above it",
            ),
            "ertel" => (
                CASES.map(str::to_owned).to_vec(),
                "each uses only those above it and `ertel-ehl`",
            ),
            _ => (declared.clone(), "as they are declared"),
        };
        let all = |names: &[String]| names.iter().cloned().collect::<BTreeSet<_>>();
        assert_eq!(
            all(&listed),
            all(&declared),
            "{name}: modules of the order and of the crate"
        );
        writeln!(text, "### {name}\n\nModules, {which}:\n").unwrap();
        writeln!(text, "{}", table(name, &listed)).unwrap();
        for opened in OPENED
            .iter()
            .filter(|opened| opened.split('/').next() == Some(name))
        {
            let inside = opened.split_once("/src/").unwrap().1;
            writeln!(text, "Parts of `{inside}`:\n\n| file | for |\n|---|---|").unwrap();
            for file in parts(opened) {
                let shown = file.split_once(&format!("{inside}/")).unwrap().1;
                writeln!(text, "| [`{shown}`](../../{file}) | {} |", said(&file)).unwrap();
            }
            writeln!(text).unwrap();
        }
    }
    generated(PAGE, "modules", &text);
}

/// The files of a folder, and the first ones of its folders, but those of tests.
fn parts(folder: &str) -> Vec<String> {
    let inside = format!("crates/{folder}");
    let mut found = Vec::new();
    for entry in fs::read_dir(root().join(&inside)).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        let first = format!("{inside}/{name}/mod.rs");
        let is_test = name.ends_with("tests.rs") || name == "tests";
        if name.ends_with(".rs") && name != "mod.rs" && !is_test {
            found.push(format!("{inside}/{name}"));
        } else if !is_test && root().join(&first).exists() {
            found.push(first);
        }
    }
    found.sort();
    found
}
