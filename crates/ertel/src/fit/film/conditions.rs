//! Conditions that differ between the films of a table, other than the variables of a form.

use ertel_input::csv::{Column, CsvTable, Row};
use ertel_input::excerpt;
use ertel_quantity::Dimension;

use super::FilmForm;
use crate::fit::DataError;
use crate::study::ISOTHERMAL;
use crate::words::digits;

/// Columns that a form over the speed does not know, with their words: none of them should vary.
const CONDITIONS: [(&str, &str, Dimension); 4] = [
    ("load", "the load", Dimension::FORCE),
    ("load", "the load", Dimension::FORCE_PER_LENGTH),
    ("temperature", "the temperature", Dimension::TEMPERATURE),
    ("radius", "the radius", Dimension::LENGTH),
];
/// Ratio of largest to smallest value from which a condition varies. It is the rounding of the table; converting its unit
/// rounds it.
const LEAST_VARIATION: f64 = 1.0 + 1e-6;

/// Column that distinguishes thermal films from isothermal ones.
enum Heat {
    /// A temperature of the film: only films with heat have one.
    Temperature(usize),
    /// The switch of a study's axis.
    Switch(usize),
}

/// Conditions of the films seen so far.
pub(super) struct Conditions {
    /// Word, column, smallest and largest value.
    columns: Vec<(&'static str, Column, [f64; 2])>,
    heat: Option<Heat>,
    n_thermal: usize,
    n_isothermal: usize,
}

impl Conditions {
    /// Conditions that a form neglects, of a table with this header.
    ///
    /// # Errors
    ///
    /// Two columns of one name.
    pub(super) fn new(table: &CsvTable, form: FilmForm) -> Result<Conditions, DataError> {
        let names = match form {
            FilmForm::Speed => &CONDITIONS[..],
            FilmForm::SpeedLoad(_) => &CONDITIONS[2..],
            FilmForm::Moes
            | FilmForm::HamrockDowson(_)
            | FilmForm::Blend(_)
            | FilmForm::Elliptical => &[],
        };
        let none = [f64::INFINITY, f64::NEG_INFINITY];
        let mut columns = Vec::new();
        for (name, word, dimension) in names {
            let found = table.find(name, *dimension)?;
            columns.extend(found.map(|column| (*word, column, none)));
        }
        let temperature = table.find("film temperature maximum", Dimension::TEMPERATURE)?;
        let titles = table.header().cells();
        let switch = || titles.iter().position(|cell| *cell == ISOTHERMAL);
        Ok(Conditions {
            columns,
            heat: temperature
                .map(|column| Heat::Temperature(column.index))
                .or_else(|| switch().map(Heat::Switch)),
            n_thermal: 0,
            n_isothermal: 0,
        })
    }

    /// Adds the conditions of a film.
    pub(super) fn add(&mut self, table: &CsvTable, row: &Row) {
        for (_, column, [low, high]) in &mut self.columns {
            if let Ok(Some(value)) = table.number(row, column) {
                (*low, *high) = (low.min(value), high.max(value));
            }
        }
        let cell = |index: usize| row.cell(index);
        match self.heat {
            Some(Heat::Temperature(index)) if !cell(index).is_empty() => self.n_thermal += 1,
            Some(Heat::Temperature(_)) => self.n_isothermal += 1,
            Some(Heat::Switch(index)) if cell(index) == "true" => self.n_isothermal += 1,
            Some(Heat::Switch(index)) if cell(index) == "false" => self.n_thermal += 1,
            Some(Heat::Switch(_)) | None => {}
        }
    }

    /// Warnings on conditions that vary.
    pub(super) fn warnings(&self, table: &CsvTable) -> Vec<String> {
        let mut warnings = Vec::new();
        for (word, column, [low, high]) in &self.columns {
            if *high > LEAST_VARIATION * low {
                warnings.push(format!(
                    "{word} varies from {} to {} ({}): the form neglects it",
                    digits(column.unit.from_si(*low), 4),
                    digits(column.unit.from_si(*high), 4),
                    excerpt(table.header().cell(column.index))
                ));
            }
        }
        if self.n_thermal > 0 && self.n_isothermal > 0 {
            warnings.push(format!(
                "{} of the films are thermal and {} isothermal: the form does not distinguish them; omit one kind",
                self.n_thermal, self.n_isothermal
            ));
        }
        warnings
    }
}
