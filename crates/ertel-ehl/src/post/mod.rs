//! Figures and fields from a converged state.

pub mod balance;
pub mod checks;
pub mod elements;
pub mod fields;
pub mod limits;
pub mod mixed;
pub mod shear;
pub mod summary;
pub mod thermal;

pub use crate::solve::profile;
