//! Measured figures, and the study of a case at their operating points.

use std::ops::Range;
use std::path::PathBuf;

use ertel_input::Document;
use ertel_input::csv::CsvParams;
use ertel_input::tree::Value;

use crate::case::Study;
use crate::case::study::PointColumn;
use crate::figures::{bearing, gears};
use crate::solution::Figure;

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
    pub(super) fn figure(self) -> Option<Figure> {
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

/// Contents of a file, before they are combined with the case.
pub(super) struct Content {
    /// Varied quantities; as many values as there are rows.
    pub(super) columns: Vec<PointColumn>,
    /// Line and figures of each row.
    pub(super) rows: Vec<(usize, [Option<Measurement>; N_MEASURANDS])>,
    pub(super) notes: Vec<String>,
    /// Title and meaning of each column that is measured.
    pub(super) measured: Vec<(String, String)>,
}

/// Key path of the lubricant's temperature in a case: at the top where the lubricant is given by its name.
pub(super) fn temperature_key(case: &Document) -> &'static str {
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
pub(super) fn column(key: &str, span: Range<usize>) -> PointColumn {
    PointColumn {
        key: key.to_owned(),
        span,
        values: Vec::new(),
    }
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

/// Thermometer of a rig.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Probe {
    /// In the lubricant.
    #[default]
    Lubricant,
    /// In the pot.
    Pot,
}
