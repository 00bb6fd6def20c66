//! Stresses under a Hertz contact with a traction in proportion to its pressure.
//!
//! Line: the functions of [`super::line`] are G_p = π p_0/a (w − √(w² − a²)), G_q = µ G_p.
//!
//! Ellipse: the pressure as waves of the wave number k in the direction θ, each of which deforms the half-space in plane strain; the integral over
//! k is elementary, that over θ periodic, so that equal steps converge exponentially.
//!
//! ```text
//!   σ = a b p_0/(2π) ∫ Re(T_0 I_0 + T_1 I_1) dθ,   I_0 = (1 − q arccot q)/w²,   I_1 = z/w³ [arccot q − q/(1 + q²)]
//!   w² = a² cos²θ + b² sin²θ,   q = (z − i (x cos θ + y sin θ))/w,   T_0 + k z T_1: stress of a wave over its load, less e^(−kz)
//! ```

use std::f64::consts::PI;

use realfft::num_complex::Complex64;

use super::Stress;
use super::line::{Potentials, plane_strain};

/// A Hertz contact that slides or rolls along x.
#[derive(Clone, Copy, Debug)]
pub struct HertzLoad {
    /// Semi-axis along x.
    pub half_width: f64,
    /// Semi-axis along y; `None` for a line contact.
    pub half_width_y: Option<f64>,
    /// Largest pressure.
    pub pressure: f64,
    /// Traction on the body along +x over the pressure.
    pub friction: f64,
    /// Poisson's ratio of the body.
    pub poisson: f64,
}

/// Directions of waves: first and largest number.
const DIRECTIONS: [usize; 2] = [32, 8192];
/// Change of the stresses over the largest pressure at which the number is no longer doubled.
const SETTLED: f64 = 1e-13;
/// Depth of the surface over the smaller semi-axis of an ellipse.
const SURFACE: f64 = 1e-13;
/// |q| from which series are more accurate than the differences.
const SERIES_FROM: f64 = 8.0;

impl HertzLoad {
    /// Stress at a point, z ≥ 0.
    pub fn at(&self, x: f64, y: f64, z: f64) -> Stress {
        let Some(b) = self.half_width_y else {
            return plane_strain(&self.potentials(x, z), z, self.poisson);
        };
        // On the rim at the surface a wave has no limit.
        let z = z.max(SURFACE * self.half_width.min(b));
        let scale = self.half_width * b * self.pressure;
        let mut n = DIRECTIONS[0];
        let mut sum = self.waves([x, y, z], b, n, 0.0);
        loop {
            // The directions between those of the sum before.
            let between = self.waves([x, y, z], b, n, 0.5);
            let change = (between - sum) * (scale / (2 * n) as f64);
            sum += between;
            n *= 2;
            let largest = change.0.iter().fold(0.0, |m: f64, s| m.max(s.abs()));
            if largest < SETTLED * self.pressure || n >= DIRECTIONS[1] {
                return sum * (scale / n as f64);
            }
        }
    }

    /// G and −G' of a line at (x, z), z ≥ 0.
    pub(super) fn potentials(&self, x: f64, z: f64) -> Potentials {
        let (a, w) = (self.half_width, Complex64::new(x, z));
        let root = (w - a).sqrt() * (w + a).sqrt();
        let factor = PI * self.pressure / a;
        let g = factor * (w - root);
        let derivative = factor * (w / root - 1.0);
        let loads = [1.0, self.friction];
        Potentials {
            first: loads.map(|load| load * g),
            second: loads.map(|load| load * derivative),
        }
    }

    /// Sum over n directions of half a turn, which stands for the whole; the first is `offset` steps from x.
    fn waves(&self, [x, y, z]: [f64; 3], b: f64, n: usize, offset: f64) -> Stress {
        let a = self.half_width;
        let mut sum = Stress::default();
        for i in 0..n {
            let angle = PI * (i as f64 + offset) / n as f64;
            let (s, c) = angle.sin_cos();
            let w = (a * c).hypot(b * s);
            let q = Complex64::new(z, -(x * c + y * s)) / w;
            let [first, second] = integrals(q);
            let (first, second) = (first / (w * w), second * z / (w * w * w));
            sum += wave(c, s, self.poisson, self.friction, [first, second]);
        }
        sum
    }
}

/// 1 − q arccot q and arccot q − q/(1 + q²).
pub(super) fn integrals(q: Complex64) -> [Complex64; 2] {
    if q.norm() > SERIES_FROM {
        let inverse = 1.0 / (q * q);
        let (mut power, mut sums) = (inverse, [Complex64::default(); 2]);
        for n in 1..16 {
            let sign = if n % 2 == 1 { 1.0 } else { -1.0 };
            let odd = f64::from(2 * n + 1);
            sums[0] += sign / odd * power;
            sums[1] += sign * (1.0 - 1.0 / odd) * power;
            power *= inverse;
        }
        return [sums[0], sums[1] / q];
    }
    let i = Complex64::i();
    let arccot = -0.5 * i * ((q + i).ln() - (q - i).ln());
    [1.0 - q * arccot, arccot - q / (1.0 + q * q)]
}

/// Real part of T_0 I_0 + T_1 I_1 for unit pressure and the shear µ along x: what is even in the direction has the real part of I, what is odd
/// the imaginary one.
fn wave(c: f64, s: f64, nu: f64, mu: f64, integrals: [Complex64; 2]) -> Stress {
    let [even_0, even_1] = integrals.map(|i| i.re);
    let [odd_0, odd_1] = integrals.map(|i| -i.im);
    let pressure = Stress([
        -(c * c + 2.0 * nu * s * s) * even_0 + c * c * even_1,
        -(s * s + 2.0 * nu * c * c) * even_0 + s * s * even_1,
        -even_0 - even_1,
        -(1.0 - 2.0 * nu) * c * s * even_0 + c * s * even_1,
        c * odd_1,
        s * odd_1,
    ]);
    let shear = Stress([
        2.0 * c * (1.0 + nu * s * s) * odd_0 - c * c * c * odd_1,
        2.0 * nu * c * c * c * odd_0 - c * s * s * odd_1,
        c * odd_1,
        s * (1.0 - 2.0 * nu * c * c) * odd_0 - c * c * s * odd_1,
        -even_0 + c * c * even_1,
        c * s * even_1,
    ]);
    pressure + shear * mu
}
