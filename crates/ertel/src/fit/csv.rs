//! Lines and cells of CSV text.

/// Lines that are neither empty nor comments: number from 1, text, and the separator of cells, which the first one has.
pub(crate) fn rows(text: &str) -> impl Iterator<Item = (usize, &str, char)> {
    let lines = text.trim_start_matches('\u{feff}').lines().enumerate();
    let rows = lines
        .map(|(i, line)| (i + 1, line.trim_end()))
        .filter(|(_, line)| !line.trim().is_empty() && !line.trim_start().starts_with('#'));
    let separator = rows
        .clone()
        .next()
        .and_then(|(_, head)| [';', '\t', ','].into_iter().find(|c| head.contains(*c)));
    rows.map(move |(number, line)| (number, line, separator.unwrap_or(',')))
}

/// The cells of a line, without spaces and quotes around them; separators within quotes do not count.
pub(crate) fn cells(line: &str, separator: char) -> Vec<&str> {
    let mut result = Vec::new();
    let (mut start, mut quotes) = (0, 0);
    for (i, c) in line.char_indices() {
        if c == '"' && (quotes > 0 || line[start..i].trim().is_empty()) {
            quotes += 1;
        } else if c == separator && quotes % 2 == 0 {
            result.push(clean(&line[start..i]));
            (start, quotes) = (i + c.len_utf8(), 0);
        }
    }
    result.push(clean(&line[start..]));
    result
}

/// A cell without spaces and quotes around it.
fn clean(cell: &str) -> &str {
    cell.trim().trim_matches('"').trim()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn separators_within_quotes_do_not_count() {
        assert_eq!(cells(r#"1, "a, b" ,3"#, ','), ["1", "a, b", "3"]);
        // An inch sign is no quote.
        assert_eq!(cells(r#"x 1" y,2"#, ','), [r#"x 1" y"#, "2"]);
        // A doubled quote stays within.
        assert_eq!(cells(r#""say ""x,y""",2"#, ',').len(), 2);
        assert_eq!(cells("a;;", ';'), ["a", "", ""]);
    }
}
