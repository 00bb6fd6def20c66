//! `equations.md`: from each equation to the page that explains it, the code that computes it and the tests that check it.
//!
//! Doc comments name an equation in one of two ways: `Habchi 2008, eq. 2.10`, always with the source, or by a separate line,
//! `Theory: Carreau-Yasuda.`, the bold words or the heading under which a page of `docs/theory` has it. Doc comments of tests likewise.

mod explained;
mod name;

use std::collections::BTreeMap;
use std::fmt::Write;

use super::pages::{generated, read, root};
use super::source::{defined, rust_files};
use explained::explained;
use name::{Equation, named};

const PAGE: &str = "docs/developer/equations.md";

/// Folders of which every file has an equation.
const LAWS: [&str; 6] = [
    "crates/ertel-rheology/src/conductivity",
    "crates/ertel-rheology/src/density",
    "crates/ertel-rheology/src/heat_capacity",
    "crates/ertel-rheology/src/shear",
    "crates/ertel-rheology/src/viscosity",
    "crates/ertel-ehl/src/forms",
];

/// Files in these folders without an equation, and why.
const WITHOUT: [(&str, &str); 2] = [
    ("forms/dual.rs", "numbers that carry derivatives"),
    (
        "forms/energy/heights.rs",
        "points at which energy.rs evaluates its equations",
    ),
];

/// Equations without explaining page or without a test, and why.
const EXCEPTIONS: [(&str, &str); 1] = [(
    "Habchi 2008, eq. 3.24",
    "the default replaces it; the study penalty-scaling compares both",
)];

/// An item with a doc comment, and the equations in it.
struct Item {
    file: String,
    /// Empty for the comment at the top of a file.
    name: String,
    is_test: bool,
    equations: Vec<Equation>,
}

/// All doc comments of a file.
fn items(file: &str, problems: &mut Vec<String>) -> Vec<Item> {
    let text = read(file);
    let mut found = Vec::new();
    let mut comment: Vec<&str> = Vec::new();
    let mut is_test = false;
    let mut take = |name: &str, is_test: bool, comment: &mut Vec<&str>| {
        let names = comment.iter().filter_map(|line| {
            let name = line.trim().strip_prefix("Theory: ")?;
            Some(Equation::Named(name.trim_end_matches('.').to_owned()))
        });
        let mut equations: Vec<Equation> = names.collect();
        match named(&comment.join("\n"), None) {
            Ok(numbered) => equations.extend(numbered),
            Err(place) => problems.push(format!("{file}: \"{place}\" names no source of the list")),
        }
        comment.clear();
        found.push(Item {
            file: file.to_owned(),
            name: name.to_owned(),
            is_test,
            equations,
        });
    };
    for line in text.lines() {
        let code = line.trim();
        if let Some(doc) = code.strip_prefix("//!") {
            comment.push(doc);
        } else if let Some(doc) = code.strip_prefix("///") {
            comment.push(doc);
        } else if code.starts_with('#') {
            is_test |= code == "#[test]";
        } else {
            match defined(line) {
                Some(name) => take(name, is_test, &mut comment),
                None => take("", false, &mut comment),
            }
            is_test = false;
        }
    }
    found
}

/// Whether tests in one file are those of the module in the other: inside of it, or next to it.
fn belongs(test: &str, module: &str) -> bool {
    let stem = module.trim_end_matches(".rs").trim_end_matches("/mod");
    test == module
        || [format!("{stem}/tests.rs"), format!("{stem}_tests.rs")]
            .iter()
            .any(|own| own == test)
}

/// Code that computes an equation, and tests that name it.
#[derive(Default)]
struct Row {
    code: Vec<(String, String)>,
    tests: Vec<(String, String)>,
}

/// A link to code: a type by its name, a function with its module, a comment at the top of a file by that.
fn link((file, name): &(String, String)) -> String {
    let stem = file.trim_end_matches(".rs").trim_end_matches("/mod");
    let module = stem.rsplit('/').next().unwrap();
    let shown = match name {
        name if name.is_empty() => format!("{module}.rs"),
        name if name.starts_with(|c: char| c.is_uppercase()) => name.clone(),
        name => format!("{module}::{name}"),
    };
    format!("[`{shown}`](../../{file})")
}

#[test]
fn index_of_equations_is_that_of_the_code() {
    let mut problems = Vec::new();
    let mut all: Vec<Item> = Vec::new();
    for crate_name in ["ertel-rheology", "ertel-ehl", "ertel-fem", "ertel"] {
        for folder in ["src", "tests"] {
            let folder = format!("crates/{crate_name}/{folder}");
            if root().join(&folder).exists() {
                for file in rust_files(&folder)
                    .iter()
                    .filter(|f| !f.contains("tests/developer"))
                {
                    all.extend(items(file, &mut problems));
                }
            }
        }
    }
    let is_of_tests = |file: &str| file.contains("/tests/") || file.ends_with("tests.rs");
    let mut rows: BTreeMap<Equation, Row> = BTreeMap::new();
    for item in &all {
        for equation in &item.equations {
            let row = rows.entry(equation.clone()).or_default();
            let place = (item.file.clone(), item.name.clone());
            let list = match (item.is_test, is_of_tests(&item.file)) {
                (true, _) => &mut row.tests,
                (false, false) => &mut row.code,
                // Helpers of tests.
                (false, true) => continue,
            };
            if !list.contains(&place) {
                list.push(place);
            }
        }
    }
    rows.retain(|_, row| !row.code.is_empty());
    for row in rows.values_mut().filter(|row| row.tests.is_empty()) {
        for (file, _) in &row.code {
            let own = all
                .iter()
                .filter(|item| item.is_test && belongs(&item.file, file));
            row.tests.extend(
                own.take(3)
                    .map(|item| (item.file.clone(), item.name.clone())),
            );
        }
    }
    let places = explained();
    let head = "| equation | page | code | tests |\n|---|---|---|---|\n";
    let [mut numbered, mut by_name] = [head.to_owned(), head.to_owned()];
    for (equation, row) in &rows {
        let words = equation.words();
        let is_known = EXCEPTIONS.iter().any(|(own, _)| *own == words);
        let place = places.get(equation);
        if (place.is_none() || row.tests.is_empty()) != is_known {
            problems.push(match is_known {
                true => {
                    format!("{words} has a page and a test: take it off the list of exceptions")
                }
                false => format!(
                    "{words} ({}) has no {}",
                    row.code[0].0,
                    if place.is_none() { "page" } else { "test" }
                ),
            });
        }
        let page = place.map_or("–".to_owned(), |(page, anchor)| {
            let name = page.rsplit('/').next().unwrap();
            format!(
                "[{}](../{}#{anchor})",
                name.trim_end_matches(".md"),
                &page["docs/".len()..]
            )
        });
        let list = |places: &[(String, String)]| match places {
            [] => "–".to_owned(),
            places => places.iter().map(link).collect::<Vec<_>>().join(", "),
        };
        let text = match equation {
            Equation::Numbered { .. } => &mut numbered,
            Equation::Named(_) => &mut by_name,
        };
        writeln!(
            text,
            "| {words} | {page} | {} | {} |",
            list(&row.code),
            list(&row.tests)
        )
        .unwrap();
    }
    for folder in LAWS {
        for file in rust_files(folder)
            .iter()
            .filter(|file| !file.ends_with("tests.rs") && !file.ends_with("mod.rs"))
        {
            let has_one = all
                .iter()
                .any(|item| item.file == *file && !item.equations.is_empty());
            let is_known = WITHOUT.iter().any(|(own, _)| file.ends_with(own));
            if has_one == is_known {
                problems.push(format!("{file}: names an equation: {has_one}; is on the list of those without: {is_known}"));
            }
        }
    }
    assert!(
        problems.is_empty(),
        "{} problems\n{}",
        problems.len(),
        problems.join("\n")
    );
    generated(PAGE, "numbered", &numbered);
    generated(PAGE, "named", &by_name);
}
