//! The interface between those who ask for the solution of a contact and the method that finds it.
//!
//! ```text
//!   Problem (the contact, dimensionless) + plan (how an engine goes about it)  →  Engine  →  Solved: film, figures, error bars, effort
//! ```
//! An engine is a way of solving: finite elements ([`crate::solve`]). What is read off a film after the solve asks for a [`Film`], which
//! any engine can give: the fields at its quadrature points and at any place.

pub mod around;
pub mod far_field;
pub mod figures;
pub mod film;
pub mod flux;
pub mod friction;
pub mod hills;
mod observer;
mod problem;
mod profile;
pub mod region;
pub mod sensitivity;
pub mod shear;

pub use film::{Film, Point, PointFields, PointTable};
pub use observer::{NoObserver, Observer};
pub use problem::{Extents, Problem};
pub use profile::{Meniscus, Profile};

use crate::solution::{LevelStats, Measured};

/// A way of solving contacts.
pub trait Engine {
    /// How it goes about a problem: its meshes, tolerances and strategies.
    type Plan;
    /// What it finds.
    type Solution: Solved<Plan = Self::Plan>;
    /// What it can start from: what it found for a similar problem.
    type Start;
    /// Why it finds nothing.
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

    /// Solves a problem from the solution of a similar one; `None` where that does not lead there.
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

/// What an engine found.
pub trait Solved {
    /// How the engine went about it.
    type Plan;

    /// The film, of which anything can be read.
    fn film(&self, problem: &Problem<Self::Plan>) -> impl Film;

    /// Figures with error bars, SI.
    fn measured(&self, problem: &Problem<Self::Plan>) -> Measured;

    /// Effort and figures of each stage, the last one that of the solution.
    fn levels(&self) -> &[LevelStats];
}
