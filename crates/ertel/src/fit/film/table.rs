//! Films from a table.

use ertel_rheology::quantity::{Dimension, Unit};

use super::power::LEAST_VARIATION;
use super::{FilmForm, FilmKind, FilmState};
use crate::contact::ContactKind;
use crate::fit::DataError;
use crate::fit::csv::{cells as cells_of, rows};
use crate::fit::data::{Column, unit_text};
use crate::output::digits;

/// Names of the column of the entrainment speed, as results and curves have it, and a short one.
const SPEED_NAMES: [&str; 3] = ["entrainment speed", "motion.entrainment speed", "speed"];
/// Columns that a form over the speed does not know, with their words: none of them should vary.
const CONDITIONS: [(&str, &str, Dimension); 4] = [
    ("load", "the load", Dimension::FORCE),
    ("load", "the load", Dimension::FORCE_PER_LENGTH),
    ("temperature", "the temperature", Dimension::TEMPERATURE),
    ("radius", "the radius", Dimension::LENGTH),
];

/// Films to fit a form to.
#[derive(Clone, Debug, PartialEq)]
pub struct Films {
    /// The form.
    pub form: FilmForm,
    /// Which film.
    pub kind: FilmKind,
    /// The films.
    pub states: Vec<FilmState>,
    /// What varies beside the form's variables.
    pub warnings: Vec<String>,
}

/// The header of a table.
struct Header<'a> {
    file: &'a str,
    line: usize,
    cells: Vec<&'a str>,
}

impl Header<'_> {
    fn error(&self, line: usize, column: usize, problem: String) -> DataError {
        DataError {
            file: self.file.to_owned(),
            line,
            column,
            problem,
        }
    }

    fn find(&self, name: &'static str, dimension: Dimension) -> Option<Column> {
        self.cells.iter().enumerate().find_map(|(index, cell)| {
            let unit = Unit::parse(&unit_text(cell, name)?).ok()?;
            let fits = unit.dimension().same_exponents(dimension);
            fits.then_some(Column { index, name, unit })
        })
    }

    fn need(
        &self,
        names: &[&'static str],
        dimension: Dimension,
        help: &str,
    ) -> Result<Column, DataError> {
        let found = names.iter().find_map(|name| self.find(name, dimension));
        found.ok_or_else(|| {
            let problem = format!(
                "there is no column `{}`{help}; the columns are {}",
                names[0].replace(' ', "_"),
                self.cells.join(", ")
            );
            self.error(self.line, 1, problem)
        })
    }

    /// A number above zero, or one of zero where that is `allowed`.
    fn positive(
        &self,
        line: usize,
        cells: &[&str],
        column: &Column,
        allowed: bool,
    ) -> Result<f64, DataError> {
        let value = column
            .number(cells)
            .map_err(|(column, problem)| self.error(line, column, problem))?;
        if value > 0.0 || (allowed && value == 0.0) {
            return Ok(value);
        }
        let problem = format!(
            "{}: {value} has no logarithm: it must be above zero",
            column.name
        );
        Err(self.error(line, column.index + 1, problem))
    }
}

/// Where the variables of a form come from.
enum Source {
    /// Moes' M and L, U and R.
    Groups {
        load: Column,
        material: Column,
        speed: Column,
        radius: Result<f64, Column>,
    },
    /// The variables themselves.
    Columns(Vec<Column>),
}

/// Reads films from the text of a CSV file with a column `film_central_m` or `film_minimum_m` and what the form needs:
/// `moes_load`, `moes_material`, `speed_group` and `radius_m`, which `radius` (m) replaces, for forms in groups;
/// `entrainment_speed_m_per_s` and the load for those in speed and load; error bars from `film_central_error_m` or
/// `film_minimum_error_m`, where there are such. Any unit of the dimension does. Lines without a
/// film are left out.
///
/// # Errors
///
/// Missing columns and numbers, with line and column; `None` if only the column of the film is missing.
pub fn read_films(
    file: &str,
    text: &str,
    form: FilmForm,
    kind: FilmKind,
    radius: Option<f64>,
) -> Result<Option<Films>, DataError> {
    let mut lines = rows(text);
    let Some((line, head, separator)) = lines.next() else {
        return Err(DataError {
            file: file.to_owned(),
            line: 1,
            column: 1,
            problem: "the file is empty".to_owned(),
        });
    };
    let header = Header {
        file,
        line,
        cells: cells_of(head, separator),
    };
    let [name, error_name] = match kind {
        FilmKind::Central => ["film central", "film central error"],
        FilmKind::Minimum => ["film minimum", "film minimum error"],
    };
    let Some(film) = header.find(name, Dimension::LENGTH) else {
        return Ok(None);
    };
    let error = header.find(error_name, Dimension::LENGTH);
    let source = source(&header, form, radius)?;
    let conditions = match form {
        FilmForm::Speed => &CONDITIONS[..],
        FilmForm::SpeedLoad(_) => &CONDITIONS[2..],
        _ => &[],
    };
    let conditions: Vec<(&str, Column)> = conditions
        .iter()
        .filter_map(|(name, word, dimension)| Some((*word, header.find(name, *dimension)?)))
        .collect();
    let mut ranges = vec![[f64::INFINITY, f64::NEG_INFINITY]; conditions.len()];
    let mut states = Vec::new();
    let (mut n_isoviscous, mut first_isoviscous) = (0, None);
    for (line, row, _) in lines {
        let cells: Vec<&str> = cells_of(row, separator);
        if cells.get(film.index).is_none_or(|cell| cell.is_empty()) {
            continue;
        }
        let thickness = header.positive(line, &cells, &film, false)?;
        let (scale, variables) = match &source {
            Source::Columns(columns) => {
                let value = |c: &Column| header.positive(line, &cells, c, false);
                (1.0, columns.iter().map(value).collect::<Result<_, _>>()?)
            }
            Source::Groups {
                load,
                material,
                speed,
                radius,
            } => {
                let load = header.positive(line, &cells, load, false)?;
                let speed = header.positive(line, &cells, speed, false)?;
                let l = header.positive(line, &cells, material, true)?;
                if l == 0.0 {
                    n_isoviscous += 1;
                    first_isoviscous.get_or_insert((line, material.index + 1));
                }
                let radius = match radius {
                    Ok(radius) => *radius,
                    Err(column) => header.positive(line, &cells, column, false)?,
                };
                groups(form, radius, speed, load, l)
            }
        };
        for ((_, column), [low, high]) in conditions.iter().zip(&mut ranges) {
            if let Ok(value) = column.number(&cells) {
                (*low, *high) = (low.min(value), high.max(value));
            }
        }
        // A film without an error bar has an empty cell.
        let given = error
            .as_ref()
            .filter(|e| cells.get(e.index).is_some_and(|c| !c.is_empty()));
        let bar = match given {
            Some(error) => Some(header.positive(line, &cells, error, true)?),
            None => None,
        };
        states.push(FilmState {
            film: thickness,
            scale,
            variables,
            error: bar.map(|bar| bar / thickness),
        });
    }
    // The blend has L in a term of its own; a power law has its logarithm, unless there is none in any film.
    if let Some((line, column)) = first_isoviscous
        && n_isoviscous < states.len()
        && !matches!(form, FilmForm::Blend(_))
    {
        let problem =
            "moes material: 0 has no logarithm: it must be above zero in all films, or zero in all";
        return Err(header.error(line, column, problem.to_owned()));
    }
    let mut warnings = Vec::new();
    for ((word, column), [low, high]) in conditions.iter().zip(ranges) {
        if high > LEAST_VARIATION * low {
            warnings.push(format!(
                "{word} varies from {} to {} ({}): the form leaves it out",
                digits(column.unit.from_si(low), 4),
                digits(column.unit.from_si(high), 4),
                header.cells[column.index]
            ));
        }
    }
    Ok(Some(Films {
        form,
        kind,
        states,
        warnings,
    }))
}

/// The columns that a form needs.
fn source(header: &Header<'_>, form: FilmForm, radius: Option<f64>) -> Result<Source, DataError> {
    let load = |dimension, unit: &str| {
        let help = format!(" with a unit, such as `load_{unit}`");
        header.need(&["load"], dimension, &help)
    };
    let speed = || {
        let help = " with a unit, such as `entrainment_speed_m_per_s`";
        header.need(&SPEED_NAMES, Dimension::SPEED, help)
    };
    let none = Dimension::DIMENSIONLESS;
    match form {
        FilmForm::Speed => Ok(Source::Columns(vec![speed()?])),
        FilmForm::SpeedLoad(ContactKind::Circular) => Ok(Source::Columns(vec![
            speed()?,
            load(Dimension::FORCE, "N")?,
        ])),
        FilmForm::SpeedLoad(ContactKind::Line) => Ok(Source::Columns(vec![
            speed()?,
            load(Dimension::FORCE_PER_LENGTH, "N_per_m")?,
        ])),
        FilmForm::Moes | FilmForm::HamrockDowson(_) | FilmForm::Blend(_) => Ok(Source::Groups {
            load: header.need(&["moes load"], none, "")?,
            material: header.need(&["moes material"], none, "")?,
            speed: header.need(&["speed group"], none, "")?,
            radius: match radius {
                Some(radius) => Ok(radius),
                None => Err(header.need(
                    &["radius"],
                    Dimension::LENGTH,
                    " with a unit, such as `radius_m`, and no radius for all is given (`--radius`)",
                )?),
            },
        }),
    }
}

/// Scale (m) and variables of a form in groups, from R (m), U, M and L.
///
/// W = M (2U)^k, G = L (2U)^(-1/4), with k = 3/4 in circular and 1/2 in line contacts
fn groups(form: FilmForm, radius: f64, u: f64, m: f64, l: f64) -> (f64, Vec<f64>) {
    match form {
        FilmForm::HamrockDowson(contact) => {
            let w = m * (2.0 * u).powf(contact.moes_power());
            let g = l * (2.0 * u).powf(-0.25);
            (radius, vec![u, g, w])
        }
        _ => (radius * (2.0 * u).sqrt(), vec![m, l]),
    }
}

/// Which contact the films of a table belong to, by its column `load_N` or `load_N_per_m`; `None` without one of these.
pub fn contact_of_films(text: &str) -> Option<ContactKind> {
    let (_, head, separator) = rows(text).next()?;
    let cells = cells_of(head, separator);
    let has = |dimension: Dimension| {
        let unit = |cell: &&str| Unit::parse(&unit_text(cell, "load")?).ok();
        let mut units = cells.iter().filter_map(unit);
        units.any(|unit| unit.dimension().same_exponents(dimension))
    };
    match (has(Dimension::FORCE), has(Dimension::FORCE_PER_LENGTH)) {
        (true, false) => Some(ContactKind::Circular),
        (false, true) => Some(ContactKind::Line),
        _ => None,
    }
}
