//! All integration tests in one program: each program of its own would link the whole library once more, and run alone.

mod bad_cases;
mod commands;
mod compare;
mod constants;
mod curve;
mod data_sheet;
mod docs;
mod estimate;
mod files;
mod fit;
mod interferogram;
mod machine;
mod manners;
mod mixed;
mod own_data;
mod places;
mod schema;
mod solve;
mod studies;
mod sweep;
mod uncertainty;
mod unresolved;
mod unwritable;
mod user_files;
mod validate;
mod view;
