//! Fluids and solids that come with the crate.
//!
//! One TOML file each in `data/fluids` and `data/solids`, with the schema of [`Fluid::from_table`] and
//! [`Solid::from_table`]. A file opens with `title`, `source` (a key of `data/references.bib`), `locator` (the place in
//! it), `status` and `notes`; these hold for each of its numbers unless `[provenance."key.path"]` says otherwise.
//!
//! Files of a user have the same schema; of the head nothing must be there. A name that ends with `.toml` is a file.

use std::path::{Path, PathBuf};

use thiserror::Error;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::input::file::{LARGEST_DOCUMENT, read_text};
use crate::input::{Document, InputError, Recorder, Table};
use crate::provenance::{Datum, Status};
use crate::{Files, Fluid, Solid};

/// Name and text of the files of a folder.
type Folder = [(&'static str, &'static str)];

macro_rules! folder {
    ($folder:literal, $suffix:literal: $($name:literal)*) => {
        &[$(($name, include_str!(concat!("../data/", $folder, "/", $name, $suffix)))),*]
    };
}

const FLUIDS: &Folder = folder!("fluids", ".toml":
    "ammonia" "ester-iso-vg-320" "ester-kr-015" "fva-3" "gear-oil-80w-90" "glycerol" "holmes-evans-oil"
    "iso-vg-100-mineral" "iso-vg-100-pao" "iso-vg-150-mineral" "iso-vg-150-pao" "iso-vg-220-mineral" "iso-vg-220-pao"
    "iso-vg-32-mineral" "iso-vg-32-pao" "iso-vg-320-mineral" "iso-vg-320-pao" "iso-vg-46-mineral" "iso-vg-46-pao"
    "iso-vg-460-mineral" "iso-vg-460-pao" "iso-vg-68-mineral" "iso-vg-68-pao" "iso-vg-680-mineral" "iso-vg-680-pao"
    "liquid-oxygen" "mil-l-23699-ester" "mil-l-7808-ester" "mourier-oil" "n-decane" "n-dodecane" "n-nonane" "n-octane"
    "nynas-hp12" "nynas-hp4" "nynas-t22" "nynas-t9" "pag-iso-vg-320" "pao-10" "pao-100" "pao-4" "pao-40" "pao-650"
    "polyphenyl-ether-5p4e" "r123" "r1234yf" "r134a" "r152a" "r245fa" "r32" "santotrac-30" "santotrac-50"
    "squalane-pip" "thesis-fluid-a" "thesis-fluid-b" "thesis-fluid-c" "thesis-roelands-oil" "thesis-wlf-oil" "toluene"
    "turbine-oil-sae-30" "venner-oil" "water");

const TABLES: &Folder = folder!("fluids", "":
    "ammonia.csv" "liquid-oxygen.csv" "n-decane.csv" "n-dodecane.csv" "n-nonane.csv" "n-octane.csv" "r123.csv"
    "r1234yf.csv" "r134a.csv" "r152a.csv" "r245fa.csv" "r32.csv" "toluene.csv" "water.csv");

const SOLIDS: &Folder = folder!("solids", ".toml":
    "austempered-ductile-iron" "gear-steel" "glass" "pa66" "peek" "pom" "sapphire" "silicon-nitride"
    "soda-lime-glass" "steel");

/// The bibliography of the database, in BibTeX.
pub const REFERENCES: &str = include_str!("../data/references.bib");

/// A name that is not in the database, or a data file at fault.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum DatabaseError {
    /// There is no such fluid or solid.
    #[error(
        "there is no {kind} `{name}` in the database{}; the choices are {}",
        .near.map(|near| format!(" (did you mean `{near}`?)")).unwrap_or_default(), .choices.join(", ")
    )]
    Unknown {
        /// `fluid` or `solid`.
        kind: &'static str,
        /// The name asked for.
        name: String,
        /// The name most like it.
        near: Option<&'static str>,
        /// All names.
        choices: Vec<&'static str>,
    },
    /// A file of the database, or of the user, is wrong.
    #[error(transparent)]
    Data(#[from] InputError),
    /// A file of the user cannot be read.
    #[error("{path} {reason}")]
    File {
        /// The file.
        path: String,
        /// Why not.
        reason: String,
    },
}

/// Names of the fluids, in alphabetical order.
pub fn fluid_names() -> Vec<&'static str> {
    FLUIDS.iter().map(|(name, _)| *name).collect()
}

/// Names of the solids, in alphabetical order.
pub fn solid_names() -> Vec<&'static str> {
    SOLIDS.iter().map(|(name, _)| *name).collect()
}

/// Whether a name is that of a file of the user.
pub fn is_file(name: &str) -> bool {
    name.ends_with(".toml")
}

/// The fluid of that name.
///
/// # Errors
///
/// [`DatabaseError::Unknown`] lists the names there are.
pub fn fluid(name: &str) -> Result<Fluid, DatabaseError> {
    fluid_noted_by(name, None)
}

fn fluid_noted_by(name: &str, inputs: Option<Recorder<'_>>) -> Result<Fluid, DatabaseError> {
    let (name, text) = find("fluid", FLUIDS, name)?;
    let document = Document::parse(format!("data/fluids/{name}.toml"), text)?;
    read_fluid(
        &document,
        name,
        Files::Embedded(TABLES),
        Head::Whole,
        inputs,
    )
}

/// The fluid of that name, or of that file in `folder`. Tables that the file names are found in its own folder; `inputs` notes its
/// quantities.
///
/// # Errors
///
/// As of [`fluid`]; a file that cannot be read, and whatever is wrong in it, with its line.
pub fn fluid_or_file(
    name: &str,
    folder: &Path,
    inputs: Option<Recorder<'_>>,
) -> Result<Fluid, DatabaseError> {
    if !is_file(name) {
        return fluid_noted_by(name, inputs);
    }
    let own = OwnFile::read(folder, name)?;
    read_fluid(&own.document, name, own.files(), Head::AsFarAsGiven, inputs)
}

/// The solid of that name.
///
/// # Errors
///
/// [`DatabaseError::Unknown`] lists the names there are.
pub fn solid(name: &str) -> Result<Solid, DatabaseError> {
    solid_noted_by(name, None)
}

fn solid_noted_by(name: &str, inputs: Option<Recorder<'_>>) -> Result<Solid, DatabaseError> {
    let (name, text) = find("solid", SOLIDS, name)?;
    let document = Document::parse(format!("data/solids/{name}.toml"), text)?;
    read_solid(
        &document,
        name,
        Files::Embedded(TABLES),
        Head::Whole,
        inputs,
    )
}

/// The solid of that name, or of that file in `folder`; as [`fluid_or_file`].
///
/// # Errors
///
/// As of [`solid`]; a file that cannot be read, and whatever is wrong in it, with its line.
pub fn solid_or_file(
    name: &str,
    folder: &Path,
    inputs: Option<Recorder<'_>>,
) -> Result<Solid, DatabaseError> {
    if !is_file(name) {
        return solid_noted_by(name, inputs);
    }
    let own = OwnFile::read(folder, name)?;
    read_solid(&own.document, name, own.files(), Head::AsFarAsGiven, inputs)
}

fn read_fluid(
    document: &Document,
    name: &str,
    files: Files<'_>,
    head: Head,
    inputs: Option<Recorder<'_>>,
) -> Result<Fluid, DatabaseError> {
    let mut table = document.root_noted_by(inputs);
    let entry = Entry::read(&mut table, head, name)?;
    let mut fluid = Fluid::from_table(&mut table, name, files)?;
    table.finish()?;
    // What a data sheet leaves open is not in the file.
    let derived = |datum: &Datum| matches!(datum.status, Status::Estimated | Status::Computed);
    fluid.provenance.retain(derived);
    fluid
        .provenance
        .splice(0..0, entry.provenance(document.text()));
    fluid.title = entry.title;
    fluid.notes = entry.notes;
    Ok(fluid)
}

fn read_solid(
    document: &Document,
    name: &str,
    files: Files<'_>,
    head: Head,
    inputs: Option<Recorder<'_>>,
) -> Result<Solid, DatabaseError> {
    let mut table = document.root_noted_by(inputs);
    let entry = Entry::read(&mut table, head, name)?;
    let mut solid = Solid::from_table(&mut table, name, files)?;
    table.finish()?;
    solid.provenance = entry.provenance(document.text());
    solid.title = entry.title;
    solid.notes = entry.notes;
    Ok(solid)
}

/// A file of the user.
struct OwnFile {
    path: PathBuf,
    document: Document,
}

impl OwnFile {
    fn read(folder: &Path, name: &str) -> Result<Self, DatabaseError> {
        let path = folder.join(name);
        let text = read_text(&path, LARGEST_DOCUMENT).map_err(|error| DatabaseError::File {
            path: path.display().to_string(),
            reason: error.to_string(),
        })?;
        let document = Document::parse(path.display().to_string(), text)?;
        Ok(Self { path, document })
    }

    fn files(&self) -> Files<'_> {
        Files::Folder(self.path.parent().unwrap_or(Path::new("")))
    }
}

/// What of the head of a data file must be there.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Head {
    /// All of it: files of the database.
    Whole,
    /// Nothing: files of users.
    AsFarAsGiven,
}

fn find(
    kind: &'static str,
    folder: &Folder,
    name: &str,
) -> Result<(&'static str, &'static str), DatabaseError> {
    folder
        .iter()
        .copied()
        .find(|(found, _)| *found == name)
        .ok_or_else(|| {
            let choices: Vec<&'static str> = folder.iter().map(|(name, _)| *name).collect();
            let wanted = name.to_lowercase();
            let similarity = |choice: &str| {
                // A part of a name counts as much as a likeness of the whole: `squalane`, `fluid-a`.
                let part = wanted.len() >= 3 && choice.contains(&wanted);
                if part {
                    1.0
                } else {
                    strsim::jaro_winkler(choice, &wanted)
                }
            };
            let near = choices
                .iter()
                .copied()
                .max_by(|a, b| similarity(a).total_cmp(&similarity(b)));
            let near = near.filter(|near| similarity(near) > 0.8);
            DatabaseError::Unknown {
                kind,
                name: name.to_owned(),
                near,
                choices,
            }
        })
}

/// Keys that are about the entry, not data.
const HEADER: [&str; 6] = [
    "title",
    "source",
    "locator",
    "status",
    "notes",
    "provenance",
];

/// The head of a data file.
struct Entry {
    title: String,
    notes: Vec<String>,
    origin: Origin,
    /// By key path.
    exceptions: Vec<(String, Origin)>,
}

/// Origin of a number; what an exception leaves out is that of the entry.
#[derive(Default)]
struct Origin {
    source: Option<String>,
    locator: Option<String>,
    status: Option<Status>,
    note: Option<String>,
}

impl Entry {
    fn read(table: &mut Table<'_>, head: Head, name: &str) -> Result<Self, InputError> {
        if head == Head::Whole {
            for key in ["title", "source", "locator", "status"] {
                if !table.contains(key) {
                    return Err(table.missing(key));
                }
            }
        }
        let text = |text: Option<&str>| text.map(str::to_owned);
        let title = text(table.optional_str("title")?).unwrap_or_else(|| name.to_owned());
        let notes = table.optional_strs("notes")?.unwrap_or_default();
        let origin = Origin {
            source: text(table.optional_str("source")?).or(Some(name.to_owned())),
            locator: text(table.optional_str("locator")?),
            status: table.optional_choice("status", &Status::NAMES)?,
            note: None,
        };
        let mut exceptions = Vec::new();
        if let Some(mut provenance) = table.optional_table("provenance")? {
            let keys: Vec<&str> = provenance.keys().collect();
            for key in keys {
                let mut of_key = provenance.required_table(key)?;
                let origin = Origin {
                    source: text(of_key.optional_str("source")?),
                    locator: text(of_key.optional_str("locator")?),
                    status: of_key.optional_choice("status", &Status::NAMES)?,
                    note: text(of_key.optional_str("note")?),
                };
                of_key.finish()?;
                exceptions.push((key.to_owned(), origin));
            }
        }
        Ok(Self {
            title,
            notes: notes.into_iter().map(str::to_owned).collect(),
            origin,
            exceptions,
        })
    }

    /// Every datum of the file with its origin, in the order of the file. `text` has been parsed before.
    fn provenance(&self, text: &str) -> Vec<Datum> {
        let mut leaves = Vec::new();
        if let Ok(root) = DeTable::parse(text) {
            collect("", root.get_ref(), &mut leaves);
        }
        leaves.sort_by_key(|leaf| leaf.0);
        leaves
            .into_iter()
            .map(|(_, key, value)| self.datum(key, &value))
            .collect()
    }

    fn datum(&self, key: String, written: &str) -> Datum {
        let none = Origin::default();
        let exception = self
            .exceptions
            .iter()
            .find(|(path, _)| *path == key)
            .map_or(&none, |(_, origin)| origin);
        let (source, locator) = match (&exception.source, &exception.locator) {
            // Another source: the locator of the entry does not belong to it.
            (Some(source), locator) => (Some(source), locator.as_ref()),
            (None, locator) => (
                self.origin.source.as_ref(),
                locator.as_ref().or(self.origin.locator.as_ref()),
            ),
        };
        let source: Vec<&str> = [source, locator]
            .into_iter()
            .flatten()
            .map(String::as_str)
            .collect();
        let (value, unit) = split_unit(written);
        Datum {
            key,
            value,
            unit,
            source: source.join(", "),
            status: exception
                .status
                .or(self.origin.status)
                .unwrap_or(Status::User),
            note: exception.note.clone(),
        }
    }
}

/// Position, key path and text of every value that is data.
fn collect(path: &str, table: &DeTable<'_>, leaves: &mut Vec<(usize, String, String)>) {
    for (key, value) in table {
        let key = key.get_ref().as_ref();
        if path.is_empty() && HEADER.contains(&key) || path == "validity" && key == "source" {
            continue;
        }
        let path = if path.is_empty() {
            key.to_owned()
        } else {
            format!("{path}.{key}")
        };
        match value.get_ref() {
            DeValue::Table(table) => collect(&path, table, leaves),
            leaf => leaves.push((value.span().start, path, written(leaf))),
        }
    }
}

/// A value as a person wrote it.
fn written(value: &DeValue<'_>) -> String {
    match value {
        DeValue::String(text) => text.to_string(),
        DeValue::Integer(digits) => digits.as_str().to_owned(),
        DeValue::Float(digits) => digits.as_str().to_owned(),
        DeValue::Array(values) => {
            let values: Vec<String> = values.iter().map(Spanned::get_ref).map(written).collect();
            values.join(" to ")
        }
        DeValue::Boolean(value) => value.to_string(),
        DeValue::Datetime(value) => value.to_string(),
        DeValue::Table(_) => String::new(),
    }
}

/// Splits `40 mPa.s` into value and unit; `1` is the unit of a bare number, a name has none.
fn split_unit(written: &str) -> (String, String) {
    let number = |text: &str| text.parse::<f64>().is_ok();
    match written.split_once(' ') {
        Some((_, rest)) if rest.contains(" to ") => (
            written.to_owned(),
            rest.rsplit(' ').next().unwrap_or("").to_owned(),
        ),
        Some((value, unit)) if number(value) => (value.to_owned(), unit.to_owned()),
        _ if number(written) => (written.to_owned(), "1".to_owned()),
        _ => (written.to_owned(), String::new()),
    }
}
