//! Files on disk, whatever their content: written completely or not at all, with links followed.

mod csv;
mod place;
mod whole;

pub use csv::{quoted, text_field};
pub use place::place;
pub(crate) use whole::{TEMPORARY, sync_folder};
pub use whole::{clear_unfinished, write_whole};
