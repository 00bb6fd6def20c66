//! Heights of a surface from a file: text in rows, points, CSV, SDF (ISO 25178-71) and X3P (ISO 25178-72).

mod sdf;
mod text;
mod x3p;

use std::path::Path;

use ertel_input::csv::CsvError;
use ertel_input::file::{FileError, LARGEST_TABLE, read_bytes, read_table};
use thiserror::Error;

use crate::contact::topography::Topography;

/// Points of a map in each direction at least, and of a profile in its row.
pub const LEAST_POINTS: usize = 4;
/// Points of a map at most: 2048 by 2048.
pub const MOST_POINTS: usize = 4_194_304;

/// Data of a map that a file may lack.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Layout {
    /// Distance of points in a row, m.
    pub spacing: Option<f64>,
    /// Distance of rows, m.
    pub row_spacing: Option<f64>,
    /// Unit of the heights, m.
    pub height_unit: Option<f64>,
    /// Unit of the places, m.
    pub length_unit: Option<f64>,
    /// Whether a text has a point in each line, and not a row.
    pub has_points: bool,
}

/// Kind of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Rows of heights.
    Rows,
    /// Points with their places.
    Points,
    /// CSV with columns of places and heights.
    Csv,
    /// SDF.
    Sdf,
    /// X3P.
    X3p,
}

impl Format {
    /// Its name.
    pub fn words(self) -> &'static str {
        match self {
            Format::Rows => "rows of heights",
            Format::Points => "points",
            Format::Csv => "CSV",
            Format::Sdf => "SDF of ISO 25178-71",
            Format::X3p => "X3P of ISO 25178-72",
        }
    }

    /// The input that scales its heights.
    pub fn heights_by(self) -> &'static str {
        match self {
            Format::Rows | Format::Points => "`height_unit`",
            Format::Csv => "the unit in the title of the heights",
            Format::Sdf => "Zscale of the file",
            Format::X3p => "CZ/Increment in main.xml",
        }
    }
}

/// Heights of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Heights {
    /// The points.
    pub map: Topography,
    /// Format of the file.
    pub format: Format,
    /// xxh3 of its bytes.
    pub hash: u64,
}

/// Why a file is no map.
#[derive(Debug, Error)]
pub enum MapError {
    /// The system does not give it.
    #[error("{0}")]
    File(#[from] FileError),
    /// A table.
    #[error("{0}")]
    Csv(#[from] CsvError),
    /// A key that the case has to give.
    #[error("the file does not give {what}: set `{key}`, such as {key} = \"{example}\"")]
    Missing {
        /// The missing data.
        what: &'static str,
        /// Where it is given.
        key: &'static str,
        /// An example.
        example: &'static str,
    },
    /// A key for data that the file gives.
    #[error("the file gives {what}: remove `{key}`")]
    Redundant {
        /// The data in the file.
        what: &'static str,
        /// The key.
        key: &'static str,
    },
    /// A line that does not fit.
    #[error("line {line}: {problem}")]
    Line {
        /// From 1.
        line: usize,
        /// The error.
        problem: String,
    },
    /// Anything else.
    #[error("{0}")]
    Content(String),
}

impl MapError {
    fn at(line: usize, problem: impl Into<String>) -> MapError {
        MapError::Line {
            line,
            problem: problem.into(),
        }
    }

    fn content(problem: impl Into<String>) -> MapError {
        MapError::Content(problem.into())
    }
}

/// Reads a file.
///
/// # Errors
/// [`MapError`]: no such file, content that is none of the formats, too many points, and data that the case lacks.
pub fn read(path: &Path, layout: &Layout) -> Result<Heights, MapError> {
    let bytes = read_bytes(path, LARGEST_TABLE)?;
    let hash = xxhash_rust::xxh3::xxh3_64(&bytes);
    let (map, format) = match bytes.as_slice() {
        [b'P', b'K', 3, 4, ..] => {
            layout.check_redundant(true)?;
            (x3p::parse(&bytes)?, Format::X3p)
        }
        _ if sdf::is_binary(&bytes) => {
            layout.check_redundant(true)?;
            (sdf::binary::parse(&bytes)?, Format::Sdf)
        }
        _ => {
            let text = read_table(path)?;
            match () {
                () if sdf::is_ascii(&text) => {
                    layout.check_redundant(true)?;
                    (sdf::parse(&text)?, Format::Sdf)
                }
                () if text::has_header(&text) => {
                    layout.check_redundant(true)?;
                    let file = path.file_name().unwrap_or_default().to_string_lossy();
                    (text::parse_csv(&file, &text)?, Format::Csv)
                }
                () if layout.has_points => {
                    layout.check_redundant(false)?;
                    (text::parse_points(&text, layout)?, Format::Points)
                }
                () => (text::parse_rows(&text, layout)?, Format::Rows),
            }
        }
    };
    Ok(Heights { map, format, hash })
}

impl Layout {
    /// Refuses keys for data that the file gives: distances, and perhaps units.
    fn check_redundant(&self, units: bool) -> Result<(), MapError> {
        let twice = [
            (
                self.spacing.is_some(),
                "the places of its points",
                "spacing",
            ),
            (
                self.row_spacing.is_some(),
                "the places of its points",
                "row_spacing",
            ),
            (
                units && self.height_unit.is_some(),
                "its units",
                "height_unit",
            ),
            (
                units && self.length_unit.is_some(),
                "its units",
                "length_unit",
            ),
        ];
        match twice.iter().find(|(is_given, ..)| *is_given) {
            None => Ok(()),
            Some((_, what, key)) => Err(MapError::Redundant { what, key }),
        }
    }
}

/// A map of `counts` points, whose heights must be finite or missing.
fn finite(
    counts: [usize; 2],
    spacing: [f64; 2],
    heights: Vec<f64>,
) -> Result<Topography, MapError> {
    match heights.iter().any(|h| h.is_infinite()) {
        true => Err(MapError::content("a height is infinite")),
        false => Ok(Topography {
            counts,
            spacing,
            heights,
        }),
    }
}

/// Refuses grids with too many points, or too few.
fn checked(counts: [usize; 2]) -> Result<[usize; 2], MapError> {
    match counts[0].checked_mul(counts[1]) {
        Some(n) if n <= MOST_POINTS => {}
        _ => {
            return Err(MapError::content(format!(
                "{} x {} points are too many: at most {MOST_POINTS} are read; export fewer",
                counts[0], counts[1]
            )));
        }
    }
    let is_grid = counts[0] >= LEAST_POINTS && (counts[1] >= LEAST_POINTS || counts[1] == 1);
    match is_grid {
        true => Ok(counts),
        false => Err(MapError::content(format!(
            "{} x {} points are too few: a map has {LEAST_POINTS} in each direction at least, a profile {LEAST_POINTS} in a row",
            counts[0], counts[1]
        ))),
    }
}

#[cfg(test)]
mod tests;
