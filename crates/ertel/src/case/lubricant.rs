//! `[lubricant]`.

use ertel_rheology::{DensityLaw, ViscosityLaw};

/// The lubricant of a case.
#[derive(Clone, Debug, PartialEq)]
pub struct Lubricant {
    /// Name in the database; `None` for laws written in the case file.
    pub name: Option<String>,
    /// Temperature, K.
    pub temperature: f64,
    /// Density law.
    pub density: DensityLaw,
    /// Viscosity law.
    pub viscosity: ViscosityLaw,
}

impl Lubricant {
    /// Viscosity at ambient pressure, Pa·s.
    pub fn ambient_viscosity(&self) -> f64 {
        self.viscosity.viscosity(0.0, self.temperature)
    }

    /// Density at ambient pressure, kg/m³.
    pub fn ambient_density(&self) -> f64 {
        self.density.density(0.0, self.temperature)
    }
}
