//! Oils by their data sheet.

mod base_oil;
mod coefficient;
mod data;
mod viscosity;

pub(super) use self::base_oil::read_base_oil;
pub(super) use self::data::{computed, datum_of, figures, given};

use self::base_oil::needs_base_oil;
use self::coefficient::COEFFICIENTS;
use self::data::{CELSIUS_40, CELSIUS_100, estimated, twice};
use self::viscosity::{ANY, AT_ANY, DYNAMIC, KINEMATIC, has_dynamic, points};
use super::{locate, reference_temperature};
use crate::data_sheet::{BaseOil, WATER_AT_15, viscosity_index};
use crate::density::{DowsonHigginson, ThermalExpansion};
use crate::provenance::{Datum, ValidityRange};
use crate::viscosity::{PressureLaw, Walther};
use crate::{DensityLaw, ViscosityLaw};
use ertel_input::{Bounds, InputError, Table};
use ertel_quantity::Dimension;

/// Keys of a data sheet. `reference_temperature` is one of the fluid, and so is `base_oil`, of which heat and shear are estimated.
const KEYS: [&str; 7] = [
    "iso_vg",
    "viscosity_index",
    "density_15",
    "density_20",
    "relative_density_15",
    "pressure_viscosity_coefficient",
    "pressure_law",
];

/// Those of the density.
const DENSITY_KEYS: [&str; 3] = ["density_15", "density_20", "relative_density_15"];

/// 120, with what the rounding of viscosities may take off.
const LOWEST_INDEX_OF_GROUP_III: f64 = 115.0;
const CELSIUS_15: f64 = 288.15;
const CELSIUS_20: f64 = 293.15;
/// The laws of an oil, and where their numbers come from.
pub(super) struct Sheet {
    pub density: DensityLaw,
    pub viscosity: ViscosityLaw,
    pub reference_temperature: f64,
    pub validity: ValidityRange,
    pub provenance: Vec<Datum>,
}

/// Whether the table has keys of a data sheet; the first of them.
pub(super) fn first_key(table: &mut Table<'_>) -> Option<&'static str> {
    let of_temperature = KINEMATIC.iter().chain(&DYNAMIC).chain(&COEFFICIENTS);
    let at_any = AT_ANY.into_iter().chain([ANY]);
    let mut all = (of_temperature.map(|(key, _)| *key))
        .chain(at_any)
        .chain(KEYS);
    all.find(|key| table.contains(key))
}

/// The law of the density that the keys of a data sheet make; `None` where the table has none of the density.
pub(super) fn density(table: &mut Table<'_>) -> Result<Option<DensityLaw>, InputError> {
    if !DENSITY_KEYS.iter().any(|key| table.contains(key)) {
        return Ok(None);
    }
    let base_oil = read_base_oil(table)?;
    read_density(table, base_oil, &mut Vec::new()).map(Some)
}

/// Reads the keys of a data sheet. `density` is the law of the density where the table has one.
pub(super) fn read(
    table: &mut Table<'_>,
    density: Option<DensityLaw>,
) -> Result<Sheet, InputError> {
    let base_oil = read_base_oil(table)?;
    let mut data = Vec::new();
    if let Some(base_oil) = base_oil {
        data.push(given(table, "base_oil", base_oil.name().to_owned(), ""));
    }
    // A dynamic viscosity becomes a kinematic one by the density.
    let first = match has_dynamic(table) {
        true => Some(density_law(table, density.clone(), base_oil, &mut data)?),
        false => None,
    };
    let points = points(table, first.as_ref(), base_oil, &mut data)?;
    check_group(table, base_oil, points)?;
    let density = match first {
        Some(law) => law,
        None => density_law(table, density, base_oil, &mut data)?,
    };
    let reference = match table.contains("reference_temperature") {
        true => Some(reference_temperature(table)?),
        false => None,
    };
    let (a, b) = Walther::constants(points);
    let mut law = Walther {
        a,
        b,
        density: density.clone(),
        alpha: 0.0,
        reference_temperature: reference.unwrap_or(CELSIUS_40),
        alpha_exponent: 0.0,
        pressure: table
            .optional_choice("pressure_law", &PressureLaw::NAMES)?
            .unwrap_or(PressureLaw::Roelands),
    };
    coefficient::read(table, &mut law, base_oil, &mut data)?;
    let reference = reference.unwrap_or(law.reference_temperature);
    let viscosity = Walther::new(law).map_err(locate(table))?;
    Ok(Sheet {
        density,
        viscosity: ViscosityLaw::Walther(viscosity),
        reference_temperature: reference,
        validity: ValidityRange {
            pressure: Some((0.0, 3000.0 * 101_325.0)),
            temperature: Some((CELSIUS_20, 423.15)),
            source: "Roelands et al. 1963".to_owned(),
            of_law: true,
        },
        provenance: data,
    })
}

/// Refuses an oil of Group III with a lower viscosity index than such oils have.
fn check_group(
    table: &Table<'_>,
    base_oil: Option<BaseOil>,
    points: [viscosity::Point; 2],
) -> Result<(), InputError> {
    let [nu_40, nu_100] = [CELSIUS_40, CELSIUS_100].map(|t| viscosity::viscosity_of(points, t));
    match (base_oil, viscosity_index(nu_40, nu_100)) {
        (Some(BaseOil::GroupIII), Some(index)) if index < LOWEST_INDEX_OF_GROUP_III => {
            let problem = format!(
                "an oil of Group III has a viscosity index of 120 and above (API 1509), the viscosities give {index:.0}"
            );
            Err(table.error("base_oil", problem).with_help(
                "a mineral oil with a lower index is of Group I or II, `base_oil = \"mineral\"`",
            ))
        }
        _ => Ok(()),
    }
}

/// The law that the table has, or the one by the density of the sheet.
fn density_law(
    table: &mut Table<'_>,
    law: Option<DensityLaw>,
    base_oil: Option<BaseOil>,
    data: &mut Vec<Datum>,
) -> Result<DensityLaw, InputError> {
    let Some(law) = law else {
        return read_density(table, base_oil, data);
    };
    match DENSITY_KEYS.into_iter().find(|key| table.contains(key)) {
        None => Ok(law),
        Some(key) => Err(twice(table, key, "density")),
    }
}

/// Dowson and Higginson's law with the density at 15 or 20 degC and the expansion of the kind of oil.
fn read_density(
    table: &mut Table<'_>,
    base_oil: Option<BaseOil>,
    data: &mut Vec<Datum>,
) -> Result<DensityLaw, InputError> {
    let bounds = Bounds::closed(500.0, 2500.0);
    let mut found = Vec::new();
    for (key, temperature) in [("density_15", CELSIUS_15), ("density_20", CELSIUS_20)] {
        if let Some(rho) = table.optional_quantity(key, Dimension::DENSITY, bounds)? {
            data.push(given(table, key, figures(rho), "kg/m^3"));
            found.push((key, rho, temperature));
        }
    }
    let key = "relative_density_15";
    if let Some(relative) = table.optional_number(key, Bounds::closed(0.5, 2.5))? {
        data.push(given(table, key, relative.to_string(), "1"));
        found.push((key, relative * WATER_AT_15, CELSIUS_15));
    }
    let (rho_0, reference_temperature) = match (&found[..], base_oil) {
        ([(first, ..), (key, ..), ..], _) => return Err(twice(table, key, first)),
        ([(_, rho, temperature)], _) => (*rho, *temperature),
        ([], Some(base_oil)) => {
            let typical = base_oil.density_at_15();
            let unit = (1.0, "kg/m^3");
            let rho = estimated(
                table,
                data,
                ("density_15", &typical),
                Dimension::DENSITY,
                unit,
            );
            (rho, CELSIUS_15)
        }
        ([], None) => {
            return Err(needs_base_oil(table, "density_15"));
        }
    };
    let Some(base_oil) = base_oil else {
        return Err(needs_base_oil(table, "base_oil"));
    };
    let expansion = base_oil.expansion();
    let of_temperature = Dimension::INVERSE_TEMPERATURE;
    // The share is of the density at 15 degC.
    let beta = estimated(
        table,
        data,
        ("density.beta", &expansion),
        of_temperature,
        (1.0, "1/K"),
    );
    let beta = beta / (1.0 - beta * (reference_temperature - CELSIUS_15));
    let thermal = ThermalExpansion {
        reference_temperature,
        temperature_coefficient: beta,
    };
    let law = DowsonHigginson::new(rho_0, Some(thermal)).map_err(locate(table))?;
    Ok(DensityLaw::DowsonHigginson(law))
}
