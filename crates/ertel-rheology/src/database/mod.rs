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
use ertel_input::{Document, Recorder};
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
    let Some(path) = own_path(Kind::Fluid, name, folder) else {
        return fluid_noted_by(name, inputs);
    };
    let own = OwnFile::read(path)?;
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
    let Some(path) = own_path(Kind::Solid, name, folder) else {
        return solid_noted_by(name, inputs);
    };
    let own = OwnFile::read(path)?;
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
    // Estimated and computed data are not in the file.
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
