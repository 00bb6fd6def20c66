//! Validation: comparison with published values, study by study.
//!
//! A study is a folder with case files and a `reference.toml` that says which runs to make of them
//! and which published values, tolerances and reasons belong to the results.

mod check;
mod deflection;
mod instants;
mod outcome;
mod page;
mod picture;
mod place;
mod profiles;
mod quantity;
mod read;
mod read_picture;
mod run;
mod study;
mod table;
mod update;

pub use check::{Accept, Check, Reference, Row, Verdict};
pub use deflection::{Deflection, deflect};
pub use outcome::{Outcome, Run, Selection, Task};
pub use page::{markdown, splice};
pub use place::{Place, Published};
pub use profiles::Profile;
pub use quantity::Quantity;
pub use read::{names, read};
pub use run::StudyResult;
pub use study::{Picture, PictureKind, Study};
pub use table::{csv, summary, text};
pub use update::{Change, update};
