//! Text of a user in messages: no control characters, and no more than a line's worth.

use std::borrow::Cow;
use std::fmt::Write as _;

/// Most characters of a line or a cell that an error quotes.
pub const LONGEST_EXCERPT: usize = 200;

/// Text for a terminal: control characters and those that turn the direction of writing are escaped as in JSON and TOML,
/// `\u001b`, but for the ends of lines and tabs.
#[must_use]
pub fn escaped(text: &str) -> Cow<'_, str> {
    if !text.chars().any(is_escaped) {
        return Cow::Borrowed(text);
    }
    let mut result = String::with_capacity(text.len() + 16);
    for c in text.chars() {
        if is_escaped(c) {
            let _ = write!(result, "\\u{:04x}", c as u32);
        } else {
            result.push(c);
        }
    }
    Cow::Owned(result)
}

/// Whether a terminal would act on the character instead of showing it.
fn is_escaped(c: char) -> bool {
    (c.is_control() && c != '\n' && c != '\t')
        || matches!(c, '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{feff}')
}

/// The same on one line, cut to [`LONGEST_EXCERPT`] characters.
#[must_use]
pub fn excerpt(text: &str) -> String {
    cut(escaped(text).replace('\n', "\\u000a"), LONGEST_EXCERPT)
}

/// A whole message, escaped: it may list choices, but does not repeat a value of a thousand lines.
pub(super) fn message(text: &str) -> String {
    cut(escaped(text).into_owned(), 10 * LONGEST_EXCERPT)
}

fn cut(mut text: String, most: usize) -> String {
    if let Some((end, _)) = text.char_indices().nth(most) {
        text.truncate(end);
        text.push('…');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn terminals_see_no_control_characters() {
        assert_eq!(escaped("plain µ\n"), "plain µ\n");
        assert_eq!(
            escaped("a\u{1b}[2J\u{7}\u{9b}\u{202e}b"),
            "a\\u001b[2J\\u0007\\u009b\\u202eb"
        );
        assert_eq!(excerpt("a\nb"), "a\\u000ab");
        assert_eq!(excerpt(&"µ".repeat(200)).chars().count(), 200);
        assert_eq!(excerpt(&"µ".repeat(1000)), "µ".repeat(200) + "…");
    }
}
