//! Constants in the theory pages: the numbers of the pages equal those of the source.

mod rows;

use std::fs;

use crate::common::root;
use rows::ROWS;

const WORDS: [&str; 13] = [
    "zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten",
    "eleven", "twelve",
];

/// The numbers of a constant, of the first field of this name that has a number, or of the first place of this code, as the source has
/// them.
fn constant(file: &str, name: &str) -> Vec<f64> {
    let folder = match file.starts_with("crates/") {
        true => root(),
        false => root().join("crates/ertel-ehl/src"),
    };
    let text = fs::read_to_string(folder.join(file)).unwrap_or_else(|e| panic!("{file}: {e}"));
    if name.contains("{}") {
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        let found = numbers_of(&without_separators(&text), name);
        return found
            .into_iter()
            .next()
            .unwrap_or_else(|| panic!("{file} has no {name}"));
    }
    if name.starts_with(|c: char| c.is_lowercase()) {
        let key = format!(" {name}: ");
        let fields = text.split(&key).skip(1);
        let values =
            fields.filter_map(|rest| rest.split_once(',')?.0.replace('_', "").parse().ok());
        return values.take(1).collect();
    }
    let (_, rest) = text
        .split_once(&format!("const {name}: "))
        .unwrap_or_else(|| panic!("{file} has no {name}"));
    let (_, value) = rest.split_once(" = ").unwrap();
    let (value, _) = value.split_once(';').unwrap();
    let numbers = value.split(|c: char| !(c.is_ascii_alphanumeric() || ".-_".contains(c)));
    numbers
        .filter(|part| !part.is_empty())
        .map(|part| {
            part.replace('_', "")
                .parse()
                .unwrap_or_else(|_| panic!("{file}: {name} = {value}"))
        })
        .collect()
}

/// `0.007_15` as `0.00715`.
fn without_separators(text: &str) -> String {
    let is_digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
    let mut result = String::new();
    let mut rest = text.chars().peekable();
    while let Some(c) = rest.next() {
        let between = is_digit(result.chars().next_back()) && is_digit(rest.peek().copied());
        if c != '_' || !between {
            result.push(c);
        }
    }
    result
}

/// The number with which a text begins, in digits or as a word, and what follows.
fn number(text: &str) -> Option<(f64, &str)> {
    if let Some(value) = WORDS.iter().position(|word| text.starts_with(word)) {
        return Some((value as f64, &text[WORDS[value].len()..]));
    }
    let end = text
        .find(|c: char| !(c.is_ascii_digit() || ".e-".contains(c)))
        .unwrap_or(text.len());
    // A point may end the sentence.
    let ends = (1..=end).rev().filter(|end| text.is_char_boundary(*end));
    ends.map(|end| (&text[..end], &text[end..]))
        .filter(|(digits, _)| !digits.ends_with('.'))
        .find_map(|(digits, rest)| Some((digits.parse().ok()?, rest)))
}

/// The numbers of a sentence where the text has it.
fn numbers_of(text: &str, sentence: &str) -> Vec<Vec<f64>> {
    let mut parts = sentence.split("{}");
    let first = parts.next().unwrap();
    let rest: Vec<&str> = parts.collect();
    let starts = text.match_indices(first).map(|(at, _)| at + first.len());
    let read = |start: usize| {
        let mut left = &text[start..];
        let mut numbers = Vec::new();
        for part in &rest {
            let (value, after) = number(left)?;
            numbers.push(value);
            left = after.strip_prefix(part)?;
        }
        Some(numbers)
    };
    starts.filter_map(read).collect()
}

/// Each sentence is on its page, with the numbers of the source.
#[test]
fn theory_pages_state_the_constants_of_the_source() {
    let mut wrong = Vec::new();
    for (page, sentence, constants) in ROWS {
        let text = fs::read_to_string(root().join("docs").join(page)).unwrap();
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        let found = numbers_of(&text, sentence);
        let expected: Vec<f64> = (constants.iter())
            .map(|(file, name, at, factor)| constant(file, name)[*at] * factor)
            .collect();
        let same = |numbers: &Vec<f64>| {
            numbers.len() == expected.len()
                && numbers
                    .iter()
                    .zip(&expected)
                    .all(|(a, b)| (a - b).abs() <= 1e-9 * b.abs())
        };
        if !found.iter().any(same) {
            wrong.push(format!(
                "{page}: \"{sentence}\" says {found:?}, the source has {expected:?}"
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Words, digits and the ends of sentences are read as they are meant.
#[test]
fn numbers_are_read_from_sentences() {
    assert_eq!(
        numbers_of(
            "halved up to six times (twelve at most).",
            "up to {} times ({} at"
        ),
        [[6.0, 12.0]]
    );
    assert_eq!(
        numbers_of("with 0.3, 1. Then 1e-3: end", "with {}, {}."),
        [[0.3, 1.0]]
    );
    assert_eq!(numbers_of("end at 1e-3: the", "end at {}: the"), [[1e-3]]);
    assert!(numbers_of("end at some", "end at {}").is_empty());
}
