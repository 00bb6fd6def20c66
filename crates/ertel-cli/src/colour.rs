//! Colour in the terminal.

use std::fmt::Write as _;
use std::io;
use std::sync::OnceLock;

use anstream::ColorChoice;
use anstyle::{AnsiColor, Style};
use clap::ValueEnum;

/// When to colour.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum When {
    /// On terminals, unless NO_COLOR or CLICOLOR=0 is set; CLICOLOR_FORCE=1 colours elsewhere, too
    #[default]
    Auto,
    /// Always
    Always,
    /// Never
    Never,
}

static WHEN: OnceLock<When> = OnceLock::new();

/// Sets it for the whole program.
pub fn set(when: When) {
    let _ = WHEN.set(when);
}

/// Whether a stream is to be coloured, whose own choice is `auto`.
fn is_on(auto: impl FnOnce() -> ColorChoice) -> bool {
    match WHEN.get().copied().unwrap_or_default() {
        When::Always => true,
        When::Never => false,
        When::Auto => auto() != ColorChoice::Never,
    }
}

/// Text for stdout.
pub fn stdout(text: String) -> String {
    match is_on(|| anstream::AutoStream::choice(&io::stdout())) {
        true => painted(&text),
        false => text,
    }
}

/// Text for stderr.
pub fn stderr(text: String) -> String {
    match is_on(|| anstream::AutoStream::choice(&io::stderr())) {
        true => painted(&text),
        false => text,
    }
}

const RED: Style = AnsiColor::Red.on_default().bold();
const YELLOW: Style = AnsiColor::Yellow.on_default().bold();
const BLUE: Style = AnsiColor::Blue.on_default().bold();
const CYAN: Style = AnsiColor::Cyan.on_default();
const BOLD: Style = Style::new().bold();

/// Parts that are coloured wherever they begin a line, after blanks.
const MARKS: [(&str, Style); 7] = [
    ("error:", RED),
    ("warning:", YELLOW),
    ("note:", CYAN),
    ("= help:", CYAN),
    ("| = help:", CYAN),
    ("-->", BLUE),
    ("! ", YELLOW),
];

/// The text with colours for terminals; its words stay the same.
fn painted(text: &str) -> String {
    let mut result = String::with_capacity(text.len() + 64);
    let mut lines = text.split_inclusive('\n').peekable();
    while let Some(line) = lines.next() {
        let body = line.trim_end_matches('\n');
        let blank = body.len() - body.trim_start().len();
        let (indent, rest) = body.split_at(blank);
        let mark = MARKS.iter().find(|(mark, _)| rest.starts_with(mark));
        let carets = rest
            .strip_prefix('|')
            .filter(|r| r.trim_start().starts_with('^'));
        let is_title = lines.peek().is_some_and(|next| next.starts_with('─'));
        let _ = match (mark, carets) {
            (Some((mark, style)), _) => {
                write!(
                    result,
                    "{indent}{style}{mark}{style:#}{}",
                    &rest[mark.len()..]
                )
            }
            (None, Some(carets)) => write!(result, "{indent}|{RED}{carets}{RED:#}"),
            (None, None) if is_title => write!(result, "{BOLD}{body}{BOLD:#}"),
            (None, None) => write!(result, "{body}"),
        };
        result.push_str(&line[body.len()..]);
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_leave_the_words_as_they_are() {
        let text = "error: x\n  --> a.toml:1:1\n   |\n 1 | raduis\n   | ^^^^^^ here\n   = help: y\n\nTitle\n─────\n  ! beware\n";
        let painted = painted(text);
        assert!(
            painted.starts_with("\u{1b}[1m\u{1b}[31merror:\u{1b}[0m x\n"),
            "{painted:?}"
        );
        assert!(painted.contains("\u{1b}[1mTitle\u{1b}[0m\n"), "{painted:?}");
        let mut plain = String::new();
        let mut rest = painted.as_str();
        while let Some((before, after)) = rest.split_once("\u{1b}[") {
            plain.push_str(before);
            rest = after.split_once('m').unwrap().1;
        }
        plain.push_str(rest);
        assert_eq!(plain, text);
    }
}
