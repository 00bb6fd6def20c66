//! Lubricants, materials and fits.

use std::path::{Path, PathBuf};

use ertel::fit::{self, Data, FilmForm, FilmKind, Heading, LawName, Params, Property, Reading};
use ertel::solution::{Field, Figure};
use ertel::warning::WarningKind;
use ertel_input::file::read_table;
use ertel_quantity::Dimension;
use ertel_rheology::viscosity::PressureLaw;
use ertel_rheology::{DensityLaw, Isotherms, database};
use pyo3::prelude::*;

use crate::errors::{self, CaseError};

/// Meaning, limit and remedy of the code of a warning.
#[pyfunction]
pub fn explanation(code: &str) -> PyResult<[&'static str; 3]> {
    let kind = WarningKind::with_code(code).ok_or_else(|| {
        let all: Vec<&str> = WarningKind::ALL.iter().map(|kind| kind.code()).collect();
        CaseError::new_err(format!(
            "`{code}` is not a code of warnings; the codes are {}",
            all.join(", ")
        ))
    })?;
    let e = kind.explanation();
    Ok([e.meaning, e.limit, e.remedy])
}

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

/// Values of the table law at places (Pa, K): isotherms at `temperatures` (K) over the same `pressures` (Pa), with a row of values (SI) for each;
/// of a viscosity (`of_logarithms`) their logarithms are interpolated, as the law does.
#[pyfunction]
pub fn interpolated(
    of_logarithms: bool,
    temperatures: Vec<f64>,
    pressures: Vec<f64>,
    values: Vec<Vec<f64>>,
    places: Vec<(f64, f64)>,
) -> PyResult<Vec<f64>> {
    let pressures = vec![pressures; temperatures.len()];
    let table = match of_logarithms {
        true => Isotherms::of_logarithms(temperatures, pressures, values),
        false => Isotherms::straight(temperatures, pressures, values),
    };
    let table = table.map_err(|error| CaseError::new_err(error.to_string()))?;
    let at = places.into_iter().map(|(p, t)| table.evaluate(p, t));
    Ok(match of_logarithms {
        true => at.map(f64::exp).collect(),
        false => at.collect(),
    })
}

/// Sets the folder of own lubricants and materials, once for the process.
#[pyfunction]
pub fn use_own_data(folder: PathBuf) -> PyResult<()> {
    database::use_own_data(&folder).map_err(errors::database)?;
    Ok(())
}

/// Text of a table of measurements: of a regular file of bounded size.
#[pyfunction]
pub fn table_text(path: PathBuf) -> PyResult<String> {
    read_table(&path).map_err(|error| CaseError::new_err(format!("{} {error}", path.display())))
}

/// Fits a law to the text of a CSV table; returns constants (key, SI value, unit in which it is shown, SI interval), the rms of the
/// relative deviations, warnings, and the text of a file for the lubricant.
#[pyfunction]
#[pyo3(signature = (property, file, text, law, hold, title, source, density, reference_temperature, pressure_law))]
#[allow(clippy::type_complexity, clippy::too_many_arguments)]
pub fn fit_law(
    property: &str,
    file: &str,
    text: &str,
    law: &str,
    hold: Vec<(String, String)>,
    title: &str,
    source: &str,
    density: Option<&str>,
    reference_temperature: Option<&str>,
    pressure_law: &str,
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
    let density = density
        .map(|name| fit::density_of(name).map_err(|e| bad(format!("density {name}: {e}"))))
        .transpose()?;
    let reference_temperature = reference_temperature
        .map(|text| {
            ertel_quantity::parse(text, Dimension::TEMPERATURE)
                .map_err(|e| bad(format!("reference_temperature: {e}")))
        })
        .transpose()?;
    let (_, pressure_law) = (PressureLaw::NAMES.iter())
        .find(|(name, _)| *name == pressure_law)
        .ok_or_else(|| bad(format!("pressure_law `{pressure_law}`: roelands or barus")))?;
    let reading = Reading {
        density: density.clone(),
        may_be_ambient: law == LawName::Walther,
        ..Reading::default()
    };
    let data = Data::read(file, text, property, &reading).map_err(|e| bad(e.to_string()))?;
    let equation_of_state = match &density {
        Some(DensityLaw::Tait(tait)) => Some(tait.volume.clone()),
        _ => None,
    };
    let params = Params {
        held,
        reference_temperature,
        equation_of_state,
        density,
        pressure_law: *pressure_law,
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

/// Fits a film-thickness formula to the text of a table of films; returns for each film its name, the constants (name, value, interval; nothing for the
/// exponent of what does not vary), the rms of formula/film - 1, and warnings.
#[pyfunction]
#[pyo3(signature = (file, text, form, radius, confidence))]
#[allow(clippy::type_complexity)]
pub fn fit_film(
    file: &str,
    text: &str,
    form: &str,
    radius: Option<f64>,
    confidence: f64,
) -> PyResult<
    Vec<(
        &'static str,
        Vec<(&'static str, Option<(f64, [f64; 2])>)>,
        f64,
        Vec<String>,
    )>,
> {
    let bad = |text: String| CaseError::new_err(text);
    if radius.is_some_and(|r| !(r.is_finite() && r > 0.0)) {
        return Err(bad(
            "the radius (m) is a finite number above zero".to_owned()
        ));
    }
    let form = FilmForm::named(form, fit::contact_of_films(text))
        .map_err(|e| bad(format!("{file}: {e}")))?;
    let mut fits = Vec::new();
    for kind in [FilmKind::Central, FilmKind::Minimum] {
        // The asymptotes are those of the central film.
        if kind == FilmKind::Minimum && matches!(form, FilmForm::Blend(_)) {
            continue;
        }
        let films =
            fit::read_films(file, text, form, kind, radius).map_err(|e| bad(e.to_string()))?;
        let Some(films) = films else { continue };
        let fit = fit::fit_film(&films, confidence).map_err(|e| bad(format!("{file}: {e}")))?;
        let constants = (form.constants().iter().zip(&fit.constants))
            .map(|(name, found)| (*name, found.as_ref().map(|c| (c.value, c.interval))))
            .collect();
        fits.push((kind.name(), constants, fit.rms(), fit.warnings.clone()));
    }
    if fits.is_empty() {
        return Err(bad(format!(
            "{file}: there is neither a column film_central_m nor film_minimum_m"
        )));
    }
    Ok(fits)
}

/// Title, names of the laws (viscosity, shear thinning, density), reference temperature (K), notes and sources of a lubricant.
#[pyfunction]
#[allow(clippy::type_complexity)]
pub fn fluid(
    name: &str,
) -> PyResult<(
    String,
    [Option<String>; 3],
    Option<f64>,
    Vec<String>,
    Vec<(String, String, String)>,
)> {
    let fluid = database::fluid_or_file(name, Path::new(""), None).map_err(errors::database)?;
    let laws = [
        Some(fluid.viscosity.name().to_owned()),
        fluid
            .shear_thinning
            .as_ref()
            .map(|law| law.name().to_owned()),
        fluid.density.as_ref().map(|law| law.name().to_owned()),
    ];
    let sources = (fluid.provenance.iter())
        .map(|d| (d.key.clone(), d.value.clone(), d.source.clone()))
        .collect();
    Ok((
        fluid.title,
        laws,
        fluid.reference_temperature,
        fluid.notes,
        sources,
    ))
}

/// Name, unit and words of every field.
#[pyfunction]
pub fn field_names() -> Vec<(&'static str, &'static str, &'static str)> {
    Field::ALL.map(|f| (f.name(), f.unit(), f.words())).to_vec()
}

/// Name, words and symbol of every figure, in the order of the report; symbols of those that are shown first.
#[pyfunction]
pub fn figure_names() -> Vec<(&'static str, &'static str, &'static str)> {
    Figure::ALL
        .map(|f| (f.name(), f.words(), f.symbol()))
        .to_vec()
}
