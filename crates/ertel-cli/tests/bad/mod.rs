//! Cases that must be refused, as `cases.txt` in this folder describes them.

/// A case that must be refused.
pub struct BadCase {
    /// Its name.
    pub name: String,
    /// The case file.
    pub text: String,
    /// Words of the message.
    pub expected: Vec<String>,
}

/// All of a list.
///
/// # Panics
/// When a line that is to be changed is not there.
pub fn bad_cases(list: &str) -> Vec<BadCase> {
    let mut sections = list.split("\n== ").skip(1).map(|section| {
        let (name, rest) = section.split_once('\n').unwrap_or((section, ""));
        (
            name.to_owned(),
            rest.lines().filter(|line| !line.is_empty()),
        )
    });
    let (_, base) = sections.next().expect("a base case");
    let base: Vec<&str> = base.collect();
    let cases = sections.map(|(name, changes)| {
        let mut lines = base.clone();
        let mut at = lines.len();
        let mut expected = Vec::new();
        let place = |lines: &[&str], text: &str| {
            let found = lines.iter().position(|line| *line == text);
            found.unwrap_or_else(|| panic!("{name}: `{text}` is not there"))
        };
        for change in changes {
            match change.split_at(2) {
                ("- ", text) => {
                    at = place(&lines, text);
                    lines.remove(at);
                }
                ("@ ", text) => at = place(&lines, text) + 1,
                ("+ ", text) => {
                    lines.insert(at, text);
                    at += 1;
                }
                ("! ", text) => expected.push(text.to_owned()),
                _ => panic!("{name}: {change}"),
            }
        }
        BadCase {
            text: lines.join("\n") + "\n",
            expected,
            name,
        }
    });
    cases.collect()
}
