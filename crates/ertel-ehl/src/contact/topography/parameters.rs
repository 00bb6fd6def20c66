//! Height parameters of a surface (ISO 25178-2), about its mean, and its asperities by spectral moments.
//!
//! ```text
//!   Sa = ⟨|z|⟩   Sq = √⟨z²⟩   Ssk = ⟨z³⟩/Sq³   Sku = ⟨z⁴⟩/Sq⁴   Sz = max z − min z
//!   m_0 = Sq²,  m_2 = ⟨(∂z/∂s)²⟩,  m_4 = ⟨(∂²z/∂s²)²⟩                  s along rows and columns
//!   η = m_4/(6π√3 m_2),  β = 3√π/(8√m_4)                              density and tip radius of summits
//!   σβη = Sq/(16√(3π)) · √m_4/m_2,  σ/β = 8/(3√π) Sq √m_4
//! ```
//! Asperities: McCool 1987 (J. Tribology 109, 264-270) after Nayak, of isotropic Gaussian surfaces, by differences of neighbouring points. m_2 and m_4 grow with
//! the shortest wavelength: spacing and filter decide them.

use std::f64::consts::PI;

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
    /// σβη of its asperities by spectral moments, as `asperity_group` of rough surfaces; 0 of a plane.
    pub asperity_group: f64,
    /// σ/β likewise.
    pub rms_height_to_asperity_radius: f64,
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
        let [m2, m4] = self.moments();
        let summits = match m2 > 0.0 && m4 > 0.0 {
            true => [
                sq * m4.sqrt() / (16.0 * (3.0 * PI).sqrt() * m2),
                8.0 / (3.0 * PI.sqrt()) * sq * m4.sqrt(),
            ],
            false => [0.0; 2],
        };
        Parameters {
            asperity_group: summits[0],
            rms_height_to_asperity_radius: summits[1],
            sa: moment(&f64::abs),
            sq,
            ssk: over(moment(&|z| (z / sq).powi(3))),
            sku: over(moment(&|z| (z / sq).powi(4))),
            sz: (ends[1] - ends[0]).max(0.0),
        }
    }

    /// m_2 and m_4, 1 and 1/m², over all points whose neighbours have heights.
    fn moments(&self) -> [f64; 2] {
        let [nx, ny] = self.counts;
        let (mut sums, mut n) = ([0.0; 2], 0);
        for (count, stride, spacing) in [(nx, 1, self.spacing[0]), (ny, nx, self.spacing[1])] {
            for k in 0..self.heights.len() {
                let along = (k / stride) % count.max(1);
                if along == 0 || along + 1 >= count {
                    continue;
                }
                let [before, here, behind] = [k - stride, k, k + stride].map(|k| self.heights[k]);
                let slope = 0.5 * (behind - before) / spacing;
                let curvature = (behind - 2.0 * here + before) / (spacing * spacing);
                if curvature.is_finite() {
                    sums[0] += slope * slope;
                    sums[1] += curvature * curvature;
                    n += 1;
                }
            }
        }
        sums.map(|sum| sum / f64::from(n.max(1)))
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

    /// Waves A sin kx cos ky along both directions, in closed form: m_2 = A²k²/4, m_4 = A²k⁴/4, Sq = A/2, so that σβη = 1/(16√(3π)) and σ/β = 2A²k²/(3√π).
    #[test]
    fn asperities_of_waves() {
        let (n, amplitude, spacing) = (800, 0.3, 0.5);
        let k = 2.0 * PI / (100.0 * spacing);
        let height = |i: usize| {
            let [x, y] = [i % n, i / n].map(|at| k * spacing * at as f64);
            amplitude * x.sin() * y.cos()
        };
        let map = Topography {
            counts: [n, n],
            spacing: [spacing; 2],
            heights: (0..n * n).map(height).collect(),
        };
        let p = map.parameters();
        let group = 1.0 / (16.0 * (3.0 * PI).sqrt());
        assert_relative_eq!(p.asperity_group, group, max_relative = 3e-3);
        let ratio = 2.0 * (amplitude * k).powi(2) / (3.0 * PI.sqrt());
        assert_relative_eq!(p.rms_height_to_asperity_radius, ratio, max_relative = 3e-3);
        let plane = Topography {
            heights: vec![0.0; n * n],
            ..map
        };
        assert_eq!(plane.parameters().asperity_group, 0.0);
    }
}
