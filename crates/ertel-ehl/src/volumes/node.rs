//! Quantities of the film equation at a node.

/// Nodal quantities of the film equation.
#[derive(Clone, Copy, Debug, Default)]
pub struct Node {
    /// P.
    pub pressure: f64,
    /// H.
    pub film: f64,
    /// ρ̄ and ρ̄' by P.
    pub density: [f64; 2],
    /// ln μ̄ and its derivative by P.
    pub ln_viscosity: [f64; 2],
    /// m = ρ̄H.
    pub mass: f64,
    /// Its derivatives by P and by H.
    pub mass_by: [f64; 2],
}
