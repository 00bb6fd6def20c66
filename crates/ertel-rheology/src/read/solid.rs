//! Solids from a table.

use super::{Files, Material};
use crate::provenance::{Datum, Status};
use crate::{ConductivityLaw, HeatCapacityLaw, Solid};
use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;

impl Solid {
    /// Reads a solid from a table: `youngs_modulus`, `poissons_ratio`, and where given `hertz_pressure_limit`, `density`, and the laws
    /// `thermal_conductivity` and `heat_capacity`, where a quantity means a constant.
    ///
    /// The table may have further keys; its owner calls [`Table::finish`]. `name` is what the solid is called in
    /// messages.
    ///
    /// # Errors
    ///
    /// Missing keys, wrong units and impossible values, with their line.
    pub fn from_table(
        table: &mut Table<'_>,
        name: &str,
        files: Files<'_>,
    ) -> Result<Self, InputError> {
        let mut solid = Self {
            name: name.to_owned(),
            title: name.to_owned(),
            youngs_modulus: 0.0,
            poissons_ratio: 0.0,
            hertz_pressure_limit: None,
            density: None,
            thermal_conductivity: None,
            heat_capacity: None,
            notes: Vec::new(),
            provenance: Vec::new(),
        };
        // Fail on what a solid cannot do without, then read all.
        table.required_quantity("youngs_modulus", Dimension::PRESSURE, Bounds::POSITIVE)?;
        table.required_number("poissons_ratio", POISSONS_RATIO)?;
        solid.override_from(table, files)?;
        Ok(solid)
    }

    /// Replaces what the table gives. Keys as in [`Solid::from_table`].
    ///
    /// # Errors
    ///
    /// Wrong units and impossible values, with their line.
    pub fn override_from(
        &mut self,
        table: &mut Table<'_>,
        files: Files<'_>,
    ) -> Result<(), InputError> {
        let positive = Bounds::POSITIVE;
        if let Some(modulus) =
            table.optional_quantity("youngs_modulus", Dimension::PRESSURE, positive)?
        {
            self.youngs_modulus = modulus;
            self.record("youngs_modulus", modulus.to_string(), "Pa");
        }
        if let Some(ratio) = table.optional_number("poissons_ratio", POISSONS_RATIO)? {
            self.poissons_ratio = ratio;
            self.record("poissons_ratio", ratio.to_string(), "1");
        }
        let key = "hertz_pressure_limit";
        if let Some(limit) = table.optional_quantity(key, Dimension::PRESSURE, positive)? {
            self.hertz_pressure_limit = Some(limit);
            self.record(key, limit.to_string(), "Pa");
        }
        if let Some(density) = table.optional_quantity("density", Dimension::DENSITY, positive)? {
            self.density = Some(density);
            self.record("density", density.to_string(), "kg/m^3");
        }
        let key = "thermal_conductivity";
        if let Some(law) = ConductivityLaw::read(table, key, Material::Solid, None, files)? {
            self.record_law(key, law.constant_value(), law.name(), "W/(m.K)");
            self.thermal_conductivity = Some(law);
        }
        let key = "heat_capacity";
        if let Some(law) = HeatCapacityLaw::read(table, key, Material::Solid, None, files)? {
            self.record_law(key, law.constant_value(), law.name(), "J/(kg.K)");
            self.heat_capacity = Some(law);
        }
        Ok(())
    }

    /// Notes that the law at `key` comes from the user, a law that is more than a number by its name.
    fn record_law(&mut self, key: &str, constant: Option<f64>, name: &str, unit: &str) {
        if let Some(value) = constant {
            return self.record(key, value.to_string(), unit);
        }
        self.record(key, name.to_owned(), "");
        if let Some(datum) = self.provenance.last_mut() {
            datum.key += ".law";
        }
    }

    /// Notes that a number comes from the user. The database replaces these records by its own.
    fn record(&mut self, key: &str, value: String, unit: &str) {
        let prefix = format!("{key}.");
        self.provenance
            .retain(|datum| datum.key != key && !datum.key.starts_with(&prefix));
        self.provenance.push(Datum {
            key: key.to_owned(),
            value,
            unit: unit.to_owned(),
            source: "given".to_owned(),
            status: Status::User,
            note: None,
        });
    }
}

/// Stable; 0.5 is incompressible, as rubber nearly is.
const POISSONS_RATIO: Bounds = Bounds::above_to(-1.0, 0.5);
