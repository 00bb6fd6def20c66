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
//! of sliding, f_b the boundary friction coefficient. The asperity pressure is by default that of Greenwood and Tripp (1970, The contact of two nominally flat
//! rough surfaces, Proc. IMechE 185, 625-633): elastic asperities of one tip radius on both surfaces, Gaussian heights, no interaction of
//! neighbours; other laws: [`AsperityLaw`], other gaps that flow: [`Flow`]. Finite volumes solve for oil and asperities together ([`crate::volumes`]).
//!
//! Theory: Mixed lubrication.

mod flow;
mod law;
mod persson;
mod pressure_table;
mod rough;
mod statistics;
mod table;

pub use flow::{Flow, ORIENTATIONS, Orientation};
pub use law::{Asperities, AsperityLaw, Summits};
pub use persson::{DECAY, Persson};
pub use pressure_table::PressureTable;
pub use rough::Rough;

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use std::f64::consts::PI;

    const SUMMITS: Summits = Summits {
        asperity_group: 0.05,
        rms_height_to_asperity_radius: 1e-3,
    };

    fn asperities(law: AsperityLaw) -> Asperities {
        Asperities {
            law,
            hardness: None,
            boundary_friction_coefficient: None,
            flow: Flow::AverageGap,
            flow_is_chosen: true,
            orientation: None,
        }
    }

    /// The pressure from the pairs themselves, by sums over overlap and distance: no use of F_{5/2} and its factor.
    #[test]
    fn pressure_of_pairs_of_paraboloids() {
        let (sigma, modulus): (f64, f64) = (0.3e-6, 115e9);
        let typical = asperities(AsperityLaw::GreenwoodTripp(SUMMITS));
        let beta = sigma / SUMMITS.rms_height_to_asperity_radius;
        let density = SUMMITS.asperity_group / (sigma * beta);
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
            let expected = typical.pressure(u, sigma, 2.0 * modulus);
            assert_relative_eq!(pressure, expected, max_relative = 1e-3);
        }
    }

    /// 16√2π/15 · 0.05² · √0.001 · 115.4 GPa · 0.61663422 (mpmath): 26.66 MPa where the mean planes meet.
    #[test]
    fn pressure_where_mean_planes_meet() {
        let typical = asperities(AsperityLaw::GreenwoodTripp(SUMMITS));
        let pressure = typical.pressure(0.0, 1e-6, 2.0 * 115.384_615_384_615_38e9);
        assert_relative_eq!(pressure, 26656868.58629429, max_relative = 1e-12);
    }

    /// Spheres on one surface pressed by a smooth one, by sums over the heights: η ∫ 4/3 E* √β w^{3/2} φ dw.
    #[test]
    fn pressure_of_spheres_on_one_surface() {
        let (sigma, modulus): (f64, f64) = (0.3e-6, 115e9);
        let beta = sigma / SUMMITS.rms_height_to_asperity_radius;
        let density = SUMMITS.asperity_group / (sigma * beta);
        let law = asperities(AsperityLaw::GreenwoodWilliamson(SUMMITS));
        for u in [-1.0, 0.5, 2.5] {
            let n = 20_000;
            let step = (9.0 - u) / f64::from(n);
            let sum: f64 = (0..n)
                .map(|i| {
                    let w = (f64::from(i) + 0.5) * step;
                    let likelihood = (-0.5 * (u + w).powi(2)).exp() / (2.0 * PI).sqrt();
                    4.0 / 3.0 * modulus * beta.sqrt() * (w * sigma).powf(1.5) * likelihood * step
                })
                .sum();
            let expected = law.pressure(u, sigma, 2.0 * modulus);
            assert_relative_eq!(density * sum, expected, max_relative = 1e-5);
        }
    }

    /// E* β e^(−u/γ) = 115 GPa · 0.05 · e^(−1/0.45) = 623.116 MPa (mpmath); with a hardness H A_r/A_0 = 2 GPa · erf(√2 · 0.05 e^(−1/0.45)/0.3).
    #[test]
    fn pressure_of_randomly_rough_surfaces() {
        let law = asperities(AsperityLaw::Persson(Persson::new(0.3, None, Some(0.05))));
        let soft = Asperities {
            hardness: Some(2e9),
            ..law.clone()
        };
        let at = |of: &Asperities| of.pressure(1.0, 0.3e-6, 230e9);
        assert_relative_eq!(at(&law), 623_116_133.525_901_3, max_relative = 1e-12);
        assert_relative_eq!(at(&soft), 57_630_914.876_290_09, max_relative = 1e-12);
    }

    /// H Q(0) = H/2 where the mean planes meet, and H where they overlap by far; without effect where summits are elastic.
    #[test]
    fn no_more_than_the_hardness_on_the_area_that_touches() {
        let law = asperities(AsperityLaw::GreenwoodTripp(SUMMITS));
        let soft = Asperities {
            hardness: Some(20e6),
            ..law.clone()
        };
        let at = |of: &Asperities, u: f64| of.pressure(u, 1e-6, 230e9);
        assert_relative_eq!(at(&soft, 0.0), 10e6, max_relative = 1e-14);
        assert_relative_eq!(at(&soft, -8.0), 20e6, max_relative = 1e-14);
        assert_eq!(at(&soft, 3.0), at(&law, 3.0));
    }
}
