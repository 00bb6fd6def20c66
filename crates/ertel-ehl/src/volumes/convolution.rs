//! Deflection of half-spaces on a regular grid, by fast Fourier transforms.
//!
//! ```text
//!   δ_i = C/π Σ_j K_{i−j} P_j,   K = ∫∫ dA/r over the cell of node j, seen from node i      (Love 1929; Johnson 1985, eq. 3.25)
//! ```

use std::f64::consts::PI;
use std::sync::{Arc, Mutex};

use rayon::prelude::*;
use realfft::num_complex::Complex64;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};
use rustfft::Fft;

use super::grid::Grid;

/// The convolution of a grid.
pub struct Convolution {
    n: [usize; 2],
    half: bool,
    /// Transformed lengths.
    padded: [usize; 2],
    /// Transform of C/π K over the padded lengths, one line of `padded[1]` for each wave along the rows: real, as K is even.
    symbol: Vec<f64>,
    forward: Arc<dyn RealToComplex<f64>>,
    backward: Arc<dyn ComplexToReal<f64>>,
    along: [Arc<dyn Fft<f64>>; 2],
    /// Work space for transforms, reused: as much memory as all other vectors of a grid together.
    room: Mutex<Room>,
}

/// Waves of the rows, and lines across them.
#[derive(Default)]
struct Room {
    rows: Vec<Complex64>,
    lines: Vec<Complex64>,
}

/// Rows and waves that a thread takes at a time.
const ROWS: usize = 16;

/// ∫∫ 1/r over a rectangle from the origin to (x, y), with the sign of xy.
fn corner(x: f64, y: f64) -> f64 {
    let part = |a: f64, b: f64| {
        if a == 0.0 {
            0.0
        } else {
            a * (b / a.abs()).asinh()
        }
    };
    part(x, y) + part(y, x)
}

/// The next length at least as large that transforms fast.
pub(super) fn smooth(least: usize) -> usize {
    (least..)
        .find(|n| {
            let mut n = *n;
            for p in [2, 3, 5] {
                while n % p == 0 {
                    n /= p;
                }
            }
            n == 1
        })
        .unwrap_or(least)
}

impl Convolution {
    /// For half-spaces of the compliance C over a grid.
    pub fn new(grid: &Grid, compliance: f64) -> Convolution {
        let n = grid.n;
        let rows = if grid.half { 2 * n[1] - 1 } else { n[1] };
        // Even, so that a transform of real numbers may halve it.
        let padded = [2 * smooth(n[0]), 2 * smooth(rows)];
        let mut planner = RealFftPlanner::<f64>::new();
        let forward = planner.plan_fft_forward(padded[0]);
        let backward = planner.plan_fft_inverse(padded[0]);
        let mut complex = rustfft::FftPlanner::<f64>::new();
        let along = [
            complex.plan_fft_forward(padded[1]),
            complex.plan_fft_inverse(padded[1]),
        ];
        let mut convolution = Convolution {
            n,
            half: grid.half,
            padded,
            symbol: Vec::new(),
            forward,
            backward,
            along,
            room: Mutex::default(),
        };
        convolution.symbol = convolution.transformed(grid.spacing, compliance / PI, rows);
        convolution
    }

    /// Transform of the kernel.
    fn transformed(&self, [dx, dy]: [f64; 2], factor: f64, rows: usize) -> Vec<f64> {
        let [px, py] = self.padded;
        let (nx, waves) = (self.n[0], px / 2 + 1);
        // ∫∫ 1/r over the corners between nodes, then cells by differences.
        let corners: Vec<f64> = (0..=rows)
            .flat_map(|j| (0..=nx).map(move |i| (i, j)))
            .map(|(i, j)| corner((i as f64 - 0.5) * dx, (j as f64 - 0.5) * dy))
            .collect();
        let at = |i: usize, j: usize| corners[j * (nx + 1) + i];
        let kernel = |i: usize, j: usize| at(i + 1, j + 1) - at(i, j + 1) - at(i + 1, j) + at(i, j);
        let mut lines = vec![Complex64::default(); waves * py];
        let mut row = self.forward.make_input_vec();
        let mut out = self.forward.make_output_vec();
        for j in 0..rows {
            row.fill(0.0);
            for i in 0..nx {
                let value = factor * kernel(i, j);
                row[i] = value;
                if i > 0 {
                    row[px - i] = value;
                }
            }
            self.forward
                .process(&mut row, &mut out)
                .expect("lengths agree");
            for (k, value) in out.iter().enumerate() {
                lines[k * py + j] = *value;
                if j > 0 {
                    lines[k * py + py - j] = *value;
                }
            }
        }
        for line in lines.chunks_exact_mut(py) {
            self.along[0].process(line);
        }
        let scale = 1.0 / (px * py) as f64;
        lines.iter().map(|c| c.re * scale).collect()
    }

    /// Deflection at the nodes under pressures there.
    pub fn apply(&self, pressure: &[f64]) -> Vec<f64> {
        let ([nx, ny], [_, py]) = (self.n, self.padded);
        let waves = self.padded[0] / 2 + 1;
        // Where another thread has it, for this time.
        let mut own = Room::default();
        let mut kept = self.room.try_lock();
        let Room { rows, lines } = kept.as_deref_mut().unwrap_or(&mut own);
        rows.resize(ny * waves, Complex64::default());
        lines.resize(waves * py, Complex64::default());
        // Along the rows that there are.
        (rows.par_chunks_exact_mut(waves))
            .zip(pressure.par_chunks_exact(nx))
            .with_min_len(ROWS)
            .for_each_init(
                || {
                    (
                        self.forward.make_input_vec(),
                        self.forward.make_scratch_vec(),
                    )
                },
                |(row, scratch), (spectrum, values)| {
                    if values.iter().all(|p| *p == 0.0) {
                        spectrum.fill(Complex64::default());
                        return;
                    }
                    row[..nx].copy_from_slice(values);
                    row[nx..].fill(0.0);
                    (self.forward)
                        .process_with_scratch(row, spectrum, scratch)
                        .expect("lengths agree");
                },
            );
        // Across them there and back, wave by wave.
        let n_scratch = (self.along.iter())
            .map(|fft| fft.get_inplace_scratch_len())
            .fold(0, usize::max);
        (lines.par_chunks_exact_mut(py))
            .zip(self.symbol.par_chunks_exact(py))
            .enumerate()
            .with_min_len(ROWS)
            .for_each_init(
                || vec![Complex64::default(); n_scratch],
                |scratch, (k, (line, symbol))| {
                    for j in 0..ny {
                        line[j] = rows[j * waves + k];
                    }
                    line[ny..].fill(Complex64::default());
                    if self.half {
                        for j in 1..ny {
                            line[ny - 1 + j] = line[ny - 1 - j];
                        }
                    }
                    self.along[0].process_with_scratch(line, scratch);
                    for (value, factor) in line.iter_mut().zip(symbol) {
                        *value *= *factor;
                    }
                    self.along[1].process_with_scratch(line, scratch);
                },
            );
        let mut deflection = vec![0.0; nx * ny];
        (deflection.par_chunks_exact_mut(nx))
            .enumerate()
            .with_min_len(ROWS)
            .for_each_init(
                || {
                    let spectrum = self.backward.make_input_vec();
                    (
                        spectrum,
                        self.backward.make_output_vec(),
                        self.backward.make_scratch_vec(),
                    )
                },
                |(spectrum, row, scratch), (j, values)| {
                    for (k, value) in spectrum.iter_mut().enumerate() {
                        *value = lines[k * py + j];
                    }
                    // Of real numbers; all but rounding.
                    spectrum[0].im = 0.0;
                    spectrum[waves - 1].im = 0.0;
                    (self.backward)
                        .process_with_scratch(spectrum, row, scratch)
                        .expect("lengths agree");
                    values.copy_from_slice(&row[..nx]);
                },
            );
        deflection
    }

    /// Nine-point stencil that is nearest to the inverse over all waves of the grid: its weights at the centre, along the first and
    /// the second direction, and on the diagonals.
    pub fn inverse(&self) -> [f64; 4] {
        let [px, py] = self.padded;
        let scale = (px * py) as f64;
        let (mut matrix, mut right) = ([[0.0; 4]; 4], [0.0; 4]);
        for kx in (0..=px / 2).step_by(3) {
            let x = (2.0 * PI * kx as f64 / px as f64).cos();
            for ky in (0..=py / 2).step_by(3) {
                let y = (2.0 * PI * ky as f64 / py as f64).cos();
                let symbol = self.symbol[kx * py + ky] * scale;
                let basis = [1.0, 2.0 * x, 2.0 * y, 4.0 * x * y].map(|b| b * symbol);
                for (i, a) in basis.iter().enumerate() {
                    right[i] += a;
                    for (j, b) in basis.iter().enumerate() {
                        matrix[i][j] += a * b;
                    }
                }
            }
        }
        solve_small(matrix, right)
    }
}

/// Gaussian elimination of a small positive definite system.
pub(super) fn solve_small<const N: usize>(mut a: [[f64; N]; N], mut b: [f64; N]) -> [f64; N] {
    for k in 0..N {
        for i in k + 1..N {
            let factor = a[i][k] / a[k][k];
            let pivot = a[k];
            (a[i].iter_mut().zip(pivot)).for_each(|(a, p)| *a -= factor * p);
            b[i] -= factor * b[k];
        }
    }
    for k in (0..N).rev() {
        let sum: f64 = (k + 1..N).map(|j| a[k][j] * b[j]).sum();
        b[k] = (b[k] - sum) / a[k][k];
    }
    b
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::HertzZone;
    use crate::contact::Turn;
    use approx::assert_relative_eq;

    fn grid(h: f64, half: bool, ratio: f64) -> Grid {
        let zone = HertzZone {
            axis_ratio: ratio,
            turn: Turn::NONE,
            roller: None,
        };
        Grid::covering([[-1.5, 1.25], [-1.5, 1.5]], [h; 2], half, &zone)
    }

    /// Hertz's pressure √(1 − r²) deflects half-spaces by C π/4 (2 − r²) within the circle (Johnson 1985, eq. 3.41a); the error falls with
    /// the power 1.5 of the cell at least, as the pressure ends with a square root. A half with its mirror image is the whole.
    #[test]
    fn deflection_under_hertz_pressure() {
        let c = 0.7;
        let error = |h: f64, half: bool| {
            let grid = grid(h, half, 1.0);
            let pressure: Vec<f64> = (grid.nodes())
                .map(|[i, j]| {
                    let [x, y] = grid.on_axes(i, j);
                    (1.0 - x * x - y * y).max(0.0).sqrt()
                })
                .collect();
            let deflection = Convolution::new(&grid, c).apply(&pressure);
            let errors = grid.nodes().zip(deflection).map(|([i, j], found)| {
                let [x, y] = grid.on_axes(i, j);
                let r2 = x * x + y * y;
                match r2 < 0.9 {
                    true => (found - c * PI / 4.0 * (2.0 - r2)).abs(),
                    false => 0.0,
                }
            });
            errors.fold(0.0, f64::max)
        };
        let errors = [0.125, 0.0625, 0.03125].map(|h| error(h, true));
        assert!(errors[2] < 1e-3, "{errors:?}");
        assert!(errors[0] > 6.0 * errors[2], "{errors:?}");
        assert_relative_eq!(errors[1], error(0.0625, false), max_relative = 1e-6);
    }

    /// The kernel against a sum over small squares, on cells three times as long as wide.
    #[test]
    fn kernel_by_quadrature() {
        let grid = grid(0.25, false, 3.0);
        let mut pressure = vec![0.0; grid.n_nodes()];
        let [ci, cj] = grid.centre();
        pressure[grid.index(ci, cj)] = 1.0;
        let found = Convolution::new(&grid, PI).apply(&pressure);
        let n = 200;
        for (di, dj) in [(1, 0), (0, 1), (2, 1), (3, 2)] {
            let at = [0.25 * f64::from(di), 0.75 * f64::from(dj)];
            let mut sum = 0.0;
            for a in 0..n {
                for b in 0..n {
                    let x = ((f64::from(a) + 0.5) / f64::from(n) - 0.5) * 0.25;
                    let y = ((f64::from(b) + 0.5) / f64::from(n) - 0.5) * 0.75;
                    sum += 0.25 * 0.75 / f64::from(n * n) / (at[0] - x).hypot(at[1] - y);
                }
            }
            let own = found[grid.index(ci + di as usize, cj + dj as usize)];
            assert_relative_eq!(own, sum, max_relative = 1e-4);
        }
    }

    /// The stencil undoes the compliance for waves as short as the cells, on cells of any shape: a checkerboard and lines come back to a third.
    #[test]
    fn stencil_is_nearly_the_inverse() {
        for ratio in [1.0, 0.2, 8.0] {
            let grid = grid(0.0625, false, ratio);
            let convolution = Convolution::new(&grid, 1.3);
            let [s0, sx, sy, sd] = convolution.inverse();
            let [nx, ny] = grid.n;
            for (kx, ky) in [(1.0, 1.0), (1.0, 0.0), (0.0, 1.0), (0.5, 0.5)] {
                let wave: Vec<f64> = (grid.nodes())
                    .map(|[i, j]| (PI * kx * i as f64).cos() * (PI * ky * j as f64).cos())
                    .collect();
                let w = convolution.apply(&wave);
                let (i, j) = (nx / 2 / 4 * 4, ny / 2 / 4 * 4);
                let at = |i: usize, j: usize| w[grid.index(i, j)];
                let back = s0 * at(i, j)
                    + sx * (at(i - 1, j) + at(i + 1, j))
                    + sy * (at(i, j - 1) + at(i, j + 1))
                    + sd * (at(i - 1, j - 1)
                        + at(i + 1, j - 1)
                        + at(i - 1, j + 1)
                        + at(i + 1, j + 1));
                assert!((back - 1.0).abs() < 0.33, "{ratio} {kx} {ky}: {back}");
            }
        }
    }
}
