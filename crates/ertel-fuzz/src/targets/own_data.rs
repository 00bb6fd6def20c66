//! Lubricants and solids of the user: files by their path, with the tables that they name.

use std::path::Path;

use ertel_rheology::database::{DatabaseError, fluid_or_file, solid_or_file};

use super::{Verdict, check_place, check_text};
use crate::finding::Defect;

/// Pressures (Pa) and a temperature (K) at which laws are asked.
const PRESSURES: [f64; 4] = [0.0, 1e5, 5e8, 2e9];
const TEMPERATURE: f64 = 333.0;

/// Reads `oil.toml` as a lubricant and as a solid.
pub fn run(folder: &Path) -> Result<Verdict, Defect> {
    let mut verdict = Verdict::Refused;
    match fluid_or_file("oil.toml", folder, None) {
        Ok(fluid) => {
            for pressure in PRESSURES {
                let viscosity = fluid.viscosity(pressure, TEMPERATURE);
                if viscosity.is_nan() || viscosity < 0.0 {
                    let text = format!("{viscosity} Pa.s at {pressure} Pa");
                    return Err(Defect::wrong("a viscosity that is none", text));
                }
                if let Ok(density) = fluid.density(pressure, TEMPERATURE)
                    && density.is_nan()
                {
                    return Err(Defect::wrong(
                        "a density that is none",
                        pressure.to_string(),
                    ));
                }
            }
            verdict = Verdict::Taken;
        }
        Err(error) => drop(refused(&error, folder)?),
    }
    match solid_or_file("oil.toml", folder, None) {
        Ok(_) => Ok(Verdict::Taken),
        Err(error) => refused(&error, folder).map(|_| verdict),
    }
}

fn refused(error: &DatabaseError, folder: &Path) -> Result<Verdict, Defect> {
    match error {
        DatabaseError::Data(error) => check_place(error, folder),
        error => check_text(&error.to_string()),
    }
}
