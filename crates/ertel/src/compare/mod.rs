//! Measured films and tractions compared with computed ones.
//!
//! A table of measurements ([`Measured`]) says at which speeds, loads, slide-to-roll ratios and temperatures a contact was
//! measured, and what was found. These rows make a [`Study`] of a case; its results make a [`Comparison`].
//!
//! ```text
//! table ─► Measured { rows, study } ─► sweep ─► records ─► Comparison { rows, statistics }
//! ```

mod columns;
mod comparison;
mod rig;
mod speeds;
mod statistics;
mod table;
mod turned;

use std::collections::HashMap;
use std::ops::Range;
use std::path::{Path, PathBuf};

use ertel_input::csv::{CsvError, CsvParams};
use ertel_input::file::{FileError, read_table};
use ertel_input::tree::Value;
use ertel_input::{Document, InputError};

use crate::case::Study;
use crate::case::study::PointColumn;
use crate::figures::{bearing, gears};
use crate::solution::Figure;
use crate::study::journal::PointKey;

pub use comparison::{Compared, ComparedRow, Comparison, Outcome};
pub use rig::Probe;
pub use statistics::Statistics;

/// A figure that is measured and computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Measurand {
    /// Film thickness in the centre of the contact, m.
    FilmCentral,
    /// Smallest film thickness, m.
    FilmMinimum,
    /// Traction coefficient.
    Traction,
    /// Friction torque of a whole machine, N m.
    FrictionTorque,
    /// Power that a whole machine loses, W.
    FrictionPower,
    /// Power lost in the mesh of gears over that at the pinion.
    MeshLoss,
}

/// Number of figures that may be measured.
pub const N_MEASURANDS: usize = Measurand::ALL.len();

impl Measurand {
    /// All, in the order of tables.
    pub const ALL: [Measurand; 6] = [
        Measurand::FilmCentral,
        Measurand::FilmMinimum,
        Measurand::Traction,
        Measurand::FrictionTorque,
        Measurand::FrictionPower,
        Measurand::MeshLoss,
    ];

    /// The figure of a contact that it is compared with; `None` of those that only whole machines have.
    fn figure(self) -> Option<Figure> {
        match self {
            Measurand::FilmCentral => Some(Figure::FilmCentral),
            Measurand::FilmMinimum => Some(Figure::FilmMinimum),
            Measurand::Traction => Some(Figure::TractionCoefficient),
            _ => None,
        }
    }

    /// Whether a whole machine has it; of films it has the smallest ones.
    pub fn is_of_machines(self) -> bool {
        self != Measurand::Traction
    }

    /// Whether a single contact has it.
    pub fn is_of_contacts(self) -> bool {
        self.figure().is_some()
    }

    /// Name of its columns, without the unit: that of the figure in results.
    pub fn name(self) -> &'static str {
        match self {
            Measurand::FrictionTorque => bearing::FRICTION_TORQUE.name,
            Measurand::FrictionPower => bearing::FRICTION_POWER.name,
            Measurand::MeshLoss => gears::MESH_LOSS.name,
            _ => self.figure().map_or("", Figure::name),
        }
    }

    /// Its name in words.
    pub fn words(self) -> &'static str {
        match self {
            Measurand::FrictionTorque => "friction torque",
            Measurand::FrictionPower => "power lost",
            Measurand::MeshLoss => "power lost over that at the pinion",
            _ => self.figure().map_or("", Figure::words),
        }
    }

    /// Its SI unit; empty of a pure number.
    pub fn unit(self) -> &'static str {
        match self {
            Measurand::FilmCentral | Measurand::FilmMinimum => "m",
            Measurand::FrictionTorque => "N m",
            Measurand::FrictionPower => "W",
            Measurand::Traction | Measurand::MeshLoss => "",
        }
    }

    /// Whether it is a film thickness.
    pub fn is_film(self) -> bool {
        self.unit() == "m"
    }
}

/// A measured value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measurement {
    /// The value, SI.
    pub value: f64,
    /// Half-width of its uncertainty, same unit; `None` where the table says nothing.
    pub uncertainty: Option<f64>,
}

/// A row of a table of measurements.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredRow {
    /// Line of the file, from 1.
    pub line: usize,
    /// Number of the point in the study, from 0.
    pub point: usize,
    /// Measured values, in the order of [`Measurand::ALL`].
    pub figures: [Option<Measurement>; N_MEASURANDS],
}

/// Measurements, and the study of a case at their operating points.
#[derive(Clone, Debug)]
pub struct Measured {
    /// The file.
    pub file: PathBuf,
    /// The rows that were read, in the order of the file.
    pub rows: Vec<MeasuredRow>,
    /// The operating points, each once.
    pub study: Study,
    /// Omissions and assumptions.
    pub notes: Vec<String>,
    /// Meaning of each column, by its title in the file.
    pub used: Vec<(String, String)>,
    /// Text of the case file.
    pub case_text: String,
}

/// Options for reading a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ReadParams {
    /// Steps of a rig's file, by number; empty: all that vary speed, load or sliding.
    pub steps: Vec<usize>,
    /// Thermometer of a rig.
    pub probe: Probe,
    /// Options that assign the columns of a table.
    pub table: CsvParams,
}

/// Why measurements were not read.
#[derive(Debug, thiserror::Error)]
pub enum MeasuredError {
    /// The file cannot be read.
    #[error("{} {source}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// Why.
        source: FileError,
    },
    /// The table is wrong.
    #[error(transparent)]
    Table(#[from] CsvError),
    /// A figure was measured that the case does not have.
    #[error("{}: `{figure}` is a figure of {of}, and the case is {case}", path.display())]
    NoSuchFigure {
        /// The file.
        path: PathBuf,
        /// Name of its column.
        figure: &'static str,
        /// Kind of case that has it.
        of: &'static str,
        /// Kind of the case.
        case: &'static str,
    },
    /// A point is no case that can be solved, or the base case is wrong.
    #[error(transparent)]
    Case(#[from] InputError),
}

/// Contents of a file, before they are combined with the case.
struct Content {
    /// Varied quantities; as many values as there are rows.
    columns: Vec<PointColumn>,
    /// Line and figures of each row.
    rows: Vec<(usize, [Option<Measurement>; N_MEASURANDS])>,
    notes: Vec<String>,
    /// Title and meaning of each column that is measured.
    measured: Vec<(String, String)>,
}

impl Measured {
    /// Reads the measurements in the file `path`, a table or an export of a rig, and the case `base` at each of their points.
    ///
    /// # Errors
    ///
    /// [`MeasuredError`] with file, line and column: of the file itself, and of every point that the case refuses.
    pub fn read(base: &Path, path: &Path, params: &ReadParams) -> Result<Self, MeasuredError> {
        let text = read_table(path).map_err(|source| MeasuredError::File {
            path: path.to_owned(),
            source,
        })?;
        // The key of the temperature depends on how the case names its lubricant.
        let case = Document::read(base)?;
        let given = match case.root().optional_table("compare")? {
            Some(table) => CsvParams::of_table(table)?,
            None => CsvParams::default(),
        };
        let params = &ReadParams {
            table: given.with(&params.table),
            ..params.clone()
        };
        let file = path.display().to_string();
        let mut content = match rig::is_export(&text) {
            true => rig::read(&case, &file, &text, params)?,
            false => table::read(&case, &file, &text, params)?,
        };
        let set = content.columns.iter().map(|column| {
            let title = text[column.span.clone()].trim().to_owned();
            (title, format!("sets {}", column.key))
        });
        let used = set.chain(std::mem::take(&mut content.measured)).collect();
        let replaced = speeds::replace(&case, &mut content);
        let Content {
            columns,
            rows,
            notes,
            ..
        } = content;
        // Most rows of a rig repeat others: each case is read once.
        let (columns, written) = distinct_rows(columns);
        let mut study = Study::of_points(base, &replaced, path, &text, columns)?;
        let same = distinct(&mut study);
        let point_of_row = written.into_iter().map(|point| same[point]);
        check_figures(path, &study, &rows)?;
        let row = |((line, figures), point): ((usize, _), usize)| MeasuredRow {
            line,
            point,
            figures,
        };
        Ok(Self {
            file: path.to_owned(),
            rows: rows.into_iter().zip(point_of_row).map(row).collect(),
            study,
            notes,
            used,
            case_text: case.text().to_owned(),
        })
    }

    /// Whether any row has a figure.
    pub fn has(&self, figure: Measurand) -> bool {
        let index = figure as usize;
        self.rows.iter().any(|row| row.figures[index].is_some())
    }
}

/// Rejects figures of whole machines for a single contact, and vice versa.
fn check_figures(
    path: &Path,
    study: &Study,
    rows: &[(usize, [Option<Measurement>; N_MEASURANDS])],
) -> Result<(), MeasuredError> {
    let is_machine = study.points.iter().all(|p| p.case.whole.is_some());
    let (contact, machine) = ("a single contact", "a whole machine");
    for figure in Measurand::ALL {
        let has = match is_machine {
            true => figure.is_of_machines(),
            false => figure.is_of_contacts(),
        };
        let was_measured = |(_, figures): &(usize, [Option<Measurement>; N_MEASURANDS])| {
            figures[figure as usize].is_some()
        };
        if !has && rows.iter().any(was_measured) {
            let [of, case] = if is_machine {
                [contact, machine]
            } else {
                [machine, contact]
            };
            return Err(MeasuredError::NoSuchFigure {
                path: path.to_owned(),
                figure: figure.name(),
                of,
                case,
            });
        }
    }
    Ok(())
}

/// Keeps the first of identical rows; returns the index of the kept row for each.
fn distinct_rows(mut columns: Vec<PointColumn>) -> (Vec<PointColumn>, Vec<usize>) {
    let n_rows = columns.first().map_or(0, |column| column.values.len());
    let mut seen: HashMap<String, usize> = HashMap::new();
    let mut is_first = Vec::with_capacity(n_rows);
    let mut index = Vec::with_capacity(n_rows);
    for i in 0..n_rows {
        let values = columns
            .iter()
            .map(|column| format!("{:?}\n", column.values[i].1));
        let next = seen.len();
        let place = *seen.entry(values.collect()).or_insert(next);
        is_first.push(place == next);
        index.push(place);
    }
    for column in &mut columns {
        let mut first = is_first.iter();
        column.values.retain(|_| first.next() == Some(&true));
    }
    (columns, index)
}

/// Keeps the first of identical points of a study; returns the index of the kept point for each.
fn distinct(study: &mut Study) -> Vec<usize> {
    let mut seen: HashMap<PointKey, usize> = HashMap::new();
    let mut kept = Vec::new();
    let mut index = Vec::new();
    for point in std::mem::take(&mut study.points) {
        let next = kept.len();
        let place = *seen.entry(PointKey::new(&point.case)).or_insert(next);
        if place == next {
            kept.push(point);
        }
        index.push(place);
    }
    study.points = kept;
    index
}

/// Key path of the lubricant's temperature in a case: at the top where the lubricant is given by its name.
fn temperature_key(case: &Document) -> &'static str {
    match case
        .tree()
        .entry("lubricant")
        .map(|entry| &entry.node.value)
    {
        Some(Value::Table(_)) => "lubricant.temperature",
        _ => "temperature",
    }
}

/// A column without values.
fn column(key: &str, span: Range<usize>) -> PointColumn {
    PointColumn {
        key: key.to_owned(),
        span,
        values: Vec::new(),
    }
}

#[cfg(test)]
mod table_tests;
#[cfg(test)]
mod tests;
