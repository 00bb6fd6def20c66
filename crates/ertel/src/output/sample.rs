//! Small contacts, solved once for all tests of output: those of the golden records.

use std::path::Path;
use std::sync::OnceLock;

use crate::case::{Case, CaseEcho};
use crate::contact::ContactKind;
use crate::run::solve;
use crate::solution::{Bar, Figure, Reading, Solution};
use crate::solve::NoObserver;

/// A contact with its solution: a line contact, or an elliptical or circular one on a coarse mesh.
pub(super) fn solved(kind: ContactKind) -> &'static (CaseEcho, Solution) {
    static SOLVED: [OnceLock<(CaseEcho, Solution)>; 3] = [const { OnceLock::new() }; 3];
    let (place, text) = match kind {
        ContactKind::Line => (0, include_str!("../../tests/golden/cases/line.toml")),
        ContactKind::Circular => (1, include_str!("../../tests/golden/cases/circle.toml")),
        ContactKind::Elliptical => (2, include_str!("../../tests/golden/cases/ellipse.toml")),
        ContactKind::Roller => panic!("no roller among the samples"),
    };
    SOLVED[place].get_or_init(|| {
        let case = Case::from_text("sample.toml", text, Path::new("")).expect("a valid case");
        let solution = solve(&case, &mut NoObserver).expect("it converges");
        (case.echo(), solution)
    })
}

/// Sets a figure that the summary has, too, with its error bar, SI.
pub(super) fn set(solution: &mut Solution, figure: Figure, value: f64, error: f64) {
    solution.measured.figures.set(figure, Reading::new(value));
    let bar = Bar {
        value: error,
        place: None,
    };
    solution.measured.bars.set(figure, bar);
    let estimate = solution.measured.estimate(figure);
    match figure {
        Figure::FilmCentral => solution.summary.film_central = estimate,
        other => panic!("{} is not set by a test yet", other.name()),
    }
}

/// The same, to be changed.
pub(super) fn owned(kind: ContactKind) -> (CaseEcho, Solution) {
    solved(kind).clone()
}
