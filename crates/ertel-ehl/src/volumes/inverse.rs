//! Stencils of nine points that are nearest to the inverse of a deflection, over all waves of a grid.

use std::f64::consts::PI;

use super::convolution::Convolution;
use super::grid::Grid;
use super::kernel::Kernel;
use super::padded::Padded;
use crate::contact::{HertzZone, Turn};

/// Nine-point stencils, one for all rows or one for each: weights at the centre, along the first and the second direction, and on the diagonals.
#[derive(Clone, Debug, PartialEq)]
pub struct Stencils(Vec<[f64; 4]>);

impl Stencils {
    /// One for each row.
    pub fn of_rows(stencils: Vec<[f64; 4]>) -> Stencils {
        Stencils(stencils)
    }

    /// That of a row.
    #[inline(always)]
    pub fn of(&self, row: usize) -> &[f64; 4] {
        &self.0[row.min(self.0.len() - 1)]
    }
}

impl From<[f64; 4]> for Stencils {
    fn from(stencil: [f64; 4]) -> Stencils {
        Stencils(vec![stencil])
    }
}

/// For a grid: by every third wave along both directions.
pub fn of_grid(deflection: &Convolution<f64>) -> [f64; 4] {
    let [px, py] = deflection.transforms().padded();
    let (symbol, gain) = (deflection.symbol(), deflection.transforms().gain());
    let cosine = |k: usize, n: usize| (2.0 * PI * k as f64 / n as f64).cos();
    let every_third = |n: usize| (0..=n / 2).step_by(3);
    nearest(every_third(px).flat_map(|kx| {
        let x = cosine(kx, px);
        every_third(py).map(move |ky| {
            let y = cosine(ky, py);
            let symbol = symbol[kx * py + ky] * gain;
            [1.0, 2.0 * x, 2.0 * y, 4.0 * x * y].map(|b| b * symbol)
        })
    }))
}

/// For a line: three points.
pub fn of_line(transforms: &Padded, coefficients: &[f64]) -> [f64; 4] {
    let [padded, _] = transforms.padded();
    let spectrum = transforms.along().of_even(coefficients);
    let [centre, off_diagonal] = nearest(spectrum.iter().enumerate().map(|(k, wave)| {
        let x = (2.0 * PI * k as f64 / padded as f64).cos();
        [wave.re, 2.0 * x * wave.re]
    }));
    [centre, off_diagonal, 0.0, 0.0]
}

/// Nodes along the sides of the grid from which the stencil of a cell is computed.
const PATCH: usize = 24;

/// For a regular grid with cells of a size.
pub fn of_cell(kernel: &Kernel, size: [f64; 2]) -> [f64; 4] {
    let zone = HertzZone {
        axis_ratio: 1.0,
        turn: Turn::NONE,
        roller: None,
    };
    let bounds = size.map(|h| [0.0, (PATCH - 1) as f64 * h]);
    let transforms = Padded::new(&Grid::covering(bounds, size, false, &zone));
    let symbol = transforms.of_even(&kernel.cells(size, [PATCH; 2]));
    of_grid(&Convolution::new(transforms, symbol))
}

/// Weights of products of a basis with the symbol, wave by wave, whose sum is nearest to one.
fn nearest<const N: usize>(waves: impl Iterator<Item = [f64; N]>) -> [f64; N] {
    let (mut matrix, mut right) = ([[0.0; N]; N], [0.0; N]);
    for basis in waves {
        for (i, a) in basis.iter().enumerate() {
            right[i] += a;
            for (j, b) in basis.iter().enumerate() {
                matrix[i][j] += a * b;
            }
        }
    }
    solve_small(matrix, right)
}

/// Gaussian elimination of a small positive definite system.
fn solve_small<const N: usize>(mut a: [[f64; N]; N], mut b: [f64; N]) -> [f64; N] {
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
    use crate::volumes::deflection::Deflection;

    const BODIES: Kernel = Kernel::HalfSpace { compliance: 1.3 };

    /// The stencil undoes the compliance for waves as short as the cells, on cells of any shape: a checkerboard and lines come back to a third.
    #[test]
    fn stencil_is_nearly_the_inverse() {
        for axis_ratio in [1.0, 0.2, 8.0] {
            let zone = HertzZone {
                axis_ratio,
                turn: Turn::NONE,
                roller: None,
            };
            let grid = Grid::covering([[-1.5, 1.25], [-1.5, 1.5]], [0.0625; 2], false, &zone);
            let deflection = Deflection::new(&grid, BODIES);
            let [s0, sx, sy, sd] = *deflection.stencils().of(0);
            let [nx, ny] = grid.n;
            for (kx, ky) in [(1.0, 1.0), (1.0, 0.0), (0.0, 1.0), (0.5, 0.5)] {
                let wave: Vec<f64> = (grid.nodes())
                    .map(|[i, j]| (PI * kx * i as f64).cos() * (PI * ky * j as f64).cos())
                    .collect();
                let w = deflection.apply(&wave);
                let (i, j) = (nx / 2 / 4 * 4, ny / 2 / 4 * 4);
                let at = |i: usize, j: usize| w[grid.index(i, j)];
                let back = s0 * at(i, j)
                    + sx * (at(i - 1, j) + at(i + 1, j))
                    + sy * (at(i, j - 1) + at(i, j + 1))
                    + sd * (at(i - 1, j - 1)
                        + at(i + 1, j - 1)
                        + at(i - 1, j + 1)
                        + at(i + 1, j + 1));
                assert!((back - 1.0).abs() < 0.33, "{axis_ratio} {kx} {ky}: {back}");
            }
        }
    }

    /// Of a line it undoes the compliance for waves of two and four cells to a factor of 2.5: three points are far from |k|.
    #[test]
    fn stencil_of_a_line() {
        let grid = Grid::of_line([-128, 128], 1.0 / 32.0);
        let deflection = Deflection::new(&grid, BODIES);
        let [centre, off_diagonal, ..] = *deflection.stencils().of(0);
        for wave in [1.0, 0.5] {
            let values: Vec<f64> = (0..grid.n[0])
                .map(|i| (PI * wave * (i as f64 - 128.0)).cos())
                .collect();
            let w = deflection.apply(&values);
            let back = centre * w[128] + off_diagonal * (w[127] + w[129]);
            assert!((0.4..1.6).contains(&back), "{wave}: {back}");
        }
    }
}
