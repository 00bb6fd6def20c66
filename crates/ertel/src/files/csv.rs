//! Fields of CSV tables.

use ertel_input::escaped;

/// A text as a field: quoted where it must be (RFC 4180), and, where a spreadsheet would take it for a formula, with an
/// apostrophe before it. Numbers stay as they are.
pub fn text_field(text: &str) -> String {
    if is_formula(text) {
        format!("\"'{}\"", escaped(text).replace('"', "\"\""))
    } else {
        quoted(text)
    }
}

/// A field, quoted where any of the usual separators would end it.
pub fn quoted(text: &str) -> String {
    // A terminal that shows the table acts on no character of it.
    let text = &*escaped(text);
    if text.contains([',', ';', '\t', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}

/// Whether a spreadsheet would evaluate a text. Some skip blanks, and some take the wide forms of the signs, too.
fn is_formula(text: &str) -> bool {
    let first = text.trim_start_matches(' ').chars().next();
    let signs = ['=', '+', '-', '@', '\t', '\r', '\n', '＝', '＋', '－', '＠'];
    first.is_some_and(|c| signs.contains(&c)) && text.trim().parse::<f64>().is_err()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spreadsheets_take_texts_as_texts_and_numbers_as_numbers() {
        for text in [
            "=cmd|' /C calc'!A0",
            "+1+2",
            "-a",
            "@sum(a1)",
            "\t=1",
            " =1",
            "\n=1",
            "-",
            "＝1",
        ] {
            assert_eq!(text_field(text), format!("\"'{text}\""));
        }
        assert_eq!(text_field("=\"a\""), "\"'=\"\"a\"\"\"");
        for plain in ["-1.5e-3", "+2", "-5", "", "oil = thick", "a-b", "-0"] {
            assert_eq!(text_field(plain), plain);
        }
        assert_eq!(text_field("\u{1b}[31mred"), "\\u001b[31mred");
        assert_eq!(text_field("=\u{7}1"), "\"'=\\u00071\"");
        assert_eq!(text_field("a;b"), "\"a;b\"");
        assert_eq!(quoted("-5.1 %"), "-5.1 %");
    }
}
