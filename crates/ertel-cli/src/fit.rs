//! `ertel fit`.

mod all;
mod film;
mod law;
mod stribeck;

use ertel::fit::Property;

use crate::args::{FitArgs, FitCommand, FitLawArgs};
use crate::failure::Failure;

/// Runs the command.
///
/// # Errors
///
/// Data that cannot be read, a fit that does not exist, files that cannot be written.
pub fn run(arguments: &FitArgs) -> Result<(), Failure> {
    match &arguments.command {
        FitCommand::Viscosity(arguments) => run_law(Property::Viscosity, arguments),
        FitCommand::Density(arguments) => run_law(Property::Density, arguments),
        FitCommand::Film(arguments) => film::run(arguments),
        FitCommand::Stribeck(arguments) => stribeck::run(arguments),
    }
}

fn run_law(property: Property, arguments: &FitLawArgs) -> Result<(), Failure> {
    match arguments.law == all::NAME {
        true => all::run(property, arguments),
        false => law::run(property, arguments),
    }
}
