//! Generated surfaces: self-affine with random phases.
//!
//! ```text
//!   C(q) = C_0 for q' ≤ q_r,   C_0 (q'/q_r)^(−2(1+H)) for q_r < q' ≤ q_s,   0 beyond;   q = 2π/λ
//!   q'² = γ q_∥² + q_⊥²/γ                     γ: how much longer hills are along the lay than across it
//! ```
//! C two-dimensional power spectral density (Persson et al. 2005; Jacobs, Junge and Pastewka 2017), C_0 such that the rms height is Sq. Amplitudes
//! are those of C, phases are random: Sq and C are met exactly on the periodic grid of the points. Of a profile C ~ q^(−1−2H).

use std::f64::consts::PI;

use rustfft::FftPlanner;
use rustfft::num_complex::Complex;

use super::Topography;

/// Parameters of a generated surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SelfAffine {
    /// Roll-off wavelength λ_r, m.
    pub rolloff: f64,
    /// Shortest wavelength λ_s, m.
    pub shortest: f64,
    /// Hurst exponent H, 0 to 1.
    pub hurst: f64,
    /// Root mean square height Sq, m.
    pub sq: f64,
    /// γ, 1 where all directions are alike.
    pub anisotropy: f64,
    /// Direction of the lay from the rows, rad.
    pub lay: f64,
}

/// Grid of a generated surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Generated {
    /// Its law.
    pub law: SelfAffine,
    /// Points in a row, and rows.
    pub counts: [usize; 2],
    /// Their distances, m.
    pub spacing: [f64; 2],
}

impl SelfAffine {
    /// C over C_0 at a wave vector along the rows and across them, 1/m.
    fn density(&self, [x, y]: [f64; 2], is_profile: bool) -> f64 {
        let (sin, cos) = self.lay.sin_cos();
        let [along, across] = [x * cos + y * sin, y * cos - x * sin];
        let q = match is_profile {
            true => x.abs(),
            false => (self.anisotropy * along * along + across * across / self.anisotropy).sqrt(),
        };
        let [rolloff, shortest] = [self.rolloff, self.shortest].map(|length| 2.0 * PI / length);
        let exponent = if is_profile { 0.5 } else { 1.0 } + self.hurst;
        match q {
            _ if q > shortest * (1.0 + 1e-9) => 0.0,
            _ if q <= rolloff => 1.0,
            _ => (q / rolloff).powf(-2.0 * exponent),
        }
    }
}

impl Generated {
    /// The surface, whose phases are those of `random` numbers from 0 to 1; `None` where no wave of the law fits on the grid.
    pub fn make(&self, mut random: impl FnMut() -> f64) -> Option<Topography> {
        let [nx, ny] = self.counts;
        let mut waves = vec![Complex::<f64>::default(); nx * ny];
        let number = |k: usize, n: usize| match 2 * k < n {
            true => k as f64,
            false => k as f64 - n as f64,
        };
        let mut sum = 0.0;
        for k in 1..nx * ny {
            let (i, j) = (k % nx, k / nx);
            let opposite = (ny - j) % ny * nx + (nx - i) % nx;
            if opposite <= k {
                continue;
            }
            let q = [(i, nx, self.spacing[0]), (j, ny, self.spacing[1])]
                .map(|(k, n, d)| 2.0 * PI * number(k, n) / (n as f64 * d));
            let phase = 2.0 * PI * random();
            let density = self.law.density(q, ny == 1);
            waves[k] = Complex::from_polar(density.sqrt(), phase);
            waves[opposite] = waves[k].conj();
            sum += 2.0 * density;
        }
        if sum == 0.0 {
            return None;
        }
        let mut planner = FftPlanner::new();
        let along = planner.plan_fft_inverse(nx);
        waves
            .chunks_exact_mut(nx)
            .for_each(|row| along.process(row));
        if ny > 1 {
            let across = planner.plan_fft_inverse(ny);
            let mut column = vec![Complex::default(); ny];
            for i in 0..nx {
                (column.iter_mut().enumerate()).for_each(|(j, z)| *z = waves[j * nx + i]);
                across.process(&mut column);
                (column.iter().enumerate()).for_each(|(j, z)| waves[j * nx + i] = *z);
            }
        }
        let factor = self.law.sq / sum.sqrt();
        Some(Topography {
            counts: self.counts,
            spacing: self.spacing,
            heights: waves.iter().map(|z| factor * z.re).collect(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::spectrum;
    use super::*;
    use approx::assert_relative_eq;

    fn random() -> impl FnMut() -> f64 {
        let mut state = 7_u64;
        move || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695);
            (state >> 33) as f64 / f64::from(1_u32 << 31)
        }
    }

    /// Sq to the digit; the spectrum of a profile falls as λ^(1+2H), a factor 2^(1+2H) per octave, between both wavelengths, is flat above
    /// and nothing below; equal numbers make equal surfaces.
    #[test]
    fn profiles_have_the_spectrum_of_the_law() {
        let law = SelfAffine {
            rolloff: 256.0,
            shortest: 8.0,
            hurst: 0.8,
            sq: 0.3,
            anisotropy: 1.0,
            lay: 0.0,
        };
        let own = Generated {
            law,
            counts: [8192, 1],
            spacing: [1.0; 2],
        };
        let map = own.make(random()).unwrap();
        assert_relative_eq!(map.parameters().sq, 0.3, max_relative = 1e-10);
        assert_eq!(own.make(random()), Some(map.clone()));
        let found = spectrum(&map, 0);
        let at = |wavelength: f64| -> f64 {
            let near = (found.wavelength.iter().zip(&found.density))
                .filter(|(l, _)| (**l / wavelength).log2().abs() < 0.55);
            let logs: Vec<f64> = near.map(|(_, d)| d.log2()).collect();
            logs.iter().sum::<f64>() / logs.len() as f64
        };
        let slope = (at(128.0) - at(16.0)) / 3.0;
        assert_relative_eq!(slope, 2.6, max_relative = 0.1);
        assert!(at(1024.0) - at(512.0) < 1.0);
        let below = (found.wavelength.iter().zip(&found.density)).filter(|(l, _)| **l < 7.0);
        assert!(below.map(|(_, d)| *d).fold(0.0, f64::max) < 1e-6 * at(128.0).exp2());
    }

    /// On surfaces: Sq to the digit, C ~ q^(−2(1+H)) is q^(−1−2H) of their rows, and hills are γ times longer along the lay.
    #[test]
    fn surfaces_are_longer_along_their_lay() {
        let law = SelfAffine {
            rolloff: 32.0,
            shortest: 4.0,
            hurst: 0.7,
            sq: 2.0,
            anisotropy: 1.0,
            lay: 0.0,
        };
        let made = |law: SelfAffine| {
            let own = Generated {
                law,
                counts: [256, 256],
                spacing: [1.0; 2],
            };
            own.make(random()).unwrap()
        };
        // Mean square slopes by differences: those along the lay are 1/γ² of those across it.
        let slopes = |map: &Topography| {
            let mut sums = [0.0; 2];
            for j in 0..255 {
                for i in 0..255 {
                    let k = 256 * j + i;
                    sums[0] += (map.heights[k + 1] - map.heights[k]).powi(2);
                    sums[1] += (map.heights[k + 256] - map.heights[k]).powi(2);
                }
            }
            sums[1] / sums[0]
        };
        let round = made(law);
        assert_relative_eq!(round.parameters().sq, 2.0, max_relative = 1e-10);
        assert_relative_eq!(slopes(&round), 1.0, max_relative = 0.1);
        let long = made(SelfAffine {
            anisotropy: 3.0,
            ..law
        });
        assert!((6.0..10.0).contains(&slopes(&long)), "{}", slopes(&long));
        let turned = made(SelfAffine {
            anisotropy: 3.0,
            lay: std::f64::consts::FRAC_PI_2,
            ..law
        });
        assert!(slopes(&turned) < 1.0 / 6.0);
    }
}
