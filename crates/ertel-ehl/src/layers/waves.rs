//! Stresses in coated half-spaces under harmonic loads.
//!
//! With lengths in 1/k, x along the wave and y across it, loads e^(ix) on the surface:
//!
//! ```text
//!   pressure 1:          σ_zz = −f    σ_xz = −i f'    σ_xx = f''       f(0) = 1, f'(0) = 0
//!   shear 1 along x:     σ_zz = i g   σ_xz = −g'      σ_xx = −i g''    g(0) = 0, g'(0) = 1      σ_yy = ν (σ_xx + σ_zz)
//!   shear 1 across it:   σ_yz = t'    σ_xy = i t                       t'(0) = −1
//! ```
//! The shear is that on the body. f and g are Airy's functions of [`super::response`]; t/G is the displacement across, t = a e^(−z) + b e^z. Waves down are
//! counted from the upper side of a layer, waves up from its lower side: no exponential grows.

use nalgebra::Matrix2;

use super::Coated;
use super::response::{Waves, from_above, inverse};

/// A plane in a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// Depth below the surface.
    pub depth: f64,
    /// The layer that it lies in, counted from zero at the surface, or the substrate after them; both sides of an interface are planes.
    pub part: usize,
}

/// f, f', f'', then g, g', g'', then t, t' at a plane.
pub type Harmonic = [f64; 8];

impl Coated {
    /// The stresses under loads of the wave number k, at planes.
    pub fn harmonic(&self, k: f64, planes: &[Plane]) -> Vec<Harmonic> {
        let mut all = vec![[0.0; 8]; planes.len()];
        let (reflections, _) = self.reflections(k);
        let across = self.reflections_across(k);
        // f and f' of both loads, and t', at the upper side of a part.
        let (mut loads, mut traction) = (Matrix2::identity(), -1.0);
        let mut top = 0.0;
        for part in 0..=self.layers.len() {
            let thickness = self.layers.get(part).map(|layer| k * layer.thickness);
            let waves = Waves::of(self.material(part));
            let own = reflections.get(part).copied().unwrap_or_default();
            let seen = thickness.map_or(own, |d| from_above(own, d));
            let down = inverse(waves.down[1] + waves.up[1] * seen) * loads;
            let delayed = |d: f64| Matrix2::new(1.0, d, 0.0, 1.0) * down * (-d).exp();
            let up = thickness.map_or(Matrix2::zeros(), |d| own * delayed(d));
            let (echo, delay) = thickness.map_or((0.0, 1.0), |d| (across[part], (-d).exp()));
            let first = -traction / (1.0 - echo * delay * delay);
            for (plane, found) in planes.iter().zip(&mut all) {
                if plane.part != part {
                    continue;
                }
                let z = k * plane.depth - top;
                // Of waves up, e^s with s below the lower side; there are none in the substrate.
                let s = thickness.map_or(f64::NEG_INFINITY, |d| (z - d).min(0.0));
                let (fall, rise) = ((-z).exp(), s.exp());
                let s = if rise == 0.0 { 0.0 } else { s };
                for load in 0..2 {
                    let [a, b] = [0, 1].map(|i| fall * down[(i, load)]);
                    let [c, d] = [0, 1].map(|i| rise * up[(i, load)]);
                    let (below, above) = (a + b * z, c + d * s);
                    found[3 * load] = below + above;
                    found[3 * load + 1] = b - below + above + d;
                    found[3 * load + 2] = below - 2.0 * b + above + 2.0 * d;
                }
                let back = echo * delay * rise;
                found[6] = first * (fall + back);
                found[7] = first * (back - fall);
            }
            if let Some(d) = thickness {
                loads = waves.down[1] * delayed(d) + waves.up[1] * up;
                traction = first * delay * (echo - 1.0);
                top += d;
            }
        }
        all
    }

    /// The reflections of t at the lower sides of the layers.
    fn reflections_across(&self, k: f64) -> Vec<f64> {
        let shear = |part: usize| {
            let material = self.material(part);
            0.5 * material.youngs_modulus / (1.0 + material.poissons_ratio)
        };
        // Traction over displacement, both across, at the upper side of what is below.
        let mut stiffness = shear(self.layers.len());
        let mut all = vec![0.0; self.layers.len()];
        for (part, layer) in self.layers.iter().enumerate().rev() {
            let own = shear(part);
            all[part] = (own - stiffness) / (own + stiffness);
            let seen = all[part] * (-2.0 * k * layer.thickness).exp();
            stiffness = own * (1.0 - seen) / (1.0 + seen);
        }
        all
    }
}
