//! Words, numbers and strings of TOML, JSON and CSV, and damage to them.

use std::ops::Range;

use fastrand::Rng;

use super::Words;

/// Kind of a token.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A key, the name of a section, `true`.
    Word,
    /// A number outside quotes.
    Number,
    /// A string with its quotes.
    String,
}

/// The tokens of a text, without comments.
pub fn tokens(text: &str) -> Vec<(Kind, Range<usize>)> {
    let bytes = text.as_bytes();
    let mut found = Vec::new();
    let mut at = 0;
    while at < bytes.len() {
        let start = at;
        let while_in =
            |set: fn(&u8) -> bool| start + bytes[start..].iter().take_while(|b| set(b)).count();
        match bytes[at] {
            b'#' => at = while_in(|b| *b != b'\n'),
            b'"' => {
                let end = bytes[at + 1..]
                    .iter()
                    .position(|b| matches!(b, b'"' | b'\n'));
                at = end.map_or(bytes.len(), |n| at + n + 2);
                found.push((Kind::String, start..at));
            }
            b'0'..=b'9' | b'-' | b'+' => {
                at = while_in(|b| b.is_ascii_alphanumeric() || b"+-._".contains(b));
                found.push((Kind::Number, start..at));
            }
            b if b.is_ascii_alphabetic() || b == b'_' => {
                at = while_in(|b| b.is_ascii_alphanumeric() || b"-_.".contains(b));
                found.push((Kind::Word, start..at));
            }
            _ => at += 1,
        }
    }
    found.retain(|(_, span)| text.is_char_boundary(span.start) && text.is_char_boundary(span.end));
    found
}

/// Numbers at and beyond the ends of what is allowed.
pub const NUMBERS: [&str; 40] = [
    "0",
    "-0.0",
    "1",
    "-1",
    "2",
    "0.5",
    "0.4999999999",
    "1e-3",
    "1e3",
    "1e-6",
    "1e6",
    "1e-12",
    "1e9",
    "1e12",
    "1e18",
    "1e30",
    "-1e30",
    "1e-30",
    "1e100",
    "1e154",
    "1e-154",
    "1e300",
    "1e308",
    "-1e308",
    "1e309",
    "5e-324",
    "2.2250738585072014e-308",
    "nan",
    "inf",
    "-inf",
    "+nan",
    "9223372036854775807",
    "9223372036854775808",
    "-9223372036854775808",
    "4294967296",
    "20000",
    "20001",
    "1e",
    "0x7fff_ffff",
    "1_000",
];

/// Units, right and wrong.
const UNITS: [&str; 32] = [
    "m", "mm", "um", "nm", "N", "kN", "N/m", "kN/m", "Pa", "MPa", "GPa", "1/GPa", "Pa.s", "mPa.s",
    "cP", "m/s", "mm/s", "K", "degC", "kg/m^3", "g/cm^3", "W/(m.K)", "J/(kg.K)", "%", "1/K",
    "K/GPa", "m^2/s", "°C", "", "m/s/s", "m^-400", "furlong",
];

/// Values of another type.
const VALUES: [&str; 20] = [
    "true",
    "false",
    "\"\"",
    "\"x\"",
    "[]",
    "{}",
    "[[]]",
    "[1, 2]",
    "{ law = \"table\", file = \"table.csv\" }",
    "1979-05-27",
    "07:32:00",
    "\"\\u001b[31m\"",
    "\"\\U0001F600\"",
    "'''a\nb'''",
    "\"../../../etc/passwd\"",
    "\"/dev/zero\"",
    "\"\\u0000\"",
    "[{ a = 1 }]",
    "\"steel\"",
    "\"table\"",
];

fn pick<'a>(rng: &mut Rng, from: &[&'a str]) -> &'a str {
    from[rng.usize(0..from.len())]
}

/// Another number: an extreme one, or the old one times a power of ten.
fn other_number(old: &str, rng: &mut Rng) -> String {
    match old.parse::<f64>() {
        Ok(value) if rng.u8(0..5) < 4 => match rng.u8(0..8) {
            0 => format!("{:e}", -value),
            1 => format!("{:e}", value * (1.0 + f64::EPSILON)),
            2 => format!("{:e}", value * rng.f64() * 2.0),
            3 if value.abs() < 1e15 => format!("{}", value as i64 + 1),
            4 => format!("{:e}", value * 10f64.powi(rng.i32(-9..=9))),
            // Near enough to be taken more often than not.
            _ => format!("{:e}", value * (2.0 * rng.f64() - 1.0).exp()),
        },
        _ => pick(rng, &NUMBERS).to_owned(),
    }
}

/// Another string in quotes: number and unit changed, a word of other files, or something that no reader awaits.
fn other_string(old: &str, rng: &mut Rng, words: &Words) -> String {
    let inner = old.trim_matches('"');
    let (number, unit) = inner.split_once(' ').unwrap_or((inner, ""));
    let is_quantity = number.parse::<f64>().is_ok();
    match rng.u8(0..10) {
        0..=3 if is_quantity => format!("\"{} {unit}\"", other_number(number, rng)),
        4 if is_quantity => format!("\"{number} {}\"", pick(rng, &UNITS)),
        5 if is_quantity => other_number(number, rng),
        6 => pick(rng, &VALUES).to_owned(),
        7 => format!("\"{inner}{}\"", inner.repeat(rng.usize(1..50))),
        8 => typo(old, rng),
        _ => words.string(rng).to_owned(),
    }
}

/// A character left out, doubled or replaced.
fn typo(old: &str, rng: &mut Rng) -> String {
    let mut chars: Vec<char> = old.chars().collect();
    if chars.is_empty() {
        return "x".to_owned();
    }
    let at = rng.usize(0..chars.len());
    match rng.u8(0..4) {
        0 => drop(chars.remove(at)),
        1 => chars.insert(at, chars[at]),
        2 => chars[at] = rng.alphanumeric(),
        _ => chars[at] = chars[at].to_ascii_uppercase(),
    }
    chars.into_iter().collect()
}

/// Changes one token of a text.
pub fn damage(text: &mut String, rng: &mut Rng, words: &Words) {
    let all = tokens(text);
    if all.is_empty() {
        return text.push_str(words.line(rng));
    }
    let (kind, span) = all[rng.usize(0..all.len())].clone();
    let old = text[span.clone()].to_owned();
    let new = match rng.u8(0..12) {
        0 => String::new(),
        1 => format!("{old} {old}"),
        2 => {
            let same: Vec<_> = all.iter().filter(|(k, _)| *k == kind).collect();
            text[same[rng.usize(0..same.len())].1.clone()].to_owned()
        }
        _ => match kind {
            Kind::Number if rng.u8(0..8) == 0 => pick(rng, &VALUES).to_owned(),
            Kind::Number => other_number(&old, rng),
            Kind::String => other_string(&old, rng, words),
            Kind::Word if rng.bool() => typo(&old, rng),
            Kind::Word => words.word(rng).to_owned(),
        },
    };
    text.replace_range(span, &new);
}
