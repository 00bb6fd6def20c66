//! Dimensionless groups of Hamrock and Dowson and of Moes.

use serde::Serialize;

use super::{Contact, Family};

/// Load, speed and material groups for one pressure-viscosity coefficient.
///
/// Circular: W = F/(E'R²), R along the entrainment of ellipses, M = W (2U)^(−3/4); line and, with w = F/l, roller: W = w/(E'R), M = W (2U)^(−1/2);
/// U = μ₀ u_m/(E'R), G = αE', L = G (2U)^(1/4).
///
/// Source: Habchi 2008, eqs. 2.33, 2.34 (corrected).
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Groups {
    /// Load group W.
    pub load: f64,
    /// Speed group U.
    pub speed: f64,
    /// Material group G.
    pub material: f64,
    /// Moes load group M.
    pub moes_load: f64,
    /// Moes material group L.
    pub moes_material: f64,
}

impl Groups {
    /// Groups for reduced modulus E' (Pa), ambient viscosity μ₀ (Pa·s), entrainment speed (m/s)
    /// and pressure-viscosity coefficient α (1/Pa).
    pub fn new(
        contact: &Contact,
        reduced_modulus: f64,
        viscosity: f64,
        entrainment_speed: f64,
        pressure_viscosity_coefficient: f64,
    ) -> Groups {
        let [r, _] = contact.radii_along_and_across();
        let speed = viscosity * entrainment_speed / (reduced_modulus * r);
        let material = pressure_viscosity_coefficient * reduced_modulus;
        let load = match contact.kind.family() {
            Family::Point => contact.load / (reduced_modulus * r * r),
            Family::Cylinder => contact.line_load() / (reduced_modulus * r),
        };
        Groups {
            load,
            speed,
            material,
            moes_load: load * (2.0 * speed).powf(-contact.kind.family().moes_power()),
            moes_material: material * (2.0 * speed).powf(0.25),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::near::near;
    use approx::assert_relative_eq;

    /// Independently computed figures of the thesis's main case (section 3.7.2): W, U, G, M, L.
    #[test]
    fn thesis_main_case() {
        let contact = Contact::circular(0.016, 100.0);
        let g = Groups::new(&contact, 230.769_230_77e9, 0.04, 0.8, 22e-9);
        assert_relative_eq!(g.load, 1.69271e-6, max_relative = 1e-5);
        assert_relative_eq!(g.speed, 8.66667e-12, max_relative = 1e-6);
        assert_relative_eq!(g.material, 5076.92, max_relative = 1e-6);
        assert_relative_eq!(g.moes_load, 199.26, max_relative = 1e-4);
        assert_relative_eq!(g.moes_material, 10.3591, max_relative = 1e-5);
    }

    /// Line: by hand for w = 1e5 N/m, E' = 2e11 Pa, R = 0.01 m, μ₀ = 0.02 Pa·s, u = 1 m/s:
    /// W = 5e-5, U = 1e-11, (2U)^½ = 4.472136e-6, M = 11.18034.
    #[test]
    fn line_groups_by_hand() {
        let contact = Contact::line(0.01, 1e5);
        let g = Groups::new(&contact, 2e11, 0.02, 1.0, 2e-8);
        assert_relative_eq!(g.moes_load, 11.180_34, max_relative = 1e-6);
        near(g.moes_material, 4000.0 * 2.114_742_5e-3, 1e-6);
    }
}
