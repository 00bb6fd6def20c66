//! Figures and fields of a solved stage for output, in SI.

mod balance;
pub mod elements;
pub mod fields;
pub mod summary;
mod temperature_field;
pub mod thermal;
