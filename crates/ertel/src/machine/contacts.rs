//! Figures of single contacts, and their sums over a machine.

use crate::mark::Marked;
use crate::point::{MachineSolution, PointSolution};
use crate::solution::Figure;

/// A value of each contact of a machine; `None` where it is not known.
pub(super) type Values = Vec<Option<Marked>>;

/// A value of every contact that is solved, those that are alike included.
pub(super) fn each(
    solved: &MachineSolution,
    value: impl Fn(&PointSolution) -> Option<Marked>,
) -> Values {
    let all = 0..solved.contacts.len();
    all.map(|i| value(solved.of(i)?)).collect()
}

/// A figure of a contact.
pub(super) fn figure_of(point: &PointSolution, figure: Figure) -> Option<Marked> {
    Marked::of(point.outcome.solution()?, figure)
}

/// The friction coefficient of a contact: of oil and asperities where they share the load.
pub(super) fn friction_of(point: &PointSolution) -> Option<Marked> {
    let both = figure_of(point, Figure::FrictionTotal);
    both.or_else(|| figure_of(point, Figure::TractionCoefficient))
}

/// Sum over all loaded contacts, identical ones counted as often as they occur. `None` where one of them has no value.
pub(super) fn sum(
    solved: &MachineSolution,
    value: impl Fn(usize, &PointSolution) -> Option<Marked>,
) -> Option<Marked> {
    let machine = &solved.machine;
    let own = machine.contacts.iter().enumerate();
    let own = own.filter(|(i, contact)| contact.like == Some(*i));
    let of = own.map(|(i, _)| Some(value(i, solved.of(i)?)? * machine.count(i) as f64));
    let nothing = Marked {
        error: Some(0.0),
        ..Marked::exact(0.0)
    };
    of.into_iter().try_fold(nothing, |sum, of| Some(sum + of?))
}
