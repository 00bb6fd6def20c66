//! Height parameters of a surface (ISO 25178-2), about its mean.
//!
//! ```text
//!   Sa = ⟨|z|⟩   Sq = √⟨z²⟩   Ssk = ⟨z³⟩/Sq³   Sku = ⟨z⁴⟩/Sq⁴   Sz = max z − min z
//! ```

use serde::Serialize;

use super::Topography;

/// Parameters of the heights; of a profile those of its line.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Parameters {
    /// Arithmetical mean height Sa, m.
    pub sa: f64,
    /// Root mean square height Sq, m.
    pub sq: f64,
    /// Skewness Ssk; 0 of a plane.
    pub ssk: f64,
    /// Kurtosis Sku; 0 of a plane.
    pub sku: f64,
    /// Maximum height Sz, m.
    pub sz: f64,
}

impl Topography {
    /// Its parameters over the points that have a height.
    pub fn parameters(&self) -> Parameters {
        let known = || self.heights.iter().filter(|h| !h.is_nan());
        let n = known().count().max(1) as f64;
        let mean = known().sum::<f64>() / n;
        let moment = |f: &dyn Fn(f64) -> f64| known().map(|h| f(h - mean)).sum::<f64>() / n;
        let sq = moment(&|z| z * z).sqrt();
        let over = |value: f64| if sq > 0.0 { value } else { 0.0 };
        let ends = known().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], h| {
            [low.min(*h), high.max(*h)]
        });
        Parameters {
            sa: moment(&f64::abs),
            sq,
            ssk: over(moment(&|z| (z / sq).powi(3))),
            sku: over(moment(&|z| (z / sq).powi(4))),
            sz: (ends[1] - ends[0]).max(0.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// By hand: 0, 0, 0, 4 with a hole. Closed form: a sine has 2A/π, A/√2, 0, 3/2 and 2A.
    #[test]
    fn parameters_by_hand_and_of_a_sine() {
        let mut map = Topography {
            counts: [5, 1],
            spacing: [1.0; 2],
            heights: vec![0.0, 0.0, f64::NAN, 0.0, 4.0],
        };
        let p = map.parameters();
        assert_relative_eq!(p.sa, 1.5);
        assert_relative_eq!(p.sq, 3.0_f64.sqrt());
        assert_relative_eq!(p.ssk, 6.0 / 3.0_f64.powf(1.5), max_relative = 1e-12);
        assert_relative_eq!(p.sku, 21.0 / 9.0, max_relative = 1e-12);
        assert_relative_eq!(p.sz, 4.0);
        map.counts = [4000, 1];
        map.heights = (0..4000)
            .map(|i| 3.0 * (f64::from(i) * std::f64::consts::PI / 400.0 + 1e-3).sin())
            .collect();
        let p = map.parameters();
        let expected = [
            6.0 / std::f64::consts::PI,
            3.0 / 2.0_f64.sqrt(),
            0.0,
            1.5,
            6.0,
        ];
        for (own, expected) in [p.sa, p.sq, p.ssk, p.sku, p.sz].into_iter().zip(expected) {
            assert_relative_eq!(own, expected, max_relative = 1e-4, epsilon = 1e-9);
        }
    }
}
