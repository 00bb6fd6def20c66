//! Blends of oils from a table.

use std::path::Path;

use super::data_sheet::{computed, figures, given};
use crate::data_sheet::{Blend, BlendError};
use crate::provenance::{Datum, Status, ValidityRange};
use crate::{Fluid, database};
use ertel_input::{Bounds, InputError, Table};

const KEY: &str = "blend";
/// Distance of the sum of the shares from 1 that rounding explains.
const TOLERANCE: f64 = 1e-3;
const EXAMPLE: &str = "such as blend = [{ name = \"iso-vg-220-mineral\", share = 0.7 }, { name = \"pao-40\", share = 0.3 }]";

impl Fluid {
    /// Reads `blend = [{ name = "..", share = 0.6 }, { name = "..", share = 0.4 }]`, an oil blended of fluids of the database or of files in
    /// `folder`, with their shares of the mass; [`Blend`] says how. Data of a part are noted below `blend.NAME`.
    ///
    /// Estimated data of a part are in the provenance of the blend, prefixed with the name of the part. The kind of the base oil is
    /// that of the parts, if they have one in common.
    ///
    /// # Errors
    ///
    /// Fewer than two parts, a part twice, unknown names, shares that do not sum to 1, parts that cannot be blended: each with its line.
    pub fn from_blend(table: &mut Table<'_>, folder: &Path) -> Result<Self, InputError> {
        let mut shares = Vec::new();
        let mut fluids: Vec<Fluid> = Vec::new();
        let mut names: Vec<String> = Vec::new();
        for mut part in table.tables(KEY)? {
            let name = part.required_str("name")?;
            if names.iter().any(|other| other == name) {
                return Err(part.error("name", format!("`{name}` is in the blend twice")));
            }
            let inputs = table.recorder(&format!("{KEY}.{name}"));
            let fluid = database::fluid_or_file(name, folder, inputs)
                .map_err(|error| part.error("name", error.to_string()))?;
            shares.push(part.required_number("share", Bounds::open(0.0, 1.0))?);
            part.finish()?;
            fluids.push(fluid);
            names.push(name.to_owned());
        }
        if fluids.len() < 2 {
            let problem = "a blend needs two oils or more";
            return Err(table.error(KEY, problem).with_help(EXAMPLE));
        }
        let sum: f64 = shares.iter().sum();
        if (sum - 1.0).abs() > TOLERANCE {
            let problem = format!("the shares of the mass sum to {}, not to 1", figures(sum));
            return Err(table.error(KEY, problem).with_help(EXAMPLE));
        }
        let parts: Vec<(f64, &Fluid)> = (shares.iter().map(|share| share / sum))
            .zip(&fluids)
            .collect();
        let blend = Blend::new(&parts).map_err(|error| refused(table, &error))?;
        let percent = |share: f64| figures(100.0 * share);
        let described: Vec<String> = (parts.iter())
            .map(|(share, fluid)| format!("{} {} %", fluid.name, percent(*share)))
            .collect();
        let name = format!("blend of {}", described.join(", "));
        let kind = fluids[0].base_oil;
        let mut fluid = fluids[0].clone();
        fluid.provenance = provenance(table, &parts, &blend);
        fluid.title.clone_from(&name);
        fluid.name = name;
        fluid.viscosity = blend.viscosity;
        fluid.density = Some(blend.density);
        fluid.reference_temperature = Some(crate::data_sheet::BLENDING_TEMPERATURES[0]);
        fluid.thermal_conductivity = None;
        fluid.heat_capacity = None;
        fluid.base_oil = kind.filter(|_| fluids.iter().all(|part| part.base_oil == kind));
        fluid.validity = validity(&fluids);
        fluid.notes = Vec::new();
        Ok(fluid)
    }
}

fn refused(table: &Table<'_>, error: &BlendError) -> InputError {
    let help = match error {
        BlendError::NoDensity { .. } => "give it a density in a file of your own",
        BlendError::NoTemperature { .. } | BlendError::TemperatureRange { .. } => {
            "give its viscosities at both temperatures, as a data sheet in a file of your own"
        }
        BlendError::ShearThinning { .. } => {
            "ASTM D7152 excludes such oils, and those with viscosity index improvers: measure the blend"
        }
        BlendError::Law(_) => "check the viscosities of the parts",
    };
    table.error(KEY, error.to_string()).with_help(help)
}

/// The pressures and temperatures that the data of all parts cover.
fn validity(fluids: &[Fluid]) -> Option<ValidityRange> {
    let known: Vec<&ValidityRange> = fluids.iter().filter_map(|f| f.validity.as_ref()).collect();
    let common = |of: &dyn Fn(&ValidityRange) -> Option<(f64, f64)>| {
        let ranges = known.iter().filter_map(|range| of(range));
        ranges.reduce(|(a, b), (c, d)| (a.max(c), b.min(d)))
    };
    let (pressure, temperature) = (common(&|v| v.pressure), common(&|v| v.temperature));
    let first = known.first()?;
    let of_law = known.iter().all(|range| range.of_law);
    Some(ValidityRange {
        pressure: pressure.filter(|(low, high)| low <= high),
        temperature: temperature.filter(|(low, high)| low <= high),
        source: match of_law {
            true => first.source.clone(),
            false => "what the data of all parts of the blend cover".to_owned(),
        },
        of_law,
    })
}

fn provenance(table: &Table<'_>, parts: &[(f64, &Fluid)], blend: &Blend) -> Vec<Datum> {
    let mut data = Vec::new();
    for ((share, part), volume) in parts.iter().zip(&blend.volume_shares) {
        let name = &part.name;
        data.push(given(
            table,
            &format!("blend.{name}"),
            share.to_string(),
            "1",
        ));
        let key = format!("blend.{name}.volume_share");
        data.push(computed(&key, figures(*volume), "1", "volumes add"));
    }
    for (at, (nu, alpha)) in ["40", "100"]
        .iter()
        .zip(blend.kinematic_viscosities.iter().zip(blend.coefficients))
    {
        let key = format!("kinematic_viscosity_{at}");
        data.push(computed(&key, figures(1e6 * nu), "mm^2/s", "astm_d7152"));
        let key = format!("pressure_viscosity_coefficient_{at}");
        let value = figures(1e9 * alpha);
        data.push(computed(&key, value, "1/GPa", "by volume"));
    }
    for (_, part) in parts {
        let estimates = part.provenance.iter();
        data.extend(
            estimates
                .filter(|datum| datum.status == Status::Estimated)
                .map(|datum| Datum {
                    key: format!("{}.{}", part.name, datum.key),
                    ..datum.clone()
                }),
        );
    }
    data
}
