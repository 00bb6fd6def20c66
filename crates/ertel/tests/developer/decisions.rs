//! Decisions: numbered titles, one list, and in it which of them later ones replace.

use std::fmt::Write;
use std::fs;

use super::pages::{generated, links, read, root};

/// How the first line of a decision begins that a later one has changed.
const CHANGED: [&str; 3] = ["Replaced by ", "Replaced in part by ", "Extended by "];

/// The files of decisions, in their order.
fn files() -> Vec<String> {
    let entries = fs::read_dir(root().join("docs/decisions")).unwrap();
    let mut files: Vec<String> = entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    files.sort();
    files
}

/// The number of a decision by its file, or by a link to it.
fn number(file: &str) -> Option<usize> {
    let name = file.rsplit('/').next()?;
    name.get(..4)?
        .parse()
        .ok()
        .filter(|_| name.ends_with(".md"))
}

#[test]
fn decisions_are_numbered_and_listed() {
    let summary = read("docs/SUMMARY.md");
    let mut table = "| | decision | changed by a later one |\n|---|---|---|\n".to_owned();
    let mut wrong = Vec::new();
    for (i, file) in files().iter().enumerate() {
        let n = i + 1;
        if number(file) != Some(n) {
            wrong.push(format!("{file} is in the position of number {n}"));
        }
        let text = read(&format!("docs/decisions/{file}"));
        let mut lines = text.lines();
        let title = lines.next().unwrap_or_default();
        let Some(title) = title.strip_prefix(&format!("# {n}. ")) else {
            wrong.push(format!("{file}: the title is not `# {n}. ...`"));
            continue;
        };
        let first = lines.find(|line| !line.is_empty()).unwrap_or_default();
        let is_changed = CHANGED.iter().any(|word| first.starts_with(word));
        if is_changed
            && !links(first)
                .iter()
                .any(|(_, target)| number(target) > Some(n))
        {
            wrong.push(format!("{file} names no later decision that changes it"));
        }
        let changed = if is_changed {
            first.replace("](", "](decisions/")
        } else {
            String::new()
        };
        writeln!(table, "| {n} | [{title}](decisions/{file}) | {changed} |").unwrap();
        if !summary.contains(&format!("- [{n}. {title}](decisions/{file})\n")) {
            wrong.push(format!(
                "docs/SUMMARY.md does not list {file} by number and title"
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    generated("docs/decisions.md", "decisions", &table);
}

/// A link that says a number leads to the decision of that number.
#[test]
fn links_to_decisions_have_their_numbers() {
    fn walk(folder: &str, found: &mut Vec<String>) {
        for entry in fs::read_dir(root().join(folder)).unwrap() {
            let entry = entry.unwrap();
            let path = format!("{folder}/{}", entry.file_name().display());
            if entry.path().is_dir() {
                walk(&path, found);
            } else if path.ends_with(".md") {
                found.push(path);
            }
        }
    }
    let mut pages = Vec::new();
    walk("docs", &mut pages);
    let mut wrong = Vec::new();
    for page in pages {
        for (shown, target) in links(&read(&page)) {
            let said: Option<usize> = (shown.to_lowercase().trim_start_matches("decision "))
                .parse()
                .ok();
            if let (Some(said), Some(n)) = (said, number(&target))
                && said != n
            {
                wrong.push(format!("{page}: [{shown}]({target})"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
