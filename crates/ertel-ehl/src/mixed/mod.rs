//! Mixed lubrication: the oil and the asperities of two rough surfaces share the load.
//!
//! ```text
//!   λ = h_min/σ                                                             lambda ratio
//!   p_a(h) = κ F_{5/2}(h/σ),  κ = 16√2π/15 (σβη)² √(σ/β) E*                 asperity pressure
//!   P = p + p_a(h) ≥ p_a(h)                                                 total pressure: deflects the bodies and bears the load
//!   h_T = E[max(h + δ, 0)] = σ F_1(−h/σ)                                    mean gap
//!   L = ∫ p_a dA/W,     f = ∫ τ dA/W + f_b/W ∫ p_a e dA                     load share of the asperities, friction coefficient
//! ```
//! h is the distance of the mean planes, of any sign, σ the composite rms height, η the density of asperities on each surface, β their tip radius,
//! E* with 1/E* = Σ (1−ν²)/E the plane-strain modulus of the pair (half of E'), p the pressure and τ the shear stress of the oil, e the direction
//! of sliding, f_b the boundary friction coefficient. The asperity pressure is that of Greenwood and Tripp (1970, The contact of two nominally flat
//! rough surfaces, Proc. IMechE 185, 625-633): elastic asperities of one tip radius on both surfaces, Gaussian heights, no interaction of
//! neighbours. Finite volumes solve for oil and asperities together ([`crate::volumes`]).
//!
//! Theory: Mixed lubrication.

mod rough;
mod statistics;
mod table;

use std::f64::consts::PI;

use serde::Serialize;

pub use rough::Rough;
pub use statistics::five_halves_integral;

/// The gap through which the oil flows between rough surfaces.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Flow {
    /// The mean gap h_T: what the valleys hold, never negative.
    #[default]
    AverageGap,
    /// The distance of the mean planes, none where they overlap.
    Distance,
}

impl Flow {
    /// Every choice, by its name in case files.
    pub const ALL: [(&'static str, Flow); 2] = [
        ("average-gap", Flow::AverageGap),
        ("distance", Flow::Distance),
    ];

    /// For reports.
    pub fn words(self) -> &'static str {
        match self {
            Flow::AverageGap => "through the mean gap",
            Flow::Distance => "through the distance of the mean planes",
        }
    }
}

/// Asperities of two surfaces of one kind.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Asperities {
    /// σβη: composite rms height, tip radius and density of asperities, dimensionless.
    pub asperity_group: f64,
    /// σ/β: composite rms height over tip radius.
    pub rms_height_to_asperity_radius: f64,
    /// Friction of asperities over their load, if given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub boundary_friction_coefficient: Option<f64>,
    /// Where the oil flows.
    pub flow: Flow,
}

impl Asperities {
    /// κ, Pa; `reduced_modulus` is E' = 2E* in Pa.
    pub fn stiffness(&self, reduced_modulus: f64) -> f64 {
        let shape = self.asperity_group.powi(2) * self.rms_height_to_asperity_radius.sqrt();
        16.0 * 2f64.sqrt() * PI / 15.0 * shape * 0.5 * reduced_modulus
    }

    /// Asperity pressure, Pa, at the film thickness over composite rms height u; `reduced_modulus` is E' = 2E* in Pa.
    ///
    /// ```text
    ///   p_a = 16√2π/15 (σβη)² √(σ/β) (E'/2) F_{5/2}(u)
    /// ```
    /// Greenwood and Tripp 1970, whose E' is E* here. As pairs of paraboloids of the radius β that overlap by w on the axis and pass
    /// at a distance r, each with 4/3 E* √(β/2) (w − r²/4β)^{3/2}, integrated over r and the heights.
    pub fn pressure(&self, film_to_height: f64, reduced_modulus: f64) -> f64 {
        self.stiffness(reduced_modulus) * five_halves_integral(film_to_height)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    const TYPICAL: Asperities = Asperities {
        asperity_group: 0.05,
        rms_height_to_asperity_radius: 1e-3,
        boundary_friction_coefficient: None,
        flow: Flow::AverageGap,
    };

    /// The pressure from the pairs themselves, by sums over overlap and distance: no use of F_{5/2} and its factor.
    #[test]
    fn pressure_of_pairs_of_paraboloids() {
        let (sigma, modulus): (f64, f64) = (0.3e-6, 115e9);
        let beta = sigma / TYPICAL.rms_height_to_asperity_radius;
        let density = TYPICAL.asperity_group / (sigma * beta);
        for u in [0.5, 1.5, 3.0] {
            let (n_heights, n_distances) = (600, 600);
            let most = 8.0 - u;
            let mut pressure = 0.0;
            for i in 0..n_heights {
                let w = (i as f64 + 0.5) * most / n_heights as f64;
                let likelihood = (-0.5 * (u + w).powi(2)).exp() / (2.0 * PI).sqrt();
                let height = likelihood * most / n_heights as f64;
                // r from 0 to where the overlap ends, √(4βw).
                let reach = (4.0 * beta * w * sigma).sqrt();
                for j in 0..n_distances {
                    let r = (j as f64 + 0.5) * reach / n_distances as f64;
                    let overlap = w * sigma - r * r / (4.0 * beta);
                    let force = 4.0 / 3.0 * modulus * (0.5 * beta).sqrt() * overlap.powf(1.5);
                    let ring = 2.0 * PI * r * reach / n_distances as f64;
                    pressure += density * density * force * ring * height;
                }
            }
            let expected = TYPICAL.pressure(u, 2.0 * modulus);
            assert_relative_eq!(pressure, expected, max_relative = 1e-3);
        }
    }

    /// 16√2π/15 · 0.05² · √0.001 · 115.4 GPa · 0.61663422 (mpmath): 26.66 MPa where the mean planes meet.
    #[test]
    fn pressure_where_mean_planes_meet() {
        let pressure = TYPICAL.pressure(0.0, 2.0 * 115.384_615_384_615_38e9);
        assert_relative_eq!(pressure, 26656868.58629429, max_relative = 1e-12);
    }
}
