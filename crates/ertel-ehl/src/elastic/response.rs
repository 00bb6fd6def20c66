//! Response of elastic bodies to pressures at their surface.

use super::{Accuracy, Trace};

/// Response of elastic bodies, dimensionless. Values are nodal values of the trace's spaces, pressures at all nodes, edge included.
pub trait SurfaceResponse: Send + Sync {
    /// Deflection at the deflection nodes under nodal pressures.
    fn deflect(&self, trace: &Trace, pressure: &[f64], accuracy: Accuracy) -> Vec<f64>;

    /// Stiffness between near deflection nodes, in the order of [`near_pairs`](super::near_pairs), for a preconditioner.
    fn near_stiffness(&self) -> Vec<f64>;

    /// Σ(1 − ν²)/E for short waves.
    fn compliance(&self) -> f64;

    /// Frees memory of data that can be computed again on demand.
    fn release(&self) {}
}
