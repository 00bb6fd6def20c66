//! `ertel solids`.

use std::path::Path;

use ertel::words::pressure;
use ertel_rheology::database::{self, Kind};

use crate::args::{SolidsArgs, SolidsCommand};
use crate::failure::Failure;
use crate::fluids::names;
use crate::print;
use crate::provenance::{data, notes};
use crate::table::columns;

/// Runs the command.
///
/// # Errors
///
/// An unknown name, or stdout that cannot be written.
pub fn run(arguments: &SolidsArgs) -> Result<(), Failure> {
    let text = match &arguments.command {
        None | Some(SolidsCommand::List) => list()?,
        Some(SolidsCommand::Show { name }) => show(name)?,
    };
    print::report(&text)
}

fn list() -> Result<String, Failure> {
    let mut rows = Vec::new();
    for name in names(Kind::Solid) {
        let solid = database::solid_or_file(&name, Path::new(""), None)?;
        rows.push(vec![
            name,
            format!("E {}", pressure(solid.youngs_modulus)),
            format!("ν {}", solid.poissons_ratio),
            solid.title,
        ]);
    }
    Ok(format!(
        "Solids (`ertel solids show NAME` for the data and their sources):\n\n{}",
        columns(&rows)
    ))
}

fn show(name: &str) -> Result<String, Failure> {
    let solid = database::solid_or_file(name, Path::new(""), None)?;
    let mut text = format!("{}: {}\n\n", solid.name, solid.title);
    text += &data(&solid.provenance);
    text += &notes(&solid.notes);
    Ok(text)
}
