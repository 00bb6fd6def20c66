//! Load and friction of asperities over the film of smooth surfaces: a model of mixed lubrication.
//!
//! ```text
//!   λ = h_min/σ                                                             lambda ratio
//!   p_a(h) = 16√2π/15 (σβη)² √(σ/β) E* F_{5/2}(h/σ)                         asperity pressure
//!   W_a = ∫ p_a(h(x, y)) dA,     L = W_a/W                                  asperity load and its share
//!   f = (1 − L) f_fluid + f_b 1/W ∫ p_a e dA                                friction coefficient
//! ```
//! σ is the composite rms height, η the density of asperities on each surface, β their tip radius, E* with 1/E* = Σ (1−ν²)/E the
//! plane-strain modulus of the pair (half of E'), e the direction of sliding, f_b the boundary friction coefficient. The pressure
//! is that of Greenwood and Tripp (1970, The contact of two nominally flat rough surfaces, Proc. IMechE 185, 625-633): elastic
//! asperities of one tip radius on both surfaces, Gaussian heights, no interaction of neighbours.
//!
//! Film and traction are those of smooth surfaces under the whole load. The load on the asperities would lower the pressure of the
//! film and thicken it; the model neglects that, and is valid while the share is small ([`SMALL_SHARE`]). A film has no negative
//! thickness, so p_a is at most p_a(0), tens to some hundred MPa with usual asperities: under higher Hertz pressures the share
//! stays below one however thin the film.

mod load;
mod statistics;

use std::f64::consts::PI;

use serde::Serialize;

pub use load::{AsperityForces, TOLERANCE, asperity_forces};
pub use statistics::{NOTHING_FROM, five_halves_integral};

/// Asperity load share above which the film of smooth surfaces is not accurate. With a tenth of its load removed, the film
/// is 0.8 to 1.4 % thicker (h ∝ W^−0.073, Hamrock and Dowson 1977, to W^−0.13, Dowson and Higginson 1977), and the asperity pressure
/// falls by several times that (−d ln F_{5/2}/d ln u is 6.1 at u = 2): the share errs by 5 to 8 % of its value. Our choice, not from
/// a paper.
pub const SMALL_SHARE: f64 = 0.1;

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
}

impl Asperities {
    /// Asperity pressure, Pa, at the film thickness over composite rms height u; `reduced_modulus` is E' = 2E* in Pa.
    ///
    /// ```text
    ///   p_a = 16√2π/15 (σβη)² √(σ/β) (E'/2) F_{5/2}(u)
    /// ```
    /// Greenwood and Tripp 1970, whose E' is E* here. As pairs of paraboloids of the radius β that overlap by w on the axis and pass
    /// at a distance r, each with 4/3 E* √(β/2) (w − r²/4β)^{3/2}, integrated over r and the heights.
    pub fn pressure(&self, film_to_height: f64, reduced_modulus: f64) -> f64 {
        let shape = self.asperity_group.powi(2) * self.rms_height_to_asperity_radius.sqrt();
        let factor = 16.0 * 2f64.sqrt() * PI / 15.0 * shape * 0.5 * reduced_modulus;
        factor * five_halves_integral(film_to_height)
    }

    /// Share of a load (N, or N/m of lines) that they carry where the mean planes of both surfaces meet all over the dry contact
    /// (m², or m), without the gap around it.
    pub fn share_at_contact(&self, reduced_modulus: f64, area: f64, load: f64) -> f64 {
        self.pressure(0.0, reduced_modulus) * area / load
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
