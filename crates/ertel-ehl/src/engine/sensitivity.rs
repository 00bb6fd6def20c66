//! Derivatives of figures by inputs, for any engine.

use super::Problem;
use crate::solution::Figure;

/// The reason why derivatives by an input are unavailable.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NoDerivative {
    /// It moves the edge of the contact area.
    #[error("it moves the edge of the contact area")]
    Edge,
    /// The mesh cannot be made for the changed shape.
    #[error("the mesh cannot be made for a changed shape")]
    Mesh,
    /// Its linear equations could not be solved.
    #[error("its linear equations could not be solved")]
    LinearSolver,
    /// One of them is not a finite number.
    #[error("one of its derivatives is not a finite number")]
    NotFinite,
}

/// A problem whose input differs a little from that of the solution.
pub struct Perturbed<Plan> {
    /// The problem.
    pub problem: Problem<Plan>,
    /// By how much the input differs.
    pub step: f64,
}

/// A solution that provides its derivatives.
pub trait Derivatives<Plan> {
    /// The figures that derivatives are of.
    fn figures(&self) -> Vec<Figure>;

    /// Value of a figure at the solution, SI.
    fn value(&self, figure: Figure) -> f64;

    /// Derivatives of the figures, SI, for each input.
    fn derivatives(&self, inputs: &[Perturbed<Plan>]) -> Vec<Result<Vec<f64>, NoDerivative>>;
}
