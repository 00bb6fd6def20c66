//! Pressure-viscosity coefficients that follow from a law.
//!
//! Theory: Pressure-viscosity coefficients.

use num_dual::first_derivative;

use super::{NoAsymptote, ViscosityLaw};

/// First pressure interval (Pa); the following ones double.
const FIRST_INTERVAL: f64 = 1e6;
/// Pressure (Pa) at which the integral is given up.
const LARGEST_PRESSURE: f64 = 1e14;
/// Relative error allowed in the integral.
const TOLERANCE: f64 = 1e-10;

impl ViscosityLaw {
    /// Initial slope `α = d ln μ/dp` at ambient pressure and `temperature` (K), in 1/Pa.
    pub fn pressure_viscosity_slope(&self, temperature: f64) -> f64 {
        first_derivative(|p| self.ln_viscosity(p, temperature.into()), 0.0).1
    }

    /// Reciprocal asymptotic isoviscous pressure coefficient (Blok 1963), in 1/Pa, at `temperature` (K):
    ///
    /// ```text
    /// 1/α* = ∫₀^∞ μ(0)/μ(p) dp
    /// ```
    ///
    /// # Errors
    ///
    /// [`NoAsymptote`] if the integral diverges, as for a constant viscosity.
    pub fn pressure_viscosity_reciprocal_asymptotic(
        &self,
        temperature: f64,
    ) -> Result<f64, NoAsymptote> {
        let ln_mu_0 = self.ln_viscosity(0.0, temperature);
        let integrand = |p: f64| (ln_mu_0 - self.ln_viscosity(p, temperature)).exp();

        let mut integral = 0.0;
        let (mut from, mut to) = (0.0, FIRST_INTERVAL);
        while to < LARGEST_PRESSURE {
            let ends = (integrand(from), integrand(to));
            let middle = integrand(0.5 * (from + to));
            // A viscosity may dip a little (water does), but one that has fallen tenfold does not come back.
            if ends.1.is_nan() || ends.1 > 10.0 {
                break;
            }
            // Before the sum has grown, the interval itself sets the scale.
            let tolerance = TOLERANCE * f64::max(integral, to - from);
            integral += simpson(&integrand, (from, to), ends, middle, tolerance, 20);
            // The rest is about (value / slope of ln μ); with a slope of at least a few 1/p it is below this bound.
            if ends.1 * to < 1e-12 * integral {
                return Ok(1.0 / integral);
            }
            (from, to) = (to, 2.0 * to);
        }
        Err(NoAsymptote { temperature })
    }
}

/// Adaptive Simpson rule; `depth` bounds the bisections.
fn simpson(
    f: &impl Fn(f64) -> f64,
    (a, b): (f64, f64),
    (f_a, f_b): (f64, f64),
    f_m: f64,
    tolerance: f64,
    depth: u32,
) -> f64 {
    let m = 0.5 * (a + b);
    let (f_left, f_right) = (f(0.5 * (a + m)), f(0.5 * (m + b)));
    let whole = (b - a) / 6.0 * (f_a + 4.0 * f_m + f_b);
    let left = (m - a) / 6.0 * (f_a + 4.0 * f_left + f_m);
    let right = (b - m) / 6.0 * (f_m + 4.0 * f_right + f_b);
    let correction = (left + right - whole) / 15.0;
    if depth == 0 || correction.abs() <= tolerance {
        return left + right + correction;
    }
    simpson(f, (a, m), (f_a, f_m), f_left, 0.5 * tolerance, depth - 1)
        + simpson(f, (m, b), (f_m, f_b), f_right, 0.5 * tolerance, depth - 1)
}
