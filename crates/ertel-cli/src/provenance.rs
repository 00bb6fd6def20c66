//! Numbers with their sources, as text.

use ertel_rheology::database::REFERENCES;
use ertel_rheology::provenance::Datum;

use crate::table::{columns, paragraph};

/// Every number with its unit and status; below, the remarks and the sources that the rows refer to.
pub fn data(provenance: &[Datum]) -> String {
    let heading = ["datum", "value", "status", "source"];
    let mut rows = vec![heading.map(str::to_owned).to_vec()];
    let mut sources: Vec<&str> = Vec::new();
    let mut remarks = String::new();
    // The range is shown in words.
    for datum in provenance.iter().filter(|d| !d.key.starts_with("validity")) {
        let number = sources
            .iter()
            .position(|source| *source == datum.source)
            .unwrap_or_else(|| {
                sources.push(&datum.source);
                sources.len() - 1
            });
        let unit = if datum.unit == "1" { "" } else { &datum.unit };
        rows.push(vec![
            datum.key.clone(),
            format!("{} {unit}", datum.value).trim_end().to_owned(),
            datum.status.to_string(),
            format!("[{}]", number + 1),
        ]);
        if let Some(note) = &datum.note {
            remarks += &paragraph(&format!("  {}: ", datum.key), note);
        }
    }
    let mut text = columns(&rows) + &remarks + "\nSources\n";
    for (i, source) in sources.iter().enumerate() {
        text += &paragraph(&format!("  [{}] ", i + 1), &described(source));
    }
    text
}

/// Notes to read before use.
pub fn notes(notes: &[String]) -> String {
    if notes.is_empty() {
        return String::new();
    }
    let items: String = notes.iter().map(|note| paragraph("  - ", note)).collect();
    format!("\nNotes\n{items}")
}

/// `habchi2008, Table 5.2` with the entry of the bibliography instead of its key.
fn described(source: &str) -> String {
    let (key, place) = source.split_once(", ").unwrap_or((source, ""));
    match reference(key) {
        Some(reference) if place.is_empty() => reference,
        Some(reference) => format!("{reference} {place}"),
        None if key == "none" => "no source".to_owned(),
        None => source.to_owned(),
    }
}

/// Author, title, where and when, of an entry of the bibliography.
fn reference(key: &str) -> Option<String> {
    let start = REFERENCES.find(&format!("{{{key},"))?;
    let entry = REFERENCES[start..].split("\n}").next()?;
    let field = |name: &str| {
        entry.lines().find_map(|line| {
            let (found, value) = line.split_once('=')?;
            let value = value.trim().trim_end_matches(',');
            (found.trim() == name).then(|| value.replace(['{', '}', '\\'], ""))
        })
    };
    let place = [
        "journal",
        "school",
        "booktitle",
        "publisher",
        "howpublished",
    ];
    let parts = [
        field("author"),
        field("title"),
        place.iter().find_map(|name| field(name)),
    ];
    let mut text = parts.into_iter().flatten().collect::<Vec<_>>().join(". ");
    if let Some(year) = field("year") {
        text += &format!(", {year}");
    }
    text = text.replace("--", "-");
    if !text.ends_with('.') {
        text.push('.');
    }
    Some(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn references_read_like_a_list_of_literature() {
        assert_eq!(
            described("habchi2008, Table 5.2"),
            "Habchi, Wassim. A full-system finite element approach to elastohydrodynamic lubrication problems: \
             application to ultra-low-viscosity fluids. INSA de Lyon, 2008. Table 5.2"
        );
        assert_eq!(described("none"), "no source");
    }

    #[test]
    fn every_source_of_the_database_is_in_the_bibliography() {
        use ertel_rheology::database::{fluid, fluid_names, solid, solid_names};
        let fluids = fluid_names()
            .into_iter()
            .flat_map(|n| fluid(n).unwrap().provenance);
        let solids = solid_names()
            .into_iter()
            .flat_map(|n| solid(n).unwrap().provenance);
        for datum in fluids.chain(solids) {
            let key = datum.source.split(", ").next().unwrap();
            assert!(
                key == "none" || reference(key).is_some(),
                "{}",
                datum.source
            );
        }
    }
}
