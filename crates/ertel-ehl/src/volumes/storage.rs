//! Change in time of something at the nodes.

/// How something at the nodes changes in time, mass or temperature: ∂q/∂T = c_0 q + h with h = Σ c_k q of the instants before.
#[derive(Clone, Debug)]
pub struct Storage {
    /// c_0.
    pub rate: f64,
    /// h at all nodes.
    pub past: Vec<f64>,
}
