//! Figures of single contacts, and their sums over a machine.

use crate::mark::Marked;
use crate::point::{MachineSolution, PointSolution};
use crate::solution::Figure;

/// The contact with the smallest film, by its place among the contacts.
pub(super) fn thinnest(solved: &MachineSolution) -> Option<usize> {
    let films = solved
        .solved()
        .filter_map(|(i, point)| Some((i, figure_of(point, Figure::FilmMinimum)?.value)));
    let (i, _) = films.min_by(|a, b| a.1.total_cmp(&b.1))?;
    Some(i)
}

/// A figure of a contact.
pub(super) fn figure_of(point: &PointSolution, figure: Figure) -> Option<Marked> {
    Marked::of(point.outcome.solution()?, figure)
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
