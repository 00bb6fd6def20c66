//! Tuned constants of the finite elements, each with its purpose and, where measured, the basis.
//!
//! Decisions behind them: 0007 (orders), 0010 (film and heat in turn), 0025 (rollers).
//!
//! None is a property of a contact: another value costs time or accuracy, or keeps a contact from being solved. A change is tried on the
//! studies of the thesis (`ertel validate`), and moves the golden records.

pub mod heat;
pub mod meshes;
pub mod newton;
pub mod stages;
