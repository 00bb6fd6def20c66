//! Solids from a table.

use crate::Solid;
use crate::input::{Bounds, InputError, Table};
use crate::provenance::{Datum, Status};
use crate::quantity::Dimension;

impl Solid {
    /// Reads a solid from a table: `youngs_modulus`, `poissons_ratio`, and where given `density`,
    /// `thermal_conductivity`, `heat_capacity`.
    ///
    /// The table may have further keys; its owner calls [`Table::finish`]. `name` is what the solid is called in
    /// messages.
    ///
    /// # Errors
    ///
    /// Missing keys, wrong units and impossible values, with their line.
    pub fn from_table(table: &mut Table<'_>, name: &str) -> Result<Self, InputError> {
        let mut solid = Self {
            name: name.to_owned(),
            title: name.to_owned(),
            youngs_modulus: 0.0,
            poissons_ratio: 0.0,
            density: None,
            thermal_conductivity: None,
            heat_capacity: None,
            notes: Vec::new(),
            provenance: Vec::new(),
        };
        // Fail on what a solid cannot do without, then read all.
        table.required_quantity("youngs_modulus", Dimension::PRESSURE, Bounds::POSITIVE)?;
        table.required_number("poissons_ratio", POISSONS_RATIO)?;
        solid.override_from(table)?;
        Ok(solid)
    }

    /// Replaces what the table gives. Keys as in [`Solid::from_table`].
    ///
    /// # Errors
    ///
    /// Wrong units and impossible values, with their line.
    pub fn override_from(&mut self, table: &mut Table<'_>) -> Result<(), InputError> {
        let mut read = |key: &str, dimension, bounds, unit: &str| {
            let value = table.optional_quantity(key, dimension, bounds)?;
            if let Some(value) = value {
                self.provenance.retain(|datum| datum.key != key);
                self.provenance.push(Datum {
                    key: key.to_owned(),
                    value: value.to_string(),
                    unit: unit.to_owned(),
                    source: "given".to_owned(),
                    status: Status::User,
                    note: None,
                });
            }
            Ok::<_, InputError>(value)
        };
        let positive = Bounds::POSITIVE;
        let youngs_modulus = read("youngs_modulus", Dimension::PRESSURE, positive, "Pa")?;
        let poissons_ratio = read(
            "poissons_ratio",
            Dimension::DIMENSIONLESS,
            POISSONS_RATIO,
            "1",
        )?;
        let density = read("density", Dimension::DENSITY, positive, "kg/m^3")?;
        let conductivity = read(
            "thermal_conductivity",
            Dimension::THERMAL_CONDUCTIVITY,
            positive,
            "W/(m.K)",
        )?;
        let heat_capacity = read(
            "heat_capacity",
            Dimension::SPECIFIC_HEAT,
            positive,
            "J/(kg.K)",
        )?;
        self.youngs_modulus = youngs_modulus.unwrap_or(self.youngs_modulus);
        self.poissons_ratio = poissons_ratio.unwrap_or(self.poissons_ratio);
        self.density = density.or(self.density);
        self.thermal_conductivity = conductivity.or(self.thermal_conductivity);
        self.heat_capacity = heat_capacity.or(self.heat_capacity);
        Ok(())
    }
}

/// Stable and compressible.
const POISSONS_RATIO: Bounds = Bounds::open(-1.0, 0.5);
