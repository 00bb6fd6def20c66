//! Fluids and solids that come with the crate.
//!
//! One TOML file each in `data/fluids` and `data/solids`, with the schema of [`Fluid::from_table`] and
//! [`Solid::from_table`]. A file opens with `title`, `source` (a key of `data/references.bib`), `locator` (the place in
//! it), `status` and `notes`; these hold for each of its numbers unless `[provenance."key.path"]` says otherwise.
//!
//! Files of a user have the same schema; of the head nothing must be there. A name that ends with `.toml` is a file; other names
//! are looked for in the folder of own data, if there is one ([`use_own_data`]), and then in the database.

mod entry;
mod error;
pub(crate) mod names;
mod own;
mod shipped;

use std::path::Path;

use crate::provenance::{Datum, Status};
use crate::{Files, Fluid, Solid};
use entry::{Entry, Head};
use ertel_input::{Document, Recorder, Table};
use own::OwnFile;
use shipped::{FLUIDS, Folder, SOLIDS, TABLES};

pub use error::DatabaseError;
pub use own::{Kind, OwnData, is_file, own_data, own_path, use_own_data};

/// The bibliography of the database, in BibTeX.
pub const REFERENCES: &str = include_str!("../../data/references.bib");

/// Names of the fluids, in alphabetical order.
pub fn fluid_names() -> Vec<&'static str> {
    FLUIDS.iter().map(|(name, _)| *name).collect()
}

/// Names of the solids, in alphabetical order.
pub fn solid_names() -> Vec<&'static str> {
    SOLIDS.iter().map(|(name, _)| *name).collect()
}

/// The fluid of that name.
///
/// # Errors
///
/// [`DatabaseError::Unknown`] lists the names there are.
pub fn fluid(name: &str) -> Result<Fluid, DatabaseError> {
    open(Kind::Fluid, name, None, None, read_fluid)
}

/// The fluid of that name in the own data or the database, or of that file in `folder`. Tables that the file names are found in its own
/// folder; `inputs` notes its quantities.
///
/// # Errors
///
/// As of [`fluid`]; a file that cannot be read, and whatever is wrong in it, with its line.
pub fn fluid_or_file(
    name: &str,
    folder: &Path,
    inputs: Option<Recorder<'_>>,
) -> Result<Fluid, DatabaseError> {
    open(Kind::Fluid, name, Some(folder), inputs, read_fluid)
}

/// The solid of that name.
///
/// # Errors
///
/// [`DatabaseError::Unknown`] lists the names there are.
pub fn solid(name: &str) -> Result<Solid, DatabaseError> {
    open(Kind::Solid, name, None, None, read_solid)
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
    open(Kind::Solid, name, Some(folder), inputs, read_solid)
}

/// Reads a fluid or a solid from the file of the user that the name stands for, where files in a folder are meant too, or from the database.
fn open<T>(
    kind: Kind,
    name: &str,
    folder: Option<&Path>,
    inputs: Option<Recorder<'_>>,
    read: fn(&str, &str, Table<'_>, Files<'_>, Head) -> Result<T, DatabaseError>,
) -> Result<T, DatabaseError> {
    if let Some(path) = folder.and_then(|folder| own_path(kind, name, folder)) {
        let own = OwnFile::read(path)?;
        let (text, table) = (own.document.text(), own.document.root_noted_by(inputs));
        return read(name, text, table, own.files(), Head::AsFarAsGiven);
    }
    let (word, entries) = match kind {
        Kind::Fluid => ("fluid", FLUIDS),
        Kind::Solid => ("solid", SOLIDS),
    };
    let (name, text) = find(word, entries, name)?;
    let document = Document::parse(format!("data/{word}s/{name}.toml"), text)?;
    let table = document.root_noted_by(inputs);
    read(name, text, table, Files::Embedded(TABLES), Head::Whole)
}

fn read_fluid(
    name: &str,
    text: &str,
    mut table: Table<'_>,
    files: Files<'_>,
    head: Head,
) -> Result<Fluid, DatabaseError> {
    let entry = Entry::read(&mut table, head, name)?;
    let mut fluid = Fluid::from_table(&mut table, name, files)?;
    table.finish()?;
    // Estimated and computed data are not in the file.
    let derived = |datum: &Datum| matches!(datum.status, Status::Estimated | Status::Computed);
    fluid.provenance.retain(derived);
    fluid.provenance.splice(0..0, entry.provenance(text));
    fluid.title = entry.title;
    fluid.notes = entry.notes;
    Ok(fluid)
}

fn read_solid(
    name: &str,
    text: &str,
    mut table: Table<'_>,
    files: Files<'_>,
    head: Head,
) -> Result<Solid, DatabaseError> {
    let entry = Entry::read(&mut table, head, name)?;
    let mut solid = Solid::from_table(&mut table, name, files)?;
    table.finish()?;
    solid.provenance = entry.provenance(text);
    solid.title = entry.title;
    solid.notes = entry.notes;
    Ok(solid)
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
            let shipped = folder.iter().map(|(name, _)| *name);
            let own = own_data().map_or(&[][..], |own| match kind {
                "fluid" => &own.fluids,
                _ => &own.solids,
            });
            let choices: Vec<&'static str> =
                own.iter().map(String::as_str).chain(shipped).collect();
            let meant = names::meant(kind, name, &choices);
            DatabaseError::Unknown {
                kind,
                name: name.to_owned(),
                near: meant.near,
                help: meant.help,
                choices,
            }
        })
}
