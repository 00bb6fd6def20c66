//! Elastic constants of a body.

use serde::Serialize;

/// Elastic constants of one body; the modulus in Pa, or over the stress scale of the solver ([`Material::over`]).
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Material {
    /// Young's modulus E.
    pub youngs_modulus: f64,
    /// Poisson's ratio ν.
    pub poissons_ratio: f64,
}

impl Material {
    /// The same with the modulus over a stress scale.
    #[must_use]
    pub fn over(self, stress: f64) -> Material {
        Material {
            youngs_modulus: self.youngs_modulus / stress,
            ..self
        }
    }

    /// (1 − ν²)/E, by which a half-space deflects.
    pub fn compliance(self) -> f64 {
        (1.0 - self.poissons_ratio * self.poissons_ratio) / self.youngs_modulus
    }
}

/// Σ(1 − ν²)/E of bodies: a half-space of them answers a wave of pressure of the wave number k by 2/|k| times that.
pub fn compliance(bodies: &[Material]) -> f64 {
    bodies.iter().map(|body| body.compliance()).sum()
}

/// Reduced modulus of two bodies, Pa: 2/E' = (1 − ν_1²)/E_1 + (1 − ν_2²)/E_2.
///
/// Source: Habchi 2008, eq. 2.27 (as corrected in `docs/theory`).
pub fn reduced_modulus(body_1: Material, body_2: Material) -> f64 {
    2.0 / (body_1.compliance() + body_2.compliance())
}
