//! Stage after stage from the dry contact to the solution: a diffusive start on a coarse mesh, the case's own equations, finer meshes.
//!
//! - `problem`: the contact, the method, the solution of a stage;
//! - `stage`: the data of one stage;
//! - `meshes`: stages on their meshes, each from the state before, and halved meshes;
//! - `stage_run`: Newton's method on one;
//! - `start`: from which pressures;
//! - `similar`: from the solution of a similar problem instead.

mod meshes;
mod problem;
mod similar;
mod stage;
pub mod stage_run;
pub mod start;

pub use meshes::solve_stages;
pub use problem::{HeatPlan, MeshEnd, Plan, Problem, StageSolution, Target};
pub use similar::{Start, solve_on_mesh, solve_warm};
pub use stage::Stage;
