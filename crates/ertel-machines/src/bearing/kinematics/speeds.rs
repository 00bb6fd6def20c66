//! Speeds of the rings.

/// Speeds of both rings, rad/s, in the same direction of rotation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Speeds {
    /// ω_i.
    pub inner: f64,
    /// ω_o.
    pub outer: f64,
}

impl Speeds {
    /// ω_i − ω_o.
    pub fn relative(&self) -> f64 {
        self.inner - self.outer
    }
}
