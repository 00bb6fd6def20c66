//! Temperatures of the surfaces of both bodies on a grid by the heat that flows into them, by fast Fourier transforms.
//!
//! ```text
//!   T_i = Σ_j K_{i−j} q_j         K the response of a moving body to heat in a cell (see [`super::source`]); along a roller, of each shape [`super::axial`]
//! ```

use rayon::prelude::*;
use realfft::num_complex::Complex64;

use super::padded::{NO_FADING, Padded};
use super::source::MovingBody;
use super::turning::Turning;
use crate::volumes::grid::Grid;

/// Spreading of heat in one body under a grid.
pub struct Spreading {
    transforms: Padded,
    /// Transform of K, over the gain of the transforms.
    symbol: Vec<Complex64>,
    /// Of a body that spins.
    turning: Option<Turning>,
}

impl Spreading {
    /// In a body below a grid whose half-width is `length`, m; it spins about the centre at a rate, m/s over a half-width.
    pub fn new(grid: &Grid, body: &MovingBody, length: f64, spin: f64) -> Spreading {
        let turning = Turning::new(grid, body.velocity, spin);
        let transforms = Padded::new(turning.as_ref().map_or(grid, Turning::plane));
        let size = grid.cell_size(length);
        let reach = transforms.covered().map(|n| n - 1);
        let response = match transforms.shapes() {
            None => body.response(size, reach),
            Some(shapes) => {
                let squares = shapes.squares().iter().map(|k| k / (length * length));
                body.response_to_shapes(size[0], reach[0], &squares.collect::<Vec<f64>>())
            }
        };
        Spreading {
            symbol: transforms.of_response(&response),
            transforms,
            turning,
        }
    }

    /// By the transform of K, over the gain of the transforms.
    pub fn of_symbol(transforms: Padded, symbol: Vec<Complex64>) -> Spreading {
        Spreading {
            transforms,
            symbol,
            turning: None,
        }
    }

    /// Rises at the nodes, K, by the heat that flows in there, W/m².
    pub fn apply(&self, heat: &[f64]) -> Vec<f64> {
        if let Some(turning) = &self.turning {
            return turning.draw_back(&self.spread(&turning.draw_out(heat)));
        }
        self.spread(heat)
    }

    fn spread(&self, heat: &[f64]) -> Vec<f64> {
        let mut spectrum = self.transforms.spectrum(heat, NO_FADING);
        (spectrum.par_iter_mut().zip(&self.symbol))
            .with_min_len(LEAST)
            .for_each(|(value, factor)| *value *= *factor);
        self.transforms.values(spectrum)
    }
}

/// Numbers that a thread takes at a time.
const LEAST: usize = 4096;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::{HertzZone, Turn};
    use approx::assert_relative_eq;

    /// A body that turns under a spot of heat against the sum of its instantaneous sources, each of which has turned with the body: R(ωt)(r' − c) + c, spread over √(4χt).
    #[test]
    fn a_body_that_spins() {
        let zone = HertzZone {
            axis_ratio: 1.0,
            turn: Turn::NONE,
            roller: None,
        };
        let a = 1e-4;
        let grid = Grid::covering([[-3.0, 3.0], [-3.0, 3.0]], 0.0625, false, &zone);
        for peclet in [10.0, 40.0] {
            let mut body = MovingBody {
                conductivity: 46.0,
                capacity: 7850.0 * 470.0,
                velocity: [0.0; 2],
                depth: 10.0 * a,
            };
            let chi = body.diffusivity();
            let speed = peclet * chi / a;
            body.velocity = [speed, 0.0];
            let spin = 0.3 * speed;
            let spreading = Spreading::new(&grid, &body, a, spin);
            let (width, at) = (0.5, [-0.5, 0.6]);
            let spot = |[x, y]: [f64; 2]| {
                (-((x - at[0]).powi(2) + (y - at[1]).powi(2)) / (width * width)).exp()
            };
            let heat: Vec<f64> = (grid.nodes())
                .map(|[i, j]| 1e7 * spot(grid.on_axes(i, j)))
                .collect();
            let found = spreading.apply(&heat);
            let exact = |[x, y]: [f64; 2]| {
                let (n, last) = (4000, 40.0 * a / speed);
                let step = f64::sqrt(last) / f64::from(n);
                let sum: f64 = (0..n)
                    .map(|k| ((f64::from(k) + 0.5) * step).powi(2))
                    .map(|t| {
                        // The middle of the spot turns about c = (0, v/ω).
                        let (sin, cos) = (spin / a * t).sin_cos();
                        let centre = speed / spin;
                        let from = [at[0], at[1] - centre];
                        let moved = [
                            cos * from[0] - sin * from[1],
                            centre + sin * from[0] + cos * from[1],
                        ];
                        let wide = width * width + 4.0 * chi * t / (a * a);
                        let distance = (x - moved[0]).powi(2) + (y - moved[1]).powi(2);
                        width * width / wide * (-distance / wide).exp()
                    })
                    .sum();
                2e7 * step * sum / (body.capacity * (std::f64::consts::PI * chi).sqrt())
            };
            let largest = found.iter().fold(0.0_f64, |m, t| m.max(*t));
            let mut worst = 0.0_f64;
            for j in (8..grid.n[1]).step_by(12) {
                for i in (8..grid.n[0]).step_by(12) {
                    let own = exact(grid.on_axes(i, j));
                    worst = worst.max((found[grid.index(i, j)] - own).abs() / largest);
                }
            }
            eprintln!("{peclet}: {worst}");
            assert!(worst < 0.02, "{peclet}: {worst}");
        }
    }

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
