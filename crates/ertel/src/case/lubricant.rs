//! `lubricant` and `temperature`.

use std::path::Path;

use crate::warning::{Warning, WarningKind};
use ertel_input::{Bounds, InputError, StrOrTable, Table};
use ertel_quantity::Dimension;
use ertel_rheology::provenance::{Datum, Status, TemperatureRange};
use ertel_rheology::{
    ConductivityLaw, DensityLaw, Files, Fluid, HeatCapacityLaw, ShearThinning, ViscosityLaw,
    database,
};

/// Temperatures of lubricants, K: values outside indicate a wrong unit.
pub(super) const TEMPERATURE: Bounds = Bounds::closed(100.0, 1000.0);
/// Ambient viscosities from gases to pitch, Pa·s; likewise.
pub(super) const VISCOSITY: Bounds = Bounds::closed(1e-6, 1e6);
/// Ambient densities, kg/m³; likewise.
const DENSITY: Bounds = Bounds::closed(0.1, 3e4);

/// Keys of the lubricant temperature.
pub(super) const TEMPERATURE_KEYS: [&str; 2] = ["temperature", "lubricant.temperature"];

/// Remedy for a law without temperature dependence.
const OILS_WITH_TEMPERATURE: &str = "give the law a temperature dependence (`beta` and `reference_temperature` of Roelands' law), the oil by its \
     data sheet (`iso_vg`, `kinematic_viscosity_40` and `_100`), or a viscosity for each temperature";

/// K by which the temperature of a case may differ from that of its constants.
const SAME_TEMPERATURE: f64 = 0.5;

/// The lubricant of a case.
#[derive(Clone, Debug, PartialEq)]
pub struct Lubricant {
    /// Name in the database, file of the user, or the parts of a blend; `None` for laws written in the case file.
    pub name: Option<String>,
    /// Temperature with which the lubricant enters the contact, K.
    pub temperature: f64,
    /// Temperature at which it is supplied, K, where the contact has another one: the bulk temperature of the teeth.
    pub supply_temperature: Option<f64>,
    /// Density law.
    pub density: DensityLaw,
    /// Law of the viscosity at low shear.
    pub viscosity: ViscosityLaw,
    /// Shear thinning; `None` for a Newtonian lubricant.
    pub shear_thinning: Option<ShearThinning>,
    /// Law of the thermal conductivity, if known.
    pub thermal_conductivity: Option<ConductivityLaw>,
    /// Conductivity at ambient pressure by the kind of the base oil, W/(m K), if that is known: for estimates of cases without heat.
    pub typical_conductivity: Option<f64>,
    /// Law of the heat capacity, if known.
    pub heat_capacity: Option<HeatCapacityLaw>,
    /// Temperatures that the data cover, each with its source.
    pub temperature_ranges: Vec<TemperatureRange>,
    /// Numbers that are estimates, as of an oil given by its data sheet.
    pub estimates: Vec<Datum>,
    /// Whether shear thinning is estimated by the kind of the oil without being asked for.
    pub is_shear_by_kind: bool,
}

impl Lubricant {
    /// Viscosity at ambient pressure and low shear, Pa·s.
    pub fn ambient_viscosity(&self) -> f64 {
        self.viscosity.viscosity(0.0, self.temperature)
    }

    /// Whether the oil itself is known by its data sheet, and not only heat or shear by its kind.
    pub fn is_of_data_sheet(&self) -> bool {
        let by_kind = |key: &str| {
            ["thermal_conductivity.", "heat_capacity.", "shear_thinning."]
                .iter()
                .any(|part| key.starts_with(part))
        };
        self.estimates.iter().any(|datum| !by_kind(&datum.key))
    }

    /// Temperature of the oil in the sump or the jet, K.
    pub fn oil_temperature(&self) -> f64 {
        self.supply_temperature.unwrap_or(self.temperature)
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

    /// Density at a pressure, Pa, over that at ambient pressure.
    pub fn relative_density(&self, pressure: f64) -> f64 {
        self.density.density(pressure, self.temperature) / self.ambient_density()
    }

    /// The laws that do not depend on temperature, in words; `None` where the viscosity does.
    pub fn no_temperature(&self) -> Option<String> {
        let (viscosity, density) = (self.viscosity.name(), self.density.name());
        match (
            self.viscosity.depends_on_temperature(),
            self.density.depends_on_temperature(),
        ) {
            (true, _) => None,
            (false, true) => Some(format!(
                "the viscosity law ({viscosity}) does not depend on temperature"
            )),
            (false, false) => Some(format!(
                "neither the viscosity law ({viscosity}) nor the density law ({density}) depends on temperature"
            )),
        }
    }

    /// Warns that a deliberate change of temperature, described by `how`, has no effect. `keys` were changed with it: where the
    /// viscosity is among them, it may well be that of this temperature.
    pub(super) fn temperature_ignored<'a>(
        &self,
        keys: impl IntoIterator<Item = &'a str>,
        how: &str,
    ) -> Option<Warning> {
        let keys: Vec<&str> = keys.into_iter().collect();
        let temperature = keys.iter().find(|key| TEMPERATURE_KEYS.contains(key))?;
        let is_viscosity = |key: &&str| {
            *key == "lubricant" || key.starts_with("lubricant.") && !TEMPERATURE_KEYS.contains(key)
        };
        if keys.iter().any(is_viscosity) {
            return None;
        }
        if self.supply_temperature.is_some() {
            let text = format!(
                "`{temperature}` {how}, but films are computed at the temperature of the teeth, `machine.bulk_temperature`, and do not change"
            );
            return Some(Warning::new(WarningKind::TemperatureIgnored, text));
        }
        let reason = self.no_temperature()?;
        let text = format!(
            "`{temperature}` {how}, but {reason}: the film is the same at any temperature; {OILS_WITH_TEMPERATURE}"
        );
        Some(Warning::new(WarningKind::TemperatureIgnored, text))
    }
}

/// Conditions of the contact.
#[derive(Clone, Copy)]
pub(super) struct Conditions {
    /// Hertz pressure, Pa.
    pub pressure: f64,
    /// Whether the contact is thermal.
    pub heat: bool,
    /// Whether a lubricant without a law of shear thinning gets the estimated one of its kind.
    pub shear: bool,
    /// Temperature of the flanks, K, where a machine states it: oil on them reaches it before it enters the contact.
    pub flank_temperature: Option<f64>,
}

/// Reads the lubricant at the top level: a name with a top-level `temperature`, or a table.
///
/// Files that it names are in `folder`. `conditions` are those of the contact. Returns the warnings about the range of the data, too, with that of the thermal
/// data where there is heat.
pub(super) fn read(
    root: &mut Table<'_>,
    folder: &Path,
    conditions: Conditions,
) -> Result<(Lubricant, Vec<Warning>), InputError> {
    let lubricant = root.required_str_or_table("lubricant");
    let lubricant =
        lubricant.map_err(|error| super::sections::missing(root, "lubricant", error))?;
    match lubricant {
        StrOrTable::Str(name) => by_name(root, name, folder, conditions),
        StrOrTable::Table(table) => {
            if root.contains("temperature") {
                return Err(root
                    .error("temperature", "`temperature` belongs in [lubricant]")
                    .with_help("at the top level it belongs to `lubricant = \"name\"`"));
            }
            by_table(table, folder, conditions)
        }
    }
}

/// `lubricant = "name"`, with a top-level `temperature`.
fn by_name(
    root: &mut Table<'_>,
    name: &str,
    folder: &Path,
    conditions: Conditions,
) -> Result<(Lubricant, Vec<Warning>), InputError> {
    let mut fluid = database::fluid_or_file(name, folder, root.recorder("lubricant"))
        .map_err(super::unknown(root, "lubricant"))?;
    if conditions.heat {
        fluid.estimate_heat(root, "lubricant")?;
    }
    let by_kind = conditions.shear && fluid.estimate_shear(root, "lubricant")?;
    let temperature = root
        .required_quantity("temperature", Dimension::TEMPERATURE, TEMPERATURE)
        .map_err(|error| {
            error.with_help(
                "a lubricant given by its name needs the temperature before the first [table]",
            )
        })?;
    let place = ("lubricant", Some(name));
    let (mut lubricant, warnings) = check(root, place, fluid, temperature, conditions)?;
    lubricant.is_shear_by_kind = by_kind;
    Ok((lubricant, warnings))
}

/// `[lubricant]`.
fn by_table(
    mut table: Table<'_>,
    folder: &Path,
    conditions: Conditions,
) -> Result<(Lubricant, Vec<Warning>), InputError> {
    let temperature =
        table.required_quantity("temperature", Dimension::TEMPERATURE, TEMPERATURE)?;
    let name = table.optional_str("name")?.map(str::to_owned);
    let is_blend = table.contains("blend");
    if let (Some(_), true) = (&name, is_blend) {
        return Err(table
            .error("blend", "`name` and `blend` both define the oil")
            .with_help("keep one of them; a part of a blend has its own `name`"));
    }
    let named = match &name {
        Some(name) => {
            let fluid = database::fluid_or_file(name, folder, table.own_recorder())
                .map_err(super::unknown(&table, "name"))?;
            Some(("name", fluid))
        }
        None if is_blend => Some(("blend", Fluid::from_blend(&mut table, folder)?)),
        None => None,
    };
    let (key, name, mut fluid) = match named {
        Some((key, mut fluid)) => {
            fluid.override_from(&mut table, Files::Folder(folder))?;
            let name = name.unwrap_or_else(|| fluid.name.clone());
            (key, Some(name), fluid)
        }
        None => {
            if table.contains("viscosity") && !table.contains("density") {
                return Err(table.missing("density").with_help(
                    "such as density = { law = \"dowson-higginson\", rho_0 = \"870 kg/m^3\" }",
                ));
            }
            let fluid = Fluid::from_table(&mut table, "the lubricant", Files::Folder(folder))?;
            ("viscosity", None, fluid)
        }
    };
    if conditions.heat {
        fluid.estimate_heat(&table, "")?;
    }
    let by_kind = conditions.shear && fluid.estimate_shear(&table, "")?;
    let place = (key, name.as_deref());
    let (mut lubricant, warnings) = check(&table, place, fluid, temperature, conditions)?;
    table.finish()?;
    lubricant.is_shear_by_kind = by_kind;
    Ok((lubricant, warnings))
}

/// The laws at the temperature of the case; errors point to `key` of `table`. `name` is that in the database.
fn check(
    table: &Table<'_>,
    (key, name): (&str, Option<&str>),
    fluid: Fluid,
    supplied: f64,
    conditions: Conditions,
) -> Result<(Lubricant, Vec<Warning>), InputError> {
    let Conditions { pressure, heat, .. } = conditions;
    let temperature = conditions.flank_temperature.unwrap_or(supplied);
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
    let reference_temperature = fluid.reference_temperature;
    let mut estimates = fluid.provenance;
    estimates.retain(|datum| datum.status == Status::Estimated);
    let lubricant = Lubricant {
        name: name.map(str::to_owned),
        temperature,
        supply_temperature: conditions.flank_temperature.map(|_| supplied),
        density,
        viscosity: fluid.viscosity,
        shear_thinning: fluid.shear_thinning,
        thermal_conductivity: fluid.thermal_conductivity,
        typical_conductivity: fluid
            .base_oil
            .map(|base_oil| base_oil.heat().conductivity.value),
        heat_capacity: fluid.heat_capacity,
        temperature_ranges,
        estimates,
        is_shear_by_kind: false,
    };
    check_values(table, key, &lubricant, pressure)?;
    let mut warnings: Vec<Warning> = warnings.iter().map(Warning::from).collect();
    warnings.extend(glass(&lubricant, pressure));
    let out_of_range = warnings
        .iter()
        .any(|w| w.kind == WarningKind::TemperatureRange);
    let holds_at = reference_temperature.filter(|_| !out_of_range);
    warnings.extend(without_temperature(&lubricant, holds_at));
    Ok((lubricant, warnings))
}

/// Refuses viscosities and densities that no lubricant has; `pressure` is the Hertz pressure, Pa.
fn check_values(
    table: &Table<'_>,
    key: &str,
    lubricant: &Lubricant,
    pressure: f64,
) -> Result<(), InputError> {
    let temperature = lubricant.temperature;
    let (mu_0, rho_0) = (lubricant.ambient_viscosity(), lubricant.ambient_density());
    for (what, value, bounds, unit) in [
        ("viscosity", mu_0, VISCOSITY, "Pa.s"),
        ("density", rho_0, DENSITY, "kg/m^3"),
    ] {
        if !bounds.contains(value) {
            let text = format!(
                "the {what} at {:.2} °C and ambient pressure is {value:e} {unit}; it must be {}",
                temperature - 273.15,
                bounds.describe(unit)
            );
            return Err(table.error(key, text));
        }
    }
    let ln_mu = lubricant.viscosity.ln_viscosity(pressure, temperature);
    let ln_rho = lubricant.density.density(pressure, temperature).ln();
    for (what, logarithm) in [("viscosity", ln_mu), ("density", ln_rho)] {
        if !logarithm.is_finite() {
            let text = format!("the {what} law fails at the Hertz pressure of {pressure:.3e} Pa");
            return Err(table.error(key, text));
        }
    }
    Ok(())
}

/// Warns of laws without temperature at another temperature than that of their constants, K: that at which the oil is supplied to hot teeth, or
/// `holds_at`.
fn without_temperature(lubricant: &Lubricant, holds_at: Option<f64>) -> Option<Warning> {
    let reason = lubricant.no_temperature()?;
    let temperature = lubricant.temperature;
    let differs = |other: &f64| (temperature - other).abs() > SAME_TEMPERATURE;
    let (other, text) = match lubricant.supply_temperature.filter(differs) {
        Some(supplied) => {
            let text = format!(
                "the teeth are at {:.2} °C and the oil at {:.2} °C, but {reason}: films use the given constants, not those at the temperature of the teeth; \
                 {OILS_WITH_TEMPERATURE}",
                temperature - 273.15,
                supplied - 273.15
            );
            (supplied, text)
        }
        None => {
            let holds_at = holds_at.filter(differs)?;
            let text = format!(
                "the constants of the lubricant apply at {:.2} °C, but its temperature is {:.2} °C, and {reason}: \
                 {OILS_WITH_TEMPERATURE}",
                holds_at - 273.15,
                temperature - 273.15
            );
            (holds_at, text)
        }
    };
    let distance = (temperature - other).abs();
    Some(Warning::beyond(
        WarningKind::TemperatureIgnored,
        distance,
        text,
    ))
}

/// ln of the viscosity, Pa·s, from which a liquid counts as a glass: 1e12 Pa·s, the viscosity of the glass transition in the law of
/// Yasutomi, Bair and Winer (1984).
const LN_GLASS: f64 = 27.631_021_115_928_547;

/// Warns where a law predicts a glass at the Hertz pressure, Pa.
fn glass(lubricant: &Lubricant, pressure: f64) -> Option<Warning> {
    let law = &lubricant.viscosity;
    let logarithm = law.ln_viscosity(pressure, lubricant.temperature);
    let text = format!(
        "the viscosity law ({}) gives 1e{:.0} Pa.s at the Hertz pressure, beyond the glass transition (1e12 Pa.s): the law is extrapolated far \
         beyond its validity, and friction and shear stress are not to be used",
        law.name(),
        logarithm / std::f64::consts::LN_10
    );
    (logarithm > LN_GLASS).then(|| Warning::beyond(WarningKind::Glass, logarithm / LN_GLASS, text))
}
