//! Mechanics of rolling bearings, gears and cams: geometry, motion, loads, life and friction models, in SI and without a solver.
//!
//! The results are the contacts of a machine, each with its radii, speeds and load, and the figures of standards and models for comparison
//! with solved contacts. The crate reads no files and writes no text.

pub mod bearing;
pub mod cam;
pub mod gear;

#[cfg(test)]
#[path = "../../ertel-quantity/tests/common/near.rs"]
mod near;
