//! Temperatures of the surfaces of both bodies on a grid by the heat that flows into them, by fast Fourier transforms.
//!
//! ```text
//!   T_i = Σ_j K_{i−j} q_j         K the response of a moving body to heat in a cell (see [`super::source`])
//! ```

use std::sync::Arc;

use rayon::prelude::*;
use realfft::num_complex::Complex64;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};
use rustfft::Fft;

use super::source::MovingBody;
use crate::volumes::grid::Grid;

/// Spreading of heat in one body under a grid.
pub struct Spreading {
    n: [usize; 2],
    half: bool,
    padded: [usize; 2],
    /// Transform of K, one line of `padded[1]` for each wave along the rows.
    symbol: Vec<Complex64>,
    forward: Arc<dyn RealToComplex<f64>>,
    backward: Arc<dyn ComplexToReal<f64>>,
    along: [Arc<dyn Fft<f64>>; 2],
    /// K of a cell in itself, K/(W/m²).
    own: f64,
}

/// Rows and waves that a thread takes at a time.
const ROWS: usize = 16;

/// The next even length at least as large that transforms fast.
fn smooth(least: usize) -> usize {
    let is_smooth = |n: &usize| {
        let mut n = *n;
        for p in [2, 3, 5] {
            while n.is_multiple_of(p) {
                n /= p;
            }
        }
        n == 1
    };
    2 * (least.div_ceil(2)..).find(is_smooth).unwrap_or(least)
}

impl Spreading {
    /// In a body below a grid whose half-width is `length`, m.
    pub fn new(grid: &Grid, body: &MovingBody, length: f64) -> Spreading {
        let n = grid.n;
        let rows = if grid.half { 2 * n[1] - 1 } else { n[1] };
        let padded = [2 * n[0], 2 * rows].map(smooth);
        let mut planner = RealFftPlanner::<f64>::new();
        let forward = planner.plan_fft_forward(padded[0]);
        let backward = planner.plan_fft_inverse(padded[0]);
        let mut complex = rustfft::FftPlanner::<f64>::new();
        let along = [
            complex.plan_fft_forward(padded[1]),
            complex.plan_fft_inverse(padded[1]),
        ];
        let size = grid.spacing.map(|h| h * length);
        let reach = [n[0] - 1, rows - 1];
        let response = body.response(size, reach);
        let width = 2 * reach[0] + 1;
        let [px, py] = padded;
        let waves = px / 2 + 1;
        let mut symbol = vec![Complex64::default(); waves * py];
        let (mut row, mut out) = (forward.make_input_vec(), forward.make_output_vec());
        for j in 0..2 * reach[1] + 1 {
            row.fill(0.0);
            for i in 0..width {
                row[(i + px - reach[0]) % px] = response[j * width + i];
            }
            forward.process(&mut row, &mut out).expect("lengths agree");
            for (k, value) in out.iter().enumerate() {
                symbol[k * py + (j + py - reach[1]) % py] = *value / (px * py) as f64;
            }
        }
        symbol
            .par_chunks_exact_mut(py)
            .with_min_len(ROWS)
            .for_each(|line| along[0].process(line));
        Spreading {
            n,
            half: grid.half,
            padded,
            symbol,
            forward,
            backward,
            along,
            own: response[reach[1] * width + reach[0]],
        }
    }

    /// Response of a cell to its own heat, K/(W/m²).
    pub fn own(&self) -> f64 {
        self.own
    }

    /// Rises at the nodes, K, by the heat that flows in there, W/m².
    pub fn apply(&self, heat: &[f64]) -> Vec<f64> {
        let ([nx, ny], [px, py]) = (self.n, self.padded);
        let waves = px / 2 + 1;
        let mut rows = vec![Complex64::default(); ny * waves];
        (rows.par_chunks_exact_mut(waves))
            .zip(heat.par_chunks_exact(nx))
            .with_min_len(ROWS)
            .for_each_init(
                || {
                    (
                        self.forward.make_input_vec(),
                        self.forward.make_scratch_vec(),
                    )
                },
                |(row, scratch), (spectrum, values)| {
                    row[..nx].copy_from_slice(values);
                    row[nx..].fill(0.0);
                    (self.forward)
                        .process_with_scratch(row, spectrum, scratch)
                        .expect("lengths agree");
                },
            );
        let mut lines = vec![Complex64::default(); waves * py];
        (lines.par_chunks_exact_mut(py))
            .zip(self.symbol.par_chunks_exact(py))
            .enumerate()
            .with_min_len(ROWS)
            .for_each(|(k, (line, symbol))| {
                for j in 0..ny {
                    line[j] = rows[j * waves + k];
                }
                if self.half {
                    for j in 1..ny {
                        line[ny - 1 + j] = line[ny - 1 - j];
                    }
                }
                self.along[0].process(line);
                for (value, factor) in line.iter_mut().zip(symbol) {
                    *value *= *factor;
                }
                self.along[1].process(line);
            });
        let mut rises = vec![0.0; nx * ny];
        (rises.par_chunks_exact_mut(nx))
            .enumerate()
            .with_min_len(ROWS)
            .for_each_init(
                || {
                    (
                        self.backward.make_input_vec(),
                        self.backward.make_output_vec(),
                    )
                },
                |(spectrum, row), (j, values)| {
                    for (k, value) in spectrum.iter_mut().enumerate() {
                        *value = lines[k * py + j];
                    }
                    // Of real numbers; all but rounding.
                    spectrum[0].im = 0.0;
                    spectrum[waves - 1].im = 0.0;
                    self.backward.process(spectrum, row).expect("lengths agree");
                    values.copy_from_slice(&row[..nx]);
                },
            );
        rises
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::{HertzZone, Turn};
    use approx::assert_relative_eq;

    /// The convolution against its sum, on a grid and on a half.
    #[test]
    fn transforms_against_sums() {
        let zone = HertzZone {
            axis_ratio: 1.3,
            turn: Turn::NONE,
            roller: None,
        };
        for half in [false, true] {
            let grid = Grid::covering([[-1.0, 0.75], [-1.0, 1.0]], 0.25, half, &zone);
            let body = MovingBody {
                conductivity: 1.1,
                capacity: 2.2e6,
                velocity: [0.7, if half { 0.0 } else { 0.3 }],
                depth: 3e-4,
            };
            let spreading = Spreading::new(&grid, &body, 1e-4);
            let heat: Vec<f64> = (0..grid.n_nodes())
                .map(|k| (1.7 * k as f64).sin())
                .collect();
            let [nx, ny] = grid.n;
            let rows = if half { 2 * ny - 1 } else { ny };
            let response = body.response(grid.spacing.map(|h| 1e-4 * h), [nx - 1, rows - 1]);
            let found = spreading.apply(&heat);
            let at = |i: usize, j: usize| {
                let j = if j < ny { j } else { 2 * (ny - 1) - j };
                heat[grid.index(i, j)]
            };
            for [i, j] in [[0, 0], [3, 2], [nx - 1, ny - 1]] {
                let mut sum = 0.0;
                for y in 0..rows {
                    for x in 0..nx {
                        let offset = (j + rows - 1 - y) * (2 * nx - 1) + i + nx - 1 - x;
                        sum += response[offset] * at(x, y);
                    }
                }
                assert_relative_eq!(found[grid.index(i, j)], sum, max_relative = 1e-9);
            }
        }
    }
}
