//! Figures at each contact of a machine: along a path of contact, round a bearing, over the turn of a cam.

use super::Definition;
use crate::mark::Marked;

/// A place at which a machine has figures.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// Which contact is there, by its place among the contacts.
    pub contact: usize,
    /// Coordinate of the contact: angle, rad, or distance from the pitch point, m.
    pub at: f64,
    /// `A` to `E` on a path of contact.
    pub label: Option<String>,
    /// Of which side of a jump of the load these figures are, where the contact itself is on the other side.
    pub beyond: Option<Beyond>,
}

/// A side of a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beyond {
    /// Towards smaller coordinates.
    Before,
    /// Towards larger coordinates.
    After,
}

impl Beyond {
    /// Name in results.
    pub fn name(self) -> &'static str {
        match self {
            Beyond::Before => "before",
            Beyond::After => "after",
        }
    }
}

/// A figure at all places.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactFigure {
    /// Its attributes.
    pub figure: Definition,
    /// Its SI unit; empty of a pure number.
    pub unit: &'static str,
    /// Its values; `None` where it has none: contacts without load or film, and the other side of a jump, where no film is solved.
    pub values: Vec<Option<Marked>>,
}

/// The places in their order, and the figures there.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ContactFigures {
    /// Places of the contacts; two where the load jumps.
    pub places: Vec<Place>,
    /// Figures of these machines, without those that have no value anywhere.
    pub all: Vec<ContactFigure>,
}

impl ContactFigures {
    /// A figure by its attributes.
    pub fn find(&self, figure: Definition) -> Option<&ContactFigure> {
        self.all.iter().find(|entry| entry.figure == figure)
    }

    /// Adds a figure that has a value somewhere; values that are not finite are left out. `is_per_length`: of forces and powers.
    pub(crate) fn push(
        &mut self,
        figure: Definition,
        is_per_length: bool,
        values: impl Iterator<Item = Option<Marked>>,
    ) {
        let is_number = |value: &Marked| {
            value.value.is_finite() && value.error.is_none_or(|error| error.is_finite())
        };
        let values: Vec<Option<Marked>> = values.map(|value| value.filter(is_number)).collect();
        if values.iter().any(Option::is_some) {
            let unit = figure.kind.unit(is_per_length);
            self.all.push(ContactFigure {
                figure,
                unit,
                values,
            });
        }
    }
}

impl ContactFigure {
    /// Whether some of its values have error bars.
    pub fn has_bars(&self) -> bool {
        let mut values = self.values.iter().flatten();
        values.any(|value| value.error.is_some())
    }
}
