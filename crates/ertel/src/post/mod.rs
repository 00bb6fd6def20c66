//! Figures and fields from a converged state.

pub mod film;
pub mod profile;
