//! Laws, fluids and solids from TOML tables: the same schema in the database and in case files.

/// The laws of a quantity and their names in data files: `Law`, of which readers match each, and `LAWS`.
macro_rules! laws {
    ($($law:ident = $name:literal),* $(,)?) => {
        #[derive(Clone, Copy)]
        enum Law {
            $($law),*
        }

        const LAWS: &[(&str, Law)] = &[$(($name, Law::$law)),*];
    };
}

mod blend;
mod conductivity;
mod data_sheet;
mod density;
mod estimates;
mod fluid;
mod heat_capacity;
mod property;
mod shear;
mod solid;
mod table;
mod viscosity;

use std::borrow::Cow;
use std::path::Path;

use crate::linear::LinearFactor;
use crate::{DensityLaw, LawError};
use ertel_input::file::read_table;
use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;

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
            Self::Folder(folder) => read_table(&folder.join(name))
                .map(Cow::Owned)
                .map_err(|error| format!("{} {error}", folder.join(name).display())),
            Self::Embedded(files) => files
                .iter()
                .find(|(file, _)| *file == name)
                .map(|(_, text)| Cow::Borrowed(*text))
                .ok_or_else(|| format!("there is no built-in file {name}")),
        }
    }
}

/// Material whose conductivity or heat capacity is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Material {
    /// A lubricant: any law.
    Lubricant,
    /// A solid, whose properties do not depend on pressure: `constant`, `linear` without `a_p`, and `table`.
    Solid,
}

impl Material {
    /// Of the laws, those that suit the material.
    fn suitable<T: Copy>(self, laws: &[(&'static str, T)]) -> Vec<(&'static str, T)> {
        let suits = |(name, _): &&(&str, T)| {
            self == Self::Lubricant || !["larsson-andersson", "scaling"].contains(name)
        };
        laws.iter().filter(suits).copied().collect()
    }
}

/// The table of a law at `key`; `None` if there is something else, such as a plain quantity, or nothing.
fn given_law<'a>(table: &mut Table<'a>, key: &str) -> Result<Option<Table<'a>>, InputError> {
    if table.is_table(key) {
        table.optional_table(key)
    } else {
        Ok(None)
    }
}

/// `reference_temperature`, `a_t` and, of a lubricant, the optional `a_p`.
fn linear_factor(table: &mut Table<'_>, material: Material) -> Result<LinearFactor, InputError> {
    let reference_temperature = reference_temperature(table)?;
    let a_t = table.required_quantity("a_t", Dimension::INVERSE_TEMPERATURE, Bounds::ANY)?;
    let a_p = match material {
        Material::Lubricant => {
            table.optional_quantity("a_p", Dimension::INVERSE_PRESSURE, Bounds::ANY)?
        }
        Material::Solid => None,
    };
    LinearFactor::new(reference_temperature, a_t, a_p.unwrap_or(0.0)).map_err(locate(table))
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

/// `reference_temperature` (K) and the coefficient of the temperature at `key` (1/K), which belong together.
fn coefficient_of_temperature(
    table: &mut Table<'_>,
    key: &str,
    bounds: Bounds,
) -> Result<Option<(f64, f64)>, InputError> {
    if !group(table, &["reference_temperature", key])? {
        return Ok(None);
    }
    let reference_temperature = reference_temperature(table)?;
    let coefficient = table.required_quantity(key, Dimension::INVERSE_TEMPERATURE, bounds)?;
    Ok(Some((reference_temperature, coefficient)))
}

/// The density of the same lubricant, which a law needs because it is `why`.
fn required_density(
    table: &Table<'_>,
    density: Option<&DensityLaw>,
    why: &str,
) -> Result<DensityLaw, InputError> {
    density.cloned().ok_or_else(|| {
        table
            .error(
                "law",
                format!("this law is {why}: the lubricant needs a density law"),
            )
            .with_help("such as density = { law = \"dowson-higginson\", rho_0 = \"870 kg/m^3\" }")
    })
}

fn reference_temperature(table: &mut Table<'_>) -> Result<f64, InputError> {
    table.required_quantity(
        "reference_temperature",
        Dimension::TEMPERATURE,
        Bounds::POSITIVE,
    )
}

#[cfg(test)]
mod blend_tests;
#[cfg(test)]
mod data_sheet_tests;
#[cfg(test)]
mod estimates_tests;
#[cfg(test)]
mod high_pressure_tests;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod thermal_tests;
