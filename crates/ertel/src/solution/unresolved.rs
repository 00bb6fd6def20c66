//! Figures that a mesh does not resolve.

use serde::Serialize;

use super::{Estimate, Figure, Summary, Thermal, Traction};

/// A figure that the case is solved for, with an error bar wider than half of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unresolved {
    /// Which.
    pub figure: Figure,
    /// Its value, SI; of a temperature the rise.
    pub estimate: Estimate,
}

impl Serialize for Unresolved {
    /// As the figure's name.
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.figure.name())
    }
}

/// Share of a figure that its error bar may reach.
const WIDEST: f64 = 0.5;

/// Rise of temperature that counts, K.
const LEAST_RISE: f64 = 1.0;

impl Unresolved {
    /// Those of a solution: films, traction where the surfaces slide, the largest rise of the film's temperature.
    pub fn all(
        summary: &Summary,
        traction: &Traction,
        slides: bool,
        thermal: Option<&Thermal>,
    ) -> Vec<Unresolved> {
        let films = [
            (Figure::FilmCentral, summary.film_central),
            (Figure::FilmMinimum, summary.film_minimum),
        ];
        let traction = slides.then_some((Figure::TractionCoefficient, traction.size()));
        let rise = thermal.map(|t| Estimate {
            value: t.film_maximum.value - t.inlet_temperature,
            error: t.film_maximum.error,
        });
        let rise = rise.filter(|rise| rise.value > LEAST_RISE);
        (films.into_iter())
            .chain(traction)
            .chain(rise.map(|rise| (Figure::FilmTemperatureMaximum, rise)))
            .filter(|(_, e)| e.error.is_some_and(|error| error > WIDEST * e.value.abs()))
            .map(|(figure, estimate)| Unresolved { figure, estimate })
            .collect()
    }

    /// `the minimum film thickness`.
    pub fn words(&self) -> &'static str {
        match self.figure {
            Figure::FilmCentral => "the central film thickness",
            Figure::FilmMinimum => "the minimum film thickness",
            Figure::TractionCoefficient => "the traction coefficient",
            Figure::FilmTemperatureMaximum => "the largest rise of the film's temperature",
            other => other.name(),
        }
    }
}
