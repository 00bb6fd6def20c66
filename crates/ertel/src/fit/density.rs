//! The density that a fit of the viscosity takes, and its text in an entry.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use ertel_input::{Document, InputError};
use ertel_rheology::database::{self, DatabaseError, Kind};
use ertel_rheology::density::BulkModulusSoftening;
use ertel_rheology::{DensityLaw, Files, Fluid};

/// Why there is no density by a name.
#[derive(Debug, thiserror::Error)]
pub enum DensityError {
    /// Something is wrong with the file.
    #[error(transparent)]
    File(#[from] InputError),
    /// There is no such fluid.
    #[error(transparent)]
    Database(#[from] DatabaseError),
    /// The fluid has none.
    #[error(
        "the fluid {0} has no density: give one with `density`, or with `density_15` and `base_oil`"
    )]
    None(String),
}

/// The density of a fluid of the database, or of an entry: the law of its `density`, or what the keys `density_15` and `base_oil`
/// of a data sheet make of it.
///
/// # Errors
///
/// Names that are not known, files that cannot be read, fluids without density.
pub fn density_of(name: &str) -> Result<DensityLaw, DensityError> {
    let found = match entry_path(name) {
        Some(path) => {
            let document = Document::read(&path)?;
            let folder = path.parent().unwrap_or(Path::new("."));
            Fluid::density_from_table(&mut document.root(), Files::Folder(folder))?
        }
        None => database::fluid(name)?.density,
    };
    found.ok_or_else(|| DensityError::None(name.to_owned()))
}

/// The file that a name means, by its path or in the own data; `None` of a fluid of the database.
fn entry_path(name: &str) -> Option<PathBuf> {
    database::own_path(Kind::Fluid, name, Path::new(""))
}

/// The section `[density]` of an entry, in SI to the last digit; nothing of a table.
pub(super) fn section(law: &DensityLaw) -> String {
    let mut text = format!("[density]\nlaw = \"{}\"\n", law.name());
    let mut line = |key: &str, value: f64, unit: &str| {
        let _ = match unit {
            "" => writeln!(text, "{key} = {value:?}"),
            _ if value != 0.0 && value.abs() < 1e-4 => {
                writeln!(text, "{key} = \"{value:e} {unit}\"")
            }
            _ => writeln!(text, "{key} = \"{value} {unit}\""),
        };
    };
    let rho = "kg/m^3";
    match law {
        DensityLaw::Constant(law) => line("rho_0", law.rho_0, rho),
        DensityLaw::DowsonHigginson(law) => {
            line("rho_0", law.rho_0, rho);
            line("c_1", law.compressibility, "1/Pa");
            line("c_2", law.saturation, "1/Pa");
            if let Some(thermal) = &law.thermal {
                line("reference_temperature", thermal.reference_temperature, "K");
                line("beta", thermal.temperature_coefficient, "1/K");
            }
        }
        DensityLaw::Tait(law) => {
            line("rho_0", law.rho_0, rho);
            line("k_0r", law.volume.bulk_modulus, "Pa");
            line("k_0r_prime", law.volume.bulk_modulus_slope, "");
            softening(law.volume.thermal.as_ref(), line);
        }
        DensityLaw::Murnaghan(law) => {
            line("rho_0", law.rho_0, rho);
            line("k_0r", law.bulk_modulus, "Pa");
            line("k_0r_prime", law.bulk_modulus_slope, "");
            softening(law.thermal.as_ref(), line);
        }
        DensityLaw::Table(_) => return String::new(),
    }
    text
}

/// The temperature terms of the bulk modulus.
fn softening(thermal: Option<&BulkModulusSoftening>, mut line: impl FnMut(&str, f64, &str)) {
    let Some(thermal) = thermal else { return };
    line("reference_temperature", thermal.reference_temperature, "K");
    line("beta_k", thermal.bulk_modulus_coefficient, "1/K");
    let of_slope = thermal.bulk_modulus_slope_coefficient;
    line("beta_k_prime", of_slope, "1/K");
    line("a_v", thermal.expansivity, "1/K");
}
