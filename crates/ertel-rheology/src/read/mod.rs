//! Laws, fluids and solids from TOML tables: the same schema in the database and in case files.

mod density;
mod fluid;
mod shear;
mod solid;
mod table;
mod viscosity;

use std::borrow::Cow;
use std::path::Path;

use crate::LawError;
use crate::input::{InputError, Table};

/// Where the files named in a table are found.
#[derive(Debug, Clone, Copy)]
pub enum Files<'a> {
    /// Relative to this folder, as a rule that of the case file.
    Folder(&'a Path),
    /// Built in: pairs of name and text.
    Embedded(&'a [(&'a str, &'a str)]),
}

impl<'a> Files<'a> {
    /// Text of the file `name`, or why there is none.
    fn read(&self, name: &str) -> Result<Cow<'a, str>, String> {
        match self {
            Self::Folder(folder) => std::fs::read_to_string(folder.join(name))
                .map(Cow::Owned)
                .map_err(|error| {
                    format!("{} cannot be read: {error}", folder.join(name).display())
                }),
            Self::Embedded(files) => files
                .iter()
                .find(|(file, _)| *file == name)
                .map(|(_, text)| Cow::Borrowed(*text))
                .ok_or_else(|| format!("there is no built-in file {name}")),
        }
    }
}

/// Points an error about the constants of a law at their line.
fn locate<'t>(table: &'t Table<'_>) -> impl Fn(LawError) -> InputError + 't {
    move |error| table.error(error.key(), error.to_string())
}

/// Whether the keys of a group are there; some without the others is an error.
fn group(table: &mut Table<'_>, keys: &[&str]) -> Result<bool, InputError> {
    let present: Vec<bool> = keys.iter().map(|key| table.contains(key)).collect();
    if present.iter().all(|present| !present) {
        return Ok(false);
    }
    match keys.iter().zip(present).find(|(_, present)| !present) {
        None => Ok(true),
        Some((key, _)) => Err(table.missing(key).with_help(format!(
            "{} belong together: give all or none",
            keys.join(", ")
        ))),
    }
}

/// The law named by the key `law`, or an error that lists the laws.
fn law_name<'t>(table: &mut Table<'_>, names: &[&'t str]) -> Result<&'t str, InputError> {
    let options: Vec<(&str, &'t str)> = names.iter().map(|name| (*name, *name)).collect();
    table.required_choice("law", &options)
}

#[cfg(test)]
mod tests;
