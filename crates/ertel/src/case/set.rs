//! Values that replace those of a case file: `contact.load=50 N`.

use std::path::Path;

use ertel_input::keys::{Kind, rows_of};
use ertel_input::tree::{Node, Value};
use ertel_input::{Document, InputError};
use toml_edit::{DocumentMut, Item, TableLike};

use super::Case;
use super::study::inline;

/// Name of such a value in errors, instead of a file.
const NAME: &str = "--set";

/// A value and its key.
struct Setting {
    key: String,
    node: Node,
}

impl Case {
    /// Reads the text of a case with some values replaced, each written `key=value` with a key path such as `contact.load`. A value
    /// is one of TOML, or a text without its quotes: `50 N`. The readers and their bounds are those of the file; errors about
    /// such a value show it instead of a line. [`Case::source`] is the text with the values in it.
    ///
    /// # Errors
    ///
    /// As [`Case::read`]; settings that are no `key=value`, set a key twice, or pass through a value that is not a table.
    pub fn from_text_with(
        name: &str,
        text: &str,
        folder: &Path,
        settings: &[String],
    ) -> Result<Self, InputError> {
        let document = Document::parse(name, text)?;
        let document = with_settings(document, settings)?;
        if settings.is_empty() {
            return Case::from_document(&document, folder);
        }
        // Errors show the settings as given; errors in the resulting text would show lines that the user did not write.
        let case = Case::from_document(&document, folder)?;
        let edited = edited(text, settings, &document)?;
        let mut read = Case::from_text(name, &edited, folder)?;
        let keys = settings.iter().filter_map(|s| s.split('=').next());
        let how = format!("is set ({NAME})");
        let ignored = read.lubricant.temperature_ignored(keys, &how);
        read.warn(ignored);
        match read.given == case.given {
            true => Ok(read),
            false => Err(document.root().error_here(format!(
                "{NAME} {} cannot be put into the text of this case; change the file",
                settings.join(&format!(" {NAME} "))
            ))),
        }
    }
}

/// A case or study with values replaced or added.
///
/// # Errors
///
/// As [`Case::from_text_with`], but for those of reading the values.
pub(super) fn with_settings(
    mut document: Document,
    settings: &[String],
) -> Result<Document, InputError> {
    let mut keys: Vec<String> = Vec::new();
    for text in settings {
        let (added, offset) = document.with_file(NAME, text);
        document = added;
        let error = |message: String| document.error_at(offset..offset + text.len(), "", message);
        let setting = parse(text).map_err(&error)?;
        if keys.contains(&setting.key) {
            return Err(error(format!("`{}` is set twice", setting.key)));
        }
        let key_span = offset..offset + setting.key.len();
        document.put(&setting.key, &key_span, setting.node.shifted(offset))?;
        keys.push(setting.key);
    }
    Ok(document)
}

fn parse(text: &str) -> Result<Setting, String> {
    let form = "write it as KEY=VALUE, such as \"contact.load=50 N\"";
    let (key, value) = text
        .split_once('=')
        .ok_or_else(|| format!("`{text}` has no value: {form}"))?;
    let is_bare = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    let is_key = |part: &str| !part.is_empty() && part.chars().all(is_bare);
    if !key.split('.').all(is_key) {
        return Err(format!("`{key}` is no key path: {form}"));
    }
    if value.trim().is_empty() {
        return Err(format!("`{key}` gets no value: {form}"));
    }
    let start = text.len() - value.len();
    // A text that looks like a number, such as the designation 6306.
    let is_meant =
        |node: &Node| !matches!(node.value, Value::Integer(_) | Value::Float(_)) || !is_text(key);
    let node = toml_value(value, start)
        .filter(is_meant)
        .unwrap_or_else(|| {
            let indent = value.len() - value.trim_start().len();
            Node {
                span: start + indent..start + value.trim_end().len(),
                value: Value::Str(value.trim().to_owned()),
            }
        });
    Ok(Setting {
        key: key.to_owned(),
        node,
    })
}

/// Whether the value of a key is always a text.
fn is_text(key: &str) -> bool {
    let rows = rows_of(key);
    !rows.is_empty() && rows.iter().all(|row| matches!(row.kind, Kind::Text))
}

/// The value as TOML has it, where it is one alone: a number, a switch, a list, a text in quotes. `start` is its position.
fn toml_value(value: &str, start: usize) -> Option<Node> {
    const KEY: &str = "k=";
    let document = Document::parse(NAME, format!("{KEY}{value}")).ok()?;
    let Value::Table(entries) = &document.tree().value else {
        return None;
    };
    let [entry] = &entries[..] else {
        return None;
    };
    // Here the key precedes the value; in the setting its length differs.
    let at = entry.node.clone().shifted(start);
    Some(moved_back(at, KEY.len()))
}

fn moved_back(mut node: Node, by: usize) -> Node {
    node.span = node.span.start - by..node.span.end - by;
    match &mut node.value {
        Value::Array(nodes) => {
            for inner in nodes {
                *inner = moved_back(inner.clone(), by);
            }
        }
        Value::Table(entries) => {
            for entry in entries {
                entry.key_span = entry.key_span.start - by..entry.key_span.end - by;
                entry.node = moved_back(entry.node.clone(), by);
            }
        }
        _ => {}
    }
    node
}

/// The text with the values in it; comments and the order of all else stay.
fn edited(text: &str, settings: &[String], document: &Document) -> Result<String, InputError> {
    let failed = |reason: &str| {
        document.root().error_here(format!(
            "{NAME} cannot put its values into this file: {reason}"
        ))
    };
    let mut edited: DocumentMut = text
        .parse()
        .map_err(|error: toml_edit::TomlError| failed(error.message()))?;
    for text in settings {
        let setting = parse(text).map_err(|reason| failed(&reason))?;
        let value: toml_edit::Value = inline(&setting.node)
            .parse()
            .map_err(|error: toml_edit::TomlError| failed(error.message()))?;
        put(edited.as_table_mut(), &setting.key, value)
            .ok_or_else(|| failed(&format!("`{}`", setting.key)))?;
    }
    Ok(edited.to_string())
}

fn put(table: &mut dyn TableLike, path: &str, mut value: toml_edit::Value) -> Option<()> {
    let Some((key, rest)) = path.split_once('.') else {
        match table.get_mut(path) {
            Some(Item::Value(old)) => {
                // A comment behind it stays where it is.
                *value.decor_mut() = old.decor().clone();
                *old = value;
            }
            _ => {
                table.remove(path);
                table.insert(path, Item::Value(value));
            }
        }
        return Some(());
    };
    if table.get(key).is_none() {
        let mut new = toml_edit::Table::new();
        new.set_implicit(rest.contains('.'));
        table.insert(key, Item::Table(new));
    }
    put_into(table.get_mut(key)?, rest, value)
}

/// Puts a value into a table, or into one of an array of tables, which a key path counts from 1: `surface.1.depth`.
fn put_into(item: &mut Item, path: &str, value: toml_edit::Value) -> Option<()> {
    if let Some(table) = item.as_table_like_mut() {
        return put(table, path, value);
    }
    let (place, rest) = path.split_once('.').unwrap_or((path, ""));
    let place = place.parse::<usize>().ok()?.checked_sub(1)?;
    match item {
        Item::ArrayOfTables(tables) => put(tables.get_mut(place)?, rest, value),
        Item::Value(toml_edit::Value::Array(array)) => {
            let entry = array.get_mut(place)?;
            match rest {
                "" => *entry = value.decorated("", ""),
                rest => put(entry.as_inline_table_mut()?, rest, value)?,
            }
            Some(())
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contains::contains;

    const CASE: &str = include_str!("../../../ertel-cli/tests/good/quick.toml");

    fn read(settings: &[&str]) -> Result<Case, InputError> {
        let settings: Vec<String> = settings.iter().map(|s| (*s).to_owned()).collect();
        Case::from_text_with("case.toml", CASE, Path::new(""), &settings)
    }

    /// Texts that look like numbers: a designation, a title.
    #[test]
    fn texts_need_no_quotes() {
        let case = read(&["title=6306"]).unwrap();
        assert_eq!(case.title, "6306");
        assert!(case.source.contains("title = \"6306\""));
        let bearing = include_str!("../../../../cases/machine/bearing-6206.toml");
        let settings = ["machine.designation=6306".to_owned()];
        let read = Case::from_text_with("bearing.toml", bearing, Path::new(""), &settings);
        assert!(read.unwrap().source.contains("designation = \"6306\""));
    }

    #[test]
    fn values_stand_in_the_case_and_in_its_text() {
        let case = read(&[
            "contact.load=30 kN/m",
            "motion.slide_to_roll_ratio=0.5",
            "lubricant.viscosity.mu_0=\"50 mPa.s\"",
            "solver.isothermal=true",
            "bodies.body_2={ youngs_modulus = \"210 GPa\", poissons_ratio = 0.3 }",
            "title=Other title",
            "mesh.preset=normal",
        ])
        .unwrap();
        assert_eq!(case.contact.load, 3e4);
        assert_eq!(case.motion.slide_to_roll_ratio, 0.5);
        assert!((case.lubricant.ambient_viscosity() - 0.05).abs() < 1e-12);
        assert!(case.solver.isothermal);
        assert_eq!(case.title, "Other title");
        for line in [
            "load = \"30 kN/m\"\n",
            "# A light line contact on a coarse mesh: solved in about a second.\n",
            "viscosity = { law = \"roelands\", mu_0 = \"50 mPa.s\", alpha = \"20 1/GPa\" }\n",
            "[solver]\nisothermal = true\n",
        ] {
            assert!(case.source.contains(line), "{line}: {}", case.source);
        }
        // The text reads as the same case.
        let again = Case::from_text("case.toml", &case.source, Path::new("")).unwrap();
        assert_eq!(again.given, case.given);
        assert_eq!(again.contact, case.contact);
    }

    #[test]
    fn a_table_gives_way_to_a_name() {
        let case = read(&["lubricant=squalane-pip", "temperature=40 degC"]).unwrap();
        assert_eq!(case.lubricant.name.as_deref(), Some("squalane-pip"));
        assert!(!case.source.contains("roelands"), "{}", case.source);
    }

    /// Every message shows the setting and marks the error in it.
    #[test]
    fn wrong_ones_are_shown_as_they_were_given() {
        for (settings, words) in [
            (
                &["contact.load=-5 kN/m"][..],
                "`load` must be positive\n  --> --set:1:14",
            ),
            (
                &["contact.load=5 N"],
                "`5 N` is a force, but `load` needs a force per length",
            ),
            (
                &["contact.laod=5 N"],
                "unknown key `laod` in [contact]\n  --> --set:1:1",
            ),
            (&["contact.load=5"], "`load` has no unit"),
            (
                &["motion.slide_to_roll_ratio=nan"],
                "must be a finite number",
            ),
            (
                &["contact.load"],
                "`contact.load` has no value: write it as KEY=VALUE",
            ),
            (&["contact.load= "], "gets no value"),
            (&["contact..load=1"], "is no key path"),
            (&["=1"], "is no key path"),
            (
                &["contact.load.value=1"],
                "`contact.load` is a string, not a table",
            ),
            (&["title=a", "title=b"], "`title` is set twice"),
            (&["title=[5]"], "`title` must be a string"),
            (
                &["nonsense.key=5"],
                "unknown key `nonsense` at the top level",
            ),
            (&["title=a", "contact.radius=16,5 mm"], "--> --set:1:16"),
        ] {
            let error = read(settings).unwrap_err().to_string();
            assert!(error.contains(words), "{settings:?}: {error}");
        }
    }

    /// Tables of arrays are counted from 1 in both notations.
    #[test]
    fn tables_of_arrays_take_values() {
        let waves = "kind = \"waves\"\nbody = \"body_2\"\nwavelength = \"0.2 mm\"\namplitude = \"0.1 um\"\nx = \"0 mm\"\n";
        let line = waves.trim_end().replace('\n', ", ");
        let at_rest = CASE.replace("slide_to_roll_ratio = 0.0", "slide_to_roll_ratio = -2.0");
        assert_ne!(at_rest, CASE);
        for (text, n) in [
            (
                format!("{at_rest}\n[[surface]] # First\n{waves}\n[[surface]]\n{waves}"),
                2,
            ),
            (
                format!("surface = [{{ {line} }}, {{ {line} }}]\n{at_rest}"),
                2,
            ),
        ] {
            let key = format!("surface.{n}.amplitude");
            let settings = [format!("{key}=0.02 um"), "contact.load=30 kN/m".to_owned()];
            let case = Case::from_text_with("c.toml", &text, Path::new(""), &settings).unwrap();
            let again = Case::from_text("c.toml", &case.source, Path::new("")).unwrap();
            assert_eq!(again.given, case.given);
            assert_eq!(case.given["surface"][n - 1]["amplitude"], "0.02 um");
            assert_eq!(case.given["surface"][n - 2]["amplitude"], "0.1 um");
            let beyond = [format!("surface.{}.amplitude=0.02 um", n + 1)];
            let error = Case::from_text_with("c.toml", &text, Path::new(""), &beyond).unwrap_err();
            contains(&error.to_string(), "has 2 entries, counted from 1");
        }
    }

    /// The quantity of a curve, and its values.
    #[test]
    fn curves_are_those_of_the_settings() {
        let curve = "\n[curve]\nquantity = \"contact.load\"\nvalues = [\"20 kN/m\", \"30 kN/m\"]\n";
        let text = format!("{CASE}{curve}");
        let settings = ["curve.values=[\"10 kN/m\", \"15 kN/m\", \"20 kN/m\"]".to_owned()];
        let case = Case::from_text_with("c.toml", &text, Path::new(""), &settings).unwrap();
        let points = case.curve.unwrap().points;
        assert_eq!(points.len(), 3);
        contains(&points[1].case.source, "load = \"15 kN/m\"");
    }
}
