//! Descriptions of keys for the reference, the schema and the page.

use std::fmt::Write;

use super::{Kind, Laws, Row};

impl Row {
    /// Meaning of the keys as one line of Markdown: the words, with choices at the end where the words do not list them, and bounds and
    /// default at the braces `{}` in the words, or else at the end.
    pub fn description(&self) -> String {
        let words: Vec<&str> = self.words.split_whitespace().collect();
        let mut text = words.join(" ");
        if let Kind::Choice(choices) | Kind::AnyCase(choices) = self.kind {
            let is_listed = choices
                .first()
                .is_some_and(|c| text.contains(&format!("\"{c}\"")));
            if !is_listed {
                text += if text.is_empty() { "" } else { ": " };
                text += &self.choices(choices);
            }
            return text;
        }
        let mut limits = String::new();
        if let Some([low, high]) = self.bounds.and_then(|bounds| bounds.ends()) {
            let (factor, unit) = match self.kind {
                Kind::Share => (100.0, " %"),
                _ => (1.0, ""),
            };
            let [low, high] = [low, high].map(|end| number(factor * end) + unit);
            limits = format!(", {low} to {high}");
        }
        if let Some(default) = self.default {
            let is_number = default.starts_with(|c: char| c.is_ascii_digit());
            let quotes = if is_number { "" } else { "`" };
            let _ = write!(limits, "; default {quotes}{default}{quotes}");
        }
        match text.contains("{}") {
            true => text.replacen("{}", &limits, 1),
            false => text + &limits,
        }
    }

    fn choices(&self, choices: &[&str]) -> String {
        let mut text = String::new();
        for (i, choice) in choices.iter().enumerate() {
            text += match i {
                0 => "",
                _ if i + 1 == choices.len() => " or ",
                _ => ", ",
            };
            let is_default = self.default == Some(choice);
            let _ = write!(
                text,
                "`\"{choice}\"`{}",
                if is_default { " (default)" } else { "" }
            );
        }
        text
    }
}

/// A bound: with commas between thousands, powers of ten as such.
fn number(value: f64) -> String {
    if value != 0.0 && !(1e-3..1e7).contains(&value.abs()) {
        return format!("{value:e}");
    }
    let mut text = format!("{}", (value * 1e9).round() / 1e9);
    if value.abs() >= 1e3 && !text.contains('.') {
        for at in (text.len() % 3..text.len())
            .step_by(3)
            .rev()
            .filter(|at| *at > 0)
        {
            text.insert(at, ',');
        }
    }
    text
}

/// The rows of a table of the reference as Markdown.
pub fn table(rows: &[Row]) -> String {
    let mut text = "| key | meaning |\n|---|---|\n".to_owned();
    for row in rows.iter().filter(|row| row.is_listed) {
        let keys: Vec<String> = row.keys.iter().map(|key| format!("`{key}`")).collect();
        let _ = writeln!(
            text,
            "| {} | {} |",
            keys.join(", "),
            row.description().replace('|', "\\|")
        );
    }
    text
}

/// The laws of a property as a table of the reference in Markdown.
pub fn table_of_laws(laws: &Laws) -> String {
    let mut text = "| `law` | keys | optional |\n|---|---|---|\n".to_owned();
    for law in laws.laws {
        let optional = if law.optional.is_empty() {
            String::new()
        } else {
            format!(" {}", law.optional)
        };
        let _ = writeln!(text, "| `{}` | {} |{optional} |", law.name, law.needs);
    }
    text
}

/// Plain text of Markdown: links as their words, no backquotes.
pub fn plain(text: &str) -> String {
    let mut result = String::new();
    let mut rest = text;
    while let Some((before, after)) = rest.split_once("](") {
        let link = after.split_once(')');
        match (before.rfind('['), link) {
            (Some(open), Some((_, behind))) => {
                result.push_str(&before[..open]);
                result.push_str(&before[open + 1..]);
                rest = behind;
            }
            _ => {
                result.push_str(before);
                rest = after;
            }
        }
    }
    result.push_str(rest);
    result.replace('`', "")
}

#[cfg(test)]
mod tests {
    use super::super::{rows, rows_of};
    use super::*;

    rows! {
        ROWS {
            order: Kind::Count, bounds [2.0, 10_000.0], default "8" => "order of the film";
            share: Kind::Share, bounds [2e-4, 0.1] => "a share";
            scaling: Kind::Choice(&["film", "constant", "none"]), default "constant" => "scaling";
            on: Kind::Switch, default "false" => "`true`: more |y|{}. As a rule";
        }
    }

    #[test]
    fn descriptions_contain_choices_bounds_and_defaults() {
        let expected = "| key | meaning |\n|---|---|\n\
            | `order` | order of the film, 2 to 10,000; default 8 |\n\
            | `share` | a share, 0.02 % to 10 % |\n\
            | `scaling` | scaling: `\"film\"`, `\"constant\"` (default) or `\"none\"` |\n\
            | `on` | `true`: more \\|y\\|; default `false`. As a rule |\n";
        assert_eq!(table(ROWS), expected);
    }

    #[test]
    fn markdown_syntax_is_removed() {
        assert_eq!(
            plain("a [law](x.md#y) of `k` ([why](z.md))"),
            "a law of k (why)"
        );
    }

    #[test]
    fn keys_are_found_by_their_paths() {
        let words = |path: &str| rows_of(path).first().map(|row| row.words);
        assert!(
            words("contact.radius")
                .unwrap()
                .starts_with("reduced radius")
        );
        assert_eq!(words("mu_0"), words("lubricant.viscosity.mu_0"));
        assert_eq!(words("contact.mu_0"), None);
    }
}
