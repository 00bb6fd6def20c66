//! Deflection of half-spaces on a grid whose rows lie at uneven distances: transforms along the rows, a matrix across them for each wave.
//!
//! ```text
//!   δ_ij = C/π Σ_m Σ_n K_jn(i − m) P_mn,    K_jn = ∫∫ t_n(y) dA/r over the column of node m, seen from node (i, j)
//!   ∫∫ dA/r → G_0 = x asinh(y/|x|) + y asinh(x/|y|),    ∫∫ y dA/r → G_1 = ½(x r + y² asinh(x/|y|))
//! ```
//! The pressure is constant over a cell along the rows (as in [`super::convolution`]) and linear between rows: t_n is 1 on row n and 0 on its neighbours.

use std::f64::consts::PI;
use std::sync::Arc;

use rayon::prelude::*;
use realfft::num_complex::Complex64;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};

use super::convolution::{Convolution, smooth};
use super::grid::Grid;
use super::near_stencils::Stencils;
use super::rows::Rows;
use crate::contact::{HertzZone, Turn};

/// The convolution of a grid with uneven rows.
pub struct RowsConvolution {
    n: [usize; 2],
    padded: usize,
    rows: Vec<Seen>,
    forward: Arc<dyn RealToComplex<f64>>,
    backward: Arc<dyn ComplexToReal<f64>>,
    /// Spacing along the rows, and the lengths of cells across them.
    cells: (f64, Vec<f64>),
    compliance: f64,
}

/// Influence of the other rows on a row, wave by wave: C/π K of those from `first` on, up to the next `end`.
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

/// Distance of a row in lengths of its hat, and in cells, from which a quadrature gives its kernel to 1e-7.
const FAR: f64 = 4.0;
const FAR_CELLS: f64 = 8.0;

impl RowsConvolution {
    /// For half-spaces of the compliance C over a grid with these rows.
    pub fn new(grid: &Grid, rows: &Rows, compliance: f64) -> RowsConvolution {
        let [nx, ny] = grid.n;
        let most = STRIDES[STRIDES.len() - 1];
        let padded = 2 * most * smooth((PADDED * nx as f64 / (2 * most) as f64).ceil() as usize);
        let mut planner = RealFftPlanner::<f64>::new();
        let strided = STRIDES.map(|stride| planner.plan_fft_forward(padded / stride));
        let forward = planner.plan_fft_forward(padded);
        let backward = planner.plan_fft_inverse(padded);
        let dx = grid.spacing[0];
        let hats: Vec<Option<Hat>> = (0..ny).map(|n| Hat::new(rows, n)).collect();
        let columns = Columns::new(nx, padded, dx);
        let scale = compliance / PI / padded as f64;
        let of_row = |j: usize| {
            let waves = padded / 2 + 1;
            let mut lines = vec![0.0; ny * waves];
            let y = rows.places()[j];
            for (n, line) in lines.chunks_exact_mut(waves).enumerate() {
                let Some(hat) = &hats[n] else { continue };
                let mut add = |from: f64| {
                    let which = columns.stride(hat.distance(from));
                    let (stride, forward) = (STRIDES[which], &strided[which]);
                    let mut row = forward.make_input_vec();
                    let mut out = forward.make_output_vec();
                    hat.seen_from(from, &columns, stride, &mut row);
                    let length = row.len();
                    for m in 1..length.div_ceil(2) {
                        row[length - m] = row[m];
                    }
                    forward.process(&mut row, &mut out).expect("lengths agree");
                    let scale = scale * stride as f64;
                    for (value, c) in line.iter_mut().zip(&out) {
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
            padded,
            rows: (0..ny).into_par_iter().map(of_row).collect(),
            forward: Arc::clone(&forward),
            backward,
            cells: (dx, (0..ny).map(|j| rows.step(j)).collect()),
            compliance,
        }
    }

    /// Deflection at the nodes under pressures there.
    pub fn apply(&self, pressure: &[f64]) -> Vec<f64> {
        let [nx, ny] = self.n;
        let waves = self.padded / 2 + 1;
        let mut along = vec![Complex64::default(); ny * waves];
        (along.par_chunks_exact_mut(waves))
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
                        return;
                    }
                    row[..nx].copy_from_slice(values);
                    row[nx..].fill(0.0);
                    (self.forward)
                        .process_with_scratch(row, spectrum, scratch)
                        .expect("lengths agree");
                },
            );
        let mut across = vec![Complex64::default(); ny * waves];
        (across.par_chunks_exact_mut(ny).enumerate())
            .with_min_len(ROWS)
            .for_each(|(wave, line)| {
                for (n, value) in line.iter_mut().enumerate() {
                    *value = along[n * waves + wave];
                }
            });
        let mut deflection = vec![0.0; nx * ny];
        (deflection.par_chunks_exact_mut(nx))
            .zip(&self.rows)
            .with_min_len(ROWS)
            .for_each_init(
                || {
                    (
                        self.backward.make_input_vec(),
                        self.backward.make_output_vec(),
                        self.backward.make_scratch_vec(),
                    )
                },
                |(spectrum, row, scratch), (values, seen)| {
                    seen.sums(&across, ny, spectrum);
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

    /// For each row, that of a regular grid whose cells are as long as those there.
    pub fn stencils(&self) -> Stencils {
        let (dx, lengths) = &self.cells;
        let of_row = |dy: &f64| {
            let zone = HertzZone {
                axis_ratio: 1.0,
                turn: Turn::NONE,
                roller: None,
            };
            let box_of = [*dx, *dy].map(|h| [0.0, (PATCH - 1) as f64 * h]);
            let grid = Grid::covering(box_of, [*dx, *dy], false, &zone);
            Convolution::new(&grid, self.compliance).inverse()
        };
        Stencils::of_rows(lengths.par_iter().map(of_row).collect())
    }
}

/// Nodes along the sides of the grid from which the stencil of a row is computed.
const PATCH: usize = 24;

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
    dx: f64,
    /// One after the other; from the largest distance of nodes on they stay behind, and stand at the middle of the transformed length.
    x: Vec<f64>,
    /// How many are at full distances.
    full: usize,
    /// The length on which the kernel is levelled out.
    levelled: f64,
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
        let x = (0..=last).map(|m| match m <= nx {
            true => m as f64 * dx,
            false => (nx as f64 + behind(m)) * dx,
        });
        Columns {
            dx,
            x: x.collect(),
            full: nx + 1,
            levelled: free * dx,
        }
    }

    /// Which of the [`STRIDES`] is enough for a row at some distance.
    fn stride(&self, distance: f64) -> usize {
        let longest = (distance / SAMPLES).min(self.levelled / SAMPLES_LEVELLED) / self.dx;
        let enough = STRIDES.iter().rposition(|stride| *stride as f64 <= longest);
        enough.unwrap_or(0)
    }
}

/// t_n of a row, with a quadrature of it for places far away: of degree 5.
struct Hat {
    /// Rows before, here and behind.
    places: [f64; 3],
    points: [[f64; 2]; QUADRATURE],
}

/// Points of a quadrature: three on either side.
const QUADRATURE: usize = 6;

impl Hat {
    /// Of a row; none of one that stands for nothing.
    fn new(rows: &Rows, n: usize) -> Option<Hat> {
        if rows.height(n) == 0.0 {
            return None;
        }
        let places = rows.places();
        let here = places[n];
        let before = here - rows.step(n - 1);
        let behind = match places.get(n + 1) {
            Some(place) => *place,
            None => here + rows.step(n - 1),
        };
        let gauss = [(-0.6_f64.sqrt(), 5.0), (0.0, 8.0), (0.6_f64.sqrt(), 5.0)];
        let mut points = [[0.0; 2]; QUADRATURE];
        for (k, point) in points.iter_mut().enumerate() {
            let (at, weight) = gauss[k % 3];
            let height = 0.5 + 0.5 * at;
            let foot = if k < 3 { before } else { behind };
            let length = (here - foot).abs();
            *point = [
                foot + height * (here - foot),
                height * weight / 18.0 * length,
            ];
        }
        Some(Hat {
            places: [before, here, behind],
            points,
        })
    }

    /// How far its foot is from y, negative within.
    fn distance(&self, y: f64) -> f64 {
        (self.places[0] - y).max(y - self.places[2])
    }

    /// ∫∫ t dA/r over cells at distances along the rows, so many cells from each other, seen from y.
    fn seen_from(&self, y: f64, columns: &Columns, stride: usize, kernel: &mut [f64]) {
        let dx = columns.dx;
        let [a, b, c] = self.places.map(|place| place - y);
        let length = (b - a).max(c - b);
        if self.distance(y) > (FAR * length).max(FAR_CELLS * dx) {
            // By the middle of a cell, with the curvature across it.
            let share = dx * dx / 24.0;
            for [place, weight] in self.points {
                let (square, weight) = ((place - y).powi(2), weight * dx);
                for (value, x) in kernel.iter_mut().zip(columns.x.iter().step_by(stride)) {
                    let x2 = x * x;
                    let inverse = 1.0 / (x2 + square);
                    *value += weight
                        * inverse.sqrt()
                        * (1.0 + share * (2.0 * x2 - square) * inverse * inverse);
                }
            }
            return;
        }
        let at = |x: f64| [a, b, c].map(|y| corner(x, y));
        let mut before = at(0.5 * dx).map(|corner| corner.map(|g| -g));
        for (m, (value, x)) in (kernel.iter_mut())
            .zip(columns.x.iter().step_by(stride))
            .enumerate()
        {
            if m > 0 && (stride > 1 || m >= columns.full) {
                before = at(x - 0.5 * dx);
            }
            let next = at(x + 0.5 * dx);
            let [low, here, high] = [0, 1, 2].map(|n: usize| {
                let [from, to] = [before[n], next[n]];
                [to[0] - from[0], to[1] - from[1]]
            });
            let [first, first_moment] = [here[0] - low[0], here[1] - low[1]];
            let [second, second_moment] = [high[0] - here[0], high[1] - here[1]];
            *value += (first_moment - a * first) / (b - a) + (c * second - second_moment) / (c - b);
            before = next;
        }
    }
}

/// G_0 and G_1 at a corner with x > 0.
#[inline(always)]
fn corner(x: f64, y: f64) -> [f64; 2] {
    let r = (x * x + y * y).sqrt();
    let distance = y.abs();
    // asinh(x/|y|), times y.
    let along = if y == 0.0 {
        0.0
    } else {
        y * ((x + r) / distance).ln()
    };
    let across = x * ((distance + r) / x).ln().copysign(y);
    [along + across, 0.5 * (x * r + y * along)]
}
