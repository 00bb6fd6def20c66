//! Fluids from a table.

use super::Files;
use crate::input::{Bounds, InputError, Table};
use crate::provenance::{Datum, Status, ValidityRange};
use crate::quantity::Dimension;
use crate::{DensityLaw, Fluid, ShearThinning, ViscosityLaw};

impl Fluid {
    /// Keys that [`Fluid::from_table`] and [`Fluid::override_from`] read.
    pub const KEYS: [&'static str; 7] = [
        "viscosity",
        "density",
        "shear_thinning",
        "reference_temperature",
        "thermal_conductivity",
        "heat_capacity",
        "validity",
    ];

    /// Reads a fluid from a table: `viscosity`, and where given `density`, `shear_thinning`,
    /// `reference_temperature`, `thermal_conductivity`, `heat_capacity` and `validity = { pressure = [..], temperature = [..], source = ".." }`.
    ///
    /// The table may have further keys; its owner calls [`Table::finish`]. `name` is what the fluid is called in
    /// messages.
    ///
    /// # Errors
    ///
    /// Whatever is wrong with a law or a value, with its line.
    pub fn from_table(
        table: &mut Table<'_>,
        name: &str,
        files: Files<'_>,
    ) -> Result<Self, InputError> {
        let density = read_density(table, files)?;
        let viscosity =
            ViscosityLaw::from_table(table.required_table("viscosity")?, density.as_ref(), files)?;
        let mut fluid = Self {
            name: name.to_owned(),
            title: name.to_owned(),
            viscosity,
            shear_thinning: None,
            density,
            reference_temperature: None,
            thermal_conductivity: None,
            heat_capacity: None,
            validity: None,
            notes: Vec::new(),
            provenance: Vec::new(),
        };
        fluid.read_numbers(table)?;
        fluid.read_shear_thinning(table)?;
        for key in Self::KEYS {
            if table.contains(key) {
                fluid.record_override(table, key);
            }
        }
        Ok(fluid)
    }

    /// Replaces what the table gives, key by key; a law is replaced as a whole. Keys as in [`Fluid::from_table`].
    ///
    /// # Errors
    ///
    /// Whatever is wrong with a law or a value, with its line.
    pub fn override_from(
        &mut self,
        table: &mut Table<'_>,
        files: Files<'_>,
    ) -> Result<(), InputError> {
        if let Some(density) = read_density(table, files)? {
            self.density = Some(density);
        }
        if let Some(viscosity) = table.optional_table("viscosity")? {
            self.viscosity = ViscosityLaw::from_table(viscosity, self.density.as_ref(), files)?;
        }
        self.read_numbers(table)?;
        self.read_shear_thinning(table)?;
        for key in Self::KEYS {
            if table.contains(key) {
                let prefix = format!("{key}.");
                self.provenance
                    .retain(|datum| datum.key != key && !datum.key.starts_with(&prefix));
                self.record_override(table, key);
            }
        }
        Ok(())
    }

    /// After the viscosity and the reference temperature, which the second plateau refers to.
    fn read_shear_thinning(&mut self, table: &mut Table<'_>) -> Result<(), InputError> {
        let thinning = table.optional_table("shear_thinning").map_err(|error| {
            error
                .with_help("`newtonian = true` in the [solver] of a case leaves shear thinning out")
        })?;
        if let Some(table) = thinning {
            let law =
                ShearThinning::from_table(table, &self.viscosity, self.reference_temperature)?;
            self.shear_thinning = Some(law);
        }
        Ok(())
    }

    fn read_numbers(&mut self, table: &mut Table<'_>) -> Result<(), InputError> {
        let mut read = |key: &str, dimension, value: &mut Option<f64>| {
            if let Some(given) = table.optional_quantity(key, dimension, Bounds::POSITIVE)? {
                *value = Some(given);
            }
            Ok::<(), InputError>(())
        };
        read(
            "reference_temperature",
            Dimension::TEMPERATURE,
            &mut self.reference_temperature,
        )?;
        read(
            "thermal_conductivity",
            Dimension::THERMAL_CONDUCTIVITY,
            &mut self.thermal_conductivity,
        )?;
        read(
            "heat_capacity",
            Dimension::SPECIFIC_HEAT,
            &mut self.heat_capacity,
        )?;
        if let Some(validity) = table.optional_table("validity")? {
            self.validity = Some(read_validity(validity)?);
        }
        Ok(())
    }

    /// Notes that a key comes from the user. The database replaces these records by its own.
    fn record_override(&mut self, table: &Table<'_>, key: &str) {
        let si = |value: Option<f64>| value.map_or(String::new(), |value| value.to_string());
        let (value, unit) = match key {
            "viscosity" => (self.viscosity.name().to_owned(), String::new()),
            "density" => (
                self.density
                    .as_ref()
                    .map_or("", DensityLaw::name)
                    .to_owned(),
                String::new(),
            ),
            "shear_thinning" => (
                self.shear_thinning
                    .as_ref()
                    .map_or(String::new(), ShearThinning::describe),
                String::new(),
            ),
            "reference_temperature" => (si(self.reference_temperature), "K".to_owned()),
            "thermal_conductivity" => (si(self.thermal_conductivity), "W/(m.K)".to_owned()),
            "heat_capacity" => (si(self.heat_capacity), "J/(kg.K)".to_owned()),
            _ => return,
        };
        let source = if table.path().is_empty() {
            "given".to_owned()
        } else {
            format!("given in [{}]", table.path())
        };
        let law = matches!(key, "viscosity" | "density" | "shear_thinning");
        self.provenance.push(Datum {
            key: if law {
                format!("{key}.law")
            } else {
                key.to_owned()
            },
            value,
            unit,
            source,
            status: Status::User,
            note: None,
        });
    }
}

fn read_density(table: &mut Table<'_>, files: Files<'_>) -> Result<Option<DensityLaw>, InputError> {
    table
        .optional_table("density")?
        .map(|density| DensityLaw::from_table(density, files))
        .transpose()
}

fn read_validity(mut table: Table<'_>) -> Result<ValidityRange, InputError> {
    let mut range = |key: &str, dimension| {
        let ends = table.optional_quantities(key, dimension, Bounds::NON_NEGATIVE)?;
        match ends.as_deref() {
            None => Ok(None),
            Some(&[min, max]) if min <= max => Ok(Some((min, max))),
            Some(_) => Err(table.error(key, format!("`{key}` must be a range [lowest, highest]"))),
        }
    };
    let pressure = range("pressure", Dimension::PRESSURE)?;
    let temperature = range("temperature", Dimension::TEMPERATURE)?;
    let source = table.required_str("source")?.to_owned();
    table.finish()?;
    Ok(ValidityRange {
        pressure,
        temperature,
        source,
    })
}
