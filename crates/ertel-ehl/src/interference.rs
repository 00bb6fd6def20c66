//! Optical interference in the film, as seen by a camera through a transparent body.
//!
//! Light that comes back from the lower face of the transparent body and light that comes back from the other body have run
//! through oil and spacer layer twice, the second one alone:
//!
//! ```text
//! Δ = 2 (n h + n_s t_s)                          path difference at normal incidence, m
//! δ = 2π Δ/λ + φ                                 phase difference
//! I = I₁ + I₂ + 2 √(I₁ I₂) cos δ                 (Born and Wolf 1999, section 7.2, eq. 15)
//!   = (I₁ + I₂) (1 + V cos δ),  V = 2 √(I₁ I₂)/(I₁ + I₂)
//! ```
//!
//! with the film thickness h, the refractive indices n of the oil and n_s of the spacer layer of thickness t_s, and the change of
//! phase φ of the reflections. Fringes of equal colour follow one another at films that differ by λ/(2n). Rays that are reflected
//! more than once and the finite coherence of the light are left out.
//!
//! Oil under pressure is denser and refracts more (Lorentz and Lorenz; Born and Wolf 1999, section 2.3.3, eq. 17):
//!
//! ```text
//! (n² - 1)/(n² + 2) = ρ/ρ₀ (n₀² - 1)/(n₀² + 2)
//! ```

use std::f64::consts::PI;

use serde::Serialize;

/// Wavelengths of the primaries of the CIE 1931 RGB colour space, m: red, and the lines of mercury in green and blue
/// (CIE 1931; Wright 1929 and Guild 1931).
pub const CIE_RGB: [f64; 3] = [700.0e-9, 546.1e-9, 435.8e-9];

/// The instrument of an interferogram.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Interferometer {
    /// Wavelengths in vacuum, m: one, or those of the red, green and blue channel.
    pub wavelengths: Vec<f64>,
    /// Refractive index of the oil at ambient pressure.
    pub refractive_index: f64,
    /// Whether it follows the density by Lorentz and Lorenz.
    pub follows_density: bool,
    /// Thickness of the spacer layer, m; zero without one.
    pub spacer_thickness: f64,
    /// Its refractive index.
    pub spacer_refractive_index: f64,
    /// Change of phase by the reflections, rad.
    pub phase_change: f64,
    /// Visibility V of the fringes, 0 to 1.
    pub visibility: f64,
}

impl Interferometer {
    /// Refractive index n of oil that is ρ/ρ₀ times as dense as at ambient pressure.
    pub fn refractive_index_at(&self, density_ratio: f64) -> f64 {
        if !self.follows_density {
            return self.refractive_index;
        }
        let square = self.refractive_index * self.refractive_index;
        let refraction = density_ratio * (square - 1.0) / (square + 2.0);
        ((1.0 + 2.0 * refraction) / (1.0 - refraction)).sqrt()
    }

    /// Order of interference δ/2π of a film h, m: whole where it is bright, and a half more where it is dark.
    pub fn order(&self, film: f64, density_ratio: f64, wavelength: f64) -> f64 {
        let oil = self.refractive_index_at(density_ratio) * film;
        let spacer = self.spacer_refractive_index * self.spacer_thickness;
        2.0 * (oil + spacer) / wavelength + self.phase_change / (2.0 * PI)
    }

    /// Intensity of a film h, m, as a share of the brightest, (1 + V cos δ)/(1 + V).
    pub fn intensity(&self, film: f64, density_ratio: f64, wavelength: f64) -> f64 {
        let phase = 2.0 * PI * self.order(film, density_ratio, wavelength);
        (1.0 + self.visibility * phase.cos()) / (1.0 + self.visibility)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn monochromatic() -> Interferometer {
        Interferometer {
            wavelengths: vec![600e-9],
            refractive_index: 1.5,
            follows_density: false,
            spacer_thickness: 0.0,
            spacer_refractive_index: 1.0,
            phase_change: PI,
            visibility: 1.0,
        }
    }

    /// Films of the dark fringes, by looking for minima.
    fn dark(own: &Interferometer) -> Vec<f64> {
        let step = 0.01e-9;
        let at = |i: usize| own.intensity(step * i as f64, 1.0, 600e-9);
        let is_dark = |i: &usize| at(*i) < at(i - 1) && at(*i) <= at(i + 1);
        (1..100_000)
            .filter(is_dark)
            .map(|i| step * i as f64)
            .collect()
    }

    /// λ/(2n) = 200 nm from one dark fringe to the next; with a jump of half a turn, no film at all is dark.
    #[test]
    fn dark_fringes_are_half_a_wavelength_in_the_oil_apart() {
        let own = monochromatic();
        assert!(own.intensity(0.0, 1.0, 600e-9) < 1e-12);
        let films = dark(&own);
        assert_eq!(films.len(), 4);
        for (i, film) in films.iter().enumerate() {
            assert!((film - 200e-9 * (i + 1) as f64).abs() < 0.02e-9, "{film}");
        }
    }

    /// A spacer of 100 nm with n_s = 1.2 is optically equal to 120 nm/1.5 = 80 nm of oil.
    #[test]
    fn a_spacer_layer_moves_the_fringes() {
        let own = Interferometer {
            spacer_thickness: 100e-9,
            spacer_refractive_index: 1.2,
            visibility: 0.5,
            ..monochromatic()
        };
        let films = dark(&own);
        assert!((films[0] - 120e-9).abs() < 0.02e-9, "{films:?}");
        // (1 - 0.5)/(1 + 0.5).
        assert!((own.intensity(120e-9, 1.0, 600e-9) - 1.0 / 3.0).abs() < 1e-12);
    }

    /// By hand for n₀ = 1.5 and ρ = 1.2 ρ₀: 1.2·1.25/4.25 = 6/17, n² = (1 + 12/17)/(1 - 6/17) = 29/11.
    #[test]
    fn denser_oil_refracts_more() {
        let own = Interferometer {
            follows_density: true,
            ..monochromatic()
        };
        assert!((own.refractive_index_at(1.2) - (29.0f64 / 11.0).sqrt()).abs() < 1e-14);
        assert!((own.refractive_index_at(1.0) - 1.5).abs() < 1e-14);
        assert_eq!(monochromatic().refractive_index_at(1.2), 1.5);
    }
}
