//! Mechanics of rolling bearings, gears and cams: geometry, motion, loads, life and friction models, in SI and without a solver.
//!
//! What comes out are the contacts of a machine, each with its radii, speeds and load, and the figures of norms and models that stand beside
//! what a solver finds in them. It reads no files and writes no text.

pub mod bearing;
pub mod cam;
pub mod gear;
