//! Numbers of pages that are constants of the source.
//!
//! Such a number is the text of a link by a label, whose definition at the end of the page is a file: `[0.3][SAFETY]` or `[20 %][SAFETY]`
//! with `[SAFETY]: ../../crates/.../errors.rs` equals `const SAFETY` there, and `[8][order]` the first number `order: 8,`. `SHARES.1` is the
//! second number of a list; the part of a label before `::` distinguishes constants of one name.

use std::collections::BTreeMap;

use super::pages::read;
use super::source::files;

/// The numbers of a text; those in per cent as shares.
fn numbers(text: &str) -> Vec<f64> {
    let parts = text.split(|c: char| !(c.is_ascii_alphanumeric() || "._-".contains(c)));
    let scale = if text.ends_with(" %") { 0.01 } else { 1.0 };
    let numbers = parts.filter(|part| part.contains(|c: char| c.is_ascii_digit()));
    let numbers = numbers.filter_map(|part| part.replace('_', "").parse::<f64>().ok());
    numbers.map(|number| number * scale).collect()
}

/// The numbers of a constant or of a field in the text of a Rust file.
fn constant(text: &str, name: &str) -> Vec<f64> {
    if name.starts_with(|c: char| c.is_lowercase()) {
        let key = format!(" {name}: ");
        let fields = text.split(&key).skip(1);
        let mut values = fields.map(|rest| numbers(rest.split(',').next().unwrap_or_default()));
        return values.find(|v| !v.is_empty()).unwrap_or_default();
    }
    let found = text.split_once(&format!("const {name}: "));
    let value = found.and_then(|(_, rest)| rest.split_once(" = ")?.1.split_once(';'));
    value.map_or_else(Vec::new, |(value, _)| numbers(value))
}

/// Links by a label, as text and label; labels start with a letter.
fn by_label(text: &str) -> Vec<(&str, &str)> {
    let link = |(at, _): (usize, &str)| {
        let (_, shown) = text[..at].rsplit_once('[')?;
        let (label, _) = text[at + 2..].split_once(']')?;
        let is_label = label.starts_with(|c: char| c.is_ascii_alphabetic());
        is_label.then_some((shown, label))
    };
    text.match_indices("][").filter_map(link).collect()
}

/// Differences between the numbers of a page and those of the source.
fn wrong_numbers(text: &str, source: impl Fn(&str) -> String) -> Vec<String> {
    let definitions = text.lines().filter_map(|line| {
        let (label, target) = line.strip_prefix('[')?.split_once("]: ")?;
        Some((label, target.trim_start_matches("../")))
    });
    let paths: BTreeMap<&str, &str> = definitions.collect();
    if paths.is_empty() {
        return Vec::new();
    }
    let mut unused = paths.clone();
    let mut wrong = Vec::new();
    for (shown, label) in by_label(text) {
        let Some(path) = paths.get(label) else {
            wrong.push(format!("[{label}] has no file"));
            continue;
        };
        unused.remove(label);
        let name = label.rsplit("::").next().unwrap();
        let (name, index) = name.split_once('.').unwrap_or((name, ""));
        let mut values = constant(&source(path), name);
        if let Ok(index) = index.parse::<usize>() {
            values = values.get(index).copied().into_iter().collect();
        }
        let own = numbers(shown);
        let same = |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-9 * b.abs();
        if own.is_empty() || own.len() != values.len() || !own.iter().zip(&values).all(same) {
            wrong.push(format!("[{shown}][{label}]: {path} has {values:?}"));
        }
    }
    wrong.extend(unused.keys().map(|label| format!("[{label}] is not used")));
    wrong
}

#[test]
fn numbers_of_the_pages_are_those_of_the_source() {
    let (mut wrong, mut n_links) = (Vec::new(), 0);
    for page in files("docs", &["md"]) {
        let text = read(&page);
        n_links += by_label(&text).len();
        let own = wrong_numbers(&text, read);
        wrong.extend(own.iter().map(|what| format!("{page}: {what}")));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(n_links > 60, "{n_links} numbers are linked");
}

#[test]
fn wrong_numbers_are_found() {
    let source =
        "const A: [f64; 2] = [1.0, 0.000_2];\nconst B: f64 = 0.3;\n order: usize,\n order: 8,\n";
    let wrong = |text: &str| wrong_numbers(text, |_| source.to_owned()).len();
    let files = "[A]: a.rs\n[A.1]: a.rs\n[c::B]: a.rs\n[order]: a.rs\n";
    let page = "of [1 and 2e-4][A], [2e-4][A.1] to [30 %][c::B], [8][order]\n";
    assert_eq!(wrong(&format!("{page}{files}")), 0);
    assert_eq!(wrong(&format!("{page}{files}[D]: a.rs")), 1);
    assert_eq!(wrong(&format!("{page}{}", &files[10..])), 1);
    for (right, other) in [
        ("1 and", "3 and"),
        ("2e-4][A.1", "2e-3][A.1"),
        ("30 %", "30"),
    ] {
        assert_eq!(wrong(&format!("{page}{files}").replace(right, other)), 1);
    }
}
