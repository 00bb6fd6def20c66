//! Images of a pressure below the surface, which deflect like layers.
//!
//! ```text
//!   C(k) − C(∞) ≈ Σ c_m e^(−k z_m)        δ = 1/π ∫∫ p [C(∞)/r + Σ c_m/√(r² + z_m²)] dA
//! ```
//! The waves of a layer of the thickness h come back as e^(−2kh) and its products with powers of k and of itself, so that depths from h on suffice, a geometric
//! series; the weights are by least squares over all waves. The longest wave is met exactly: far away the substrate decides.

use nalgebra::{DMatrix, DVector};

use super::Coated;

/// An image of the pressure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Image {
    /// Depth, in the unit of lengths.
    pub depth: f64,
    /// Its compliance.
    pub compliance: f64,
}

/// The half-space of short waves, and images.
#[derive(Clone, Debug, PartialEq)]
pub struct Images {
    /// C(∞), of all bodies.
    pub of_short_waves: f64,
    /// The images; none of bodies without layers.
    pub images: Vec<Image>,
}

/// Depths: how many per body, and their range over the uppermost layer and over all layers.
const DEPTHS: usize = 28;
const SHALLOWEST: f64 = 1.0;
const DEEPEST: f64 = 40.0;
/// Waves of the least squares: how many, and their range over the uppermost layer and over all layers.
const WAVES: usize = 400;
const SHORTEST: f64 = 14.0;
const LONGEST: f64 = 1e-4;
/// Singular values below this share are left out: weights stay small.
const SMALLEST: f64 = 1e-14;
/// Weight of the longest wave.
const OF_LONGEST: f64 = 100.0;

impl Images {
    /// Of bodies whose deflections add up.
    pub fn of(bodies: &[Coated]) -> Images {
        let mut all = Images {
            of_short_waves: bodies.iter().map(Coated::of_short_waves).sum(),
            images: Vec::new(),
        };
        for body in bodies.iter().filter(|body| !body.layers.is_empty()) {
            all.images.extend(images(body));
        }
        all
    }

    /// C(k).
    pub fn normal(&self, k: f64) -> f64 {
        let waves = self.images.iter();
        self.of_short_waves
            + waves
                .map(|i| i.compliance * (-k * i.depth).exp())
                .sum::<f64>()
    }
}

/// Of a body with layers.
fn images(body: &Coated) -> Vec<Image> {
    let uppermost = body.layers[0].thickness;
    let thickness: f64 = body.layers.iter().map(|layer| layer.thickness).sum();
    let depths = geometric([SHALLOWEST * uppermost, DEEPEST * thickness], DEPTHS);
    let mut waves = vec![0.0];
    waves.extend(geometric(
        [LONGEST / thickness, SHORTEST / uppermost],
        WAVES,
    ));
    let short = body.of_short_waves();
    let weight = |i: usize| if i == 0 { OF_LONGEST } else { 1.0 };
    let wanted = DVector::from_fn(waves.len(), |i, _| {
        weight(i) * (body.normal(waves[i]) / short - 1.0)
    });
    let matrix = DMatrix::from_fn(waves.len(), DEPTHS, |i, m| {
        weight(i) * (-waves[i] * depths[m]).exp()
    });
    let svd = matrix.svd(true, true);
    let least = SMALLEST * svd.singular_values.max();
    let weights = svd
        .solve(&wanted, least)
        .expect("both factors were computed");
    (depths.into_iter().zip(weights.iter()))
        .map(|(depth, weight)| Image {
            depth,
            compliance: short * weight,
        })
        .collect()
}

/// A geometric series between two numbers.
fn geometric([from, to]: [f64; 2], n: usize) -> Vec<f64> {
    let factor = (to / from).powf(1.0 / (n - 1) as f64);
    (0..n).map(|i| from * factor.powi(i as i32)).collect()
}
