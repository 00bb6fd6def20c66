//! Layout of a text, limits of its points, and why a map is refused.

use ertel_input::csv::CsvError;
use ertel_input::file::FileError;
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
    pub(super) fn at(line: usize, problem: impl Into<String>) -> MapError {
        MapError::Line {
            line,
            problem: problem.into(),
        }
    }

    pub(super) fn content(problem: impl Into<String>) -> MapError {
        MapError::Content(problem.into())
    }
}

/// Refuses grids with too many points, or too few.
pub(super) fn checked(counts: [usize; 2]) -> Result<[usize; 2], MapError> {
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

/// A map of `counts` points, whose heights must be finite or missing.
pub(super) fn finite(
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
