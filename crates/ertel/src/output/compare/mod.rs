//! Results of a comparison with measurements: `comparison.csv`, `comparison.json`, `comparison.svg` and a report.

mod folder;
mod json;
mod picture;
mod report;
mod settings;
mod table;

pub use folder::{COMPARISON_FILES, COMPARISON_STUDY, check_comparison_folder, write_comparison};
pub use json::{COMPARISON_FORMAT, comparison_json};
pub use picture::comparison_picture;
pub use report::comparison_report;
pub(super) use report::{failures, write_figures};
pub use table::comparison_table;
