//! Heights of a surface from a file: text in rows, points, CSV, SDF (ISO 25178-71) and X3P (ISO 25178-72).

mod layout;
mod sdf;
mod text;
mod x3p;

use std::path::Path;

use ertel_input::file::{LARGEST_TABLE, read_bytes, read_table};

use crate::contact::topography::Topography;
pub use layout::{LEAST_POINTS, Layout, MOST_POINTS, MapError};
use layout::{checked, finite};

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

#[cfg(test)]
mod tests;
