//! `lubricant` and `temperature`.

use std::path::Path;

use crate::warning::Warning;
use ertel_rheology::input::{Bounds, InputError, StrOrTable, Table};
use ertel_rheology::provenance::{Datum, Status, TemperatureRange};
use ertel_rheology::quantity::Dimension;
use ertel_rheology::{
    ConductivityLaw, DensityLaw, Files, Fluid, HeatCapacityLaw, ShearThinning, ViscosityLaw,
    database,
};

/// Temperatures of lubricants, K: outside, a unit was mistaken.
pub(super) const TEMPERATURE: Bounds = Bounds::closed(100.0, 1000.0);
/// Ambient viscosities from gases to pitch, Pa·s; likewise.
const VISCOSITY: Bounds = Bounds::closed(1e-6, 1e6);
/// Ambient densities, kg/m³; likewise.
const DENSITY: Bounds = Bounds::closed(0.1, 3e4);

/// The lubricant of a case.
#[derive(Clone, Debug, PartialEq)]
pub struct Lubricant {
    /// Name in the database, or file of the user; `None` for laws written in the case file.
    pub name: Option<String>,
    /// Temperature, K.
    pub temperature: f64,
    /// Density law.
    pub density: DensityLaw,
    /// Law of the viscosity at low shear.
    pub viscosity: ViscosityLaw,
    /// Shear thinning; `None` for a Newtonian lubricant.
    pub shear_thinning: Option<ShearThinning>,
    /// Law of the thermal conductivity, if known.
    pub thermal_conductivity: Option<ConductivityLaw>,
    /// Law of the heat capacity, if known.
    pub heat_capacity: Option<HeatCapacityLaw>,
    /// Temperatures that the data cover, each with what it rests on.
    pub temperature_ranges: Vec<TemperatureRange>,
    /// Numbers that are estimates, as of an oil given by its data sheet.
    pub estimates: Vec<Datum>,
}

impl Lubricant {
    /// Viscosity at ambient pressure and low shear, Pa·s.
    pub fn ambient_viscosity(&self) -> f64 {
        self.viscosity.viscosity(0.0, self.temperature)
    }

    /// Density at ambient pressure, kg/m³.
    pub fn ambient_density(&self) -> f64 {
        self.density.density(0.0, self.temperature)
    }

    /// Thermal conductivity at ambient pressure, W/(m·K), if known.
    pub fn ambient_conductivity(&self) -> Option<f64> {
        let law = self.thermal_conductivity.as_ref()?;
        Some(law.conductivity(0.0, self.temperature))
    }

    /// The narrowest range of the data that `temperature`, K, leaves.
    pub fn range_left(&self, temperature: f64) -> Option<&TemperatureRange> {
        let left = (self.temperature_ranges.iter()).filter(|range| !range.contains(temperature));
        left.min_by(|a, b| a.width().total_cmp(&b.width()))
    }
}

/// Reads the lubricant at the top level: a name with a top-level `temperature`, or a table.
///
/// Files that it names are in `folder`. `pressure` is the Hertz pressure, Pa. Returns the warnings about the range of the data, too, with that of the thermal
/// data where there is `heat`.
pub(super) fn read(
    root: &mut Table<'_>,
    folder: &Path,
    pressure: f64,
    heat: bool,
) -> Result<(Lubricant, Vec<Warning>), InputError> {
    let lubricant = root.required_str_or_table("lubricant");
    let lubricant =
        lubricant.map_err(|error| super::sections::missing(root, "lubricant", error))?;
    match lubricant {
        StrOrTable::Str(name) => {
            let fluid = database::fluid_or_file(name, folder, root.recorder("lubricant"))
                .map_err(super::unknown(root, "lubricant"))?;
            let temperature = root
                .required_quantity("temperature", Dimension::TEMPERATURE, TEMPERATURE)
                .map_err(|error| {
                    error.with_help("a lubricant given by its name needs the temperature before the first [table]")
                })?;
            check(
                root,
                ("lubricant", Some(name)),
                fluid,
                temperature,
                pressure,
                heat,
            )
        }
        StrOrTable::Table(mut table) => {
            if root.contains("temperature") {
                return Err(root
                    .error("temperature", "`temperature` belongs into [lubricant]")
                    .with_help("at the top level it goes with `lubricant = \"name\"`"));
            }
            let temperature =
                table.required_quantity("temperature", Dimension::TEMPERATURE, TEMPERATURE)?;
            let name = table.optional_str("name")?;
            let fluid = match name {
                Some(name) => {
                    let mut fluid = database::fluid_or_file(name, folder, table.own_recorder())
                        .map_err(super::unknown(&table, "name"))?;
                    fluid.override_from(&mut table, Files::Folder(folder))?;
                    fluid
                }
                None => {
                    if table.contains("viscosity") && !table.contains("density") {
                        return Err(table.missing("density").with_help(
                            "such as density = { law = \"dowson-higginson\", rho_0 = \"870 kg/m^3\" }",
                        ));
                    }
                    Fluid::from_table(&mut table, "the lubricant", Files::Folder(folder))?
                }
            };
            let key = if name.is_some() { "name" } else { "viscosity" };
            let lubricant = check(&table, (key, name), fluid, temperature, pressure, heat)?;
            table.finish()?;
            Ok(lubricant)
        }
    }
}

/// The laws at the temperature of the case; errors stand at `key` of `table`. `name` is that in the database.
fn check(
    table: &Table<'_>,
    (key, name): (&str, Option<&str>),
    fluid: Fluid,
    temperature: f64,
    pressure: f64,
    heat: bool,
) -> Result<(Lubricant, Vec<Warning>), InputError> {
    let density = fluid
        .density_law()
        .map_err(|error| table.error(key, error.to_string()))?
        .clone();
    let warnings = if heat {
        fluid.check_range_with_heat(pressure, temperature)
    } else {
        fluid.check_range(pressure, temperature)
    };
    let temperature_ranges = fluid.temperature_ranges();
    let mut estimates = fluid.provenance;
    estimates.retain(|datum| datum.status == Status::Estimated);
    let lubricant = Lubricant {
        name: name.map(str::to_owned),
        temperature,
        density,
        viscosity: fluid.viscosity,
        shear_thinning: fluid.shear_thinning,
        thermal_conductivity: fluid.thermal_conductivity,
        heat_capacity: fluid.heat_capacity,
        temperature_ranges,
        estimates,
    };
    let must_lie = |what: &str, value: f64, bounds: Bounds, unit: &str| {
        if bounds.contains(value) {
            Ok(())
        } else {
            Err(table.error(
                key,
                format!(
                    "the {what} at {temperature} K and ambient pressure is {value:e} {unit}; it must be {}",
                    bounds.describe(unit)
                ),
            ))
        }
    };
    must_lie(
        "viscosity",
        lubricant.ambient_viscosity(),
        VISCOSITY,
        "Pa.s",
    )?;
    must_lie("density", lubricant.ambient_density(), DENSITY, "kg/m^3")?;
    let loaded = [
        (
            "viscosity",
            lubricant.viscosity.ln_viscosity(pressure, temperature),
        ),
        (
            "density",
            lubricant.density.density(pressure, temperature).ln(),
        ),
    ];
    for (what, logarithm) in loaded {
        if !logarithm.is_finite() {
            return Err(table.error(
                key,
                format!("the {what} law fails at the Hertz pressure of {pressure:.3e} Pa"),
            ));
        }
    }
    Ok((lubricant, warnings.iter().map(Warning::from).collect()))
}
