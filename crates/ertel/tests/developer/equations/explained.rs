//! Where the pages explain equations.

use std::collections::BTreeMap;
use std::fs;

use super::super::pages::{read, root};
use super::name::{Equation, named};

/// Folders of pages that explain equations; the first that has one counts.
const PAGES: [&str; 3] = ["docs/theory", "docs/reference", "docs/guide"];

/// Where the pages explain equations: page and anchor, first come. Bold words that stand on the pages more than once are named with their
/// heading, `Laws, Limiting stress`.
pub fn explained() -> BTreeMap<Equation, (String, String)> {
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
    let entries = fs::read_dir(root().join(folder)).unwrap();
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
