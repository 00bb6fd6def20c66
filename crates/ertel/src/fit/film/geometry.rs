//! The ellipses of a table.

use ertel_input::csv::{Column, CsvTable, Row};
use ertel_quantity::Dimension;

use super::header::{need, positive};
use crate::contact::Contact;
use crate::fit::DataError;

/// Names of the columns, as tables of studies have them, and as their axes do.
const ACROSS: [&str; 2] = ["radius y", "contact.radius y"];
const ANGLE: [&str; 2] = ["entrainment angle", "contact.entrainment angle"];
const ALONG: [&str; 2] = ["radius", "radius x"];

/// A turn: angles beyond it are mistaken units.
const TURN: f64 = std::f64::consts::TAU;

/// Where the radii of an ellipse and the angle of its motion come from.
pub(super) struct Ellipses {
    radius: Result<f64, Column>,
    across: Column,
    /// Along x where there is none.
    angle: Option<Column>,
}

impl Ellipses {
    /// The columns of a table; `radius` (m) replaces that of the radius along x.
    ///
    /// # Errors
    ///
    /// Missing columns.
    pub fn new(table: &CsvTable, radius: Option<f64>) -> Result<Ellipses, DataError> {
        let length = Dimension::LENGTH;
        let help = " with a unit, such as `radius_y_m`, the reduced radius of the ellipses along y";
        let across = need(table, &ACROSS, length, help)?;
        let radius = match radius {
            Some(radius) => Ok(radius),
            None => {
                let help = " with a unit, such as `radius_m`, the reduced radius along x, and no radius for all is given \
                            (`--radius`)";
                Err(need(table, &ALONG, length, help)?)
            }
        };
        let angle = match table.find(ANGLE[0], Dimension::ANGLE)? {
            Some(column) => Some(column),
            None => table.find(ANGLE[1], Dimension::ANGLE)?,
        };
        Ok(Ellipses {
            radius,
            across,
            angle,
        })
    }

    /// The same where the table is one of ellipses.
    ///
    /// # Errors
    ///
    /// Missing columns of a table that has one of them.
    pub fn of(table: &CsvTable, radius: Option<f64>) -> Result<Option<Ellipses>, DataError> {
        for name in ACROSS {
            if table.find(name, Dimension::LENGTH)?.is_some() {
                return Ellipses::new(table, radius).map(Some);
            }
        }
        Ok(None)
    }

    /// The ellipse of a row, its first axis the one nearest to the motion, under no load in particular.
    ///
    /// # Errors
    ///
    /// Radii that are not above zero, angles beyond a turn.
    pub fn contact(&self, table: &CsvTable, row: &Row) -> Result<Contact, DataError> {
        let radius = match &self.radius {
            Ok(radius) => *radius,
            Err(column) => positive(table, row, column, false)?,
        };
        let across = positive(table, row, &self.across, false)?;
        let angle = match &self.angle {
            None => 0.0,
            Some(column) => {
                let angle = table.required_number(row, column)?;
                if !(-TURN..=TURN).contains(&angle) {
                    let problem = format!(
                        "{}: {angle} rad is more than a turn: give its unit in the header, such as `entrainment_angle_deg`",
                        column.name
                    );
                    return Err(table.error(row, column.index, problem));
                }
                angle
            }
        };
        Ok(Contact::elliptical([radius, across], 1.0, angle).along_motion())
    }
}
