//! How the heights are made up of waves, along the rows and across them.
//!
//! ```text
//!   S(f_k) = 2 Δ/(N ⟨w²⟩) ⟨|Σ_n w_n z_n exp(−2πi k n/N)|²⟩,   f_k = k/(N Δ),   w_n = ½(1 − cos(2π n/N))        ∫ S df = Sq²
//! ```
//! One-sided power spectral density, m³, the mean over all rows, or columns, with Hann's window; the mean over bands of wavelengths of half an
//! octave. Jacobs, Junge and Pastewka 2017, C^1D.

use std::f64::consts::PI;

use rustfft::FftPlanner;
use rustfft::num_complex::Complex;
use serde::Serialize;

use super::Topography;

/// Power spectral densities over wavelengths, the longest first.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Spectrum {
    /// Middle of each band, m.
    pub wavelength: Vec<f64>,
    /// Density in it, m³.
    pub density: Vec<f64>,
}

/// Bands in an octave.
const BANDS: f64 = 2.0;

/// Points below which a row says nothing of its waves.
const LEAST_POINTS: usize = 8;

/// Of rows (`direction` 0) or columns (1) without holes; empty where they are too short.
pub fn spectrum(map: &Topography, direction: usize) -> Spectrum {
    let [nx, ny] = map.counts;
    let (n, lines, step, stride) = match direction {
        0 => (nx, ny, 1, nx),
        _ => (ny, nx, nx, 1),
    };
    if n < LEAST_POINTS {
        return Spectrum::default();
    }
    let mean = map.heights.iter().sum::<f64>() / map.heights.len() as f64;
    let window: Vec<f64> = (0..n)
        .map(|i| 0.5 * (1.0 - (2.0 * PI * i as f64 / n as f64).cos()))
        .collect();
    let square = window.iter().map(|w| w * w).sum::<f64>() / n as f64;
    let fft = FftPlanner::new().plan_fft_forward(n);
    let mut power = vec![0.0; n / 2 + 1];
    let mut line = vec![Complex::default(); n];
    for l in 0..lines {
        for (i, (z, w)) in line.iter_mut().zip(&window).enumerate() {
            *z = Complex::new(w * (map.heights[l * stride + i * step] - mean), 0.0);
        }
        fft.process(&mut line);
        for (p, z) in power.iter_mut().zip(&line) {
            *p += z.norm_sqr();
        }
    }
    let spacing = map.spacing[direction];
    let factor = 2.0 * spacing / (n as f64 * square * lines as f64);
    let length = n as f64 * spacing;
    let mut found = Spectrum::default();
    let mut k = 1;
    while k <= n / 2 {
        let next =
            ((k as f64 * 2.0_f64.powf(1.0 / BANDS)).round() as usize).clamp(k + 1, n / 2 + 1);
        let mean = power[k..next].iter().sum::<f64>() / (next - k) as f64;
        let middle = (k as f64 * (next - 1) as f64).sqrt();
        found.wavelength.push(length / middle);
        found.density.push(factor * mean);
        k = next;
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// White noise of the variance σ² has the density 2 σ² Δ at all wavelengths; a wave along the rows is none across them.
    #[test]
    fn densities_of_noise_and_of_a_wave() {
        let mut state = 1_u64;
        let mut noise = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            ((state >> 33) as f64 / f64::from(1_u32 << 31) - 0.5) * 12.0_f64.sqrt()
        };
        let white = Topography {
            counts: [256, 256],
            spacing: [0.5, 0.25],
            heights: (0..65_536).map(|_| noise()).collect(),
        };
        for (direction, expected) in [(0, 1.0), (1, 0.5)] {
            let found = spectrum(&white, direction);
            for density in &found.density[2..] {
                assert_relative_eq!(*density, expected, max_relative = 0.15);
            }
        }
        let wave = Topography {
            heights: (0..65_536)
                .map(|k| (2.0 * PI * f64::from(k % 256) / 32.0).cos())
                .collect(),
            ..white
        };
        let along = spectrum(&wave, 0);
        let peak = (along.wavelength.iter().zip(&along.density)).max_by(|a, b| a.1.total_cmp(b.1));
        assert_relative_eq!(*peak.unwrap().0, 16.0, max_relative = 0.2);
        assert!(spectrum(&wave, 1).density[3..].iter().all(|d| *d < 1e-12));
    }
}
