//! Validation: comparison with published values, study by study.
//!
//! A study is a folder with case files and a `reference.toml` that says which runs to make of them
//! and which published values, tolerances and reasons belong to the results.

use std::path::PathBuf;

mod check;
mod deflection;
mod instants;
mod page;
mod picture;
mod profiles;
mod quantity;
mod read;
mod read_picture;
mod run;
mod table;
mod update;

pub use check::{Accept, Check, Reference, Row, Verdict};
pub use deflection::{Deflection, deflect};
pub use instants::{Place, Published};
pub use page::{markdown, splice};
pub use picture::{Picture, PictureKind};
pub use profiles::Profile;
pub use quantity::Quantity;
pub use read::{names, read};
pub use run::{Outcome, Run, Selection, StudyResult, Task};
pub use table::{csv, summary, text};
pub use update::{Change, update};

/// A validation study.
#[derive(Clone, Debug)]
pub struct Study {
    /// Name of its folder.
    pub name: String,
    /// One line.
    pub title: String,
    /// Source of the published values.
    pub source: String,
    /// Every file that it was read from.
    pub files: Vec<PathBuf>,
    /// Computations.
    pub runs: Vec<Run>,
    /// Comparisons.
    pub checks: Vec<Check>,
    /// Pictures.
    pub pictures: Vec<Picture>,
}
