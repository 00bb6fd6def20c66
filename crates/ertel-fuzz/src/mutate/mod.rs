//! Damage to inputs: of the structure of their files, and of plain bytes.

pub mod bytes;
mod csv;
mod lines;
pub mod tokens;
mod words;

use std::collections::BTreeSet;

use fastrand::Rng;

use crate::input::Input;
use tokens::Kind;

pub use words::Words;

impl Words {
    /// Those of texts.
    pub fn new<'a>(texts: impl Iterator<Item = &'a str>) -> Words {
        let [mut words, mut strings, mut lines] = [(); 3].map(|()| BTreeSet::new());
        for text in texts {
            for (kind, span) in tokens::tokens(text) {
                match kind {
                    Kind::Word => words.insert(text[span].to_owned()),
                    Kind::String => strings.insert(text[span].to_owned()),
                    Kind::Number => false,
                };
            }
            let kept = text
                .lines()
                .filter(|line| line.contains(['=', '[']) && line.len() < 500);
            lines.extend(kept.map(str::to_owned));
        }
        let [words, strings, lines] = [words, strings, lines].map(|set| set.into_iter().collect());
        Words {
            words,
            strings,
            lines,
        }
    }
}

/// Damages an input in one to eight places.
pub fn damage(input: &mut Input, rng: &mut Rng, words: &Words) {
    let main = input.target.main_file();
    // Few changes more often than many: an input that is wrong in its first line says nothing of the others.
    let n = 1 + (0..7).take_while(|_| rng.u8(0..5) < 2).count();
    for _ in 0..n {
        let index = match input.files.iter().position(|(name, _)| name == main) {
            Some(index) if rng.u8(0..5) > 0 => index,
            _ => rng.usize(0..input.files.len()),
        };
        let (name, content) = &mut input.files[index];
        damage_file(name, content, rng, words);
        content.truncate(bytes::LONGEST);
    }
}

fn damage_file(name: &str, content: &mut Vec<u8>, rng: &mut Rng, words: &Words) {
    if name.ends_with(".bin") {
        return bytes::damage_binary(content, rng);
    }
    let kind = rng.u8(0..10);
    if kind == 0 {
        return bytes::damage(content, rng);
    }
    let mut text = match String::from_utf8(std::mem::take(content)) {
        Ok(text) => text,
        Err(error) => {
            *content = error.into_bytes();
            return bytes::damage(content, rng);
        }
    };
    match (name.ends_with(".csv"), kind) {
        (true, 1..=6) => csv::damage(&mut text, rng, words),
        (true, _) => tokens::damage(&mut text, rng, words),
        (false, 1 | 2) => lines::damage(&mut text, rng, words),
        (false, _) => tokens::damage(&mut text, rng, words),
    }
    *content = text.into_bytes();
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::Target;

    /// The same seed makes the same input; another one another.
    #[test]
    fn damage_is_repeatable() {
        let text = "[contact]\nkind = \"line\" # a comment\nload = \"100 kN/m\"\n";
        let words = Words::new([text].into_iter());
        let make = |seed: u64| {
            let files = vec![("case.toml".to_owned(), text.as_bytes().to_vec())];
            let mut input = Input {
                target: Target::Case,
                files,
            };
            damage(&mut input, &mut Rng::with_seed(seed), &words);
            input
        };
        assert_eq!(make(7), make(7));
        let different: BTreeSet<Vec<u8>> = (0..200)
            .map(|s| make(s).file("case.toml").to_vec())
            .collect();
        assert!(different.len() > 80, "{}", different.len());
    }

    #[test]
    fn tokens_are_distinguished() {
        let text = "a.b = \"1 m\" # \"no\"\nc = [-1e3, true]";
        let found: Vec<_> = tokens::tokens(text)
            .into_iter()
            .map(|(k, s)| (k, &text[s]))
            .collect();
        assert_eq!(
            found,
            [
                (Kind::Word, "a.b"),
                (Kind::String, "\"1 m\""),
                (Kind::Word, "c"),
                (Kind::Number, "-1e3"),
                (Kind::Word, "true")
            ]
        );
    }
}
