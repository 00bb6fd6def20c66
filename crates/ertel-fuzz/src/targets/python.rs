//! Arguments that the functions of the Python package pass to the library: names, numbers and texts of any value.

use std::path::Path;

use ertel::case::Case;
use ertel::fit::{self, Data, FilmForm, FilmKind, LawName, Params, Property};
use ertel::study::journal::Record;
use ertel_rheology::database::fluid_or_file;
use serde::Deserialize;

use super::{Verdict, check_text};
use crate::finding::Defect;
use crate::input::{Input, Target};

/// Most numbers of an argument; the package has its own limits.
const MOST: usize = 100;

/// Arguments of calls; numbers as text, that they may be infinite and none.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct Call {
    /// `ertel.Case(...)`: the text that the package makes of its keywords.
    case: String,
    /// `ertel.viscosity(fluid, pressures, temperature)`.
    fluid: String,
    pressures: Vec<String>,
    temperature: String,
    /// `ertel.fit_viscosity(table, law, hold=...)`, `ertel.fit_film(table, form, radius=..., confidence=...)`.
    table: String,
    law: String,
    hold: Vec<(String, String)>,
    form: String,
    radius: String,
    confidence: String,
    /// A line of the journal of a part of a study.
    record: String,
}

/// A number as Python has it.
fn number(text: &str) -> f64 {
    text.trim().parse().unwrap_or(f64::NAN)
}

/// Makes the calls of `call.json`.
pub fn run(input: &Input, folder: &Path) -> Result<Verdict, Defect> {
    let Ok(call) = serde_json::from_slice::<Call>(input.file(Target::Python.main_file())) else {
        return Ok(Verdict::Refused);
    };
    let checked = |text: &str| check_text(&ertel_input::escaped(text)).map(drop);
    if let Err(error) = Case::from_text("case made in Python", &call.case, folder) {
        checked(&error.to_string())?;
    }
    match fluid_or_file(&call.fluid, folder, None) {
        Ok(fluid) => {
            let temperature = number(&call.temperature);
            for pressure in call.pressures.iter().take(MOST).map(|p| number(p)) {
                if temperature.is_finite() && temperature > 0.0 && pressure.is_finite() {
                    fluid.viscosity.viscosity(pressure, temperature);
                    fluid
                        .density
                        .as_ref()
                        .map(|law| law.density(pressure, temperature));
                }
            }
        }
        Err(error) => checked(&error.to_string())?,
    }
    laws(&call, &checked)?;
    films(&call, &checked)?;
    if let Ok(record) = serde_json::from_str::<Record>(&call.record) {
        record.is_unresolved();
    }
    Ok(Verdict::Taken)
}

fn laws(call: &Call, checked: &dyn Fn(&str) -> Result<(), Defect>) -> Result<(), Defect> {
    let Some(law) = LawName::ALL.into_iter().find(|law| law.name() == call.law) else {
        return Ok(());
    };
    let mut held = Vec::new();
    for (key, text) in call.hold.iter().take(MOST) {
        match fit::parse_constant(law, key, text) {
            Ok(value) => held.push((key.clone(), value)),
            Err(error) => return checked(&error.to_string()),
        }
    }
    let property = law.property();
    debug_assert!(matches!(property, Property::Viscosity | Property::Density));
    let data = match Data::parse("data.csv", &call.table, property) {
        Ok(data) => data,
        Err(error) => return checked(&error.to_string()),
    };
    let params = Params {
        held,
        confidence: number(&call.confidence),
        ..Params::default()
    };
    match fit::fit(&data, law, &params) {
        Ok(fit) if !fit.rms().is_finite() => {
            Err(Defect::wrong("a fit that is not finite", law.name()))
        }
        Ok(_) => Ok(()),
        Err(error) => checked(&error.to_string()),
    }
}

fn films(call: &Call, checked: &dyn Fn(&str) -> Result<(), Defect>) -> Result<(), Defect> {
    let form = match FilmForm::named(&call.form, fit::contact_of_films(&call.table)) {
        Ok(form) => form,
        Err(error) => return checked(&error.to_string()),
    };
    let radius = Some(number(&call.radius)).filter(|radius| radius.is_finite() && *radius > 0.0);
    let films = match fit::read_films("data.csv", &call.table, form, FilmKind::Central, radius) {
        Ok(Some(films)) => films,
        Ok(None) => return Ok(()),
        Err(error) => return checked(&error.to_string()),
    };
    match fit::fit_film(&films, number(&call.confidence)) {
        Ok(_) => Ok(()),
        Err(error) => checked(&error.to_string()),
    }
}
