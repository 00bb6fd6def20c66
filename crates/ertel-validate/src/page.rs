//! The page of all studies.

use super::table::{HEAD, cells, tolerance};
use super::{Study, StudyResult};

/// The whole page.
fn whole(sections: &[String]) -> String {
    format!(
        "# Validation\n\nComputed values compared with published ones. Made by\n\n    ertel validate --write docs\n\n\
         from the studies in `validation/`; `ertel validate NAME` runs one of them, with `--write docs` it updates this page; \
         `ertel validate --quick` makes the runs that take seconds. Films are H = hR/a², lengths X = x/a, pressures P = p/p_h. Rows without a tolerance are \
         shown for information.\n\n{}",
        sections.join("\n")
    )
}

/// The page with the sections of these studies (name and text) replaced; new ones are inserted in the
/// order of names.
pub fn splice(page: &str, sections: &[(String, String)]) -> String {
    let mut all: Vec<(String, String)> = Vec::new();
    // The text before the first section is rewritten.
    for part in format!("\n{page}").split("\n## ").skip(1) {
        let text = format!("## {}\n", part.trim_end());
        let name = name_of(&text).unwrap_or_default().to_owned();
        all.push((name, text));
    }
    for (name, text) in sections {
        match all.iter_mut().find(|(other, _)| other == name) {
            Some(old) => old.1.clone_from(text),
            None => all.push((name.clone(), text.clone())),
        }
    }
    all.sort_by(|a, b| a.0.cmp(&b.0));
    let texts: Vec<String> = all.into_iter().map(|(_, text)| text).collect();
    whole(&texts)
}

/// The study that a section is about, by its link to the study's folder.
fn name_of(section: &str) -> Option<&str> {
    let (_, rest) = section.split_once("](../validation/")?;
    Some(rest.split_once('/')?.0)
}

/// Section of a study in a Markdown page; `pictures` are paths and captions.
pub fn markdown(study: &Study, result: &StudyResult, pictures: &[(String, String)]) -> String {
    let mut out = format!("## {}\n\nSource: {}.", study.title, study.source);
    out.push_str(&format!(
        " Cases and remarks: [validation/{0}](../validation/{0}/README.md).\n\n",
        study.name
    ));
    let line = |cells: &[String]| {
        let escaped: Vec<String> = cells.iter().map(|c| c.replace('|', "\\|")).collect();
        format!("| {} |\n", escaped.join(" | "))
    };
    out.push_str(&line(&HEAD.map(str::to_owned)));
    out.push_str(&format!("|{}\n", "---|".repeat(HEAD.len())));
    for row in &result.rows {
        out.push_str(&line(&cells(row)));
    }
    for row in &result.rows {
        if let Some(message) = &row.message {
            out.push_str(&format!("\n{}: {message}\n", row.run));
        }
    }
    let mut reasons: Vec<String> = Vec::new();
    for check in &study.checks {
        let tolerance = tolerance(check.accept, false, check.quantity.is_count());
        let reason = format!(
            "{} ({tolerance}): {}.",
            check.quantity.label(),
            check.reason
        );
        if !check.reason.is_empty() && !reasons.contains(&reason) {
            reasons.push(reason);
        }
    }
    if !reasons.is_empty() {
        out.push_str("\nTolerances:\n\n");
        for reason in reasons {
            out.push_str(&format!("- {reason}\n"));
        }
    }
    for (path, caption) in pictures {
        out.push_str(&format!("\n![{caption}]({path})\n\n{caption}\n"));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::{splice, whole};

    fn section(name: &str, text: &str) -> (String, String) {
        let link = format!("[validation/{name}](../validation/{name}/README.md)");
        let text =
            format!("## Title of {name}\n\nSource: x. Cases and remarks: {link}.\n\n{text}\n");
        (name.to_owned(), text)
    }

    /// A new text replaces the old one, a new study comes between its neighbours, and nothing else changes.
    #[test]
    fn sections_are_replaced_and_added() {
        let texts =
            |list: &[(String, String)]| list.iter().map(|s| s.1.clone()).collect::<Vec<_>>();
        let [a, b, d] = [
            section("a", "one\n\n- list"),
            section("b", "two"),
            section("d", "four"),
        ];
        let old = whole(&texts(&[a.clone(), b, d.clone()]));
        let (b, c) = (section("b", "new"), section("c", "three"));
        let expected = whole(&texts(&[a.clone(), b.clone(), c.clone(), d]));
        assert_eq!(splice(&old, &[c.clone(), b.clone()]), expected);
        assert_eq!(splice(&expected, &[b]), expected);
        assert_eq!(splice("", &[c.clone(), a.clone()]), whole(&texts(&[a, c])));
    }
}
