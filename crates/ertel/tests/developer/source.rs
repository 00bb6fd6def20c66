//! Sources as text: what a module says of itself, and what a file defines.

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};

use super::pages::root;

/// The first sentence of the comment at the top of a file.
pub fn purpose(text: &str) -> Option<String> {
    let lines = text.lines().map_while(|line| line.strip_prefix("//!"));
    let first: Vec<&str> = lines.map(str::trim).take_while(|l| !l.is_empty()).collect();
    let first = first.join(" ");
    let end = first.find(". ").unwrap_or(first.len());
    let sentence = first[..end].trim_end_matches('.').to_owned();
    (!sentence.is_empty()).then_some(sentence)
}

/// The file of a module in a folder of sources.
pub fn file_of(folder: &Path, module: &str) -> PathBuf {
    let own = folder.join(format!("{module}.rs"));
    match own.exists() {
        true => own,
        false => folder.join(module).join("mod.rs"),
    }
}

/// The modules that a file declares, in its order, without those of tests.
pub fn modules(text: &str) -> Vec<String> {
    // A module defined elsewhere belongs to another crate.
    let before = std::iter::once("").chain(text.lines());
    let own = before
        .zip(text.lines())
        .filter(|(before, _)| !before.starts_with("#[path"));
    let names = own.filter_map(|(_, line)| {
        let rest = line.trim_start_matches("pub ").strip_prefix("mod ")?;
        Some(rest.strip_suffix(';')?.to_owned())
    });
    names.filter(|name| !name.ends_with("tests")).collect()
}

/// All files below a folder with one of some endings, sorted, each as its path in the repository; folders that builds and fuzzing fill are skipped.
pub fn files(folder: &str, endings: &[&str]) -> Vec<String> {
    const SKIPPED: [&str; 4] = ["target", "corpus", "node_modules", "pkg"];
    fn walk(folder: &Path, endings: &[&str], found: &mut Vec<PathBuf>) {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let named = |names: &[&str], name: Option<&OsStr>| {
                name.and_then(OsStr::to_str)
                    .is_some_and(|name| names.contains(&name))
            };
            if path.is_dir() {
                if !named(&SKIPPED, path.file_name()) {
                    walk(&path, endings, found);
                }
            } else if named(endings, path.extension()) {
                found.push(path);
            }
        }
    }
    let root = root();
    let mut found = Vec::new();
    walk(&root.join(folder), endings, &mut found);
    let inside = |path: PathBuf| path.strip_prefix(&root).unwrap().display().to_string();
    let mut found: Vec<String> = found.into_iter().map(inside).collect();
    found.sort();
    found
}

/// All Rust files below a folder.
pub fn rust_files(folder: &str) -> Vec<String> {
    files(folder, &["rs"])
}

/// The name that a line of code defines: of a function, type, constant, module, or else of a field or a variant.
pub fn defined(line: &str) -> Option<&str> {
    let mut rest = line.trim_start();
    if rest.starts_with("//") || rest.starts_with('#') {
        return None;
    }
    if let Some((_, after)) = (rest.split_once(") ")).filter(|_| rest.starts_with("pub(")) {
        rest = after;
    }
    rest = rest.strip_prefix("pub ").unwrap_or(rest);
    if rest.starts_with("const fn ") {
        rest = &rest["const ".len()..];
    }
    let kinds = [
        "fn ",
        "struct ",
        "enum ",
        "trait ",
        "type ",
        "const ",
        "static ",
        "mod ",
        "macro_rules! ",
    ];
    let is_item = kinds.iter().find_map(|kind| rest.strip_prefix(kind));
    let name = is_item.unwrap_or(rest);
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let end = name.find(|c: char| !is_word(c)).unwrap_or(name.len());
    let after = &name[end..];
    // Variants begin with a capital; a field has its type.
    let member: &[&str] = match name.starts_with(|c: char| c.is_uppercase()) {
        true => &[",", "(", " {", " = "],
        false => &[": "],
    };
    let is_member = member.iter().any(|next| after.starts_with(next));
    (end > 0 && (is_item.is_some() || is_member)).then_some(&name[..end])
}

#[test]
fn definitions_are_found() {
    assert_eq!(
        defined("pub const fn solve(case: &Case) -> f64 {"),
        Some("solve")
    );
    assert_eq!(defined("    Roelands(Roelands),"), Some("Roelands"));
    assert_eq!(defined("pub(in super::super) fn halfway("), Some("halfway"));
    assert_eq!(defined("pub struct Tait {"), Some("Tait"));
    assert_eq!(defined("// fn old()"), None);
    assert_eq!(defined("    rise_limit: f64,"), Some("rise_limit"));
    assert_eq!(defined("    solve.run()"), None);
    assert_eq!(defined("    fallbacks"), None);
    assert_eq!(defined("    fallbacks(outline)"), None);
}

#[test]
fn purpose_is_the_first_sentence() {
    assert_eq!(
        purpose("//! One thing.\n//! Another.\n").as_deref(),
        Some("One thing")
    );
    assert_eq!(
        purpose("//! One\n//! thing\n//!\n//! More.\n").as_deref(),
        Some("One thing")
    );
    assert_eq!(purpose("use std::fs;\n"), None);
}
