//! Tuned constants of the finite elements, each with its purpose and, where measured, the basis.
//!
//! Decisions behind them: 0007 (orders and refinement), 0010 (film and heat in turn), 0012 (films first), 0023 (ridge diffusion), 0024 (films
//! and pressure at once), 0025 and 0027 (rollers).
//!
//! None is a property of a contact: another value costs time or accuracy, or keeps a contact from being solved. A change is tried on the
//! convergence map and on the calibration of the error bars (`benches`), and moves the golden records.

pub mod bars;
pub mod continuation;
pub mod errors;
pub mod heat;
pub mod meshes;
pub mod newton;
pub mod refinement;
pub mod ridge;
pub mod stages;
pub mod warm;
