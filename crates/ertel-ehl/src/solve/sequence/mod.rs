//! Stage after stage from the dry contact to the solution: meshes from coarse to fine, a diffusive start before
//! the case's own equations, continuations where one fails.
//!
//! - `problem`: the contact, the method, the solution of a stage;
//! - `stage`: the data of one stage;
//! - `paths`: continuations to the case's own contact through easier ones;
//! - `driver`: which stage comes next, whatever solves it;
//! - `mesh_solver`: a stage on its mesh, from the state before;
//! - `stage_run`: Newton's method on it;
//! - `start`: from which pressures;
//! - `warm`: from the solution of a similar problem instead.

mod driver;
mod mesh_solver;
mod paths;
mod problem;
mod stage;
pub mod stage_run;
pub mod start;
mod warm;

pub use mesh_solver::solve_stages;
pub use problem::{HeatPlan, Plan, Problem, StageSolution};
pub use stage::Stage;
pub use warm::{Start, solve_on_mesh, solve_warm};
