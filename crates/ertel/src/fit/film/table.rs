//! Films from a table.

use ertel_input::csv::{Column, CsvError, CsvParams, CsvTable, Row, Vocabulary};
use ertel_quantity::Dimension;

use super::conditions::Conditions;
use super::geometry::Ellipses;
use super::header::{need, positive};
use super::{FilmForm, FilmKind, FilmState};
use crate::contact::{Contact, Family};
use crate::fit::DataError;
use crate::words::digits;

/// Names of the column of the entrainment speed, as results and curves have it.
const SPEED_NAMES: [&str; 2] = ["entrainment speed", "motion.entrainment speed"];

/// Films to fit a form to.
#[derive(Clone, Debug, PartialEq)]
pub struct Films {
    /// The form.
    pub form: FilmForm,
    /// Which film.
    pub kind: FilmKind,
    /// The films.
    pub states: Vec<FilmState>,
    /// Warnings on conditions that vary in addition to the form's variables.
    pub warnings: Vec<String>,
}

/// Where the reduced radius comes from.
enum Radius {
    /// One for all films, m.
    Given(f64),
    /// A column.
    Column(Box<Column>),
    /// The radii of ellipses.
    Ellipses(Box<Ellipses>),
}

/// Where the variables of a form come from.
#[expect(clippy::large_enum_variant, reason = "a table has one")]
enum Source {
    /// Moes' M and L, U and R.
    Groups(GroupColumns),
    /// The variables themselves.
    Columns(Vec<Column>),
}

/// Columns of Moes' groups.
struct GroupColumns {
    load: Column,
    material: Column,
    speed: Column,
    radius: Radius,
}

impl GroupColumns {
    /// Scale of the film and variables of a line whose material group is `l`.
    fn state(
        &self,
        table: &CsvTable,
        row: &Row,
        form: FilmForm,
        l: f64,
        unlike: &mut Unlike,
    ) -> Result<(f64, Vec<f64>), DataError> {
        let load = positive(table, row, &self.load, false)?;
        let speed = positive(table, row, &self.speed, false)?;
        Ok(match &self.radius {
            Radius::Given(radius) => groups(form, *radius, speed, load, l),
            Radius::Column(column) => {
                let radius = positive(table, row, column, false)?;
                groups(form, radius, speed, load, l)
            }
            Radius::Ellipses(ellipses) => {
                let contact = ellipses.contact(table, row)?;
                unlike.add(&contact);
                of_ellipse(form, &contact, speed, load, l)
            }
        })
    }
}

/// Reads films from the text of a CSV file with a column `film_central_m` or `film_minimum_m` and what the form needs:
/// `moes_load`, `moes_material`, `speed_group` and `radius_m`, which `radius` (m) replaces, for forms in groups, of ellipses
/// with `radius_y_m` and, where it is not 0, `entrainment_angle_rad`;
/// `entrainment_speed_m_per_s` and the load for those in speed and load; error bars from `film_central_error_m` or
/// `film_minimum_error_m`, where there are such. Any unit of the dimension does. Lines without a
/// film are omitted.
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
    let given = Given {
        radius,
        table: CsvParams::default(),
    };
    read_films_with(file, text, form, kind, &given)
}

/// Options for reading a table of films.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Given {
    /// Reduced radius of all films, m.
    pub radius: Option<f64>,
    /// Assignment of the columns.
    pub table: CsvParams,
}

/// Columns of tables of films, by the names of the program.
const NAMES: [&str; 14] = [
    "film central",
    "film minimum",
    "film central error",
    "film minimum error",
    "entrainment speed",
    "motion.entrainment speed",
    "load",
    "temperature",
    "radius",
    "radius y",
    "entrainment angle",
    "moes load",
    "moes material",
    "speed group",
];

fn parse(file: &str, text: &str, params: &CsvParams) -> Result<CsvTable, CsvError> {
    let vocabulary = Vocabulary {
        names: &NAMES,
        is_key: &|_| false,
    };
    CsvTable::parse_for(file, text, &vocabulary, params)
}

/// As [`read_films`], with options.
///
/// # Errors
///
/// As [`read_films`]; columns that the user names and that are not there.
pub fn read_films_with(
    file: &str,
    text: &str,
    form: FilmForm,
    kind: FilmKind,
    given: &Given,
) -> Result<Option<Films>, DataError> {
    let radius = given.radius;
    let table = parse(file, text, &given.table)?;
    let [name, error_name] = match kind {
        FilmKind::Central => ["film central", "film central error"],
        FilmKind::Minimum => ["film minimum", "film minimum error"],
    };
    let Some(film) = table.find(name, Dimension::LENGTH)? else {
        return Ok(None);
    };
    let error = table.find(error_name, Dimension::LENGTH)?;
    let source = source(&table, form, radius)?;
    let mut conditions = Conditions::new(&table, form)?;
    let mut states = Vec::new();
    let (mut n_isoviscous, mut first_isoviscous) = (0, None);
    let mut unlike = Unlike::default();
    for row in table.rows() {
        if table.is_missing(row, film.index) {
            continue;
        }
        let thickness = positive(&table, row, &film, false)?;
        let (scale, variables) = match &source {
            Source::Columns(columns) => {
                let value = |c: &Column| positive(&table, row, c, false);
                (1.0, columns.iter().map(value).collect::<Result<_, _>>()?)
            }
            Source::Groups(columns) => {
                let l = positive(&table, row, &columns.material, true)?;
                if l == 0.0 {
                    n_isoviscous += 1;
                    first_isoviscous.get_or_insert((row, columns.material.index));
                }
                columns.state(&table, row, form, l, &mut unlike)?
            }
        };
        conditions.add(&table, row);
        // A film without an error bar has an empty cell.
        let given = error.as_ref().filter(|e| !table.is_missing(row, e.index));
        let bar = match given {
            Some(error) => Some(positive(&table, row, error, true)?),
            None => None,
        };
        states.push(FilmState {
            film: thickness,
            scale,
            variables,
            error: bar.map(|bar| bar / thickness),
        });
    }
    // The blend has L in a separate term; a power law has its logarithm, unless it is zero in every film.
    if let Some((row, index)) = first_isoviscous
        && n_isoviscous < states.len()
        && !matches!(form, FilmForm::Blend(_))
    {
        let problem =
            "moes material: 0 has no logarithm: it must be above zero in all films, or zero in all";
        return Err(table.error(row, index, problem));
    }
    Ok(Some(Films {
        form,
        kind,
        states,
        warnings: [conditions.warnings(&table), unlike.warnings(form)].concat(),
    }))
}

/// The columns that a form needs.
fn source(table: &CsvTable, form: FilmForm, radius: Option<f64>) -> Result<Source, DataError> {
    let load = |dimension, unit: &str| {
        let help = format!(" with a unit, such as `load_{unit}`");
        need(table, &["load"], dimension, &help)
    };
    let speed = || {
        let help = " with a unit, such as `entrainment_speed_m_per_s`";
        need(table, &SPEED_NAMES, Dimension::SPEED, help)
    };
    let none = Dimension::DIMENSIONLESS;
    match form {
        FilmForm::Speed => Ok(Source::Columns(vec![speed()?])),
        FilmForm::SpeedLoad(contact) => {
            let load = match contact {
                Family::Cylinder => load(Dimension::FORCE_PER_LENGTH, "N_per_m"),
                Family::Point => load(Dimension::FORCE, "N"),
            };
            Ok(Source::Columns(vec![speed()?, load?]))
        }
        FilmForm::Moes | FilmForm::HamrockDowson(_) | FilmForm::Blend(_) | FilmForm::Elliptical => {
            Ok(Source::Groups(GroupColumns {
                load: need(table, &["moes load"], none, "")?,
                material: need(table, &["moes material"], none, "")?,
                speed: need(table, &["speed group"], none, "")?,
                radius: radius_source(table, form, radius)?,
            }))
        }
    }
}

/// Where a form in groups has its radius from.
fn radius_source(
    table: &CsvTable,
    form: FilmForm,
    radius: Option<f64>,
) -> Result<Radius, DataError> {
    let ellipses = match form {
        FilmForm::Elliptical => Some(Ellipses::new(table, radius)?),
        _ => Ellipses::of(table, radius)?,
    };
    if let Some(ellipses) = ellipses {
        return Ok(Radius::Ellipses(Box::new(ellipses)));
    }
    if let Some(radius) = radius {
        return Ok(Radius::Given(radius));
    }
    let help = " with a unit, such as `radius_m`, and no radius for all is given (`--radius`)";
    let column = need(table, &["radius"], Dimension::LENGTH, help)?;
    Ok(Radius::Column(Box::new(column)))
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

/// The same of an ellipse, whose U and M are those of the radius along the motion, R_e.
///
/// Those along its first axis: U = U_e R_e/R_x, W = W_e (R_e/R_x)²
fn of_ellipse(form: FilmForm, contact: &Contact, u: f64, m: f64, l: f64) -> (f64, Vec<f64>) {
    let [along, _] = contact.radii_along_and_across();
    if form != FilmForm::Elliptical {
        return groups(form, along, u, m, l);
    }
    let (radius, in_groups) = groups(FilmForm::HamrockDowson(Family::Point), along, u, m, l);
    let ratio = radius / contact.radius;
    let variables = vec![
        in_groups[0] * ratio,
        in_groups[1],
        in_groups[2] * ratio * ratio,
        contact.radius_y / contact.radius,
        contact.entrainment_angle.abs(),
    ];
    (contact.radius, variables)
}

/// Shapes of ellipses, as far as they differ.
struct Unlike {
    ratio: [f64; 2],
    angle: [f64; 2],
}

impl Default for Unlike {
    fn default() -> Self {
        let none = [f64::INFINITY, f64::NEG_INFINITY];
        Unlike {
            ratio: none,
            angle: none,
        }
    }
}

impl Unlike {
    fn add(&mut self, contact: &Contact) {
        let widen = |[low, high]: [f64; 2], value: f64| [low.min(value), high.max(value)];
        self.ratio = widen(self.ratio, contact.radius_y / contact.radius);
        self.angle = widen(self.angle, contact.entrainment_angle.abs().to_degrees());
    }

    /// Warning on shapes that the form neglects.
    fn warnings(&self, form: FilmForm) -> Vec<String> {
        let ([flat, wide], [low, high]) = (self.ratio, self.angle);
        if form == FilmForm::Elliptical || !(wide > 1.01 * flat || high > low + 0.5) {
            return Vec::new();
        }
        vec![format!(
            "the ellipses differ, R_y/R_x from {} to {} and the motion at {} to {} deg to x: the form neglects this; use the form \
             `elliptical`",
            digits(flat, 3),
            digits(wide, 3),
            digits(low, 3),
            digits(high, 3)
        )]
    }
}

/// Which contact the films of a table belong to, by its column `load_N` or `load_N_per_m`; `None` without one of these.
pub fn contact_of_films(text: &str) -> Option<Family> {
    contact_of_films_with(text, &CsvParams::default())
}

/// The same with the column options of the user.
pub fn contact_of_films_with(text: &str, params: &CsvParams) -> Option<Family> {
    let table = parse("", text, params).ok()?;
    let has = |dimension| table.find("load", dimension).ok().flatten().is_some();
    match (has(Dimension::FORCE), has(Dimension::FORCE_PER_LENGTH)) {
        (true, false) => Some(Family::Point),
        (false, true) => Some(Family::Cylinder),
        _ => None,
    }
}
