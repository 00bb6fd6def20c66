//! Deflection of half-spaces under a line contact, by fast Fourier transforms.
//!
//! ```text
//!   δ_i = −2C/π Σ_j K_{i−j} P_j,   K = ∫ ln(|x|/d) dx over the cell of node j, seen from node i      (Johnson 1985, eq. 2.24b)
//! ```

use std::f64::consts::PI;
use std::sync::Arc;

use realfft::num_complex::Complex64;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};

use super::convolution::{smooth, solve_small};
use super::grid::Grid;
use crate::elastic::LINE_REFERENCE;

/// The convolution of a row of nodes.
pub struct LineConvolution {
    n: usize,
    /// −2C/π K of nodes 0, 1, … n apart.
    kernel: Vec<f64>,
    /// Transformed length.
    padded: usize,
    /// Transform of −2C/π K over it: real, as K is even.
    symbol: Vec<f64>,
    forward: Arc<dyn RealToComplex<f64>>,
    backward: Arc<dyn ComplexToReal<f64>>,
}

/// ∫ ln(|x|/d) dx from 0 to x.
fn primitive(x: f64) -> f64 {
    x * ((x.abs() / LINE_REFERENCE).ln() - 1.0)
}

impl LineConvolution {
    /// For half-spaces of the compliance C under a grid.
    pub fn new(grid: &Grid, compliance: f64) -> LineConvolution {
        let (n, h) = (grid.n[0], grid.spacing[0]);
        // Even, so that a transform of real numbers may halve it.
        let padded = 2 * smooth(n);
        let mut planner = RealFftPlanner::<f64>::new();
        let forward = planner.plan_fft_forward(padded);
        let backward = planner.plan_fft_inverse(padded);
        let factor = -2.0 * compliance / PI;
        let kernel: Vec<f64> = (0..=n)
            .map(|i| {
                let [low, high] = [-0.5, 0.5].map(|side| primitive((i as f64 + side) * h));
                factor * (high - low)
            })
            .collect();
        let mut around = forward.make_input_vec();
        around[..n].copy_from_slice(&kernel[..n]);
        for i in 1..n {
            around[padded - i] = kernel[i];
        }
        let mut waves = forward.make_output_vec();
        forward
            .process(&mut around, &mut waves)
            .expect("lengths agree");
        LineConvolution {
            n,
            kernel,
            padded,
            symbol: waves.iter().map(|wave| wave.re).collect(),
            forward,
            backward,
        }
    }

    /// Deflection at the nodes under pressures there.
    pub fn apply(&self, pressure: &[f64]) -> Vec<f64> {
        let mut row = self.forward.make_input_vec();
        row[..self.n].copy_from_slice(pressure);
        let mut waves: Vec<Complex64> = self.forward.make_output_vec();
        self.forward
            .process(&mut row, &mut waves)
            .expect("lengths agree");
        let scale = 1.0 / self.padded as f64;
        for (wave, symbol) in waves.iter_mut().zip(&self.symbol) {
            *wave *= symbol * scale;
        }
        // Imaginary parts are rounding only.
        waves[0].im = 0.0;
        waves[self.padded / 2].im = 0.0;
        self.backward
            .process(&mut waves, &mut row)
            .expect("lengths agree");
        row.truncate(self.n);
        row
    }

    /// Deflection of a node by one so many nodes away, for 0, 1, … as many as there are.
    pub fn kernel(&self) -> &[f64] {
        &self.kernel
    }

    /// Three-point stencil that is nearest to the inverse over all waves of the grid, in the places of a stencil of nine points.
    pub fn inverse(&self) -> [f64; 4] {
        let (mut matrix, mut right) = ([[0.0; 2]; 2], [0.0; 2]);
        for (k, symbol) in self.symbol.iter().enumerate() {
            let x = (2.0 * PI * k as f64 / self.padded as f64).cos();
            let basis = [*symbol, 2.0 * x * symbol];
            for (i, a) in basis.iter().enumerate() {
                right[i] += a;
                for (j, b) in basis.iter().enumerate() {
                    matrix[i][j] += a * b;
                }
            }
        }
        let [centre, off_diagonal] = solve_small(matrix, right);
        [centre, off_diagonal, 0.0, 0.0]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Hertz's pressure √(1 − x²) deflects by C (ln 2d + ½ − x²) within |x| < 1 (Johnson 1985, section 4.2c); the error falls with the power 1.5 of the cell at least, as the
    /// pressure ends with a square root. Far away it deflects as the line load π/2 with its second moment: −C (ln(|x|/d) − 1/8x²).
    #[test]
    fn deflection_under_hertz_pressure() {
        let c = 0.7;
        let error = |h: f64| {
            let reach = (8.0 / h) as i64;
            let grid = Grid::of_line([-reach, reach], h);
            let x = |i: usize| grid.on_axes(i, 0)[0];
            let pressure: Vec<f64> = (0..grid.n[0])
                .map(|i| (1.0 - x(i) * x(i)).max(0.0).sqrt())
                .collect();
            let deflection = LineConvolution::new(&grid, c).apply(&pressure);
            let [centre, _] = grid.centre();
            // At the middle −2C/π ∫ √(1 − x²) ln(|x|/d) dx = C (ln 2d + ½).
            let middle = c * ((2.0 * LINE_REFERENCE).ln() + 0.5);
            let inside = (0..grid.n[0]).filter(|i| x(*i).abs() < 0.95);
            let errors = inside.map(|i| (deflection[i] - middle + c * x(i) * x(i)).abs());
            let far = deflection[2 * centre];
            let by_hand = -c * ((8.0 / LINE_REFERENCE).ln() - 1.0 / (8.0 * 64.0));
            assert_relative_eq!(far, by_hand, max_relative = 0.5 * h.powf(1.5));
            errors.fold(0.0, f64::max)
        };
        let errors = [0.125, 0.0625, 0.03125].map(error);
        assert!(errors[2] < 0.01, "{errors:?}");
        assert!(errors[0] > 6.0 * errors[2], "{errors:?}");
    }

    /// The stencil undoes the compliance for waves of two and four cells to a factor of 2.5: three points are far from |k|.
    #[test]
    fn stencil_is_nearly_the_inverse() {
        let grid = Grid::of_line([-128, 128], 1.0 / 32.0);
        let convolution = LineConvolution::new(&grid, 1.3);
        let [centre, off_diagonal, ..] = convolution.inverse();
        for wave in [1.0, 0.5] {
            let values: Vec<f64> = (0..grid.n[0])
                .map(|i| (PI * wave * (i as f64 - 128.0)).cos())
                .collect();
            let w = convolution.apply(&values);
            let back = centre * w[128] + off_diagonal * (w[127] + w[129]);
            assert!((0.4..1.6).contains(&back), "{wave}: {back}");
        }
    }
}
