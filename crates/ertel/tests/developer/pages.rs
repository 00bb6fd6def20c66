//! Pages of the documentation, and their generated parts.

use std::fs;
use std::path::{Path, PathBuf};

/// The folder of the repository.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The text of a file, by its path in the repository.
pub fn read(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// Compares the part of a page between `<!-- generated: NAME -->` and `<!-- end -->` with `text`; with the environment variable
/// `UPDATE_DOCS` the page gets the text instead.
pub fn generated(page: &str, name: &str, text: &str) {
    let old = read(page);
    let begin = format!("<!-- generated: {name} -->\n");
    let (before, rest) = old
        .split_once(&begin)
        .unwrap_or_else(|| panic!("{page} has no {begin}"));
    let (own, after) = (rest.split_once("<!-- end -->"))
        .unwrap_or_else(|| panic!("{page}: no end of the generated part {name}"));
    let new = format!("\n{}\n\n", text.trim_end());
    if own == new {
        return;
    }
    if std::env::var_os("UPDATE_DOCS").is_some() {
        let page_text = format!("{before}{begin}{new}<!-- end -->{after}");
        fs::write(root().join(page), page_text).unwrap();
        return;
    }
    let differs = |(a, b): &(&str, &str)| a != b;
    let first = (new.lines().zip(own.lines())).find(differs);
    panic!(
        "{page}: the part `{name}` is not what the sources give; first difference: {first:#?}\n\
         UPDATE_DOCS=1 cargo test --release -p ertel --test suite developer"
    );
}

/// Links of a page as their text and target, outside its blocks of code.
pub fn links(text: &str) -> Vec<(String, String)> {
    let mut found = Vec::new();
    let mut in_code = false;
    for line in text.lines() {
        if line.trim_start().starts_with("```") {
            in_code = !in_code;
        }
        if in_code || line.starts_with("    ") {
            continue;
        }
        for (at, _) in line.match_indices("](") {
            let (before, after) = (&line[..at], &line[at + 2..]);
            // The text may begin on the line before.
            let start = before.rfind('[').map_or(0, |start| start + 1);
            if let Some(end) = after.find(')') {
                found.push((before[start..].to_owned(), after[..end].to_owned()));
            }
        }
    }
    found
}

#[test]
fn links_are_read_with_their_text() {
    let text = "See [`run`](a/b.rs) and [that](c.md#d).\n```\n[no](x)\n```\n";
    let own = |a: &str, b: &str| (a.to_owned(), b.to_owned());
    assert_eq!(links(text), [own("`run`", "a/b.rs"), own("that", "c.md#d")]);
}
