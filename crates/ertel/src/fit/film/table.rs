//! Films from a table.

use ertel_rheology::quantity::{Dimension, Unit};

use super::conditions::Conditions;
use super::header::Header;
use super::{FilmForm, FilmKind, FilmState};
use crate::contact::ContactKind;
use crate::fit::DataError;
use crate::fit::csv::{cells as cells_of, rows};
use crate::fit::data::{Column, unit_text};

/// Names of the column of the entrainment speed, as results and curves have it, and a short one.
const SPEED_NAMES: [&str; 3] = ["entrainment speed", "motion.entrainment speed", "speed"];

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
    let mut conditions = Conditions::new(&header, form);
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
        conditions.add(&cells);
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
    Ok(Some(Films {
        form,
        kind,
        states,
        warnings: conditions.warnings(&header),
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
