//! Small contacts from the golden records, solved once for all output tests.

use std::path::Path;
use std::sync::OnceLock;

use crate::case::{Case, CaseEcho};
use crate::engine::NoObserver;
use crate::run::solve;
use crate::solution::{Bar, Figure, Reading, Solution};

/// A case with its solution.
pub(super) type Sample = (CaseEcho, Solution);

/// A line contact.
pub(super) fn line() -> &'static Sample {
    static SOLVED: OnceLock<Sample> = OnceLock::new();
    SOLVED.get_or_init(|| solved(include_str!("../../tests/golden/cases/line.toml")))
}

/// A circular contact on a coarse mesh.
pub(super) fn circle() -> &'static Sample {
    static SOLVED: OnceLock<Sample> = OnceLock::new();
    SOLVED.get_or_init(|| solved(include_str!("../../tests/golden/cases/circle.toml")))
}

/// An elliptical contact on a coarse mesh.
pub(super) fn ellipse() -> &'static Sample {
    static SOLVED: OnceLock<Sample> = OnceLock::new();
    SOLVED.get_or_init(|| solved(include_str!("../../tests/golden/cases/ellipse.toml")))
}

fn solved(text: &str) -> Sample {
    let case = Case::from_text("sample.toml", text, Path::new("")).expect("a valid case");
    let solution = solve(&case, &mut NoObserver).expect("it converges");
    (case.echo(), solution)
}

/// Sets a figure with its error bar, SI, including its value in the summary.
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
