//! Images of a pressure below the surface, which deflect like layers.
//!
//! ```text
//!   C(k) − C(∞) ≈ Σ c_m e^(−k z_m)        δ = 1/π ∫∫ p [C(∞)/r + Σ c_m/√(r² + z_m²)] dA
//! ```
//! The waves of a layer of the thickness h come back as e^(−2kh) and its products with powers of k and of itself, so that depths from h on suffice, a geometric
//! series; the weights are by least squares over all waves. The longest wave is met exactly: far away the substrate decides.

use nalgebra::{DMatrix, DVector, Dyn, SVD};

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
    let waves = geometric([LONGEST / thickness, SHORTEST / uppermost], WAVES);
    let short = body.of_short_waves();
    let fit = Fit::new(depths, waves);
    let wanted: Vec<f64> = (fit.waves.iter())
        .map(|k| body.normal(*k) / short - 1.0)
        .collect();
    let weights = fit.weights(&wanted);
    (fit.depths.into_iter().zip(weights.iter()))
        .map(|(depth, weight)| Image {
            depth,
            compliance: short * weight,
        })
        .collect()
}

/// Sums of images that meet functions of the wave number by least squares.
pub struct Fit {
    /// Depths of the images.
    pub depths: Vec<f64>,
    /// Wave numbers; zero, which has more weight, is the first.
    pub waves: Vec<f64>,
    factors: SVD<f64, Dyn, Dyn>,
}

impl Fit {
    /// Of images at these depths, over waves of these numbers and the longest one.
    pub fn new(depths: Vec<f64>, mut waves: Vec<f64>) -> Fit {
        waves.insert(0, 0.0);
        let matrix = DMatrix::from_fn(waves.len(), depths.len(), |i, m| {
            weight(i) * (-waves[i] * depths[m]).exp()
        });
        Fit {
            depths,
            waves,
            factors: matrix.svd(true, true),
        }
    }

    /// The images of a function with these values at the waves.
    pub fn weights(&self, values: &[f64]) -> DVector<f64> {
        let wanted = DVector::from_fn(values.len(), |i, _| weight(i) * values[i]);
        let least = SMALLEST * self.factors.singular_values.max();
        let found = self.factors.solve(&wanted, least);
        found.expect("both factors were computed")
    }
}

/// Weight of a wave.
fn weight(i: usize) -> f64 {
    if i == 0 { OF_LONGEST } else { 1.0 }
}

/// A geometric series between two numbers.
pub fn geometric([from, to]: [f64; 2], n: usize) -> Vec<f64> {
    let factor = (to / from).powf(1.0 / (n - 1) as f64);
    (0..n).map(|i| from * factor.powi(i as i32)).collect()
}
