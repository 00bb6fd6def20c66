//! Small contacts, solved once for all tests of output: those of the golden records.

use std::path::Path;
use std::sync::OnceLock;

use crate::case::{Case, CaseEcho};
use crate::contact::ContactKind;
use crate::run::solve;
use crate::solution::Solution;
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

/// The same, to be changed.
pub(super) fn owned(kind: ContactKind) -> (CaseEcho, Solution) {
    solved(kind).clone()
}
