//! Fluids from a table.

use super::{Files, Material, data_sheet, estimates};
use crate::data_sheet::BaseOil;
use crate::provenance::{Datum, ValidityRange};
use crate::{ConductivityLaw, DensityLaw, Fluid, HeatCapacityLaw, ShearThinning, ViscosityLaw};
use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;

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
    /// `reference_temperature`, `thermal_conductivity`, `heat_capacity` and
    /// `validity = { pressure = [..], temperature = [..], source = ".." }`.
    ///
    /// Instead of `viscosity`, and of `density` if wanted, the keys of a data sheet: `iso_vg` or
    /// `kinematic_viscosity_40`, `kinematic_viscosity_100` or `viscosity_index`, `density_15`, `density_20` or
    /// `relative_density_15`, `base_oil`, `pressure_viscosity_coefficient` or those at one or two temperatures
    /// (`pressure_viscosity_coefficient_40`), `pressure_law`. The remaining data are
    /// estimated ([`crate::data_sheet`]); such numbers have [`Status::Estimated`](crate::provenance::Status::Estimated) in the provenance. `base_oil` may also be given with
    /// `viscosity`: `shear_thinning = { law = "estimate" }` and [`Fluid::estimate_heat`] use it.
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
        let mut density = read_density(table, files)?;
        let base_oil = data_sheet::read_base_oil(table)?;
        let by_kind = base_oil.filter(|_| !table.contains("viscosity"));
        let sheet = match data_sheet::first_key(table).or(by_kind.map(|_| "base_oil")) {
            Some(key) if table.contains("viscosity") => {
                return Err(table.error(
                    key,
                    format!(
                        "`viscosity` and `{key}` say the same thing: give a law or a data sheet"
                    ),
                ));
            }
            Some(_) => Some(data_sheet::read(table, density.take())?),
            None => None,
        };
        let viscosity = match &sheet {
            Some(sheet) => {
                density = Some(sheet.density.clone());
                sheet.viscosity.clone()
            }
            None if !table.contains("viscosity") => {
                return Err(table.missing("viscosity").with_help(
                    "give a law, or what the data sheet of the oil says: `iso_vg` or `kinematic_viscosity_40`, \
                     `kinematic_viscosity_100`, `density_15`, `base_oil`",
                ));
            }
            None => ViscosityLaw::from_table(
                table.required_table("viscosity")?,
                density.as_ref(),
                files,
            )?,
        };
        let mut fluid = Self {
            name: name.to_owned(),
            title: name.to_owned(),
            viscosity,
            shear_thinning: None,
            density,
            reference_temperature: None,
            thermal_conductivity: None,
            heat_capacity: None,
            base_oil,
            validity: None,
            notes: Vec::new(),
            provenance: Vec::new(),
        };
        if let Some(sheet) = sheet {
            fluid.reference_temperature = Some(sheet.reference_temperature);
            fluid.validity = Some(sheet.validity);
            fluid.provenance = sheet.provenance;
        } else if let Some(base_oil) = base_oil {
            let name = base_oil.name().to_owned();
            let datum = data_sheet::given(table, "base_oil", name, "");
            fluid.provenance.push(datum);
        }
        fluid.read_others(table, files)?;
        Ok(fluid)
    }

    /// The density that the table of a fluid gives alone: its law, or what the keys of a data sheet (`density_15` with `base_oil`)
    /// make of it; `None` where it gives none.
    ///
    /// # Errors
    ///
    /// Whatever is wrong with the law or a value, with its line.
    pub fn density_from_table(
        table: &mut Table<'_>,
        files: Files<'_>,
    ) -> Result<Option<DensityLaw>, InputError> {
        match read_density(table, files)? {
            Some(law) => Ok(Some(law)),
            None => data_sheet::density(table),
        }
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
        if let Some(key) = data_sheet::first_key(table) {
            return Err(table.error(
                key,
                format!(
                    "`{key}` describes another oil; {} is one of the database",
                    self.name
                ),
            ));
        }
        if let Some(base_oil) = data_sheet::read_base_oil(table)? {
            self.take_base_oil(table, base_oil)?;
        }
        if let Some(density) = read_density(table, files)? {
            self.follow(&density);
            self.density = Some(density);
        }
        if let Some(viscosity) = table.optional_table("viscosity")? {
            self.viscosity = ViscosityLaw::from_table(viscosity, self.density.as_ref(), files)?;
        }
        self.read_others(table, files)
    }

    /// Reads what refers to density and viscosity, and notes which keys come from the user.
    fn read_others(&mut self, table: &mut Table<'_>, files: Files<'_>) -> Result<(), InputError> {
        self.read_numbers(table)?;
        self.read_thermal(table, files)?;
        let estimates = self.read_shear_thinning(table)?;
        table.read_correlations()?;
        for key in Self::KEYS {
            if table.contains(key) {
                let prefix = format!("{key}.");
                self.provenance
                    .retain(|datum| datum.key != key && !datum.key.starts_with(&prefix));
                self.record_override(table, key);
            }
        }
        self.provenance.extend(estimates);
        Ok(())
    }

    /// The kind that the user gives, for an oil of unknown kind.
    fn take_base_oil(&mut self, table: &Table<'_>, base_oil: BaseOil) -> Result<(), InputError> {
        match self.base_oil {
            Some(own) if own != base_oil => {
                let name = &self.name;
                let problem = format!(
                    "the base oil of {name} is `{}`, not `{}`",
                    own.name(),
                    base_oil.name()
                );
                return Err(table.error("base_oil", problem).with_help(
                    "leave it out, or describe an oil of your own by its data sheet without `name`",
                ));
            }
            Some(_) => {}
            None => {
                self.base_oil = Some(base_oil);
                let name = base_oil.name().to_owned();
                (self.provenance).push(data_sheet::given(table, "base_oil", name, ""));
            }
        }
        Ok(())
    }

    /// Laws that refer to the density refer to this one: a heat capacity per volume and a kinematic viscosity stay what
    /// they are.
    fn follow(&mut self, density: &DensityLaw) {
        let laws = [
            match &mut self.viscosity {
                ViscosityLaw::Walther(law) => Some(&mut law.density),
                _ => None,
            },
            match &mut self.thermal_conductivity {
                Some(ConductivityLaw::Scaling(law)) => Some(&mut law.density),
                _ => None,
            },
            match &mut self.heat_capacity {
                Some(HeatCapacityLaw::LarssonAndersson(law)) => Some(&mut law.density),
                Some(HeatCapacityLaw::Scaling(law)) => Some(&mut law.density),
                _ => None,
            },
        ];
        for law in laws.into_iter().flatten() {
            law.clone_from(density);
        }
    }

    /// After the viscosity and the reference temperature, which the second plateau refers to. Returns what of it is estimated.
    fn read_shear_thinning(&mut self, table: &mut Table<'_>) -> Result<Vec<Datum>, InputError> {
        let thinning = table.optional_table("shear_thinning").map_err(|error| {
            error
                .with_help("`newtonian = true` in the [solver] of a case leaves shear thinning out")
        })?;
        let Some(inner) = thinning else {
            return Ok(Vec::new());
        };
        let law = inner.unnoted().optional_str("law");
        let (law, estimates) = match law {
            Ok(Some("estimate")) => estimates::shear(inner, self.base_oil)?,
            _ => {
                let temperature = self.reference_temperature;
                let law = ShearThinning::from_table(inner, &self.viscosity, temperature)?;
                (law, Vec::new())
            }
        };
        self.shear_thinning = Some(law);
        Ok(estimates)
    }

    fn read_numbers(&mut self, table: &mut Table<'_>) -> Result<(), InputError> {
        let temperature = table.optional_quantity(
            "reference_temperature",
            Dimension::TEMPERATURE,
            Bounds::POSITIVE,
        )?;
        self.reference_temperature = temperature.or(self.reference_temperature);
        if let Some(validity) = table.optional_table("validity")? {
            self.validity = Some(read_validity(validity)?);
        }
        Ok(())
    }

    /// After the density, which a heat capacity per volume refers to.
    fn read_thermal(&mut self, table: &mut Table<'_>, files: Files<'_>) -> Result<(), InputError> {
        let material = Material::Lubricant;
        let density = self.density.as_ref();
        let conductivity =
            ConductivityLaw::read(table, "thermal_conductivity", material, density, files)?;
        let heat = HeatCapacityLaw::read(table, "heat_capacity", material, density, files)?;
        if conductivity.is_some() {
            self.thermal_conductivity = conductivity;
        }
        if heat.is_some() {
            self.heat_capacity = heat;
        }
        Ok(())
    }

    /// Notes that a key comes from the user. The database replaces these records by its own.
    fn record_override(&mut self, table: &Table<'_>, key: &str) {
        let si = |value: Option<f64>| value.map_or(String::new(), |value| value.to_string());
        let named = |name: Option<String>| (name.unwrap_or_default(), "");
        // A constant conductivity or heat capacity is shown by its number.
        let (value, unit) = match key {
            "viscosity" => named(Some(self.viscosity.name().to_owned())),
            "density" => named(self.density.as_ref().map(|law| law.name().to_owned())),
            "shear_thinning" => named(self.shear_thinning.as_ref().map(ShearThinning::describe)),
            "reference_temperature" => (si(self.reference_temperature), "K"),
            "thermal_conductivity" => match &self.thermal_conductivity {
                Some(ConductivityLaw::Constant(k_0)) => (k_0.to_string(), "W/(m.K)"),
                law => named(law.as_ref().map(|law| law.name().to_owned())),
            },
            "heat_capacity" => match &self.heat_capacity {
                Some(HeatCapacityLaw::Constant(c_0)) => (c_0.to_string(), "J/(kg.K)"),
                law => named(law.as_ref().map(|law| law.name().to_owned())),
            },
            _ => return,
        };
        let key = match unit {
            "" => format!("{key}.law"),
            _ => key.to_owned(),
        };
        self.provenance
            .push(data_sheet::given(table, &key, value, unit));
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
        of_law: false,
    })
}
