//! Spectra of the heights, along the rows and across them.
//!
//! ```text
//!   S(f_k) = 2 Δ/(N ⟨w²⟩) ⟨|Σ_n w_n z_n exp(−2πi k n/N)|²⟩,   f_k = k/(N Δ),   w_n = ½(1 − cos(2π n/N))        ∫ S df = Sq²
//! ```
//! One-sided power spectral density, m³, the mean over all rows, or columns, with Hann's window; the mean over bands of wavelengths of half an
//! octave. Jacobs, Junge and Pastewka 2017, C^1D.
//!
//! ```text
//!   C(f_k, g_l) = Δx Δy/(N_x N_y ⟨w²⟩) |Σ_mn w_m w_n z_mn exp(−2πi (k m/N_x + l n/N_y))|²        ∬ C df dg = Sq²
//! ```
//! Density of a surface, m⁴, the mean over all directions in bands of half an octave of 1/√(f² + g²), as far as all directions have waves: their C^iso.

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

/// Fewest points of a row for a spectrum.
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

/// Over all directions, of a surface without holes; none of a profile, and where a side is too short.
pub fn radial_spectrum(map: &Topography) -> Option<Spectrum> {
    let [nx, ny] = map.counts;
    if nx.min(ny) < LEAST_POINTS {
        return None;
    }
    let mean = map.heights.iter().sum::<f64>() / map.heights.len() as f64;
    let windows = map.counts.map(|n| -> Vec<f64> {
        (0..n)
            .map(|i| 0.5 * (1.0 - (2.0 * PI * i as f64 / n as f64).cos()))
            .collect()
    });
    let square = |w: &[f64]| w.iter().map(|w| w * w).sum::<f64>() / w.len() as f64;
    let square = square(&windows[0]) * square(&windows[1]);
    let mut planner = FftPlanner::new();
    let (along, across) = (planner.plan_fft_forward(nx), planner.plan_fft_forward(ny));
    let mut waves: Vec<Complex<f64>> = (map.heights.iter().enumerate())
        .map(|(k, z)| Complex::new(windows[0][k % nx] * windows[1][k / nx] * (z - mean), 0.0))
        .collect();
    waves
        .chunks_exact_mut(nx)
        .for_each(|row| along.process(row));
    let mut column = vec![Complex::default(); ny];
    for i in 0..nx {
        (column.iter_mut().enumerate()).for_each(|(j, z)| *z = waves[j * nx + i]);
        across.process(&mut column);
        (column.iter().enumerate()).for_each(|(j, z)| waves[j * nx + i] = *z);
    }
    let sides = [0, 1].map(|d: usize| map.counts[d] as f64 * map.spacing[d]);
    let least = 1.0 / sides[0].min(sides[1]);
    let most = 0.5 / map.spacing[0].max(map.spacing[1]);
    let band = |f: f64| (BANDS * (f / least).log2() + 0.5).floor() as usize;
    // Sums of densities and frequencies, and how many.
    let mut bands = vec![[0.0; 3]; band(most) + 1];
    let number = |k: usize, n: usize| k.min(n - k) as f64;
    for (k, z) in waves.iter().enumerate() {
        let f = (number(k % nx, nx) / sides[0]).hypot(number(k / nx, ny) / sides[1]);
        if f >= least * (1.0 - 1e-9) && f <= most * (1.0 + 1e-9) {
            let own = &mut bands[band(f).min(band(most))];
            own[0] += z.norm_sqr();
            own[1] += f;
            own[2] += 1.0;
        }
    }
    let factor = map.spacing[0] * map.spacing[1] / ((nx * ny) as f64 * square);
    let known = bands.iter().filter(|[.., n]| *n > 0.0);
    let (wavelength, density) = known
        .map(|[power, f, n]| (n / f, factor * power / n))
        .unzip();
    Some(Spectrum {
        wavelength,
        density,
    })
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
        // On surfaces σ² Δx Δy, in bands of some hundreds of waves.
        let found = radial_spectrum(&white).unwrap();
        for (wavelength, density) in found.wavelength.iter().zip(&found.density).skip(7) {
            assert!(*wavelength >= 1.0 / (1.0 + 1e-9), "{wavelength}");
            assert_relative_eq!(*density, 0.125, max_relative = 0.15);
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

    /// cos(2π f·x) of the amplitude A at (1, 1)/16 has ½A² in all, within a band about 1/f = 16/√2; a profile has none.
    #[test]
    fn the_radial_density_of_a_wave_has_its_power() {
        let n = 128_usize;
        let height = |k: usize| {
            let phase = (k % n + k / n) as f64 / 16.0;
            0.2 * (2.0 * PI * phase).cos()
        };
        let mut map = Topography {
            counts: [n, n],
            spacing: [1.0; 2],
            heights: (0..n * n).map(height).collect(),
        };
        let found = radial_spectrum(&map).unwrap();
        let rows = || found.wavelength.iter().zip(&found.density);
        let peak = rows().max_by(|a, b| a.1.total_cmp(b.1)).unwrap();
        let middle = 16.0 / 2.0_f64.sqrt();
        assert_relative_eq!(*peak.0, middle, max_relative = 0.1);
        // Modes of the band times their density, over the area.
        let [low, high] = [-0.5, 0.5].map(|half| {
            let number = (2.0 * (n as f64 / middle).log2()).round() + half;
            2.0_f64.powf(0.5 * number)
        });
        let modes = (0..n * n).filter(|k| {
            let number = |k: usize| k.min(n - k) as f64;
            let f = number(k % n).hypot(number(k / n));
            (low..high).contains(&f)
        });
        let power = *peak.1 * modes.count() as f64 / (n * n) as f64;
        assert_relative_eq!(power, 0.5 * 0.04, max_relative = 0.02);
        map.counts = [n * n, 1];
        assert_eq!(radial_spectrum(&map), None);
    }
}
