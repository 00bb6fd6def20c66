//! `equations.md`: from each equation to the page that explains it, the code that computes it and the tests that hold it.
//!
//! Doc comments name an equation in one of two ways: `Habchi 2008, eq. 2.10`, always with the source, or by a line of its own,
//! `Theory: Carreau-Yasuda.`, the bold words or the heading under which a page of `docs/theory` has it. Doc comments of tests likewise.

use std::collections::BTreeMap;
use std::fmt::Write;

use super::pages::{generated, read, root};
use super::source::{defined, rust_files};

const PAGE: &str = "docs/developer/equations.md";

/// Sources that have numbered equations, as comments and pages name them.
const SOURCES: [&str; 9] = [
    HABCHI,
    "Johnson 1985",
    "Biboulet and Houpert 2010, part 1",
    "Biboulet and Houpert 2010, part 2",
    "Born and Wolf 1999, section 7.2",
    "Born and Wolf 1999, section 2.3.3",
    "ISO/TS 16281:2008",
    "JCGM 100:2008",
    "Abramowitz and Stegun 1964",
];

/// Numbers on theory pages are those of the thesis where no other source is named.
const HABCHI: &str = "Habchi 2008";

/// Folders of pages that explain equations; the first that has one counts.
const PAGES: [&str; 3] = ["docs/theory", "docs/reference", "docs/guide"];

/// Folders of which every file has an equation.
const LAWS: [&str; 6] = [
    "crates/ertel-rheology/src/conductivity",
    "crates/ertel-rheology/src/density",
    "crates/ertel-rheology/src/heat_capacity",
    "crates/ertel-rheology/src/shear",
    "crates/ertel-rheology/src/viscosity",
    "crates/ertel-ehl/src/forms",
];

/// Files in these folders that have none of their own, and why.
const WITHOUT: [(&str, &str); 1] = [("forms/dual.rs", "numbers that carry derivatives")];

/// Equations that no page explains or no test of their own holds, and why.
const EXCEPTIONS: [(&str, &str); 1] = [(
    "Habchi 2008, eq. 3.24",
    "the default replaces it; the study penalty-scaling compares both",
)];

/// An equation by its source and number, or by its name on a theory page.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Equation {
    Numbered { source: usize, number: Number },
    Named(String),
}

impl Equation {
    fn words(&self) -> String {
        match self {
            Equation::Numbered { source, number } => {
                format!("{}, eq. {}", SOURCES[*source], number.words)
            }
            Equation::Named(name) => name.clone(),
        }
    }
}

/// `2.24b`, ordered by its parts: chapter or appendix, number, letter.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Number {
    parts: Vec<(u32, String)>,
    words: String,
}

impl Number {
    /// The number with which a text begins, and what follows.
    fn read(text: &str) -> Option<(Number, &str)> {
        let is_part = |c: char| c.is_ascii_alphanumeric() || c == '.';
        let end = text.find(|c| !is_part(c)).unwrap_or(text.len());
        let words = text[..end].trim_end_matches('.');
        let mut parts = Vec::new();
        for part in words.split('.') {
            let digits = part
                .find(|c: char| !c.is_ascii_digit())
                .unwrap_or(part.len());
            let letters = part[digits..].to_owned();
            if letters.len() > 1 {
                return None;
            }
            // Appendices, `A.6`, stand behind the chapters.
            let value = if digits == 0 {
                1000
            } else {
                part[..digits].parse().ok()?
            };
            parts.push((value, letters));
        }
        let has_digit = words.contains(|c: char| c.is_ascii_digit());
        let words = words.to_owned();
        has_digit.then(|| {
            (
                Number {
                    parts,
                    words: words.clone(),
                },
                &text[words.len()..],
            )
        })
    }

    /// All numbers up to another one that differs in its last part.
    fn up_to(&self, last: &Number) -> Vec<Number> {
        let (before, _) = self.words.rsplit_once('.').map_or(("", ""), |parts| parts);
        let ends = [self, last].map(|number| number.parts.last().unwrap().0);
        let all = (ends[0] + 1..=ends[1]).map(|i| match before {
            "" => format!("{i}"),
            before => format!("{before}.{i}"),
        });
        all.map(|words| Number::read(&words).unwrap().0).collect()
    }
}

/// The numbers of `2.25, 2.26 and 2.29 to 2.31, ...` up to the first word that is none.
fn numbers(mut text: &str) -> Vec<Number> {
    let mut found: Vec<Number> = Vec::new();
    let mut is_range = false;
    while let Some((number, rest)) = Number::read(text) {
        let new = match (is_range, found.last()) {
            (true, Some(last)) => last.up_to(&number),
            _ => vec![number],
        };
        found.extend(new);
        let separators = [", ", " and ", " to "];
        let Some(separator) = separators.iter().find(|s| rest.starts_with(**s)) else {
            break;
        };
        is_range = *separator == " to ";
        text = &rest[separator.len()..];
    }
    found
}

/// The equations that a text names; of one without its source, that of `usual`.
///
/// # Errors
/// What is written in front of a number that has no source.
fn named(text: &str, usual: Option<usize>) -> Result<Vec<Equation>, String> {
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let mut found = Vec::new();
    for word in ["eq. ", "eqs. "] {
        for (at, _) in text.match_indices(word) {
            let (before, after) = (&text[..at], &text[at + word.len()..]);
            if before.ends_with(|c: char| c.is_alphanumeric()) {
                continue;
            }
            let own = SOURCES
                .iter()
                .position(|s| before.ends_with(&format!("{s}, ")));
            let numbers = numbers(after);
            if numbers.is_empty() {
                continue;
            }
            let source = own.or(usual).ok_or_else(|| {
                let start = before.char_indices().rev().nth(40).map_or(0, |(i, _)| i);
                format!("...{}{word}{}", &before[start..], numbers[0].words)
            })?;
            let with_source = |number| Equation::Numbered { source, number };
            found.extend(numbers.into_iter().map(with_source));
        }
    }
    Ok(found)
}

/// What a doc comment stands above, and the equations in it.
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

/// Where the pages explain equations: page and anchor, first come. Bold words that stand on the pages more than once are named with their
/// heading, `Laws, Limiting stress`.
fn explained() -> BTreeMap<Equation, (String, String)> {
    let mut places = BTreeMap::new();
    let mut n_times: BTreeMap<String, usize> = BTreeMap::new();
    for folder in PAGES {
        for path in pages_of(folder) {
            let is_theory = folder == PAGES[0];
            let usual = is_theory.then_some(0);
            let (mut heading, mut place) = (String::new(), String::new());
            for paragraph in read(&path).split("\n\n") {
                for line in paragraph.lines().filter(|line| line.starts_with('#')) {
                    line.trim_start_matches('#').trim().clone_into(&mut heading);
                    place = anchor(&heading);
                    let name = Equation::Named(heading.clone());
                    let here = || (path.clone(), place.clone());
                    places.entry(name).or_insert_with(here);
                }
                let here = || (path.clone(), place.clone());
                let numbered = named(paragraph, usual).unwrap_or_default();
                let bold = paragraph.split("**").skip(1).step_by(2);
                let names = bold.flat_map(|name| {
                    let name = name.split_whitespace().collect::<Vec<_>>().join(" ");
                    let name = name.trim_end_matches('.').to_owned();
                    if is_theory {
                        *n_times.entry(name.clone()).or_default() += 1;
                    }
                    [format!("{heading}, {name}"), name].map(Equation::Named)
                });
                let names: Vec<Equation> = names.filter(|_| is_theory).collect();
                for equation in numbered.into_iter().chain(names) {
                    places.entry(equation).or_insert_with(here);
                }
            }
        }
    }
    places.retain(|equation, _| match equation {
        Equation::Named(name) => n_times.get(name).is_none_or(|n| *n == 1),
        Equation::Numbered { .. } => true,
    });
    places
}

/// The pages of a folder, sorted.
fn pages_of(folder: &str) -> Vec<String> {
    let entries = std::fs::read_dir(root().join(folder)).unwrap();
    let paths = entries.map(|entry| format!("{folder}/{}", entry.unwrap().file_name().display()));
    let mut pages: Vec<String> = paths.filter(|path| path.ends_with(".md")).collect();
    pages.sort();
    pages
}

/// The name by which a heading is linked.
fn anchor(heading: &str) -> String {
    let kept = |c: &char| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_');
    let words: String = heading.to_lowercase().chars().filter(kept).collect();
    words.trim().replace(' ', "-")
}

/// Whether tests in one file are those of the module in the other: inside of it, or beside it.
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

#[test]
fn numbers_of_equations_are_read() {
    let words = |text: &str| -> Vec<String> {
        let found = named(text, None).unwrap();
        found.iter().map(Equation::words).collect()
    };
    assert_eq!(
        words("(Habchi 2008, eqs. 2.25, 2.26, corrected)."),
        ["Habchi 2008, eq. 2.25", "Habchi 2008, eq. 2.26"]
    );
    assert_eq!(
        words("Johnson 1985,\n eqs. 4.25 to 4.27; see Habchi 2008, eq. A.6."),
        [
            "Habchi 2008, eq. A.6",
            "Johnson 1985, eq. 4.25",
            "Johnson 1985, eq. 4.26",
            "Johnson 1985, eq. 4.27"
        ]
    );
    assert!(named("the diffusion (eq. 2.29).", None).is_err());
    assert_eq!(
        named("(eq. 2.29)", Some(0)),
        named("Habchi 2008, eq. 2.29", None)
    );
    assert!(words("a sequence. 3").is_empty());
}
