//! Persson's contact of randomly rough surfaces: pressure over separation, and the area in touch.
//!
//! ```text
//!   p_a = β E* exp(−h/u_0),   u_0 = γ σ                     Persson 2007, Phys. Rev. Lett. 99, 125502
//!   A_r/A_0 = erf(√2 p_a/(E* h'))                           Yang and Persson 2008, J. Phys.: Condens. Matter 20, 215214
//!   β = e^(−γ_E/2) exp(−⟨ln w⟩),   w(q) = [π ∫_{q₀}^q k³ C(k) dk]^(−1/2),   ⟨·⟩ = ∫ · q² C w dq / ∫ q² C w dq
//! ```
//! σ is the composite rms height, h' the composite rms slope, h'² = 2π ∫ k³ C(k) dk over the power spectrum C of the heights, and γ_E Euler's constant 0.5772.
//! One band of wavelengths, q constant, has w = √2/(h' √s) with s from 0 to 1 and the weight 1/√s: β = e^(−γ_E/2 − 1) h'/√2.
//!
//! Theory: Mixed lubrication.

use std::f64::consts::{FRAC_2_SQRT_PI, SQRT_2};

use serde::Serialize;

/// γ = u_0/σ: of the 0.4 to 0.5 that numerical contacts of self-affine surfaces gave (Almqvist et al. 2011, J. Mech. Phys. Solids 59, 2355-2369) the middle.
pub const DECAY: f64 = 0.45;

/// β/h' of surfaces with one band of wavelengths, e^(−γ_E/2 − 1)/√2.
const FACTOR_OF_SLOPE: f64 = 0.194_917_005_715_775_75;

/// Numbers of Persson's law.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Persson {
    /// h': composite rms slope, the root of the mean square of the gradient in both directions, dimensionless.
    pub rms_slope: f64,
    /// γ: length over which the pressure falls to 1/e, over the composite rms height.
    pub decay_length_to_rms_height: f64,
    /// β: pressure over E* where the mean planes meet.
    pub pressure_factor: f64,
}

impl Persson {
    /// Of the composite rms slope, with γ of self-affine surfaces and β of one band of wavelengths where they are not given.
    pub fn new(rms_slope: f64, decay: Option<f64>, factor: Option<f64>) -> Persson {
        Persson {
            rms_slope,
            decay_length_to_rms_height: decay.unwrap_or(DECAY),
            pressure_factor: factor.unwrap_or(FACTOR_OF_SLOPE * rms_slope),
        }
    }

    /// p_a/E* at a distance of the mean planes over σ, and its derivative.
    #[inline]
    pub fn pressure(&self, u: f64) -> [f64; 2] {
        let decay = self.decay_length_to_rms_height;
        let value = self.pressure_factor * (-u / decay).exp();
        [value, -value / decay]
    }

    /// A_r/A_0, the share of the area in touch, at p_a/E*, and its derivative.
    #[inline]
    pub fn area_in_touch(&self, pressure: f64) -> [f64; 2] {
        let by_pressure = SQRT_2 / self.rms_slope;
        let x = by_pressure * pressure;
        [libm::erf(x), by_pressure * FRAC_2_SQRT_PI * (-x * x).exp()]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// By hand: 0.02 e^(−2/0.5) = 0.02 · 0.018315638888734; erf(√2 · 0.1) = 0.158519418878206 (mpmath); small pressures √(8/π) p_a/(E* h').
    #[test]
    fn pressure_and_area_by_hand() {
        let law = Persson::new(0.1, Some(0.5), Some(0.02));
        let [value, slope] = law.pressure(2.0);
        assert_relative_eq!(value, 3.663_127_777_746_836e-4, max_relative = 1e-14);
        assert_relative_eq!(slope, -2.0 * value, max_relative = 1e-14);
        let [area, _] = law.area_in_touch(0.01);
        assert_relative_eq!(area, 0.158_519_418_878_206_05, max_relative = 1e-14);
        let [small, by_pressure] = law.area_in_touch(1e-9);
        let proportional = (8.0 / std::f64::consts::PI).sqrt() / 0.1;
        assert_relative_eq!(small, 1e-9 * proportional, max_relative = 1e-12);
        assert_relative_eq!(by_pressure, proportional, max_relative = 1e-12);
        let step = 1e-7;
        let difference = law.area_in_touch(0.05 + step)[0] - law.area_in_touch(0.05 - step)[0];
        assert_relative_eq!(
            law.area_in_touch(0.05)[1],
            difference / (2.0 * step),
            max_relative = 1e-7
        );
    }

    /// β of one band of wavelengths from the integrals themselves, s = t²: ⟨ln w⟩ = ∫ ln(√2/(h' t)) dt.
    #[test]
    fn pressure_factor_from_the_spectrum() {
        let (slope, n) = (0.3, 200_000);
        let mean: f64 = (0..n)
            .map(|i| (SQRT_2 / slope * f64::from(n) / (f64::from(i) + 0.5)).ln())
            .sum::<f64>()
            / f64::from(n);
        let euler = 0.577_215_664_901_532_9;
        let factor = (-0.5 * euler - mean).exp();
        let law = Persson::new(slope, None, None);
        assert_relative_eq!(law.pressure_factor, factor, max_relative = 1e-5);
        assert_relative_eq!(law.pressure(0.0)[0], factor, max_relative = 1e-5);
    }
}
