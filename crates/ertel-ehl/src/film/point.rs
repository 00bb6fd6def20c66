//! Density and viscosity of the film at a point.

/// Fluid at a point: value, first and second derivative by P.
#[derive(Clone, Copy, Debug)]
pub struct PointFluid {
    /// ρ̄, ρ̄', ρ̄''.
    pub density: [f64; 3],
    /// μ̄, μ̄', μ̄''.
    pub viscosity: [f64; 3],
}
