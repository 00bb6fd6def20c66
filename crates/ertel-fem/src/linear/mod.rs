//! Linear solvers: multifrontal Cholesky with static condensation, multifrontal and sparse LU, Krylov.

pub mod block_ilu;
pub mod compliance;
pub mod condensed;
pub mod dense;
pub mod equilibrate;
pub mod frontal_lu;
pub mod fronts;
pub mod gmres;
pub mod lu;
pub mod ordering;
pub mod recycled;

/// Asked now and then during long work, from any thread: whether to give up.
pub type Stop<'a> = &'a (dyn Fn() -> bool + Sync);

/// Never gives up.
pub const NEVER: Stop<'static> = &|| false;
