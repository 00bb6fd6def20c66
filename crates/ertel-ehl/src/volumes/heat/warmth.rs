//! Coefficients of the film equation that depend on temperature, held fixed while its pressures are computed.
//!
//! ```text
//!   q(G, Ω) = q(0, Ω) + K G/12                         flow through a film of varying temperature (see [`crate::film::thermal_closure`])
//!   κ = 12 (q − q(0, Ω))_d/G_d · μ(T_m)/μ̄ = c κ(T_m)     along and across the sliding: c times that of a film of its mean temperature T_m
//!   u_s = −12 H q(0, Ω)/(μ̄λ)                            flow by sliding in addition to the mean of the surfaces where one side is warmer
//! ```
//! c, u_s and the ratio of mean densities change little with the pressure; once film and heat agree the flow is that of the whole profile.
//!
//! Theory: Heat by finite volumes.

/// Temperature-dependent film coefficients of a node.
#[derive(Clone, Copy, Debug)]
pub struct Warmth {
    /// T_m, K.
    pub temperature: f64,
    /// Mean density over that at T_m.
    pub density: f64,
    /// c along and across the sliding.
    pub flow: [f64; 2],
    /// u_s along the grid, over the entrainment speed.
    pub drift: [f64; 2],
}

impl Warmth {
    /// Number of its values.
    pub const PARTS: usize = 6;

    /// At another mean temperature, by its distance, K.
    pub fn warmer(&self, by: f64) -> Warmth {
        Warmth {
            temperature: self.temperature + by,
            ..*self
        }
    }

    /// Moved by its parts times a size; temperatures count in units of `rise`, K.
    #[must_use]
    pub fn plus(&self, parts: &[f64], size: f64, rise: f64) -> Warmth {
        let two = |of: [f64; 2], from: usize| [0, 1].map(|d: usize| of[d] + size * parts[from + d]);
        Warmth {
            temperature: self.temperature + size * rise * parts[0],
            density: self.density + size * parts[1],
            flow: two(self.flow, 2),
            drift: two(self.drift, 4),
        }
    }

    /// Parts of the difference to another over a distance.
    pub fn minus(&self, other: &Warmth, distance: f64, rise: f64) -> [f64; Warmth::PARTS] {
        let parts = [self, other].map(|of| {
            let ([a, b], [u, v]) = (of.flow, of.drift);
            [of.temperature / rise, of.density, a, b, u, v]
        });
        std::array::from_fn(|i| (parts[0][i] - parts[1][i]) / distance)
    }
}
