//! Gaussian filters.
//!
//! ```text
//!   s(x) = exp(−π (x/(α λ_c))²)/(α λ_c),   α = √(ln 2/π)          a wave of length λ keeps exp(−π (α λ_c/λ)²) of its amplitude: half at λ_c
//! ```
//! ISO 16610-21 (profiles) and ISO 16610-61 (surfaces: the product of both directions). Along the rim the weights of the points that there are
//! make up the whole.

use std::f64::consts::{LN_2, PI};

use rayon::prelude::*;

use super::Topography;

/// Pass band of a filter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pass {
    /// Longer waves than the cutoff.
    Long,
    /// Shorter ones.
    Short,
}

/// Cutoffs from a point beyond which weights are left out: exp(−π/α²) = 6e-7.
const REACH: f64 = 1.0;

impl Topography {
    /// Filters by a cutoff, m; there are no holes.
    pub fn filter(&mut self, pass: Pass, cutoff: f64) {
        let mut long = self.heights.clone();
        let [nx, ny] = self.counts;
        let weights = [0, 1].map(|d: usize| weights(cutoff / self.spacing[d]));
        long.par_chunks_exact_mut(nx)
            .for_each(|row| smooth(row, &weights[0]));
        if ny > 1 {
            let mut turned = transposed(&long, nx);
            turned
                .par_chunks_exact_mut(ny)
                .for_each(|column| smooth(column, &weights[1]));
            long = transposed(&turned, ny);
        }
        match pass {
            Pass::Long => self.heights = long,
            Pass::Short => (self.heights.iter_mut().zip(&long)).for_each(|(h, l)| *h -= l),
        }
    }
}

/// Weights of the points at 0, 1, 2 … distances, of a cutoff in distances.
fn weights(cutoff: f64) -> Vec<f64> {
    let alpha = (LN_2 / PI).sqrt();
    let n = (REACH * cutoff).ceil() as usize;
    (0..=n)
        .map(|i| (-PI * (i as f64 / (alpha * cutoff)).powi(2)).exp())
        .collect()
}

fn smooth(row: &mut [f64], weights: &[f64]) {
    let (own, n) = (row.to_vec(), row.len());
    for (i, h) in row.iter_mut().enumerate() {
        let low = i.saturating_sub(weights.len() - 1);
        let high = (i + weights.len()).min(n);
        let (mut sum, mut total) = (0.0, 0.0);
        for (k, value) in own.iter().enumerate().take(high).skip(low) {
            let w = weights[k.abs_diff(i)];
            sum += w * value;
            total += w;
        }
        *h = sum / total;
    }
}

fn transposed(values: &[f64], width: usize) -> Vec<f64> {
    let height = values.len() / width;
    let mut turned = vec![0.0; values.len()];
    for (j, row) in values.chunks_exact(width).enumerate() {
        for (i, value) in row.iter().enumerate() {
            turned[i * height + j] = *value;
        }
    }
    turned
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::near::near;
    use approx::assert_relative_eq;

    /// Closed form: a wave along x or y, or at an angle, keeps exp(−π (α λ_c/λ)²) in the middle; both passes make up the whole.
    #[test]
    fn half_of_a_wave_passes_at_the_cutoff() {
        let (n, cutoff) = (240, 40.0);
        let alpha = (LN_2 / PI).sqrt();
        for (lambda, angle, share) in [
            (40.0_f64, 0.0_f64, 0.5),
            (40.0, 0.7, 0.5),
            (20.0, 1.5, 1.0 / 16.0),
            (80.0, 0.3, 0.840_896_415),
        ] {
            let law = (-PI * (alpha * cutoff / lambda).powi(2)).exp();
            assert_relative_eq!(law, share, max_relative = 1e-8);
            let wave = |k: usize| {
                let (x, y) = ((k % n) as f64 - 120.0, (k / n) as f64 - 120.0);
                (2.0 * PI * (x * angle.cos() + y * angle.sin()) / lambda).cos()
            };
            let full = Topography {
                counts: [n, n],
                spacing: [1.0; 2],
                heights: (0..n * n).map(wave).collect(),
            };
            let (mut long, mut short) = (full.clone(), full.clone());
            long.filter(Pass::Long, cutoff);
            short.filter(Pass::Short, cutoff);
            let middle = 120 * n + 120;
            assert_relative_eq!(long.heights[middle], share, max_relative = 1e-5);
            near(long.heights[middle] + short.heights[middle], 1.0, 1e-12);
        }
        let mut flat = Topography {
            counts: [50, 1],
            spacing: [1.0; 2],
            heights: vec![2.0; 50],
        };
        flat.filter(Pass::Long, cutoff);
        assert!(flat.heights.iter().all(|h| (h - 2.0).abs() < 1e-12));
    }
}
