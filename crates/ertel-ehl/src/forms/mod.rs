//! Weak forms, one per file; the loops over elements live in `solve`.

pub mod dual;
pub mod elasticity;
pub mod energy;
pub mod flow;
pub mod oil_layer;
pub mod reynolds;
