//! The interface between the users of a contact solution and the numerical methods.
//!
//! ```text
//!   Problem (the contact, dimensionless) + plan (meshes, tolerances, strategy)  →  Engine  →  Solved: film, figures, error bars, effort
//! ```
//! An engine is a numerical method: finite elements ([`crate::solve`]) or finite volumes ([`crate::volumes`]). Post-processing uses a
//! [`Film`], which any engine provides: the fields at its quadrature points and at any place.

pub mod around;
pub mod coupling;
mod error;
pub mod far_field;
pub mod figures;
pub mod film;
pub mod flux;
pub mod friction;
pub mod heat;
pub mod hills;
mod observer;
mod problem;
mod profile;
pub mod region;
pub mod sensitivity;
pub mod shear;

pub use error::{HeatError, MissingDatum, MissingHeatData, SolveError, Stopped};
pub use film::{Film, Point, PointFields, PointTable};
pub use observer::{NoObserver, Observer};
pub use problem::{Extents, Problem};
pub use profile::{Meniscus, Profile};

use crate::solution::{LevelStats, Measured};

/// A numerical method for contacts.
pub trait Engine {
    /// Its meshes, tolerances and strategies.
    type Plan;
    /// Its solution.
    type Solution: Solved<Plan = Self::Plan>;
    /// A start: the solution of a similar problem.
    type Start;
    /// Its errors.
    type Error: std::error::Error;

    /// Solves a problem from the dry contact.
    ///
    /// # Errors
    /// When it does not converge, cannot be discretised, or the user wants to stop.
    fn solve(
        &self,
        problem: &Problem<Self::Plan>,
        observer: &mut dyn Observer,
    ) -> Result<Self::Solution, Self::Error>;

    /// Solves a problem from the solution of a similar one; `None` where it does not converge from there.
    ///
    /// # Errors
    /// When the user wants to stop.
    fn solve_from(
        &self,
        problem: &Problem<Self::Plan>,
        start: &Self::Start,
        observer: &mut dyn Observer,
    ) -> Result<Option<Self::Solution>, Self::Error>;
}

/// A solution of an engine.
pub trait Solved {
    /// Settings of the engine.
    type Plan;

    /// The film, for post-processing.
    fn film(&self, problem: &Problem<Self::Plan>) -> impl Film;

    /// Figures with error bars, SI.
    fn measured(&self, problem: &Problem<Self::Plan>) -> Measured;

    /// Effort and figures of each stage, the last one that of the solution.
    fn levels(&self) -> &[LevelStats];
}
