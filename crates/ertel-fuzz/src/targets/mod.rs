//! The readers, each driven as far as is cheap, and what must hold of them.

pub mod answers;
mod case;
mod checkpoint;
pub mod course;
mod curve_result;
mod fit;
mod grid;
pub mod journal;
mod measured;
mod own_data;
mod python;
pub mod read;
mod settings;
pub mod stopped;
mod study;
pub mod surface;
mod verdict;
pub mod view;
mod web;

use std::path::Path;

use crate::finding::Defect;
use crate::input::{Input, Target};

pub use verdict::Verdict;
use verdict::{check_place, check_text, n_lines};

/// Reads the files of an input, which stand in `folder`.
///
/// # Errors
/// A rule that does not hold.
pub fn run(input: &Input, folder: &Path) -> Result<Verdict, Defect> {
    match input.target {
        Target::Case | Target::Table | Target::Machine | Target::Surface | Target::Course => {
            case::run(folder)
        }
        Target::X3p => surface::x3p(input, folder),
        Target::Solve => case::solve(folder),
        Target::Study | Target::Points => study::run(folder),
        Target::FitViscosity | Target::FitDensity | Target::FitFilm => fit::run(input),
        Target::Measured => measured::run(folder),
        Target::Journal | Target::StudyList => journal::run(folder),
        Target::Settings => settings::run(input, folder),
        Target::Answers => answers::run(input),
        Target::OwnData => own_data::run(folder),
        Target::CurveResult => curve_result::run(folder),
        Target::View => view::run(input),
        Target::Python => python::run(input, folder),
        Target::Web => web::run(input),
        Target::Checkpoint => checkpoint::run(input, folder),
        Target::Read => read::run(input, folder),
    }
}
