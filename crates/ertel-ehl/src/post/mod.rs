//! Figures and fields of any film for output, in SI, and warnings about them.

pub mod checks;
pub mod fields;
pub mod limits;
pub mod mixed;
pub mod shear;
pub mod stresses;
pub mod summary;
pub mod thermal;
