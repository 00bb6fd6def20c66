//! Values that pictures of machines draw.

use crate::solution::Figure;
use crate::study::MachineSolution;

/// A figure of a contact, where it is resolved.
pub(super) fn film(machine: &MachineSolution, contact: usize, figure: Figure) -> Option<f64> {
    let found = machine.solution(contact)?.figure(figure)?;
    found.resolved.then_some(found.value)
}

/// The largest size of the values of curves, without gaps.
pub(super) fn largest(of: &[Vec<[f64; 2]>]) -> f64 {
    of.iter().flatten().map(|p| p[1].abs()).fold(0.0, f64::max)
}
