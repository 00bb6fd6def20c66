//! Finite volumes on regular grids: a monotone engine for line and point contacts and rollers between half-spaces: flooded or starved, Newtonian or shear-thinning,
//! isothermal or thermal.
//!
//! ```text
//!   ∇·F = 0,  P ≥ 0,  F = ū ρ̄H − H₊³ρ̄/(μ̄λ) ∇P       one balance of mass for each node
//!   H = H_0 + G + δ,  δ = K * P                           by fast Fourier transforms
//! ```
//! The flux through a face takes ln μ̄ as linear between its nodes (exponential fitting): a higher pressure drives more flow out and none in,
//! whatever the viscosity does between them. Newton's method converges from the dry contact without continuation.
//!
//! | module | what |
//! |---|---|
//! | [`grid`] | nodes of a patch |
//! | [`rows`] | rows of nodes along a roller |
//! | [`roller_zone`] | where its pressure ends |
//! | [`kernel`] | influence of the pressure on the deflection of the bodies |
//! | [`convolution`], [`rows_convolution`] | sums with influence coefficients on a grid, also those of heat; under rows of a roller |
//! | [`along`], [`padded`], [`axial`] | the transforms, along rows and of grids; shapes along the axis of a roller |
//! | [`deflection`], [`inverse`] | deflection under the pressures of a grid; stencils near to the inverse |
//! | [`node`] | quantities of the film equation at a node |
//! | [`faces`] | flux through a face and its derivatives |
//! | [`thinning`] | shear thinning of the film at a node |
//! | [`storage`] | change in time at the nodes |
//! | [`contents`] | oil in partly filled gaps |
//! | [`behind`] | oil behind the film |
//! | [`passing`] | how contents change with the pressures |
//! | [`system`], [`step`] | the equation and its linearisation; Newton's step |
//! | [`preconditioner`], [`line_factors`] | the sparse approximation of its matrix; factors of that of a long line |
//! | [`multigrid`], [`transfer`] | a cycle over coarser grids that solves it |
//! | [`stencil`], [`rectangle`] | its matrix, incomplete and complete factors |
//! | [`newton`], [`ending`] | Newton's method with active sets, and when it ends |
//! | [`pseudo_time`] | a steady film as the end of one in time |
//! | [`beyond`], [`far_pressure`] | the region beyond the first grid |
//! | [`level`] | from a grid to one with cells of half the size on a smaller patch |
//! | [`film`], [`composite`], [`fields`] | the film on all patches together; its mesh and fields |
//! | [`extremes`], [`figures`], [`summary`] | figures, error bars, warnings |
//! | [`heat`] | temperatures of film and surfaces |
//! | [`reduction`] | the film compared with that of the Newtonian fluid |
//! | [`tangents`] | derivatives of the figures by inputs |
//! | [`scope`] | which contacts it solves |
//! | [`patches`] | which grids it solves them on |
//! | [`plan`] | tolerances and limits |
//! | [`engine`] | grids until the films reach the target error |
//!
//! Theory: Finite volumes.

pub mod along;
pub mod axial;
pub mod behind;
pub mod beyond;
pub mod composite;
pub mod contents;
pub mod convolution;
pub mod deflection;
pub mod edges;
pub mod ending;
pub mod engine;
pub mod extremes;
pub mod faces;
pub mod far_pressure;
pub mod fields;
pub mod figures;
pub mod film;
pub mod grid;
pub mod heat;
pub mod inverse;
pub mod kernel;
pub mod level;
pub mod line_factors;
pub mod multigrid;
pub mod newton;
pub mod node;
pub mod padded;
pub mod passing;
pub mod patches;
pub mod plan;
pub mod preconditioner;
pub mod pseudo_time;
pub mod rectangle;
pub mod reduction;
pub mod roller_zone;
pub mod rows;
pub mod rows_convolution;
pub mod scope;
pub mod stencil;
pub mod step;
pub mod storage;
pub mod summary;
pub mod system;
pub mod tangents;
pub mod thinning;
pub mod transfer;

pub use engine::{FiniteVolumes, Volumes};
pub use plan::Plan;
pub use scope::{About, HeatAbout, why_not};

#[cfg(test)]
mod tests;
