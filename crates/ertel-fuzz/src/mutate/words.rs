//! Words, strings and lines that damaged files may have.

use fastrand::Rng;

/// Words, strings and lines of all seeds: what one of them has may turn up in another.
#[derive(Debug, Default)]
pub struct Words {
    pub(super) words: Vec<String>,
    pub(super) strings: Vec<String>,
    pub(super) lines: Vec<String>,
}

impl Words {
    fn one<'a>(from: &'a [String], rng: &mut Rng) -> &'a str {
        match from {
            [] => "x",
            from => &from[rng.usize(0..from.len())],
        }
    }

    /// A key, a name of a section.
    pub fn word(&self, rng: &mut Rng) -> &str {
        Self::one(&self.words, rng)
    }

    /// A string with its quotes.
    pub fn string(&self, rng: &mut Rng) -> &str {
        Self::one(&self.strings, rng)
    }

    /// A line of a TOML file.
    pub fn line(&self, rng: &mut Rng) -> &str {
        Self::one(&self.lines, rng)
    }
}
