//! Zero-padded Fourier transforms of nodal values of a grid: the padding takes up the periodic images. Along the axis of a roller, shapes of its rows replace
//! the waves.

use std::f64::consts::PI;
use std::ops::MulAssign;
use std::sync::Arc;

use rayon::prelude::*;
use realfft::num_complex::Complex64;
use rustfft::{Fft, FftPlanner};

use super::along::{Along, ROWS, Ramps, smooth};
use super::axial::AxialShapes;
use super::grid::Grid;

/// Transforms on a grid at least twice as long along both directions, of a line along the motion.
#[derive(Clone)]
pub struct Padded {
    /// Nodes of the grid, and whether its last row is the centreline of a mirrored half.
    n: [usize; 2],
    half: bool,
    /// Nodes with padding; across a roller, its shapes.
    padded: [usize; 2],
    along: Along,
    across: Across,
}

/// Transform of the values along a column.
#[derive(Clone)]
enum Across {
    /// None: a line is the same in all rows, and one represents them.
    Line,
    /// Waves, there and back.
    Waves([Arc<dyn Fft<f64>>; 2]),
    /// Shapes of the rows of a roller.
    Shapes(Arc<AxialShapes>),
}

/// Work space of transforms: waves of the rows, and lines across them.
#[derive(Default)]
pub struct Room {
    rows: Vec<Complex64>,
    lines: Vec<Complex64>,
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
        // Even, so that a transform of real numbers may halve it.
        let length = 2 * smooth(n[0]);
        let (across, n_across) = match &grid.rows {
            _ if grid.is_line() => (Across::Line, 1),
            Some(rows) => {
                let shapes = Arc::new(AxialShapes::new(rows, grid.half));
                let n = shapes.n();
                (Across::Shapes(shapes), n)
            }
            None => {
                let n = 2 * smooth(rows);
                let mut planner = FftPlanner::new();
                let waves = [planner.plan_fft_forward(n), planner.plan_fft_inverse(n)];
                (Across::Waves(waves), n)
            }
        };
        Padded {
            n,
            half: grid.half,
            padded: [length, n_across],
            along: Along::new(length),
            across,
        }
    }

    /// Shapes along the axis of a roller.
    pub fn shapes(&self) -> Option<&AxialShapes> {
        match &self.across {
            Across::Line | Across::Waves(_) => None,
            Across::Shapes(shapes) => Some(shapes),
        }
    }

    /// Transforms along the rows.
    pub fn along(&self) -> &Along {
        &self.along
    }

    /// Gain of a forward and backward transform.
    pub fn gain(&self) -> f64 {
        let [px, py] = self.padded;
        match &self.across {
            Across::Line | Across::Waves(_) => (px * py) as f64,
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

    /// Numbers of a spectrum.
    pub fn n_waves(&self) -> usize {
        self.along.waves() * self.padded[1]
    }

    /// Radians from node to node along both directions of the wave at each place of a spectrum, and whether a wave of two nodes is among them. Shapes of a roller have none
    /// across.
    pub fn wave(&self, k: usize) -> ([f64; 2], [bool; 2]) {
        let [px, py] = self.padded;
        let (i, j) = match self.across {
            Across::Line | Across::Waves(_) => (k / py, k % py),
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
        self.shapes()
            .map_or(0.0, |shapes| shapes.squares()[k % self.padded[1]])
    }

    /// The transform of values at the nodes of the grid, a line of waves across for each wave along the rows.
    pub fn spectrum(&self, values: &[f64], fading: Fading) -> Vec<Complex64> {
        let mut room = Room::default();
        self.transform(values, fading, &mut room, |_, _, _| {});
        room.lines
    }

    /// Values at the nodes of the grid, times the gain.
    pub fn values(&self, mut lines: Vec<Complex64>) -> Vec<f64> {
        if let Across::Waves(_) = self.across {
            (lines.par_chunks_exact_mut(self.padded[1]))
                .with_min_len(ROWS)
                .for_each_init(|| self.scratch(), |scratch, line| self.back(line, scratch));
        }
        self.nodes(&lines)
    }

    /// Values at the nodes of the grid, convolved: their spectrum times factors, which are over the gain.
    pub fn convolved<F>(&self, values: &[f64], factors: &[F], room: &mut Room) -> Vec<f64>
    where
        F: Copy + Sync,
        Complex64: MulAssign<F>,
    {
        self.transform(values, NO_FADING, room, |k, line, scratch| {
            let factors = &factors[k * line.len()..];
            for (value, factor) in line.iter_mut().zip(factors) {
                *value *= *factor;
            }
            self.back(line, scratch);
        });
        self.nodes(&room.lines)
    }

    /// Transforms values and takes each line across, with its number and work space, one step further; a line contact has one line, of the waves along it.
    fn transform(
        &self,
        values: &[f64],
        fading: Fading,
        Room { rows, lines }: &mut Room,
        then: impl Fn(usize, &mut [Complex64], &mut [Complex64]) + Sync,
    ) {
        let ([nx, ny], waves) = (self.n, self.along.waves());
        let ramps = fading.map(|ends| ends.map(ramp));
        lines.resize(self.n_waves(), Complex64::default());
        if let Across::Line = self.across {
            self.along.spectra(values, nx, &ramps[0], lines);
            then(0, lines, &mut []);
            return;
        }
        rows.resize(ny * waves, Complex64::default());
        self.along.spectra(values, nx, &ramps[0], rows);
        (lines.par_chunks_exact_mut(self.padded[1]))
            .enumerate()
            .with_min_len(ROWS)
            .for_each_init(
                || self.scratch(),
                |scratch, (k, line)| {
                    let column = (0..ny).map(|j| rows[j * waves + k]);
                    self.there(column, &ramps[1], line, scratch);
                    then(k, line, scratch);
                },
            );
    }

    /// Work space of transforms across.
    fn scratch(&self) -> Vec<Complex64> {
        let n = match &self.across {
            Across::Line | Across::Shapes(_) => 0,
            Across::Waves([there, back]) => {
                (there.get_inplace_scratch_len()).max(back.get_inplace_scratch_len())
            }
        };
        vec![Complex64::default(); n]
    }

    /// A line across, by the column of the nodes.
    fn there(
        &self,
        column: impl Iterator<Item = Complex64>,
        [before, after]: &Ramps,
        line: &mut [Complex64],
        scratch: &mut [Complex64],
    ) {
        let waves = match &self.across {
            Across::Line => return,
            Across::Shapes(shapes) => {
                shapes.parts(&column.collect::<Vec<_>>(), line);
                return;
            }
            Across::Waves([there, _]) => there,
        };
        let (ny, [_, covered], py) = (self.n[1], self.covered(), line.len());
        (line.iter_mut().zip(column)).for_each(|(value, own)| *value = own);
        line[ny..].fill(Complex64::default());
        if self.half {
            for j in 1..ny {
                line[ny - 1 + j] = line[ny - 1 - j];
            }
        }
        for (m, share) in before.iter().enumerate() {
            line[py - 1 - m] = line[0] * share;
        }
        for (m, share) in after.iter().enumerate() {
            line[covered + m] = line[covered - 1] * share;
        }
        waves.process_with_scratch(line, scratch);
    }

    /// From waves across to nodes.
    fn back(&self, line: &mut [Complex64], scratch: &mut [Complex64]) {
        if let Across::Waves([_, back]) = &self.across {
            back.process_with_scratch(line, scratch);
        }
    }

    /// Values at the nodes, by lines of nodes or of parts of shapes.
    fn nodes(&self, lines: &[Complex64]) -> Vec<f64> {
        let [ny, py] = [self.n[1], self.padded[1]];
        let mut columns = Vec::new();
        let (lines, length) = match &self.across {
            Across::Line | Across::Waves(_) => (lines, py),
            Across::Shapes(shapes) => {
                columns.resize(self.along.waves() * ny, Complex64::default());
                (columns.par_chunks_exact_mut(ny))
                    .zip(lines.par_chunks_exact(py))
                    .with_min_len(ROWS)
                    .for_each(|(column, parts)| shapes.line(parts, column));
                (columns.as_slice(), ny)
            }
        };
        self.along.values(self.n, |j, spectrum| {
            for (k, value) in spectrum.iter_mut().enumerate() {
                *value = lines[k * length + j];
            }
        })
    }

    /// The transform of a response at the offsets between nodes, row by row, over the gain. Of shapes of a roller: the response at the offsets along the rows, shape by shape.
    pub fn of_response(&self, response: &[f64]) -> Vec<Complex64> {
        let [px, py] = self.padded;
        let reach = self.covered().map(|n| n - 1);
        let rows = response.chunks_exact(2 * reach[0] + 1).enumerate();
        let transformed = rows.map(|(j, values)| {
            let spectrum = self.along.of_row(|row| {
                for (i, value) in values.iter().enumerate() {
                    row[(i + px - reach[0]) % px] = *value;
                }
            });
            let place = match self.across {
                Across::Line | Across::Waves(_) => (j + py - reach[1]) % py,
                Across::Shapes(_) => j,
            };
            (spectrum, [place; 2])
        });
        self.of_rows(transformed, self.gain())
    }

    /// The transform, over the gain, of influence coefficients that are even along both directions: at offsets of 0, 1, … nodes along the rows, row by row.
    pub fn of_even(&self, coefficients: &[f64]) -> Vec<f64> {
        let py = self.padded[1];
        let rows = coefficients.chunks_exact(self.n[0]).enumerate();
        let transformed = rows.map(|(j, row)| (self.along.of_even(row), [j, (py - j) % py]));
        let scale = 1.0 / self.gain();
        let lines = self.of_rows(transformed, 1.0);
        lines.iter().map(|wave| wave.re * scale).collect()
    }

    /// The transform of rows that are transformed along, each at its places across, over a divisor.
    fn of_rows(
        &self,
        rows: impl Iterator<Item = (Vec<Complex64>, [usize; 2])>,
        divisor: f64,
    ) -> Vec<Complex64> {
        let py = self.padded[1];
        let mut lines = vec![Complex64::default(); self.n_waves()];
        for (spectrum, places) in rows {
            for (k, value) in spectrum.into_iter().enumerate() {
                for place in places {
                    lines[k * py + place] = value / divisor;
                }
            }
        }
        if let Across::Waves([there, _]) = &self.across {
            (lines.par_chunks_exact_mut(py))
                .with_min_len(ROWS)
                .for_each(|line| there.process(line));
        }
        lines
    }
}

/// Shares of a value at nodes beyond an edge, from one to zero with a level slope at both ends.
fn ramp(n: usize) -> Vec<f64> {
    (1..=n)
        .map(|m| 0.5 + 0.5 * (PI * m as f64 / (n + 1) as f64).cos())
        .collect()
}
