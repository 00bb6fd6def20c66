//! Linear solvers: sparse Cholesky with static condensation, sparse LU, Krylov.

pub mod condensed;
pub mod gmres;
pub mod lu;
pub mod ordering;
