//! Zero-padded Fourier transforms of nodal values of a grid: the padding takes up the periodic images. Along the axis of a roller, shapes of its rows replace
//! the waves.

use std::f64::consts::PI;
use std::sync::Arc;

use rayon::prelude::*;
use realfft::num_complex::Complex64;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};
use rustfft::Fft;

use super::axial::AxialShapes;
use crate::volumes::grid::Grid;

/// Transforms on a grid at least twice as long along both directions, of a line along the motion.
#[derive(Clone)]
pub struct Padded {
    /// Nodes of the grid, and whether its last row is the centreline of a mirrored half.
    n: [usize; 2],
    half: bool,
    /// Nodes with padding; across a roller, its shapes.
    padded: [usize; 2],
    forward: Arc<dyn RealToComplex<f64>>,
    backward: Arc<dyn ComplexToReal<f64>>,
    across: Across,
}

/// Transform of the values along a column.
#[derive(Clone)]
enum Across {
    /// Waves, there and back.
    Waves([Arc<dyn Fft<f64>>; 2]),
    /// Shapes of the rows of a roller.
    Shapes(Arc<AxialShapes>),
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

/// Nodes over which values fade to zero before the first and after the last node of the grid, along both directions; 0: they end there.
pub type Fading = [[usize; 2]; 2];

/// Values end at the edges.
pub const NO_FADING: Fading = [[0; 2]; 2];

impl Padded {
    /// For a grid.
    pub fn new(grid: &Grid) -> Padded {
        let n = grid.n;
        let rows = if grid.half { 2 * n[1] - 1 } else { n[1] };
        // A line is the same in all rows: one represents them.
        let shapes = (grid.rows.as_ref()).map(|rows| Arc::new(AxialShapes::new(rows, grid.half)));
        let padded = match (grid.is_line(), &shapes) {
            (true, _) => [smooth(2 * n[0]), 1],
            (false, None) => [2 * n[0], 2 * rows].map(smooth),
            (false, Some(shapes)) => [smooth(2 * n[0]), shapes.n()],
        };
        let mut planner = RealFftPlanner::<f64>::new();
        let forward = planner.plan_fft_forward(padded[0]);
        let backward = planner.plan_fft_inverse(padded[0]);
        let mut complex = rustfft::FftPlanner::<f64>::new();
        let across = match shapes {
            Some(shapes) => Across::Shapes(shapes),
            None => Across::Waves([
                complex.plan_fft_forward(padded[1]),
                complex.plan_fft_inverse(padded[1]),
            ]),
        };
        Padded {
            n,
            half: grid.half,
            padded,
            forward,
            backward,
            across,
        }
    }

    /// Shapes along the axis of a roller.
    pub fn shapes(&self) -> Option<&AxialShapes> {
        match &self.across {
            Across::Waves(_) => None,
            Across::Shapes(shapes) => Some(shapes),
        }
    }

    /// Gain of a forward and backward transform.
    pub fn gain(&self) -> f64 {
        let [px, py] = self.padded;
        match &self.across {
            Across::Waves(_) => (px * py) as f64,
            Across::Shapes(_) => px as f64,
        }
    }

    /// Nodes along both directions, mirrored ones among them.
    pub fn covered(&self) -> [usize; 2] {
        let [nx, ny] = self.n;
        [nx, if self.half { 2 * ny - 1 } else { ny }]
    }

    /// Nodes along both directions with padding; across a roller, its shapes.
    pub fn padded(&self) -> [usize; 2] {
        self.padded
    }

    /// Waves along the rows.
    pub fn waves(&self) -> usize {
        self.padded[0] / 2 + 1
    }

    /// Numbers of a spectrum.
    pub fn n_waves(&self) -> usize {
        self.waves() * self.padded[1]
    }

    /// Radians from node to node along both directions of the wave at each place of a spectrum, and whether a wave of two nodes is among them. Shapes of a roller have none
    /// across.
    pub fn wave(&self, k: usize) -> ([f64; 2], [bool; 2]) {
        let [px, py] = self.padded;
        let (i, j) = match self.across {
            Across::Waves(_) => (k / py, k % py),
            Across::Shapes(_) => (k / py, 0),
        };
        let signed = if 2 * j > py {
            j as f64 - py as f64
        } else {
            j as f64
        };
        (
            [
                2.0 * PI * i as f64 / px as f64,
                2.0 * PI * signed / py as f64,
            ],
            [2 * i == px, 2 * j == py],
        )
    }

    /// κ² of the shape at a place of a spectrum, over half-widths squared; 0 of waves.
    pub fn across(&self, k: usize) -> f64 {
        match &self.across {
            Across::Waves(_) => 0.0,
            Across::Shapes(shapes) => shapes.squares()[k % self.padded[1]],
        }
    }

    /// The transform of values at the nodes of the grid, a line of waves across for each wave along the rows.
    pub fn spectrum(&self, values: &[f64], fading: Fading) -> Vec<Complex64> {
        let ([nx, ny], [px, py], waves) = (self.n, self.padded, self.waves());
        let ramps = fading.map(|ends| ends.map(ramp));
        let mut rows = vec![Complex64::default(); ny * waves];
        (rows.par_chunks_exact_mut(waves))
            .zip(values.par_chunks_exact(nx))
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
                    let [before, after] = &ramps[0];
                    for (m, share) in before.iter().enumerate() {
                        row[px - 1 - m] = share * values[0];
                    }
                    for (m, share) in after.iter().enumerate() {
                        row[nx + m] = share * values[nx - 1];
                    }
                    (self.forward)
                        .process_with_scratch(row, spectrum, scratch)
                        .expect("lengths agree");
                },
            );
        let mut lines = vec![Complex64::default(); waves * py];
        let [_, covered] = self.covered();
        (lines.par_chunks_exact_mut(py))
            .enumerate()
            .with_min_len(ROWS)
            .for_each(|(k, line)| {
                let along = match &self.across {
                    Across::Waves([along, _]) => along,
                    Across::Shapes(shapes) => {
                        let own: Vec<Complex64> = (0..ny).map(|j| rows[j * waves + k]).collect();
                        shapes.parts(&own, line);
                        return;
                    }
                };
                for j in 0..ny {
                    line[j] = rows[j * waves + k];
                }
                if self.half {
                    for j in 1..ny {
                        line[ny - 1 + j] = line[ny - 1 - j];
                    }
                }
                let [before, after] = &ramps[1];
                for (m, share) in before.iter().enumerate() {
                    line[py - 1 - m] = line[0] * share;
                }
                for (m, share) in after.iter().enumerate() {
                    line[covered + m] = line[covered - 1] * share;
                }
                along.process(line);
            });
        lines
    }

    /// Values at the nodes of the grid, times the gain.
    pub fn values(&self, lines: Vec<Complex64>) -> Vec<f64> {
        let ([nx, ny], waves) = (self.n, self.waves());
        let (lines, py) = self.columns(lines);
        let mut values = vec![0.0; nx * ny];
        (values.par_chunks_exact_mut(nx))
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
                    // Imaginary parts are rounding only.
                    spectrum[0].im = 0.0;
                    spectrum[waves - 1].im = 0.0;
                    self.backward.process(spectrum, row).expect("lengths agree");
                    values.copy_from_slice(&row[..nx]);
                },
            );
        values
    }

    /// Columns of nodes for each wave along the rows, and how many numbers each has.
    fn columns(&self, mut lines: Vec<Complex64>) -> (Vec<Complex64>, usize) {
        let [ny, py] = [self.n[1], self.padded[1]];
        match &self.across {
            Across::Waves([_, back]) => {
                (lines.par_chunks_exact_mut(py))
                    .with_min_len(ROWS)
                    .for_each(|line| back.process(line));
                (lines, py)
            }
            Across::Shapes(shapes) => {
                let mut columns = vec![Complex64::default(); self.waves() * ny];
                (columns.par_chunks_exact_mut(ny))
                    .zip(lines.par_chunks_exact(py))
                    .with_min_len(ROWS)
                    .for_each(|(column, parts)| shapes.line(parts, column));
                (columns, ny)
            }
        }
    }

    /// The transform of a response at the offsets between nodes, row by row, over the gain. Of shapes of a roller: the response at the offsets along the rows, shape by shape.
    pub fn of_response(&self, response: &[f64]) -> Vec<Complex64> {
        let [px, py] = self.padded;
        let reach = self.covered().map(|n| n - 1);
        let width = 2 * reach[0] + 1;
        let gain = self.gain();
        let mut symbol = vec![Complex64::default(); self.n_waves()];
        let (mut row, mut out) = (
            self.forward.make_input_vec(),
            self.forward.make_output_vec(),
        );
        for (j, values) in response.chunks_exact(width).enumerate() {
            row.fill(0.0);
            for (i, value) in values.iter().enumerate() {
                row[(i + px - reach[0]) % px] = *value;
            }
            self.forward
                .process(&mut row, &mut out)
                .expect("lengths agree");
            let place = match &self.across {
                Across::Waves(_) => (j + py - reach[1]) % py,
                Across::Shapes(_) => j,
            };
            for (k, value) in out.iter().enumerate() {
                symbol[k * py + place] = *value / gain;
            }
        }
        if let Across::Waves([along, _]) = &self.across {
            (symbol.par_chunks_exact_mut(py))
                .with_min_len(ROWS)
                .for_each(|line| along.process(line));
        }
        symbol
    }
}

/// Shares of a value at nodes beyond an edge, from one to zero with a level slope at both ends.
fn ramp(n: usize) -> Vec<f64> {
    (1..=n)
        .map(|m| 0.5 + 0.5 * (PI * m as f64 / (n + 1) as f64).cos())
        .collect()
}
