//! Lubricants, materials and fits.

use std::path::{Path, PathBuf};

use ertel::fit::{self, Data, Heading, LawName, Params, Property};
use ertel::solution::Field;
use ertel_rheology::database;
use pyo3::prelude::*;

use crate::errors::{self, CaseError};

/// Names of the lubricants (`kind = "fluids"`) or solids of the database, own ones first.
#[pyfunction]
pub fn names(kind: &str) -> PyResult<Vec<String>> {
    let own = database::own_data();
    let (own, shipped) = match kind {
        "fluids" => (own.map(|own| &own.fluids), database::fluid_names()),
        "solids" => (own.map(|own| &own.solids), database::solid_names()),
        _ => return Err(CaseError::new_err(format!("`{kind}`: fluids or solids"))),
    };
    let mut names = own.cloned().unwrap_or_default();
    for name in shipped {
        if !names.iter().any(|own| own == name) {
            names.push(name.to_owned());
        }
    }
    Ok(names)
}

/// Low-shear viscosity (Pa.s) and density (kg/m^3, not a number without a law) of a lubricant at pressures (Pa) and a temperature (K).
#[pyfunction]
pub fn viscosity(
    name: &str,
    pressures: Vec<f64>,
    temperature: f64,
) -> PyResult<(Vec<f64>, Vec<f64>)> {
    let fluid = database::fluid_or_file(name, Path::new(""), None).map_err(errors::database)?;
    if !(temperature.is_finite() && temperature > 0.0) || pressures.iter().any(|p| !p.is_finite()) {
        return Err(CaseError::new_err(
            "pressures and the temperature (K) are finite numbers, the temperature above zero",
        ));
    }
    let viscosity = pressures
        .iter()
        .map(|p| fluid.viscosity.viscosity(*p, temperature));
    let density = pressures.iter().map(|p| {
        let law = fluid.density.as_ref();
        law.map_or(f64::NAN, |law| law.density(*p, temperature))
    });
    Ok((viscosity.collect(), density.collect()))
}

/// Sets the folder of own lubricants and materials, once for the process.
#[pyfunction]
pub fn use_own_data(folder: PathBuf) -> PyResult<()> {
    database::use_own_data(&folder).map_err(errors::database)?;
    Ok(())
}

/// Fits a law to the text of a CSV table; returns constants (key, SI value, unit in which it is shown, SI interval), the rms of the
/// relative deviations, warnings, and the text of a file for the lubricant.
#[pyfunction]
#[pyo3(signature = (property, file, text, law, hold, title, source))]
#[allow(clippy::type_complexity)]
pub fn fit_law(
    property: &str,
    file: &str,
    text: &str,
    law: &str,
    hold: Vec<(String, String)>,
    title: &str,
    source: &str,
) -> PyResult<(
    Vec<(String, f64, String, Option<[f64; 2]>)>,
    f64,
    Vec<String>,
    String,
)> {
    let bad = |text: String| CaseError::new_err(text);
    let property = match property {
        "viscosity" => Property::Viscosity,
        "density" => Property::Density,
        _ => return Err(bad(format!("`{property}`: viscosity or density"))),
    };
    let law = (LawName::ALL.into_iter())
        .find(|own| own.name() == law && own.property() == property)
        .ok_or_else(|| {
            let choices = LawName::choices(property);
            bad(format!(
                "law `{law}`: the laws for the {} are {choices}",
                property.name()
            ))
        })?;
    let held = (hold.iter())
        .map(|(key, text)| Ok((key.clone(), fit::parse_constant(law, key, text)?)))
        .collect::<Result<Vec<_>, fit::FitError>>()
        .map_err(|e| bad(e.to_string()))?;
    let data = Data::parse(file, text, property).map_err(|e| bad(e.to_string()))?;
    let params = Params {
        held,
        ..Params::default()
    };
    let found = fit::fit(&data, law, &params).map_err(|e| bad(format!("{file}: {e}")))?;
    let constants = (found.constants.iter())
        .map(|c| (c.key.to_owned(), c.value, c.unit.to_owned(), c.interval))
        .collect();
    let mut warnings = found.warnings.clone();
    warnings.extend(fit::nonsense(&found, &data));
    let heading = Heading {
        title: title.to_owned(),
        source: source.to_owned(),
    };
    Ok((
        constants,
        found.rms(),
        warnings,
        fit::entry(&found, &data, &heading),
    ))
}

/// Name, unit and words of every field.
#[pyfunction]
pub fn field_names() -> Vec<(&'static str, &'static str, &'static str)> {
    Field::ALL.map(|f| (f.name(), f.unit(), f.words())).to_vec()
}
