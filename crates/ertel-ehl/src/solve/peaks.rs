//! Peaks of the pressure: the smooth one in the middle of the contact, and the highest other one.
//!
//! In point contacts there is a ridge before the outlet that may exceed the pressure of the middle, and that few meshes resolve. Both are
//! separated by the lowest pass between them.

use super::discretisation::Discretisation;
use super::evaluate::largest_of_elements;
use super::neighbours::Neighbours;
use super::state::State;
use crate::engine::hills::hills;

/// A largest pressure in p_h, and where it is in half-widths.
pub(super) type Peak = (f64, [f64; 2]);

/// The peaks of a pressure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Peaks {
    /// That of the hill on which the centre of the contact lies.
    pub central: Peak,
    /// The highest of the others.
    pub other: Option<Peak>,
}

/// The peaks of a state; the others only where `counts`.
pub(super) fn peaks(
    d: &Discretisation,
    state: &State,
    counts: impl Fn([f64; 2]) -> bool,
) -> Option<Peaks> {
    let surface = &d.contact.surface;
    let (centre, _) = d.contact.locator.find(surface, [0.0; 2])?;
    let tops = largest_of_elements(d, state);
    let values: Vec<f64> = tops.iter().map(|(p, _)| *p).collect();
    let hills = hills(&values, &Neighbours::new(surface).of, centre);
    let others = hills.others.into_iter().map(|c| tops[c]);
    Some(Peaks {
        central: tops[hills.central],
        other: others
            .filter(|(_, place)| counts(*place))
            .max_by(|a, b| a.0.total_cmp(&b.0)),
    })
}
