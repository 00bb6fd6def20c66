//! Why a cam is refused.

use thiserror::Error;

/// Why a cam, or an operation of one, is refused.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum CamError {
    /// A number is outside the range in which it makes sense.
    #[error("{name} = {value} must be {requirement}")]
    Value {
        /// Name of the number.
        name: &'static str,
        /// The number, in SI.
        value: f64,
        /// The range.
        requirement: &'static str,
    },
    /// A table of lifts has too few or too many rows.
    #[error("a table of lifts has {rows} rows, but needs {least} to {most}")]
    TableSize {
        /// Rows given.
        rows: usize,
        /// Fewest rows.
        least: usize,
        /// Most rows.
        most: usize,
    },
    /// The angles of a table do not ascend within one turn.
    #[error(
        "angles of a table of lifts must ascend within less than one turn, but row {row} is at {angle} rad"
    )]
    TableOrder {
        /// Row, from 1.
        row: usize,
        /// Its angle, rad.
        angle: f64,
    },
    /// No spline fits the table.
    #[error("no smooth curve fits the table of lifts")]
    Spline,
    /// The angles of segments do not make up a turn.
    #[error("the segments of the lift take {sum} rad, but a turn has 2π")]
    Turn {
        /// Sum of the angles, rad.
        sum: f64,
    },
    /// Rises and returns do not cancel.
    #[error("the segments of the lift end {rise} m above their start")]
    NotClosed {
        /// Lift at the end less that at the start, m.
        rise: f64,
    },
}

/// An error unless the number is finite and inside its range.
pub(super) fn in_range(
    name: &'static str,
    value: f64,
    inside: bool,
    requirement: &'static str,
) -> Result<(), CamError> {
    if inside && value.is_finite() {
        return Ok(());
    }
    Err(CamError::Value {
        name,
        value,
        requirement,
    })
}
