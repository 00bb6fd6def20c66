//! Multiaxial fatigue of a point in a body while a contact passes: the criteria of Dang Van and of Fatemi and Socie.

use std::f64::consts::PI;

use serde::Serialize;

use super::Stress;
use super::sphere::smallest_sphere;

/// Dang Van's criterion at a depth.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct DangVan {
    /// Radius of the smallest sphere that encloses the path of the deviator, in the norm √(s:s), Pa.
    pub radius: f64,
    /// Largest shear of the deviator less the centre of that sphere, Pa.
    pub shear: f64,
    /// Largest sum of that shear and α times the hydrostatic stress, Pa.
    pub index: f64,
}

/// Dang Van's index of a passage that begins and ends at rest, where the body has its residual stress. That of the shakedown takes the deviator to the centre of the
/// smallest sphere around its path.
pub fn dang_van(path: &[Stress], residual: Stress, alpha: f64) -> DangVan {
    let rest = [Stress::default()];
    let all = || path.iter().chain(&rest).map(|stress| *stress + residual);
    let points: Vec<_> = all().map(|stress| stress.deviator()).collect();
    let (centre, radius) = smallest_sphere(&points);
    let centre = Stress::of_deviator(centre);
    let mut found = DangVan {
        radius,
        shear: 0.0,
        index: f64::NEG_INFINITY,
    };
    for stress in all() {
        let shear = (stress - centre).largest_shear();
        found.shear = found.shear.max(shear);
        found.index = found.index.max(shear + alpha * stress.hydrostatic());
    }
    found
}

/// Directions of planes over half a turn.
const PLANES: usize = 90;

/// Fatemi and Socie's parameter in stresses: the largest τ_a (1 + κ σ_n/σ_y) of all planes across the plane of motion, with half the range τ_a of the
/// shear and the largest normal stress σ_n of the passage, with the residual stress, on each (Fatemi and Socie 1988; strains are elastic, γ_a = τ_a/G).
pub fn fatemi_socie(
    path: &[Stress],
    residual: Stress,
    sensitivity: f64,
    yield_strength: f64,
) -> f64 {
    let of_plane = |i: usize| {
        let (s, c) = (PI * i as f64 / PLANES as f64).sin_cos();
        let of = |stress: Stress| {
            let [xx, _, zz, _, xz, _] = stress.0;
            let shear = (zz - xx) * s * c + xz * (c * c - s * s);
            [shear, xx * c * c + zz * s * s + 2.0 * xz * s * c]
        };
        let [shear, normal] = of(residual);
        let rest = (shear, shear, normal);
        let (low, high, normal) = path.iter().fold(rest, |(low, high, normal), stress| {
            let [shear, own] = of(*stress + residual);
            (low.min(shear), high.max(shear), normal.max(own))
        });
        // A plane under compression is closed: more compression changes nothing.
        0.5 * (high - low) * (1.0 + sensitivity * normal.max(0.0) / yield_strength)
    };
    (0..PLANES).map(of_plane).fold(0.0, f64::max)
}
