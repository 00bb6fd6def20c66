//! Lines that fit the terminal.

/// Marks of list items in reports.
const MARKS: [&str; 4] = ["· ", "! ", "- ", "= "];

/// Breaks lines that are longer than `width` at spaces. The value of a row is continued in its column, a list item below its text; rows of tables stay
/// as they are.
pub fn wrapped(text: &str, width: usize) -> String {
    text.split('\n')
        .map(|line| match line.chars().count() > width {
            true => broken(line, width),
            false => line.to_owned(),
        })
        .collect::<Vec<_>>()
        .join("\n")
}

fn broken(line: &str, width: usize) -> String {
    let Some(indent) = indent(line, width) else {
        return line.to_owned();
    };
    let head: String = line.chars().take(indent.start).collect();
    let rest: String = line.chars().skip(indent.start).collect();
    let mut text = head;
    let mut column = indent.start;
    for (i, word) in rest.split(' ').filter(|word| !word.is_empty()).enumerate() {
        let length = word.chars().count();
        if i > 0 && column + 1 + length > width {
            text += &format!("\n{:1$}", "", indent.next);
            column = indent.next;
        } else if i > 0 {
            text.push(' ');
            column += 1;
        }
        text += word;
        column += length;
    }
    text
}

/// Where text begins in a line, and in those that continue it.
struct Indent {
    start: usize,
    next: usize,
}

/// `None` of rows of tables.
fn indent(line: &str, width: usize) -> Option<Indent> {
    let leading = line.chars().take_while(|c| *c == ' ').count();
    let rest = line.trim_start();
    let mark = MARKS.iter().find(|mark| rest.starts_with(*mark));
    if let Some(mark) = mark {
        let start = leading + mark.chars().count();
        return Some(Indent { start, next: start });
    }
    let Some((_, value)) = rest.split_once("  ") else {
        return Some(Indent {
            start: leading,
            next: leading + 2,
        });
    };
    let value = value.trim_start();
    if value.contains("  ") {
        return None;
    }
    let start = line.chars().count() - value.chars().count();
    let next = if start <= width / 2 {
        start
    } else {
        leading + 2
    };
    Some(Indent { start, next })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows keep their column, items their mark, tables their rows; no word is lost and no line of words is too long.
    #[test]
    fn lines_fit() {
        let words = "word ".repeat(30);
        let words = words.trim_end();
        for line in [
            format!("  quantity          {words}"),
            format!("  · {words}"),
            format!("    ! {words}"),
            words.to_owned(),
        ] {
            let found = wrapped(&line, 80);
            assert!(found.lines().count() > 1, "{found}");
            assert!(found.lines().all(|l| l.chars().count() <= 80), "{found}");
            let all = |text: &str| text.split_whitespace().count();
            assert_eq!(all(&found), all(&line));
        }
        let row = wrapped(&format!("  quantity          {words}"), 80);
        assert!(row.lines().nth(1).unwrap().starts_with(&" ".repeat(20)));
        let table = format!("  a  b  {}", "c".repeat(90));
        assert_eq!(wrapped(&table, 80), table);
        assert_eq!(wrapped("short\n", 80), "short\n");
    }
}
