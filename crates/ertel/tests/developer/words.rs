//! Plain words: idioms that readers stumbled on stay out of code, messages and pages.

use super::pages::read;
use super::source::files;

/// Words and phrases that may not occur, in identifiers neither.
const IDIOMS: [&str; 25] = [
    "told",
    "tell",
    "tells",
    "telling",
    "beside",
    "besides",
    "anew",
    "askew",
    "astray",
    "wander",
    "wanders",
    "manner",
    "manners",
    "in place of",
    "once more",
    "drawn out",
    "of its own",
    "of their own",
    "go by",
    "goes by",
    "went by",
    "go with",
    "goes with",
    "go about",
    "goes about",
];

/// This file, which quotes them.
const THIS: &str = "crates/ertel/tests/developer/words.rs";

/// The words of a text in lower case, each with its line; identifiers are taken apart.
fn words(text: &str) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    for (i, line) in text.lines().enumerate() {
        let mut word = String::new();
        let mut before = ' ';
        for c in line.chars().chain([' ']) {
            let is_next = !c.is_alphabetic() || (c.is_uppercase() && before.is_lowercase());
            if is_next && !word.is_empty() {
                found.push((i + 1, std::mem::take(&mut word)));
            }
            if c.is_alphabetic() {
                word.extend(c.to_lowercase());
            }
            before = c;
        }
    }
    found
}

/// The idioms of a text, each with its line.
fn idioms(text: &str) -> Vec<(usize, &'static str)> {
    let words = words(text);
    let phrases = IDIOMS.map(|idiom| (idiom, idiom.split(' ').collect::<Vec<_>>()));
    let mut found = Vec::new();
    for (k, (line, _)) in words.iter().enumerate() {
        for (idiom, phrase) in &phrases {
            let here = words[k..].iter().map(|(_, word)| word.as_str());
            if here.take(phrase.len()).eq(phrase.iter().copied()) {
                found.push((*line, *idiom));
            }
        }
    }
    found
}

/// Whether a line is a comment that starts with a clause as its noun: "What is left ...".
fn starts_with_what(line: &str) -> bool {
    let comment = line.trim_start().trim_start_matches(['/', '!', '#']);
    comment.len() < line.trim_start().len() && comment.starts_with(" What ") && !line.contains('?')
}

#[test]
fn idioms_are_found_in_text_and_identifiers() {
    assert!(starts_with_what("    /// What is left of it.") && !starts_with_what("/// What now?"));
    let text = "/// They are in place\n/// of it.\nfn is_told(x: ToldTwice) {}\nin placeof, untold";
    let expected = [(1, "in place of"), (3, "told"), (3, "told")];
    assert_eq!(idioms(text), expected);
}

#[test]
fn no_idiom_comes_back() {
    const FOLDERS: [&str; 8] = [
        ".ci",
        "benchmark-suite",
        "cases",
        "crates",
        "docs",
        "packaging",
        "studies",
        "validation",
    ];
    const ENDINGS: [&str; 10] = [
        "rs", "md", "toml", "py", "pyi", "sh", "html", "js", "yml", "ipynb",
    ];
    let pages = ["README.md", "CHANGELOG.md", "CONTRIBUTING.md", ".ci/run"].map(str::to_owned);
    let below = FOLDERS.iter().flat_map(|folder| files(folder, &ENDINGS));
    let mut found = Vec::new();
    for path in below.chain(pages).filter(|path| path != THIS) {
        // The former name of an option.
        let text = read(&path).replace("alias = \"beside\"", "");
        let here = idioms(&text).into_iter();
        found.extend(here.map(|(line, idiom)| format!("{path}:{line}: {idiom}")));
        let lines = text.lines().enumerate();
        let what = lines.filter(|(_, line)| starts_with_what(line));
        found.extend(what.map(|(i, _)| format!("{path}:{}: What ...", i + 1)));
    }
    assert!(
        found.is_empty(),
        "{} idioms:\n{}",
        found.len(),
        found.join("\n")
    );
}
