//! The table of a study: one line for each finished point, in the order of the points.

use std::collections::HashMap;
use std::fmt::Write as _;
use std::path::Path;

use ertel_input::file::{LARGEST_OWN, read_bytes};
use serde::{Deserialize, Serialize};

use super::columns::{Column, joint_titles, point_fields};
use super::journal::{PointKey, Record, Title};
use super::{Outcome, PointSolution, StudyError};
use crate::case::study::{AxisValue, Study};
use crate::files::{text_field, write_whole};
use crate::params::PictureFormats;
use crate::solution::{Estimate, Figure};
use crate::warning::WarningKind;

/// Name of the table in the folder of a study.
pub const TABLE: &str = "results.csv";
/// Name of the list of points there.
pub const POINTS: &str = "study.json";
/// Value of its key `format`.
pub const STUDY_FORMAT: &str = "ertel-study";

/// The points of a study, as kept next to their journal: the data for its table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StudyEcho {
    /// [`STUDY_FORMAT`].
    pub format: String,
    /// Version of the program.
    pub ertel_version: String,
    /// Title.
    pub title: String,
    /// Titles of the columns of the axes.
    pub columns: Vec<String>,
    /// Units in which the user gave them, for pictures; empty where there is none.
    pub units: Vec<String>,
    /// Formats of its pictures: those that the base case asks for.
    pub pictures: PictureFormats,
    /// Kinds of warnings that the base case silences.
    #[serde(default)]
    pub silence: Vec<WarningKind>,
    /// Key and values of each point.
    pub points: Vec<(PointKey, Vec<String>)>,
}

impl StudyEcho {
    /// The stored data of a study.
    pub fn new(study: &Study) -> StudyEcho {
        let value = |value: &AxisValue| match value {
            AxisValue::Number(number, _) => format!("{number:e}"),
            AxisValue::Text(text) => text.clone(),
        };
        StudyEcho {
            format: STUDY_FORMAT.to_owned(),
            ertel_version: env!("CARGO_PKG_VERSION").to_owned(),
            title: study.title.clone(),
            columns: study.columns.iter().map(|c| c.header.clone()).collect(),
            units: study.columns.iter().map(|c| c.unit.clone()).collect(),
            silence: (study.points.first())
                .map_or_else(Vec::new, |p| p.case.output.silence.clone()),
            pictures: (study.points.first())
                .map_or_else(PictureFormats::default, |p| p.case.output.pictures),
            points: (study.points.iter())
                .map(|p| {
                    let values = p.values.iter().map(value).collect();
                    (PointKey::new(&p.case), values)
                })
                .collect(),
        }
    }

    /// Reads the list of points in a folder; `None` where there is none.
    ///
    /// # Errors
    /// [`StudyError::Io`], also for a file that is no such list.
    pub fn read(folder: &Path) -> Result<Option<StudyEcho>, StudyError> {
        let path = folder.join(POINTS);
        let bytes = match read_bytes(&path, LARGEST_OWN) {
            Ok(bytes) => bytes,
            Err(e) if e.is_missing() => return Ok(None),
            Err(e) => return Err(StudyError::io(&path, e.into())),
        };
        let echo: Result<StudyEcho, _> = serde_json::from_slice(&bytes);
        match echo {
            Ok(echo) if echo.format == STUDY_FORMAT => {
                let n = echo.columns.len();
                match echo.points.iter().position(|(_, values)| values.len() != n) {
                    None => Ok(Some(echo)),
                    Some(i) => {
                        let values = echo.points[i].1.len();
                        let problem =
                            format!("point {} has {values} values for {n} columns", i + 1);
                        Err(StudyError::io(&path, std::io::Error::other(problem)))
                    }
                }
            }
            Ok(_) => Err(StudyError::io(
                &path,
                std::io::Error::other("not a list of points of a study"),
            )),
            Err(e) => Err(StudyError::io(&path, e.into())),
        }
    }

    /// Writes it into a folder.
    ///
    /// # Errors
    /// [`StudyError::Io`].
    pub fn write(&self, folder: &Path) -> Result<(), StudyError> {
        let path = folder.join(POINTS);
        let text =
            serde_json::to_string_pretty(self).map_err(|e| StudyError::io(&path, e.into()))?;
        write_whole(&path, text.as_bytes()).map_err(|e| StudyError::io(&path, e))
    }

    /// For each point with heat the one that differs in its switch alone, where an axis switches heat off.
    fn isothermal_points(&self) -> HashMap<usize, &PointKey> {
        let Some(switch) = self.columns.iter().position(|title| title == ISOTHERMAL) else {
            return HashMap::new();
        };
        let others = |values: &[String]| {
            let mut others = values.to_vec();
            (others.remove(switch), others)
        };
        let mut isothermal = HashMap::new();
        for (key, values) in &self.points {
            let (is_isothermal, others) = others(values);
            if is_isothermal == "true" {
                isothermal.insert(others, key);
            }
        }
        let points = self.points.iter().enumerate();
        let with_heat = points.filter_map(|(i, (_, values))| {
            let (is_isothermal, others) = others(values);
            let key = *isothermal.get(&others)?;
            (is_isothermal == "false").then_some((i, key))
        });
        with_heat.collect()
    }

    /// The table of the points that are finished, as text. The thermal reduction is computed from the point without heat
    /// where the study has it.
    pub fn table(&self, records: &HashMap<PointKey, Record>) -> String {
        let mut text = String::from("point");
        let finished: Vec<_> = (self.points.iter().enumerate())
            .filter_map(|(i, (key, values))| Some((i, values, records.get(key)?)))
            .collect();
        let isothermal = self.isothermal_points();
        let titles_of = finished.iter().map(|(_, _, record)| {
            let titles = record.fields.iter().map(|(name, _)| &**name);
            titles.collect()
        });
        let names = joint_titles(titles_of);
        let titles = self.columns.iter().map(String::as_str);
        for title in titles.chain(names.iter().copied()) {
            text.push(',');
            text.push_str(&text_field(title));
        }
        text.push('\n');
        for (i, values, record) in finished {
            let _ = write!(text, "{}", i + 1);
            let isothermal = isothermal.get(&i).and_then(|key| records.get(key));
            for value in values {
                text.push(',');
                text.push_str(&text_field(value));
            }
            for name in names.iter().copied() {
                text.push(',');
                match isothermal.and_then(|isothermal| reduction(name, record, isothermal)) {
                    Some(value) => {
                        text.push_str(&value.map_or(String::new(), |v| format!("{v:e}")))
                    }
                    None => text.push_str(&text_field(record.field(name).unwrap_or_default())),
                }
            }
            text.push('\n');
        }
        text
    }
}

/// Switch of a case that neglects heat.
pub(crate) const ISOTHERMAL: &str = "solver.isothermal";

/// Columns of thermal reductions, as a share of the isothermal value, and their figures.
const REDUCTIONS: [(&str, Figure); 3] = [
    ("thermal_reduction_central", Figure::FilmCentral),
    ("thermal_reduction_minimum", Figure::FilmMinimum),
    ("thermal_reduction_traction", Figure::TractionCoefficient),
];

/// `1 - with heat/without`, or its error bar, of a column that asks for it; `None` of the traction where nothing
/// slides; nothing inside where the films or tractions have no error bars.
fn reduction(name: &str, record: &Record, isothermal: &Record) -> Option<Option<f64>> {
    let own = name.strip_suffix("_error").unwrap_or(name);
    let (_, figure) = REDUCTIONS.iter().find(|(column, _)| *column == own)?;
    let number = |record: &Record, name: &str| record.field(name)?.parse::<f64>().ok();
    if *figure == Figure::TractionCoefficient && number(record, "slide_to_roll_ratio")? == 0.0 {
        return None;
    }
    // Films and coefficients have the same unit in all contacts.
    let column = Column::of(*figure);
    let (of, error_of) = (column.title(false), column.error_title(false)?);
    let estimate = |record| {
        Some(Estimate {
            value: number(record, &of)?,
            error: number(record, &error_of),
        })
    };
    let reduction = Estimate::reduction(estimate(record)?, estimate(isothermal)?);
    Some(match own == name {
        true => Some(reduction.value),
        false => reduction.error,
    })
}

/// Columns of a curve's table that a study has no use for: times differ from run to run, and the table must not.
fn belongs(name: &str) -> bool {
    !name.starts_with("newtonian_") && !name.starts_with("isothermal_") && name != "seconds"
}

/// The fields of a point, by the titles of their columns: its operating point, then its figures.
pub(crate) fn fields(point: &PointSolution) -> Vec<(Title, Box<str>)> {
    let is_line = point.case.contact.kind.is_line();
    let mut fields = match point.machine {
        None => operating_point(point, is_line),
        // Each contact has its own operating point; the axes give the rest.
        Some(_) => Vec::new(),
    };
    let figures = point_fields(point, is_line).into_iter();
    for (title, cell) in figures.filter(|(title, _)| belongs(title)) {
        fields.push((title, cell.to_string().replace(['\n', '\r'], " ")));
    }
    (fields.into_iter())
        .map(|(title, value)| (title.into(), value.into()))
        .collect()
}

/// Load, speeds, temperature and radii of a contact.
fn operating_point(point: &PointSolution, is_line: bool) -> Vec<(String, String)> {
    let case = &point.case;
    let number = |value: f64| format!("{value:e}");
    let load = if is_line { "load_N_per_m" } else { "load_N" };
    let motion = &case.motion;
    let operating = [
        ("radius_m", case.contact.radius),
        (load, case.contact.load),
        ("entrainment_speed_m_per_s", motion.entrainment_speed),
        ("slide_to_roll_ratio", motion.slide_to_roll_ratio),
        ("temperature_K", case.temperature),
        ("ambient_viscosity_Pa_s", case.fluid.viscosity),
    ];
    let mut fields: Vec<(String, String)> = operating
        .map(|(name, value)| (name.to_owned(), number(value)))
        .into();
    if case.contact.has_two_radii() {
        // An angle without a unit is in rad.
        for (name, value) in [
            ("radius_y_m", case.contact.radius_y),
            ("entrainment_angle_rad", case.contact.entrainment_angle),
        ] {
            fields.push((name.to_owned(), number(value)));
        }
    }
    fields
}

/// The record of a point.
pub(crate) fn record(key: PointKey, point: &PointSolution) -> Record {
    Record {
        key,
        converged: point.outcome.is_solved(),
        reason: match &point.outcome {
            Outcome::Failed(reason) => reason.clone(),
            Outcome::Solved(_) | Outcome::InTime(_) => String::new(),
        },
        fields: fields(point),
        warnings: point.warnings(),
        seconds: point.seconds,
    }
}
