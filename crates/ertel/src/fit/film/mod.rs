//! Film-thickness formulas from computed or measured films.

mod blend;
mod conditions;
mod ellipse;
mod form;
mod formula;
mod found;
mod geometry;
mod header;
mod parity;
mod power;
mod table;

pub use form::{FilmForm, FilmKind, FilmState, FormError, Variable};
pub use found::{Estimate, FilmFit, FilmFitError};
pub use parity::parity;
pub use table::{
    Films, Given, contact_of_films, contact_of_films_with, read_films, read_films_with,
};

/// Fits the films' form by least squares of `ln h`. The exponent of a variable that does not vary is omitted; its power
/// is then part of c, and a warning says so.
///
/// # Errors
///
/// [`FilmFitError`].
pub fn fit_film(films: &Films, confidence: f64) -> Result<FilmFit, FilmFitError> {
    if !(confidence > 0.0 && confidence < 1.0) {
        return Err(FilmFitError::Confidence(confidence));
    }
    let n_variables = films.form.variables().len();
    let ranges: Vec<[f64; 2]> = (0..n_variables)
        .map(|i| {
            let values = films.states.iter().map(|s| s.variables[i]);
            values.fold([f64::INFINITY, 0.0f64], |[low, high], v| {
                [low.min(v), high.max(v)]
            })
        })
        .collect();
    let found = match films.form {
        FilmForm::Blend(contact) => blend::fit(films, contact, confidence)?,
        FilmForm::Elliptical => ellipse::fit(films, &ranges, confidence)?,
        FilmForm::Moes | FilmForm::HamrockDowson(_) | FilmForm::Speed | FilmForm::SpeedLoad(_) => {
            power::fit(films, &ranges, confidence)?
        }
    };
    let deviations: Vec<f64> = found.residuals.iter().map(|r| r.exp_m1()).collect();
    if let Some(i) = deviations.iter().position(|d| !d.is_finite()) {
        return Err(FilmFitError::NotFinite(i + 1));
    }
    let is_finite = |e: &Estimate| {
        let [low, high] = e.interval;
        e.value.is_finite() && low.is_finite() && high.is_finite()
    };
    let constants = found.constants.iter().zip(films.form.constants());
    for (constant, name) in constants {
        if constant.as_ref().is_some_and(|e| !is_finite(e)) {
            return Err(FilmFitError::NoInterval(name));
        }
    }
    let has_bars = films.states.iter().all(|s| s.error.is_some());
    Ok(FilmFit {
        form: films.form,
        kind: films.kind,
        constants: found.constants,
        widened: has_bars.then_some(found.widened),
        ranges,
        deviations,
        confidence,
        warnings: [films.warnings.clone(), found.warnings].concat(),
    })
}
