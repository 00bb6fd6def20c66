//! A measured state, and how a table of them is read.

use ertel_input::csv::CsvParams;
use ertel_quantity::Dimension;
use ertel_rheology::DensityLaw;

/// The measured property.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Property {
    /// Dynamic viscosity, Pa·s.
    Viscosity,
    /// Density, kg/m³.
    Density,
}

impl Property {
    /// Name, also that of the column.
    pub fn name(self) -> &'static str {
        match self {
            Self::Viscosity => "viscosity",
            Self::Density => "density",
        }
    }

    pub(super) fn dimension(self) -> Dimension {
        match self {
            Self::Viscosity => Dimension::VISCOSITY,
            Self::Density => Dimension::DENSITY,
        }
    }
}

/// A measured state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    /// Pressure above ambient, Pa.
    pub pressure: f64,
    /// Temperature, K.
    pub temperature: f64,
    /// Viscosity (Pa·s) or density (kg/m³).
    pub value: f64,
    /// Line of the file, from 1.
    pub line: usize,
}

/// Options for reading a table of states.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Reading {
    /// Which column is which, and the decimal mark.
    pub table: CsvParams,
    /// Density of the fluid, by which a kinematic viscosity is multiplied where the table has no column of it.
    pub density: Option<DensityLaw>,
    /// Whether a table without a column of pressures is one at ambient pressure, as data sheets have it; otherwise it is an error.
    pub may_be_ambient: bool,
}
