//! Damage to the lines and sections of TOML and JSON lines.

use fastrand::Rng;

use super::Words;

/// The lines of a section with its head, `[mesh]`, as a range of lines.
fn section(lines: &[String], rng: &mut Rng) -> Option<std::ops::Range<usize>> {
    let is_head = |line: &String| line.trim_start().starts_with('[');
    let heads: Vec<usize> = (0..lines.len()).filter(|i| is_head(&lines[*i])).collect();
    if heads.is_empty() {
        return None;
    }
    let k = rng.usize(0..heads.len());
    Some(heads[k]..heads.get(k + 1).copied().unwrap_or(lines.len()))
}

/// Removes, doubles, moves and adds lines and sections.
pub fn damage(text: &mut String, rng: &mut Rng, words: &Words) {
    let mut lines: Vec<String> = text.split('\n').map(str::to_owned).collect();
    let n = lines.len();
    let at = rng.usize(0..n);
    let to = rng.usize(0..n);
    match rng.u8(0..10) {
        0 | 1 => drop(lines.remove(at)),
        2 => lines.insert(to, lines[at].clone()),
        3 => lines.swap(at, to),
        4 => {
            let line = lines.remove(at);
            lines.insert(to.min(lines.len()), line);
        }
        5..=7 => lines.insert(to, words.line(rng).to_owned()),
        8 => {
            if let Some(span) = section(&lines, rng) {
                let part: Vec<String> = match rng.u8(0..3) {
                    0 => lines.drain(span).collect(),
                    _ => lines[span].to_vec(),
                };
                // Nothing more: the section is gone.
                if rng.u8(0..3) > 0 {
                    let to = to.min(lines.len());
                    lines.splice(to..to, part);
                }
            }
        }
        _ => {
            // A line many times: long lists, deep nesting, repeated keys.
            let line = lines[at].clone();
            lines.splice(to..to, std::iter::repeat_n(line, rng.usize(2..200)));
        }
    }
    *text = lines.join("\n");
}
