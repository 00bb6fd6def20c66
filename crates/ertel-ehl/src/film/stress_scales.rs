//! Stresses of a law that a quadrature across the film must resolve.

/// Stresses, in one unit with τ and G, that the quadrature must resolve.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StressScales {
    /// κ, beyond which the fluid thins by a power law.
    pub knee: Option<f64>,
    /// Stress by which the fluidity grows exponentially.
    pub growth: Option<f64>,
    /// Stress that the fluid cannot pass.
    pub limit: Option<LimitScale>,
    /// e-folds by which the fluidity varies across the film for its temperature.
    pub variation: Option<f64>,
}

/// A limiting stress for a quadrature.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LimitScale {
    /// The limit τ_L.
    pub stress: f64,
    /// Stress r₁τ_L beyond which the fluidity is exponential.
    pub joint: f64,
    /// Stress by which it then grows e-fold.
    pub fold: f64,
}
