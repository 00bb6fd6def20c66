//! Links of all pages, and the files and names that the pages for developers link.

use std::fs;

use super::pages::{links, read, root};
use super::source::{defined, files, rust_files};

/// Pages that are written by hand; each names a function, type or constant as the text of a link to its file.
const PAGES: [&str; 3] = ["architecture.md", "recipes.md", "debugging.md"];

/// Whether a file defines what is named: a path of Rust by its last part, a key of TOML, or anything that begins a line.
fn has(path: &str, name: &str) -> bool {
    let text = read(path);
    let last = name.trim_end_matches("()").rsplit("::").next().unwrap();
    match path.rsplit('.').next() {
        Some("rs") => text.lines().any(|line| defined(line) == Some(last)),
        _ => text.contains(last),
    }
}

#[test]
fn names_of_the_developer_pages_are_in_their_files() {
    let mut wrong = Vec::new();
    let mut n_names = 0;
    for page in PAGES {
        let text = read(&format!("docs/developer/{page}"));
        for (shown, target) in links(&text) {
            let Some(path) = target.strip_prefix("../../") else {
                continue;
            };
            if !root().join(path).exists() {
                wrong.push(format!("{page}: {path} is not there"));
                continue;
            }
            let Some(name) = shown.strip_prefix('`').and_then(|s| s.strip_suffix('`')) else {
                continue;
            };
            // Files by their names, and folders.
            let is_file =
                name.contains(['/', '.']) || fs::metadata(root().join(path)).unwrap().is_dir();
            let stem = path.trim_end_matches("/mod.rs").trim_end_matches(".rs");
            if is_file || stem.ends_with(&format!("/{name}")) {
                continue;
            }
            n_names += 1;
            if !has(path, name) {
                wrong.push(format!("{page}: {path} has no {name}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(n_names > 40, "only {n_names} names were found");
}

/// Names of Rust files in code spans of a text: `solve/ridge.rs`.
fn files_named(text: &str) -> Vec<&str> {
    let spans = text
        .lines()
        .flat_map(|line| line.split('`').skip(1).step_by(2));
    let is_path = |span: &&str| {
        let is_part = |c: char| c.is_ascii_alphanumeric() || "_-/.".contains(c);
        span.ends_with(".rs") && span.contains('/') && span.chars().all(is_part)
    };
    spans.filter(is_path).collect()
}

/// Theory, decisions and the other pages name files that are there: `solve/ridge.rs` is one of some crate.
#[test]
fn files_that_pages_name_are_there() {
    let all = rust_files("crates");
    let mut pages = vec!["CONTRIBUTING.md".to_owned()];
    for folder in [
        "docs",
        "docs/theory",
        "docs/decisions",
        "docs/developer",
        "docs/reference",
        "docs/guide",
    ] {
        for entry in fs::read_dir(root().join(folder)).unwrap() {
            let path = format!("{folder}/{}", entry.unwrap().file_name().display());
            if path.ends_with(".md") {
                pages.push(path);
            }
        }
    }
    let mut wrong = Vec::new();
    for page in pages {
        let text = read(&page);
        for name in files_named(&text) {
            let inside = format!("/{name}");
            if !all
                .iter()
                .any(|path| path == name || path.ends_with(&inside))
            {
                wrong.push(format!("{page}: no crate has {name}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn missing_names_are_noticed() {
    assert!(has("crates/ertel/tests/arrows.rs", "arrows_run_down"));
    assert!(!has("crates/ertel/tests/arrows.rs", "arrows_run_up"));
    assert_eq!(files_named("in `a/b.rs`, not `fn c` or `*.rs`"), ["a/b.rs"]);
}

/// The name by which a heading is linked.
fn anchor(heading: &str) -> String {
    let kept = |c: &char| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_');
    let words: String = heading.to_lowercase().chars().filter(kept).collect();
    words.trim().replace(' ', "-")
}

#[test]
fn every_page_is_in_the_table_of_contents() {
    const SUMMARY: &str = "docs/SUMMARY.md";
    let listed = links(&read(SUMMARY)).into_iter();
    let listed: Vec<String> = listed.map(|(_, page)| format!("docs/{page}")).collect();
    for page in files("docs", &["md"]) {
        let is_listed = page == SUMMARY || listed.contains(&page);
        assert!(is_listed, "{SUMMARY} does not name {page}");
    }
}

#[test]
fn every_link_leads_somewhere() {
    let mut pages = files("docs", &["md"]);
    pages.extend(["README.md", "CONTRIBUTING.md", "CHANGELOG.md"].map(str::to_owned));
    let mut broken = Vec::new();
    for page in pages {
        let own = root().join(&page);
        for (_, link) in links(&read(&page)) {
            if link.starts_with("http") || link.starts_with("mailto:") {
                continue;
            }
            let (path, place) = link.split_once('#').unwrap_or((&link, ""));
            let target = match path {
                "" => own.clone(),
                path => own.parent().unwrap().join(path),
            };
            if !target.exists() {
                broken.push(format!("{page}: {link}"));
            } else if !place.is_empty() && target.extension().is_some_and(|e| e == "md") {
                let text = fs::read_to_string(&target).unwrap();
                let headings = text.lines().filter(|l| l.starts_with('#'));
                let has_place = headings
                    .map(|l| anchor(l.trim_start_matches('#')))
                    .any(|name| name == place);
                if !has_place && !text.contains(&format!("id=\"{place}\"")) {
                    broken.push(format!("{page}: {link}"));
                }
            }
        }
    }
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}
