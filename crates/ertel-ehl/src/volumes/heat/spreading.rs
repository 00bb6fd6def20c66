//! Temperatures of the surfaces of both bodies on a grid by the heat that flows into them, by fast Fourier transforms.
//!
//! ```text
//!   T_i = Σ_j K_{i−j} q_j         K the response of a moving body to heat in a cell (see [`super::source`]); along a roller, of each shape [`crate::volumes::axial`]
//! ```

use realfft::num_complex::Complex64;

use super::source::MovingBody;
use super::turning::Turning;
use crate::volumes::convolution::Convolution;
use crate::volumes::grid::Grid;
use crate::volumes::padded::Padded;

/// Spreading of heat in one body under a grid.
pub enum Spreading {
    /// The same everywhere.
    Even(Convolution<Complex64>),
    /// Of a body that spins.
    Turning(Box<Turning>),
}

impl Spreading {
    /// In a body below a grid whose half-width is `length`, m; it spins about the centre at a rate, m/s over a half-width.
    pub fn new(grid: &Grid, body: &MovingBody, length: f64, spin: f64) -> Spreading {
        if let Some(turning) = Turning::new(grid, body, length, spin) {
            return Spreading::Turning(Box::new(turning));
        }
        let transforms = Padded::new(grid);
        let size = grid.cell_size(length);
        let reach = transforms.covered().map(|n| n - 1);
        let response = match transforms.shapes() {
            None => body.response(size, reach),
            Some(shapes) => {
                let squares = shapes.squares().iter().map(|k| k / (length * length));
                body.response_to_shapes(size[0], reach[0], &squares.collect::<Vec<f64>>())
            }
        };
        let symbol = transforms.of_response(&response);
        Spreading::Even(Convolution::new(transforms, symbol))
    }

    /// Whether a place along the axes is outside the map of a spinning surface.
    pub fn has_lost(&self, place: [f64; 2]) -> bool {
        matches!(self, Spreading::Turning(turning) if turning.has_lost(place))
    }

    /// Rises at the nodes, K, by the heat that flows in there, W/m².
    pub fn apply(&self, heat: &[f64]) -> Vec<f64> {
        match self {
            Spreading::Even(convolution) => convolution.apply(heat),
            Spreading::Turning(turning) => turning.apply(heat),
        }
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
            let grid = Grid::covering([[-1.0, 0.75], [-1.0, 1.0]], [0.25; 2], half, &zone);
            let body = MovingBody {
                layers: Vec::new(),
                conductivity: 1.1,
                capacity: 2.2e6,
                velocity: [0.7, if half { 0.0 } else { 0.3 }],
                depth: 3e-4,
                stretch: 1.0,
            };
            let spreading = Spreading::new(&grid, &body, 1e-4, 0.0);
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
