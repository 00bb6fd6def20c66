//! Response of coated half-spaces to harmonic loads, in plane strain.
//!
//! With lengths in 1/k, Airy's function f(z) cos x gives
//!
//! ```text
//!   σ_zz = −f cos x    σ_xz = f' sin x    2G u = [(1 − ν) f'' + ν f] sin x    2G w = [(1 − ν) f''' − (2 − ν) f'] cos x
//!   f = (A + Bz) e^(−z) + (C + Dz) e^z
//! ```
//! A compliance of displacements (u, w) by loads (f, f') at an interface reflects waves (A, B) into (C, D); a layer above delays both by its
//! thickness. From the substrate upwards this is stable for thin and for thick layers.

use nalgebra::{Matrix2, Vector2};

use crate::contact::Material;

/// A bonded layer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layer {
    /// Thickness, in the unit of lengths.
    pub thickness: f64,
    /// Elastic constants.
    pub material: Material,
}

/// A body with layers.
#[derive(Clone, Debug, PartialEq)]
pub struct Coated {
    /// From the surface down.
    pub layers: Vec<Layer>,
    /// Below.
    pub substrate: Material,
}

/// Displacements and loads at a plane, of waves that fall off downwards and upwards.
pub(super) struct Waves {
    pub(super) down: [Matrix2<f64>; 2],
    pub(super) up: [Matrix2<f64>; 2],
}

impl Waves {
    pub(super) fn of(material: Material) -> Waves {
        let nu = material.poissons_ratio;
        let twice_shear = material.youngs_modulus / (1.0 + nu);
        let slow = 2.0 * (1.0 - nu);
        let rest = 1.0 - 2.0 * nu;
        Waves {
            down: [
                Matrix2::new(1.0, -slow, 1.0, rest) / twice_shear,
                Matrix2::new(1.0, 0.0, -1.0, 1.0),
            ],
            up: [
                Matrix2::new(1.0, slow, -1.0, rest) / twice_shear,
                Matrix2::new(1.0, 0.0, 1.0, 1.0),
            ],
        }
    }

    /// Compliance of a plane from which waves come back with this reflection.
    fn compliance(&self, reflection: Matrix2<f64>) -> Matrix2<f64> {
        let [displacements, loads] = [0, 1].map(|i: usize| self.down[i] + self.up[i] * reflection);
        displacements * inverse(loads)
    }

    /// Reflection at a plane of this compliance.
    fn reflection(&self, compliance: Matrix2<f64>) -> Matrix2<f64> {
        inverse(self.up[0] - compliance * self.up[1]) * (compliance * self.down[1] - self.down[0])
    }
}

/// The reflection at a plane, as seen from a plane above it; `depth`: between them, in 1/k.
pub(super) fn from_above(reflection: Matrix2<f64>, depth: f64) -> Matrix2<f64> {
    let [down, up] = [depth, -depth].map(|d| Matrix2::new(1.0, d, 0.0, 1.0));
    up * reflection * down * (-2.0 * depth).exp()
}

/// Of a matrix that is regular: loads determine the waves of elastic bodies.
pub(super) fn inverse(matrix: Matrix2<f64>) -> Matrix2<f64> {
    matrix
        .try_inverse()
        .unwrap_or_else(|| Matrix2::from_element(f64::NAN))
}

/// C = (1 − ν²)/E.
fn plane_compliance(material: Material) -> f64 {
    (1.0 - material.poissons_ratio.powi(2)) / material.youngs_modulus
}

impl Coated {
    /// Displacements (u sin kx, w cos kx), times k, by loads (f, f') of the wave number k at the surface: pressure f, shear f'.
    pub fn compliance(&self, k: f64) -> Matrix2<f64> {
        self.reflections(k).1
    }

    /// The reflections at the lower sides of the layers, from the surface down, and the compliance of the surface.
    pub(super) fn reflections(&self, k: f64) -> (Vec<Matrix2<f64>>, Matrix2<f64>) {
        let mut compliance = Waves::of(self.substrate).compliance(Matrix2::zeros());
        let mut all = Vec::new();
        for layer in self.layers.iter().rev() {
            let waves = Waves::of(layer.material);
            let own = waves.reflection(compliance);
            compliance = waves.compliance(from_above(own, k * layer.thickness));
            all.push(own);
        }
        all.reverse();
        (all, compliance)
    }

    /// The material of a part: a layer, counted from zero at the surface, or the substrate after them.
    pub fn material(&self, part: usize) -> Material {
        let layer = self.layers.get(part).map(|layer| layer.material);
        layer.unwrap_or(self.substrate)
    }

    /// Depths of the interfaces.
    pub fn interfaces(&self) -> Vec<f64> {
        let mut depth = 0.0;
        let below = |layer: &Layer| {
            depth += layer.thickness;
            depth
        };
        self.layers.iter().map(below).collect()
    }

    /// C(k) of waves of the pressure: w = 2C p/k.
    pub fn normal(&self, k: f64) -> f64 {
        0.5 * (self.compliance(k) * Vector2::new(1.0, 0.0))[1]
    }

    /// Of short waves: that of the uppermost layer.
    pub fn of_short_waves(&self) -> f64 {
        let uppermost = self.layers.first().map(|layer| layer.material);
        plane_compliance(uppermost.unwrap_or(self.substrate))
    }

    /// Of long waves: that of the substrate.
    pub fn of_long_waves(&self) -> f64 {
        plane_compliance(self.substrate)
    }
}
