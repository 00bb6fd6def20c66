//! Measured states and films, fitted by every law and form.

use ertel::fit::{self, Data, FilmForm, FilmKind, Heading, LawName, Params, Property, Reading};
use ertel_rheology::DensityLaw;

use super::{Verdict, check_text, n_lines};
use crate::finding::Defect;
use crate::input::{Input, Target};

/// Name of the file in errors.
const FILE: &str = "data.csv";

/// Fits what stands in `data.csv`.
pub fn run(input: &Input) -> Result<Verdict, Defect> {
    // As the reader of files does: what is no text is refused with its line.
    let Ok(text) = std::str::from_utf8(input.file(FILE)) else {
        return Ok(Verdict::Refused);
    };
    match input.target {
        Target::FitViscosity => laws(text, Property::Viscosity),
        Target::FitDensity => laws(text, Property::Density),
        _ => films(text),
    }
}

fn laws(text: &str, property: Property) -> Result<Verdict, Defect> {
    // As a data sheet has them: without pressures, kinematic viscosities without densities.
    let density = DensityLaw::constant(870.0).ok();
    let sheet = Reading {
        density: density.clone(),
        may_be_ambient: true,
        ..Reading::default()
    };
    if let Ok(data) = Data::read(FILE, text, property, &sheet) {
        let held = Params {
            held: vec![("alpha".into(), 20e-9)],
            reference_temperature: Some(313.15),
            density: density.clone(),
            ..Params::default()
        };
        if property == Property::Viscosity {
            fitted(&data, LawName::Walther, &held)?;
        }
    }
    let data = match Data::parse(FILE, text, property) {
        Ok(data) => data,
        Err(error) => return check_csv(&error, text),
    };
    let params = Params {
        density,
        ..Params::default()
    };
    for law in LawName::ALL
        .into_iter()
        .filter(|law| law.property() == property)
    {
        fitted(&data, law, &params)?;
    }
    Ok(Verdict::Taken)
}

/// One fit, with its entry and its picture.
fn fitted(data: &Data, law: LawName, params: &Params) -> Result<(), Defect> {
    match fit::fit(data, law, params) {
        Ok(fit) => {
            let heading = Heading {
                title: "a fluid".into(),
                source: FILE.into(),
            };
            fit::entry(&fit, data, &heading);
            fit::picture(&fit, data, &heading.title).svg();
            let (_, worst) = fit.worst();
            if !fit.rms().is_finite() || !worst.is_finite() {
                let message = format!("{}: rms {}, worst {worst}", law.name(), fit.rms());
                return Err(Defect::wrong("a fit that is not finite", message));
            }
        }
        Err(error) => drop(check_text(&error.to_string())?),
    }
    Ok(())
}

fn films(text: &str) -> Result<Verdict, Defect> {
    let contact = fit::contact_of_films(text);
    let mut verdict = Verdict::Refused;
    for name in FilmForm::NAMES {
        let form = match FilmForm::named(name, contact) {
            Ok(form) => form,
            Err(error) => {
                check_text(&error.to_string())?;
                continue;
            }
        };
        for kind in [FilmKind::Central, FilmKind::Minimum] {
            if kind == FilmKind::Minimum && matches!(form, FilmForm::Blend(_)) {
                continue;
            }
            match fit::read_films(FILE, text, form, kind, Some(0.01)) {
                Ok(None) => {}
                Ok(Some(films)) => match fit::fit_film(&films, 0.95) {
                    Ok(fit) => {
                        let parts = [fit.text(), fit.latex(), fit.code()];
                        if !fit.rms().is_finite() || parts.iter().any(|p| p.contains("NaN")) {
                            return Err(Defect::wrong(
                                "a formula that is not finite",
                                parts.join("\n"),
                            ));
                        }
                        fit.warnings
                            .iter()
                            .try_for_each(|w| check_text(w).map(drop))?;
                        fit::parity(&[(fit, films)], FILE).svg();
                        verdict = Verdict::Taken;
                    }
                    Err(error) => drop(check_text(&error.to_string())?),
                },
                Err(error) => drop(check_csv(&error, text)?),
            }
        }
    }
    Ok(verdict)
}

fn check_csv(error: &fit::DataError, text: &str) -> Result<Verdict, Defect> {
    if error.line == 0 || error.line > n_lines(text.as_bytes()) || error.column == 0 {
        return Err(Defect::wrong(
            "an error outside its table",
            error.to_string(),
        ));
    }
    check_text(&error.to_string())
}
