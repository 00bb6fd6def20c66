//! Files on disk, whatever stands in them: written whole or not at all, at the place that a name leads to.

mod csv;
mod place;
mod whole;

pub use csv::{quoted, text_field};
pub use place::place;
pub(crate) use whole::{TEMPORARY, sync_folder};
pub use whole::{clear_unfinished, write_whole};
