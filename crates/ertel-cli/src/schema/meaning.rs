//! What keys mean, in the words of the reference pages.

/// Sections of the pages and their rows.
pub struct Meanings {
    /// Heading, keys and meaning.
    rows: Vec<(String, Vec<String>, String)>,
    is_study: bool,
}

const CASE_PAGE: &str = include_str!("../../../../docs/reference/case-file.md");
const LAWS_PAGE: &str = include_str!("../../../../docs/reference/lubricant-laws.md");
const STUDY_PAGE: &str = include_str!("../../../../docs/guide/studies.md");

impl Meanings {
    /// Of cases.
    pub fn of_case() -> Self {
        let rows = [CASE_PAGE, LAWS_PAGE].into_iter().flat_map(rows).collect();
        Self {
            rows,
            is_study: false,
        }
    }

    /// Of studies.
    pub fn of_study() -> Self {
        Self {
            rows: rows(STUDY_PAGE),
            is_study: true,
        }
    }

    /// What a key of a table means, where a page says it.
    pub fn of(&self, path: &str, key: &str) -> Option<&str> {
        let headings: &[&str] = match (self.is_study, path) {
            (true, "axis") => &["Axes"],
            (true, _) => &[],
            (false, "contact") => &["[contact]", "Rollers"],
            (false, "machine") => &["kind ="],
            (false, "lubricant") => &["[lubricant]", "Oils from a data sheet"],
            (false, "output.interferogram") => &["Interferograms"],
            (false, path) if !path.is_empty() && !path.contains('.') => &[""],
            _ => return self.in_root(path, key),
        };
        let own = format!("[{path}]");
        let is_here = |heading: &str| {
            headings.iter().any(|h| match *h {
                "" => heading == own,
                h => heading.starts_with(h),
            })
        };
        let row = self
            .rows
            .iter()
            .find(|(heading, keys, _)| is_here(heading) && keys.iter().any(|k| k == key));
        row.map(|(_, _, meaning)| meaning.as_str())
    }

    /// Sections themselves: the first sentence below their heading.
    fn in_root(&self, path: &str, key: &str) -> Option<&str> {
        if !path.is_empty() || self.is_study {
            return None;
        }
        let own = format!("[{key}]");
        let row = self
            .rows
            .iter()
            .find(|(heading, keys, _)| *heading == own && keys.is_empty());
        row.map(|(_, _, meaning)| meaning.as_str())
    }
}

/// The rows of all tables of a page whose first column names keys; the first paragraph of each section without keys.
fn rows(page: &str) -> Vec<(String, Vec<String>, String)> {
    let mut rows = Vec::new();
    let mut heading = String::new();
    let mut has_words = true;
    let mut in_code = false;
    for line in page.lines() {
        if line.starts_with("```") {
            in_code = !in_code;
            continue;
        }
        if in_code {
            continue;
        }
        if line.starts_with('#') {
            heading = plain(line.trim_start_matches('#').trim());
            has_words = false;
        } else if let Some(row) = line.strip_prefix('|') {
            // A bar within a cell stands behind a backslash.
            let row = row.replace("\\|", "\u{0}");
            let mut cells = row.split('|').map(str::trim);
            let (Some(keys), Some(meaning)) = (cells.next(), cells.next()) else {
                continue;
            };
            let keys: Vec<String> = keys
                .split('`')
                .skip(1)
                .step_by(2)
                .map(str::to_owned)
                .collect();
            if !keys.is_empty() {
                rows.push((heading.clone(), keys, plain(meaning).replace('\u{0}', "|")));
            }
        } else if !has_words && !line.trim().is_empty() && !line.starts_with(' ') {
            has_words = true;
            rows.push((heading.clone(), Vec::new(), plain(line.trim())));
        }
    }
    rows
}

/// Markdown without its signs: links as their words, no backquotes.
fn plain(text: &str) -> String {
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
    use super::*;

    #[test]
    fn signs_of_markdown_are_left_out() {
        assert_eq!(
            plain("a [law](x.md#y) of `k` ([why](z.md))"),
            "a law of k (why)"
        );
    }
}
