//! One elastic body that deflects like both together.

use super::Material;

/// Equivalent body of two bodies: its surface deflection under a pressure is the sum of both bodies'.
///
/// Solves (1+ν)/E = Σ (1+ν_i)/E_i and (1−ν²)/E = Σ (1−ν_i²)/E_i (Habchi 2008, eqs. A.6, A.7):
/// with s = Σ (1+ν_i)/E_i and t = Σ (1−ν_i²)/E_i, 1 − ν = t/s and E = (1+ν)/s.
pub fn equivalent_body(body_1: Material, body_2: Material) -> Material {
    let shear = |b: Material| (1.0 + b.poissons_ratio) / b.youngs_modulus;
    let normal = |b: Material| (1.0 - b.poissons_ratio.powi(2)) / b.youngs_modulus;
    let s = shear(body_1) + shear(body_2);
    let t = normal(body_1) + normal(body_2);
    let poissons_ratio = 1.0 - t / s;
    Material {
        youngs_modulus: (1.0 + poissons_ratio) / s,
        poissons_ratio,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    const STEEL: Material = Material {
        youngs_modulus: 210e9,
        poissons_ratio: 0.3,
    };
    const GLASS: Material = Material {
        youngs_modulus: 81e9,
        poissons_ratio: 0.208,
    };

    /// Habchi 2008, eq. A.8, and the remark after it: equal bodies give E/2 and the same ν.
    #[test]
    fn equal_bodies_halve_the_modulus() {
        let body = equivalent_body(STEEL, STEEL);
        assert_relative_eq!(body.youngs_modulus, 105e9, max_relative = 1e-14);
        assert_relative_eq!(body.poissons_ratio, 0.3, max_relative = 1e-14);
    }

    /// Closed form of Habchi 2008, eq. A.8, evaluated independently.
    #[test]
    fn glass_on_steel_matches_closed_form() {
        let (ep, vp, es, vs) = (81e9_f64, 0.208_f64, 210e9_f64, 0.3_f64);
        let d = es * (1.0 + vp) + ep * (1.0 + vs);
        let e = (es * es * ep * (1.0 + vp).powi(2) + ep * ep * es * (1.0 + vs).powi(2)) / (d * d);
        let v = (es * vp * (1.0 + vp) + ep * vs * (1.0 + vs)) / d;
        let body = equivalent_body(GLASS, STEEL);
        assert_relative_eq!(body.poissons_ratio, v, max_relative = 1e-13);
        assert_relative_eq!(body.youngs_modulus, e, max_relative = 1e-13);
    }
}
