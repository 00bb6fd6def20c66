//! Deflection on a grid whose rows lie at uneven distances: transforms along the rows, a matrix across them for each wave.
//!
//! ```text
//!   δ_ij = Σ_m Σ_n K_jn(i − m) P_mn         K_jn: influence of t_n over the column of node m, seen from node (i, j) ([`super::kernel`])
//! ```
//! The pressure is constant over a cell along the rows (as in [`super::deflection`]) and linear between rows: t_n is 1 on row n and 0 on its neighbours.

use rayon::prelude::*;
use realfft::num_complex::Complex64;

use super::along::{Along, smooth};
use super::grid::Grid;
use super::inverse::{self, Stencils};
use super::kernel::{Hat, Kernel, Samples};
use super::rows::Rows;

/// The convolution of a grid with uneven rows.
pub struct RowsConvolution {
    n: [usize; 2],
    along: Along,
    rows: Vec<Seen>,
    /// Spacing along the rows, and the lengths of cells across them.
    cells: (f64, Vec<f64>),
    kernel: Kernel,
}

/// Influence of the other rows on a row, wave by wave: K of those from `first` on, up to the next `end`.
#[derive(Default)]
struct Seen {
    first: Vec<u32>,
    end: Vec<u32>,
    values: Vec<f64>,
}

/// Rows that a thread takes at a time.
const ROWS: usize = 8;

/// Influence of another row, over that of a row on itself, below which it is neglected: waves of the length l fall off with e^(−2πy/l).
const LEAST: f64 = 1e-9;

/// Transformed length over that of a row. Between the largest distance of nodes and the half of that the kernel is levelled out, so that it has no kink there
/// and its transform falls off as fast as it may.
const PADDED: f64 = 2.5;

/// Kernels of far rows are smooth along the rows: every so many cells they are looked at, several times over their distance and over the length on which they
/// are levelled out. What is left out of their waves is below e^(−8π).
const STRIDES: [usize; 6] = [1, 2, 4, 8, 16, 32];
const SAMPLES: f64 = 8.0;
const SAMPLES_LEVELLED: f64 = 16.0;

impl RowsConvolution {
    /// Of bodies under a grid with these rows.
    pub fn new(grid: &Grid, rows: &Rows, kernel: Kernel) -> RowsConvolution {
        let [nx, ny] = grid.n;
        let most = STRIDES[STRIDES.len() - 1];
        let padded = 2 * most * smooth((PADDED * nx as f64 / (2 * most) as f64).ceil() as usize);
        let strided = STRIDES.map(|stride| Along::new(padded / stride));
        let dx = grid.spacing[0];
        let hats: Vec<Option<Hat>> = (0..ny).map(|n| Hat::new(rows, n)).collect();
        let columns = Columns::new(nx, padded, dx);
        let scale = kernel.factor() / padded as f64;
        let of_row = |j: usize| {
            let waves = strided[0].waves();
            let mut lines = vec![0.0; ny * waves];
            let y = rows.places()[j];
            for (n, line) in lines.chunks_exact_mut(waves).enumerate() {
                let Some(hat) = &hats[n] else { continue };
                let mut add = |from: f64| {
                    let which = columns.stride(hat.distance(from));
                    let samples = &columns.strided[which];
                    let mut sums = vec![0.0; samples.x.len()];
                    kernel.add_hat(hat, from, samples, &mut sums);
                    let scale = scale * STRIDES[which] as f64;
                    for (value, c) in line.iter_mut().zip(strided[which].of_even(&sums)) {
                        *value += scale * c.re;
                    }
                };
                add(y);
                // The centreline is its own image.
                if grid.half && n + 1 < ny {
                    add(-y);
                }
            }
            Seen::new(&lines, waves, j)
        };
        RowsConvolution {
            n: grid.n,
            rows: (0..ny).into_par_iter().map(of_row).collect(),
            along: strided[0].clone(),
            cells: (dx, (0..ny).map(|j| rows.step(j)).collect()),
            kernel,
        }
    }

    /// Deflection at the nodes under pressures there.
    pub fn apply(&self, pressure: &[f64]) -> Vec<f64> {
        let ([nx, ny], waves) = (self.n, self.along.waves());
        let mut along = vec![Complex64::default(); ny * waves];
        (self.along).spectra(pressure, nx, &[Vec::new(), Vec::new()], &mut along);
        let mut across = vec![Complex64::default(); ny * waves];
        (across.par_chunks_exact_mut(ny).enumerate())
            .with_min_len(ROWS)
            .for_each(|(wave, line)| {
                for (n, value) in line.iter_mut().enumerate() {
                    *value = along[n * waves + wave];
                }
            });
        (self.along).values(self.n, |j, spectrum| {
            self.rows[j].sums(&across, ny, spectrum);
        })
    }

    /// For each row, that of a regular grid whose cells are as long as those there.
    pub fn stencils(&self) -> Stencils {
        let (dx, lengths) = &self.cells;
        let of_row = |dy: &f64| inverse::of_cell(&self.kernel, [*dx, *dy]);
        Stencils::of_rows(lengths.par_iter().map(of_row).collect())
    }
}

impl Seen {
    /// From what all rows do to row j, one line of waves after the other.
    fn new(lines: &[f64], waves: usize, j: usize) -> Seen {
        let ny = lines.len() / waves;
        let mut seen = Seen::default();
        for wave in 0..waves {
            let at = |n: usize| lines[n * waves + wave];
            let least = LEAST * at(j).abs();
            let counts = |n: &usize| at(*n).abs() > least;
            let first = (0..ny).find(counts).unwrap_or(0);
            let last = (0..ny).rev().find(counts).map_or(first, |n| n + 1);
            seen.first.push(first as u32);
            seen.values.extend((first..last).map(at));
            seen.end.push(seen.values.len() as u32);
        }
        seen
    }

    /// Σ K P of each wave, from the rows one after the other.
    fn sums(&self, across: &[Complex64], ny: usize, sums: &mut [Complex64]) {
        let mut start = 0;
        for (wave, sum) in sums.iter_mut().enumerate() {
            let [first, end] = [self.first[wave], self.end[wave]].map(|at| at as usize);
            let values = &self.values[start..end];
            let line = &across[wave * ny + first..][..values.len()];
            let mut sum_of_odd = Complex64::default();
            let mut sum_of_even = Complex64::default();
            for (k, p) in values.chunks(2).zip(line.chunks(2)) {
                sum_of_even += p[0] * k[0];
                if let (Some(p), Some(k)) = (p.get(1), k.get(1)) {
                    sum_of_odd += p * k;
                }
            }
            *sum = sum_of_even + sum_of_odd;
            start = end;
        }
    }
}

/// Distances along the rows at which kernels are wanted.
struct Columns {
    /// With each of the [`STRIDES`]. From the largest distance of nodes on they stay behind, and stand at the middle of the transformed length.
    strided: [Samples; STRIDES.len()],
    /// The length on which the kernel is levelled out.
    levelled: f64,
    dx: f64,
}

impl Columns {
    fn new(nx: usize, padded: usize, dx: f64) -> Columns {
        let last = padded / 2;
        let free = (last - nx) as f64;
        // Of a slope that falls from 1 to 0, with two derivatives that vanish at both ends: ∫(1 − t³(10 − 15 t + 6 t²)) dt.
        let behind = |m: usize| {
            let t = (m - nx) as f64 / free;
            free * (t - t.powi(4) * (2.5 - 3.0 * t + t * t))
        };
        let x = |m: usize| match m <= nx {
            true => m as f64 * dx,
            false => (nx as f64 + behind(m)) * dx,
        };
        Columns {
            strided: STRIDES.map(|stride| Samples {
                cell: dx,
                x: (0..=last).step_by(stride).map(x).collect(),
                adjacent: if stride > 1 { 1 } else { nx + 1 },
            }),
            levelled: free * dx,
            dx,
        }
    }

    /// Which of the [`STRIDES`] is enough for a row at some distance.
    fn stride(&self, distance: f64) -> usize {
        let longest = (distance / SAMPLES).min(self.levelled / SAMPLES_LEVELLED) / self.dx;
        let enough = STRIDES.iter().rposition(|stride| *stride as f64 <= longest);
        enough.unwrap_or(0)
    }
}
