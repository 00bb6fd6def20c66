//! Linear solvers: multifrontal Cholesky with static condensation, multifrontal and sparse LU, Krylov.

pub mod compliance;
pub mod condensed;
pub mod dense;
pub mod frontal_lu;
pub mod fronts;
pub mod gmres;
pub mod lu;
pub mod ordering;
